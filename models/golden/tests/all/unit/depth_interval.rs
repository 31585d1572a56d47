use imogene_golden::format::Format;
use imogene_golden::unit::depth_interval::{Class, FACE_FAR, FACE_NEAR, FACE_NEAR_END, halves};

const F: Format = Format::BASE;

#[test]
fn sums_beyond_the_depth_word_saturate_in_order() {
    // -2^23 - 11 863 283 needs 26 bits.
    let (a, _) = halves(Class::Side, -8_388_607 - 11_863_283, 11_863_283, false, &F);
    assert_eq!((a.zf, a.zb, a.nf), (F.z_low(), F.z_max(), FACE_NEAR_END));
}

#[test]
fn roots_behind_the_eye_are_no_face_of_a_patch() {
    let (a, _) = halves(Class::Patch, 1000, F.z_max() + 5, false, &F);
    assert_eq!((a.zf, a.zb, a.nf), (1000, 1000, FACE_NEAR));
    let (a, _) = halves(Class::Patch, F.z_max(), F.z_max() + 5, false, &F);
    assert!(!a.is_present(&F));
}

#[test]
fn solid_seen_from_inside_fills_the_line_where_f2_is_negative() {
    let (a, b) = halves(Class::Front, 0, 0, true, &F);
    assert_eq!((a.zf, a.zb), (F.z_low(), F.z_max()));
    assert!(!b.is_present(&F));
    assert!(!halves(Class::Side, 0, 0, true, &F).0.is_present(&F));
}

#[test]
fn solid_seen_from_inside_has_two_halves() {
    let (a, b) = halves(Class::Front, -500, 700, false, &F);
    assert_eq!((a.zf, a.zb, a.nb), (F.z_low(), -500, FACE_NEAR));
    assert_eq!((b.zf, b.zb, b.nf), (700, F.z_max(), FACE_FAR));
}
