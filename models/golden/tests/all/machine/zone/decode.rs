use crate::common::*;
use imogene_contract::object::{KINDS, Kind};
use imogene_contract::slots::FittedSlot;
use imogene_golden::machine::zone::beat::OBJECT_ID;
use imogene_golden::machine::zone::decode::Registers;
use imogene_golden::object::load::load_words;
use imogene_golden::object::load_slot::load_slot;
use imogene_golden::object::load_volume::load_volume;
use imogene_golden::object::quadric::MAX_PLANES;
use imogene_golden::object::slot::ProcessorWords;

fn boxes() -> impl Strategy<Value = ScreenBox> {
    let ends = [0i64..4096, 0..4096, 0..4096, 0..4096];
    ends.prop_map(|[x0, x1, y0, y1]| ScreenBox::of([x0, x1], [y0, y1]).or_empty())
}

fn formats() -> impl Strategy<Value = Format> {
    let depth = prop_oneof![Just(16u32), Just(24), Just(28)];
    let widths = (depth, 0u32..=8, 0u32..=8);
    widths.prop_map(|(w, g1, g2)| Format::new(w).unwrap().with_guards(g1, g2).unwrap())
}

proptest! {
    /// What is sent is what is held: the same words, as far as registers of their widths can tell them apart.
    #[test]
    fn objects_survive_the_stream(
        format in formats(), class_bits in 0u64..4, screen_box in boxes(), f1 in any_linear(), f2 in any_quadratic(),
        g in [any_linear(), any_linear(), any_linear()], k in any::<[i16; 3]>(), shift in 0u8..32,
        planes in prop::collection::vec((0u64..4, any_linear(), any::<[i16; 3]>()), 0..=MAX_PLANES)
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
        let mut registers = Registers::of_object(&FittedSlot::quadric(words.planes.len() as u32));
        prop_assert!(!registers.take());
        for word in load_words(&words, &format, words.planes.len()) {
            prop_assert!(registers.write(word.address.into(), word.bits));
        }
        prop_assert!(registers.take() && !registers.take());
        let ProcessorWords::Quadric(held) = registers.object(&format) else {
            panic!("a quadric")
        };
        prop_assert_eq!(held.f2.preconditioned(format.pe2_width()), words.f2.preconditioned(format.pe2_width()));
        let wanted = QuadricWords { f2: held.f2, ..words.wrapped(&format) };
        prop_assert_eq!(held, wanted);
    }

    #[test]
    fn volumes_survive_the_stream(
        format in formats(), class_bits in 0u64..4, screen_box in boxes(), f1 in any_linear(), f2 in any_quadratic(),
        shift in 0u8..=8, margin in 0u32..1 << 15, source in 0u8..16, light in any::<bool>(),
        planes in prop::collection::vec((0u64..4, any_linear()), 0..=10)
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

/// Registers of a slot with these words, of which as many bits count as there are.
fn written(slot: &FittedSlot, words: &[u64]) -> Registers {
    let mut registers = Registers::of_object(slot);
    for (address, word) in (0..).zip(words) {
        assert!(registers.write(address, *word), "{slot}: word {address}");
    }
    assert!(!registers.write(words.len() as u16, 0), "{slot}");
    registers
}

proptest! {
    /// Every bit of every word of every kind means something: what is decoded is sent again as the same words.
    #[test]
    fn every_kind_survives_the_stream(
        format in formats(), seed in any::<[u64; 16]>(), (x0, y0) in (0u64..4000, 0u64..4000), more in 0u32..8
    ) {
        for (kind, _, [least, most]) in KINDS {
            let slot = FittedSlot::of(kind, (least + more).min(most));
            let count = kind.words(slot.planes as usize);
            let sent = |words: &[u64]| load_slot(&written(&slot, words).object(&format), &format, &slot);
            let widths: Vec<u32> = sent(&vec![0; count]).iter().map(|word| word.width).collect();
            let mut words: Vec<u64> = (0u64..).zip(&widths).map(|(address, width)| {
                let place = address as usize;
                let random = seed[place % 16].rotate_left(place as u32).wrapping_mul(2 * address + 1);
                // Of second differences the lowest bit is 0.
                let even = if *width > 7 { !1 } else { !0 };
                random & even & (u64::MAX >> (64 - width))
            }).collect();
            let columns = kind.box_columns() as usize;
            words[columns] = x0 | (x0 + 95) << 12;
            words[columns + 1] = y0 | (y0 + 3) << 12;
            let bits: Vec<u64> = sent(&words).iter().map(|word| word.bits).collect();
            prop_assert_eq!(&bits, &words, "{}", slot);
        }
    }
}

#[test]
fn a_shared_processor_has_an_object_once_its_word_is_written() {
    for (kind, _, [least, _]) in KINDS {
        let mut registers = Registers::of_object(&FittedSlot::of(kind, least));
        let tells = if kind == Kind::Quadric { 23 } else { 0 };
        for address in 0..kind.words(least as usize) as u16 {
            assert!(registers.write(address, 0));
            assert_eq!(registers.take(), address == tells, "{kind:?}: {address}");
        }
    }
}

#[test]
fn there_are_as_many_words_as_planes_need() {
    let mut registers = Registers::of_object(&FittedSlot::quadric(2));
    assert!(registers.write(37, 1) && !registers.write(38, 1));
    assert!(registers.write(OBJECT_ID, 0x1fff) && registers.id() == 0xfff);
    let mut registers = Registers::of_volume(1);
    assert!(registers.write(16, 1) && !registers.write(17, 1));
    assert!(!registers.write(OBJECT_ID, 1));
}
