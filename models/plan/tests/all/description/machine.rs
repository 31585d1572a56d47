use imogene_plan::description::LitSphere;

#[test]
fn each_light_halves_the_materials() {
    let has_room = |side, materials, lights| {
        let sphere = LitSphere {
            side,
            materials,
            nearest: false,
        };
        sphere.has_room(lights)
    };
    for (side, lights, most) in [(64, 0, 8), (64, 3, 1), (128, 1, 1), (16, 0, 32), (16, 4, 2)] {
        assert!(has_room(side, most, lights), "{side} {lights}");
        assert!(!has_room(side, most + 1, lights), "{side} {lights}");
    }
    assert!(!has_room(64, 1, 4) && !has_room(16, usize::MAX, 40));
}
