use imogene_studies::kit::sheet::Sheet;

#[test]
fn panels_stand_in_bands() {
    let panel = |grey: u8| vec![grey; 3 * 2];
    let pairs = [1, 3, 5].map(|grey| [panel(grey), panel(grey + 1)]);
    let sheet = Sheet::of(&pairs, (2, 1), 2);
    assert_eq!((sheet.width, sheet.height), (2 + 4 + 2, 4 * (1 + 4) - 4));
    let at = |x: usize, y: usize| sheet.rgb[3 * (y * sheet.width + x)];
    let found = [
        (0, 0),
        (0, 5),
        (7, 0),
        (7, 5),
        (1, 10),
        (1, 15),
        (2, 0),
        (6, 10),
    ];
    assert_eq!(found.map(|(x, y)| at(x, y)), [1, 2, 3, 4, 5, 6, 255, 255]);
}
