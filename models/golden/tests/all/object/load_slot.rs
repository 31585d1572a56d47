use crate::common::*;
use imogene_contract::slots::FittedSlot;
use imogene_golden::object::curved_facet::CurvedFacetWords;
use imogene_golden::object::facet::FacetWords;
use imogene_golden::object::first_generation::{ContourPlane, FirstGenerationWords};
use imogene_golden::object::load_slot::load_slot;
use imogene_golden::object::polyhedron::PolyhedronWords;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::slots::required;

fn surface() -> QuadricWords {
    let back = PlaneWords::new(PlaneKind::Back, Linear::new(8, 9, 10), [11, 12, 13]);
    QuadricWords {
        class: Class::Patch,
        screen_box: ScreenBox::of([3, 9], [5, 7]),
        f1: Linear::new(-1, 2, 3),
        f2: Quadratic::new([-5, 7, 1, 10, 20, -1]),
        normal: NormalWords {
            g: [Linear::new(1, 2, 3); 3],
            k: [4, 5, 6],
            shift: 7,
        },
        planes: vec![back],
    }
}

fn bits(words: &ProcessorWords, planes: u32) -> Vec<u64> {
    let own = required(words).expect("a kind that has slots");
    let slot = FittedSlot { planes, ..own };
    let words = load_slot(words, &Format::BASE, &slot);
    let addresses = words.iter().map(|word| usize::from(word.address));
    assert!(addresses.eq(0..words.len()));
    assert_eq!(words.len(), slot.kind.words(planes as usize));
    assert_eq!((words[0].bits, words[1].bits), (3 | 9 << 12, 5 | 7 << 12));
    words.iter().map(|word| word.bits).collect()
}

/// The box, then the words of the ports in their order; what is not there cuts nothing.
#[test]
fn words_follow_the_ports_of_their_processor() {
    let words = bits(&ProcessorWords::Patch(surface()), 2);
    assert_eq!(words[11..24], [1, 2, 3, 1, 2, 3, 1, 2, 3, 4, 5, 6, 7]);
    assert_eq!(words[24..], [2, 8, 9, 10, 0, 0, 0, 0]);
    let screen_box = surface().screen_box;
    let solid = PolyhedronWords {
        screen_box,
        planes: surface().planes,
    };
    let words = bits(&ProcessorWords::Polyhedron(solid), 1);
    assert_eq!(words[2..], [2, 8, 9, 10, 11, 12, 13]);
    let facet = FacetWords {
        screen_box,
        edges: vec![Linear::new(1, 2, 3); 3],
        depth: Linear::new(4, 5, 6),
        normal: [Linear::new(7, 8, 9); 3],
    };
    let words = bits(&ProcessorWords::Facet(facet), 4);
    assert_eq!(words[8..17], [1, 2, 3, 0, 0, 0, 4, 5, 6]);
    let curved = CurvedFacetWords {
        screen_box,
        sides: vec![],
        depth: Quadratic::new([0, 0, 0, 0, 0, 17]),
        normal: [Quadratic::default(); 3],
    };
    let words = bits(&ProcessorWords::CurvedFacet(curved), 1);
    assert_eq!((words[2..8].iter().sum::<u64>(), words[13]), (0, 17));
    let plane = |first: i128| ContourPlane {
        depth: Linear::new(first, 0, 0),
        polar: Linear::new(first + 1, 0, 0),
        normal: [first as i16 + 2, 0, 0],
        ..ContourPlane::default()
    };
    let QuadricWords { f1, f2, normal, .. } = surface();
    let first = FirstGenerationWords {
        patch: true,
        screen_box,
        f1,
        f2,
        normal,
        front: plane(20),
        back: plane(30),
    };
    let words = bits(&ProcessorWords::FirstGeneration(first), 0);
    let places = [24, 25, 28, 43, 46, 49].map(|place| words[place]);
    assert_eq!((places, words.len()), ([1, 20, 30, 21, 31, 22], 52));
}
