use imogene_golden::format::Format;
use imogene_golden::machine::zone::beat::ID_ADDRESS;
use imogene_golden::machine::zone::decode::Registers;
use imogene_golden::object::load::load_words;
use imogene_golden::object::load_volume::load_volume;
use imogene_golden::object::quadric::{MAX_PLANES, PlaneWords, QuadricWords, ScreenBox};
use imogene_golden::object::volume::{VolumeKind, VolumePlane, VolumeQuadric, VolumeWords};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::normal::NormalWords;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use proptest::prelude::*;

fn linears() -> impl Strategy<Value = Linear> {
    any::<[i64; 3]>().prop_map(|v| {
        let [a, b, c] = v.map(i128::from);
        Linear::new(a, b, c)
    })
}

fn quadratics() -> impl Strategy<Value = Quadratic> {
    any::<[i64; 6]>().prop_map(|v| Quadratic::new(v.map(i128::from)))
}

fn boxes() -> impl Strategy<Value = ScreenBox> {
    let side = || 0i64..4096;
    (side(), side(), side(), side())
        .prop_map(|(x0, x1, y0, y1)| ScreenBox::of([x0, x1], [y0, y1]).or_empty())
}

fn formats() -> impl Strategy<Value = Format> {
    (
        prop_oneof![Just(16u32), Just(24), Just(28)],
        0u32..=8,
        0u32..=8,
    )
        .prop_map(|(w, g1, g2)| Format::new(w).unwrap().with_guards(g1, g2).unwrap())
}

proptest! {
    /// What is sent is what is held: the same words, as far as registers of their widths can tell them apart.
    #[test]
    fn objects_survive_the_stream(
        format in formats(), class_bits in 0u64..4, screen_box in boxes(), f1 in linears(), f2 in quadratics(),
        g in [linears(), linears(), linears()], k in any::<[i16; 3]>(), shift in 0u8..32,
        planes in prop::collection::vec((0u64..4, linears(), any::<[i16; 3]>()), 0..=MAX_PLANES)
    ) {
        let plane = |(kind, depth, normal)| PlaneWords { kind: PlaneKind::ALL[kind as usize], depth, normal };
        let words = QuadricWords {
            class: Class::ALL[class_bits as usize],
            screen_box,
            f1,
            f2,
            normal: NormalWords { g, k, shift },
            planes: planes.into_iter().map(plane).collect(),
        };
        let mut registers = Registers::of_object(words.planes.len());
        prop_assert!(!registers.take());
        for word in load_words(&words, &format, words.planes.len()) {
            prop_assert!(registers.write(word.address.into(), word.bits));
        }
        prop_assert!(registers.take() && !registers.take());
        let held = registers.object(&format);
        prop_assert_eq!(held.f2.preconditioned(format.pe2_width()), words.f2.preconditioned(format.pe2_width()));
        let wanted = QuadricWords { f2: held.f2, ..words.wrapped(&format) };
        prop_assert_eq!(held, wanted);
    }

    #[test]
    fn volumes_survive_the_stream(
        format in formats(), class_bits in 0u64..4, screen_box in boxes(), f1 in linears(), f2 in quadratics(),
        shift in 0u8..=8, margin in 0u32..1 << 15, source in 0u8..16, light in any::<bool>(),
        planes in prop::collection::vec((0u64..4, linears()), 0..=10)
    ) {
        let plane = |(kind, depth)| VolumePlane { kind: PlaneKind::ALL[kind as usize], depth };
        let words = VolumeWords {
            kind: if light { VolumeKind::Light } else { VolumeKind::Shadow },
            source,
            screen_box,
            margin,
            quadric: Some(VolumeQuadric { class: Class::ALL[class_bits as usize], f1, f2, shift }),
            planes: planes.into_iter().map(plane).collect(),
        };
        let mut registers = Registers::of_volume(words.planes.len());
        for word in load_volume(&words, &format, words.planes.len()) {
            prop_assert!(registers.write(word.address.into(), word.bits));
        }
        let held = registers.volume(&format);
        let [held_f2, f2] = [&held, &words].map(|w| w.quadric.expect("one").f2);
        prop_assert_eq!(held_f2.preconditioned(format.pe2_width()), f2.preconditioned(format.pe2_width()));
        let mut wanted = words.wrapped(&format);
        wanted.quadric.as_mut().expect("one").f2 = held_f2;
        prop_assert_eq!(held, wanted);
    }
}

#[test]
fn there_are_as_many_words_as_planes_need() {
    let mut registers = Registers::of_object(2);
    assert!(registers.write(37, 1) && !registers.write(38, 1));
    assert!(registers.write(ID_ADDRESS, 0x1fff) && registers.id() == 0xfff);
    let mut registers = Registers::of_volume(1);
    assert!(registers.write(16, 1) && !registers.write(17, 1));
    assert!(!registers.write(ID_ADDRESS, 1));
}
