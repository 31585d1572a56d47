use imogene_contract::MachineWords;
use imogene_contract::object::Kind;
use imogene_contract::slots::{FittedSlot, Products, Slots, parse, print};

#[test]
fn products_and_text_are_each_other() {
    let products = Products::try_from("2-1,1-16".to_owned()).unwrap();
    let second = &products.0[1];
    assert_eq!((second.intersected, second.subtracted), (1, 16));
    assert_eq!(String::from(products), "2-1,1-16");
    for text in ["", "2", "0-1", "1-17", "1-2-3", "a-1"] {
        let error = Products::try_from(text.to_owned()).unwrap_err();
        assert!(error.to_string().contains("2-1,1-3"), "{text}");
    }
}

#[test]
fn the_longer_word_is_for_both() {
    let slot = |root, plane| FittedSlot {
        root,
        plane,
        ..FittedSlot::quadric(2)
    };
    let (short, long) = (slot(Some(10), Some(20)), slot(Some(12), None));
    assert_eq!(short.or(&long), slot(Some(12), None));
    // Slots without words of their own have those of the machine, the longest of all.
    assert_eq!(FittedSlot::quadric(2).or(&short), FittedSlot::quadric(2));
    let machine = MachineWords {
        root: 12,
        dropped_rows: 7,
        ..MachineWords::of(16)
    };
    let own = MachineWords {
        root: 10,
        plane: 20,
        ..machine
    };
    assert_eq!(short.words(&machine), own);
    let quadric = FittedSlot::quadric(2);
    assert_eq!(quadric.in_words(&own, &machine), short);
    assert_eq!(quadric.in_words(&machine, &machine), quadric);
    let refused = |slot: FittedSlot| {
        let found = slot.refused(&machine);
        found.map(|(_, _, least, most)| (least, most))
    };
    assert_eq!(refused(short), None);
    assert_eq!(refused(slot(Some(7), None)), Some((8, 12)));
    assert_eq!(refused(slot(Some(13), None)), Some((8, 12)));
    assert_eq!(refused(slot(None, Some(29))), Some((16, 28)));
    let sphere = FittedSlot {
        root: Some(10),
        ..FittedSlot::of(Kind::Sphere, 0)
    };
    assert!(sphere.refused(&machine).is_some());
}

#[test]
fn text_and_slots_are_each_other() {
    let planes = |text: &str| parse(text).map(|slots| print(&slots));
    assert_eq!(parse("3,0,12").unwrap()[2], FittedSlot::quadric(12));
    // Files of before have a v behind some.
    assert_eq!(planes("3,0v,12v").unwrap(), "3,0,12");
    let kinds =
        "3,patch2,polyhedron6,facet3,curved_facet1,sphere,cylinder,first_generation,quotient2";
    let slots: Slots = kinds.to_owned().try_into().unwrap();
    assert_eq!((slots.0[1].kind, slots.0[1].planes), (Kind::Patch, 2));
    assert_eq!(String::from(slots), kinds);
    let short = "3:r14:p20,patch2:r9,0:p16";
    let slots: Slots = short.to_owned().try_into().unwrap();
    assert_eq!((slots.0[0].root, slots.0[0].plane), (Some(14), Some(20)));
    assert_eq!((slots.0[1].root, slots.0[1].plane), (Some(9), None));
    assert_eq!(String::from(slots), short);
    // Equal ones are counted from four on.
    assert_eq!(
        planes("2,3x2:r9,250xfacet3").unwrap(),
        "2,2:r9,2:r9,2:r9,250xfacet3"
    );
    assert_eq!(planes("3x1,1,sphere").unwrap(), "4x1,sphere");
    for text in "sphere1 facet2 patch patch13 torus polyhedron0".split(' ') {
        let error = Slots::try_from(text.to_owned()).unwrap_err();
        assert!(error.to_string().contains("curved_facet2"), "{text}");
    }
    let wrong = "3, v 13 -1 2w 2: 2:r 2:x3 2:r3:r3 r3 0x3 257x3 x3 2x 2x2x2";
    for text in wrong.split(' ').chain([""]) {
        assert!(parse(text).unwrap_err().to_string().contains("3,0,2:"));
    }
}
