use imogene_studies::evaluate::duplication::{Edges, formula, touched};

#[test]
fn rectangles_follow_the_formula_exactly() {
    for (size, side) in [(20, 32), (80, 128), (80, 64), (1, 8), (8, 8), (37, 16)] {
        let found = touched(size, side, Edges::Anywhere);
        let expected = formula(size as f64, side as f64);
        assert!((found.mean - expected).abs() < 1e-12, "{size} in {side}");
    }
    let found = touched(20, 32, Edges::Anywhere);
    // l h / L H, (h L + l H - 2 l h) / L H, (L - l)(H - h) / L H.
    let expected = [400.0, 480.0, 144.0].map(|part| part / 1024.0);
    assert_eq!([found.four, found.two, found.one], expected);
    assert_eq!(found.mean, found.one + 2.0 * found.two + 4.0 * found.four);
}

#[test]
fn a_pixel_is_in_one_zone() {
    assert_eq!(touched(1, 8, Edges::OnPixels).mean, 1.0);
    assert_eq!(touched(9, 8, Edges::OnPixels).mean, 4.0);
}
