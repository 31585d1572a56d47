use crate::common::*;
use imogene_golden::object::patch::{at, latency};

fn words() -> impl Strategy<Value = QuadricWords> {
    let plane = (kind(), linear(40, 800));
    let plane = plane.prop_map(|(kind, depth)| PlaneWords::new(kind, depth, [1, 2, 3]));
    // Radii and depths of the size of the zone, so that planes, roots and ends meet at many pixels.
    let f2 = (-900i128..=60, -900i128..=60, 0i128..200_000);
    let g = || linear(9000, 180_000);
    let normal = ([g(), g(), g()], any::<[i16; 3]>(), 0u8..4);
    let planes = prop::collection::vec(plane, 0..=5);
    let parts = (linear(40, 800), f2, normal, planes);
    parts.prop_map(|(f1, (a, b, f), (g, k, shift), planes)| QuadricWords {
        class: Class::Patch,
        screen_box: ScreenBox::of([1, SIDE - 2], [0, SIDE - 3]),
        f1,
        f2: bowl(a, b, f),
        normal: NormalWords { g, k, shift },
        planes,
    })
}

/// The words of a patch, moved in depth to an end of the word.
fn moved(mut words: QuadricWords, by: i128) -> QuadricWords {
    words.f1.c += by;
    for plane in &mut words.planes {
        if plane.kind != PlaneKind::Perpendicular {
            plane.depth.c += by;
        }
    }
    words
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn hands_on_what_the_quadric_processor_does(
        words in words(), depth in prop_oneof![Just(16u32), Just(24)], end in -1i128..=1
    ) {
        let format = Format::new(depth).unwrap();
        let words = moved(words, end * i128::from(format.z_max()));
        for (x, y) in pixels() {
            prop_assert_eq!(at(&words, x, y, &format), words.at(x, y, &format), "pixel ({}, {})", x, y);
        }
    }
}

#[test]
fn planes_do_not_lengthen_the_pipeline() {
    let format = Format::BASE;
    assert_eq!((latency(&format, 1), latency(&format, 2)), (33, 21));
}

/// The cut cylinder of the restatement of the source (6.7), its column for patches; format 24.
#[test]
fn cut_cylinder_of_the_specification() {
    let plane = |kind, depth| PlaneWords::new(kind, depth, [0; 3]);
    let words = QuadricWords {
        class: Class::Patch,
        screen_box: ScreenBox::of([0, 719], [0, 539]),
        f1: Linear::new(0, 0, 1_897_423),
        f2: Quadratic::new([-41_886_147, 0, 0, 30_158_026_029, 0, -5_179_122_380_046]),
        normal: NormalWords::default(),
        planes: vec![
            plane(PlaneKind::Front, Linear::new(0, 0, 1_677_721)),
            plane(PlaneKind::Back, Linear::new(0, -104_858, 36_700_156)),
            plane(PlaneKind::Back, Linear::new(0, 104_858, -19_922_942)),
        ],
    };
    let zmax = Format::BASE.z_max();
    let expected = [
        ((360, 270), 2_396_744, 1),
        ((400, 270), 2_324_394, 1),
        ((360, 330), zmax, 0),
        ((360, 337), zmax, 0),
        ((430, 270), 1_687_471, 0),
        ((435, 270), 1_780_322, 0),
        ((440, 270), zmax, 0),
    ];
    for ((x, y), zf, number) in expected {
        let pixel = at(&words, x, y, &Format::BASE);
        assert_eq!((pixel.zf, pixel.number), (zf, number), "pixel ({x}, {y})");
    }
}
