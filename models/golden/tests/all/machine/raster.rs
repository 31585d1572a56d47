use imogene_golden::machine::raster::RasterControl;

#[test]
fn zones_follow_each_other_without_a_bubble() {
    let mut raster = RasterControl::default();
    assert_eq!(raster.clock(false, 2, 2), None);
    let pixel = |_| raster.clock(true, 2, 2).expect("no bubble");
    let pixels: Vec<_> = (0..8).map(pixel).collect();
    let places: Vec<_> = pixels.iter().map(|p| (p.x, p.y)).collect();
    let zone = [(0, 0), (1, 0), (0, 1), (1, 1)];
    assert_eq!(places, [zone, zone].concat());
    assert!(pixels.iter().all(|p| p.start == ((p.x, p.y) == (0, 0))));
    assert!(pixels[2].line && pixels[3].last && !pixels[4].line);
    assert_eq!(raster.clock(false, 1, 1), None);
}
