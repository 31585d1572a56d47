use imogene_studies::trade::view::Ideal;

/// Two pixels of 4 x 4 samples in one channel: half of the first is 160, so its mean is 80; the second is black.
#[test]
fn the_ideal_picture_is_the_mean_of_its_samples() {
    let mut rgb = vec![0; 3 * 8 * 4];
    for line in 0..2 {
        for column in 0..4 {
            rgb[3 * (8 * line + column)] = 160;
        }
    }
    let ideal = Ideal::new(&rgb, 8, 4);
    assert_eq!(ideal.error(&[80, 0, 0, 0, 0, 0]), 0.0);
    // One of six channels is 51, a fifth of the scale, off.
    let error = ideal.error(&[80, 0, 0, 0, 0, 51]);
    assert!((error - 20.0 / 6f64.sqrt()).abs() < 1e-9, "{error}");
}
