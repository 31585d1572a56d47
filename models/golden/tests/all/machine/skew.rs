use imogene_golden::machine::skew::Skewed;

#[test]
fn a_pixel_is_a_diagonal_of_the_clocks() {
    let mut skewed = Skewed::new(vec![0, 1, 2, 0]);
    // Input i carries the pixel whose first input was taken `start` clocks ago.
    let at = |clock: i64| vec![clock, clock - 1, clock - 2, clock];
    assert_eq!(skewed.push(at(0)), None);
    assert_eq!(skewed.push(at(1)), None);
    assert_eq!(skewed.push(at(2)), Some(vec![0; 4]));
    assert_eq!(skewed.push(at(3)), Some(vec![1; 4]));
}

#[test]
fn without_skew_a_pixel_is_a_clock() {
    let mut skewed = Skewed::new(vec![0, 0]);
    assert_eq!(skewed.push(vec![5, 6]), Some(vec![5, 6]));
}
