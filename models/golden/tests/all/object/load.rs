use crate::common::*;
use imogene_golden::object::load::load_words;

#[test]
fn words_stand_at_their_addresses() {
    let words = QuadricWords {
        class: Class::Patch,
        screen_box: ScreenBox::of([3, 9], [5, 7]),
        f1: Linear::new(-1, 2, 3),
        f2: Quadratic::new([-5, 7, 1, 10, 20, -1]),
        normal: Default::default(),
        planes: vec![],
    };
    let list = load_words(&words, &Format::BASE, 1);
    assert_eq!(list.len(), 31);
    assert_eq!(list[0].bits, (1 << 26) - 1);
    let f2: Vec<u64> = list[3..9].iter().map(|w| w.bits).collect();
    let all = (1u64 << 48) - 1;
    assert_eq!(f2, [all - 9, 14, 1, 27, 5, all]);
    assert_eq!(list[21].bits, 3 | 9 << 12);
    assert_eq!(list[22].bits, 5 | 7 << 12);
    assert_eq!(list[23].bits, 2);
    assert_eq!((list[24].bits, list[24].width), (0, 2));

    let guarded = Format::BASE.with_guards(3, 4).unwrap();
    let list = load_words(&words, &guarded, 1);
    assert_eq!((list[0].bits, list[0].width), ((1 << 29) - 1, 29));
    assert_eq!((list[8].bits, list[8].width), ((1 << 52) - 1, 52));
    assert_eq!((list[9].width, list[24].width), (24, 2));
}
