use imogene_golden::format::Format;
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END};
use imogene_golden::unit::normal::{NEAR_END_NORMAL, NormalWords, select};

#[test]
fn near_and_far_faces_differ_in_the_sign_of_the_root_term() {
    let words = NormalWords {
        k: [64, -64, 100],
        ..Default::default()
    };
    let g = [0, 0, 1 << 20];
    let of = |face| select(face, true, g, 25_600, &words, &[], &Format::BASE);
    assert_eq!(of(FACE_NEAR), [-100, 100, 4096 - 157]);
    assert_eq!(of(FACE_FAR), [100, -100, 4096 + 156]);
}

#[test]
fn planes_and_near_end_have_constant_normals() {
    let words = NormalWords::default();
    let planes = [[1, 2, 3], [4, 5, 6]];
    let of = |face, there| select(face, there, [0; 3], 0, &words, &planes, &Format::BASE);
    assert_eq!(of(3, true), [4, 5, 6]);
    assert_eq!(of(9, true), [0; 3]);
    assert_eq!(of(FACE_NEAR_END, true), NEAR_END_NORMAL);
    assert_eq!(of(2, false), [0; 3]);
}
