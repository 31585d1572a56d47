use imogene_board::stays;

#[test]
fn images_stay_as_long_as_the_scene_says() {
    let at_60 = |seconds: &[f64]| stays(seconds, 60.0);
    assert_eq!(at_60(&[0.0]), (1, vec![1]));
    assert_eq!(at_60(&[0.08, 0.08]), (5, vec![1, 1]));
    assert_eq!(stays(&[0.1, 0.1], 30.0), (3, vec![1, 1]));
    assert_eq!(at_60(&[0.1, 0.25, 0.001]), (1, vec![6, 15, 1]));
    assert_eq!(at_60(&[0.1, 0.25]), (3, vec![2, 5]));
    // 600 frames are more than the memory can say.
    assert_eq!(at_60(&[10.0]), (200, vec![3]));
}
