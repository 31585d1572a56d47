use imogene_studies::evaluate::scenes::balls;

#[test]
fn balls_have_a_box_of_eighty_pixels_wherever_they_are() {
    let balls = balls().unwrap();
    let planes = balls.each_ref().map(|ball| ball.object.words.planes.len());
    assert_eq!(planes, [0, 3, 4]);
    for ball in &balls {
        let scene = ball.at(&[[0, 0], [37, 100]], [300, 200]);
        for (slot, place) in scene.slots().iter().zip([[0, 0], [37, 100]]) {
            let window = slot.words.screen_box();
            assert_eq!([window.x0, window.y0], place);
            assert_eq!([window.x1, window.y1], place.map(|v| v + 79));
        }
    }
}
