use crate::common::*;
use imogene_golden::object::as_quadric::AsQuadricError;
use imogene_golden::object::facet::FacetWords;
use imogene_golden::object::polyhedron::PolyhedronWords;
use imogene_golden::object::slot::ProcessorWords;

const BOX: ScreenBox = ScreenBox::of([2, SIDE - 1], [1, SIDE - 3]);

/// Every pixel of an object beside that of a quadric processor of `planes` planes that draws it; at how many it is.
fn compare(
    object: &ProcessorWords,
    format: &Format,
    planes: usize,
    same: impl Fn(&ObjectPixel, &ObjectPixel) -> bool,
) -> Result<usize, TestCaseError> {
    let quadric = object.on_quadric_processor(format, planes);
    let quadric = quadric.expect("enough planes and guard bits");
    let mut present = 0;
    for (x, y) in pixels() {
        let (got, wanted) = (quadric.at(x, y, format), object.at(x, y, format));
        prop_assert!(same(&got, &wanted), "({x}, {y}): {got:?}, not {wanted:?}");
        present += usize::from(got.zf != format.z_max());
    }
    Ok(present)
}

fn facet_words(format: &Format) -> impl Strategy<Value = FacetWords> + use<> {
    let end = i128::from(format.z_max() << 10);
    let about =
        |end: i128| linear(1 << 14, 1 << 16).prop_map(move |l| Linear::new(l.a, l.b, l.c + end));
    let depth = prop_oneof![
        linear(3000, 1 << 20),
        about(end),
        about(-end),
        // Past the end of the accumulator: both wrap alike.
        linear(i64::MAX >> 20, i64::MAX >> 20),
    ];
    let normal = || linear(1 << 19, 1 << 24);
    let edges = prop::collection::vec(linear(40, 600), 3..=4);
    (edges, depth, [normal(), normal(), normal()]).prop_map(|(edges, depth, normal)| FacetWords {
        screen_box: BOX,
        edges,
        depth,
        normal,
    })
}

fn check_facet(words: &FacetWords, format: &Format) -> Result<usize, TestCaseError> {
    let facet = ProcessorWords::Facet(words.clone());
    // All but the number of the face.
    let seen = |pixel: &ObjectPixel| (pixel.zf, pixel.zb, pixel.normal);
    compare(&facet, format, 4, |a, b| seen(a) == seen(b))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn facets_with_all_guard_bits_are_the_same(
        words in facet_words(&Format::BASE), guards in 10u32..=16
    ) {
        check_facet(&words, &Format::BASE.with_guards(guards, 0).unwrap())?;
    }

    /// Without guard bits where the increments are whole depth words, whatever the constant.
    #[test]
    fn facets_with_fewer_places_need_fewer_guard_bits(
        mut words in facet_words(&Format::BASE), guards in 0u32..10
    ) {
        let format = Format::BASE.with_guards(guards, 0).unwrap();
        words.depth.a <<= 10 - guards;
        words.depth.b <<= 10 - guards;
        check_facet(&words, &format)?;
        if let Some(fewer) = guards.checked_sub(1) {
            words.depth.a |= 1 << (10 - guards);
            let format = Format::BASE.with_guards(fewer, 0).unwrap();
            prop_assert_eq!(
                ProcessorWords::Facet(words).on_quadric_processor(&format, 4),
                Err(AsQuadricError::GuardBits(guards, fewer))
            );
        }
    }

    /// A patch processor reads no class; its words may have any.
    #[test]
    fn patches_are_the_same(
        class in class(),
        f1 in linear(60, 900), (a, b) in (-900i128..=60, -900i128..=60), f in 0i128..200_000,
        g in [linear(9000, 1 << 22), linear(9000, 1 << 22), linear(9000, 1 << 22)], k in any::<[i16; 3]>(),
        planes in prop::collection::vec((kind(), linear(40, 900), any::<[i16; 3]>()), 0..=5)
    ) {
        let plane = |(kind, depth, normal)| PlaneWords::new(kind, depth, normal);
        let words = QuadricWords {
            class,
            screen_box: BOX,
            f1,
            f2: bowl(a, b, f),
            normal: NormalWords { g, k, shift: 1 },
            planes: planes.into_iter().map(plane).collect(),
        };
        compare(&ProcessorWords::Patch(words), &Format::BASE, 5, |a, b| a == b)?;
    }

    #[test]
    fn polyhedra_are_the_same(
        planes in prop::collection::vec((kind(), linear(30, 900), any::<[i16; 3]>()), 1..=12), end in -1i64..=1
    ) {
        let format = Format::BASE;
        let shifted = |kind, l: Linear| match kind {
            PlaneKind::Perpendicular => l,
            _ => Linear { c: l.c + i128::from(end * format.z_max()), ..l },
        };
        let plane = |(kind, l, normal)| PlaneWords { kind, depth: shifted(kind, l), normal };
        let words = PolyhedronWords {
            screen_box: BOX,
            planes: planes.into_iter().map(plane).collect(),
        };
        // An absent object is absent, whatever face it lost last.
        let absent = format.z_max();
        let same = |a: &ObjectPixel, b: &ObjectPixel| a == b || (a.zf, b.zf) == (absent, absent);
        compare(&ProcessorWords::Polyhedron(words), &format, 12, same)?;
    }

    #[test]
    fn volumes_of_planes_are_the_same(
        planes in prop::collection::vec((kind(), linear(30, 900)), 0..=10), margin in 0u32..200,
        depths in prop::collection::vec(-1500i64..1500, 20)
    ) {
        let format = Format::BASE;
        let words = VolumeWords {
            kind: VolumeKind::Shadow,
            source: 1,
            screen_box: BOX,
            margin,
            quadric: None,
            planes: planes.into_iter().map(|(kind, depth)| VolumePlane { kind, depth }).collect(),
        };
        let quadric = words.on_quadric_processor(10).expect("ten planes");
        for (x, y) in pixels() {
            let [ours, theirs] = [&quadric, &words].map(|w| w.holds(x, y, depths[x as usize], &format));
            prop_assert_eq!(ours, theirs);
        }
    }
}

#[test]
fn a_facet_is_there_where_it_should_be() {
    let format = Format::BASE.with_guards(10, 0).unwrap();
    let edges = [[1, 0, -4], [0, 1, -5], [-1, -1, 30]];
    let words = FacetWords {
        screen_box: BOX,
        edges: edges.map(|[a, b, c]| Linear::new(a, b, c)).to_vec(),
        depth: Linear::new(1500, -700, 123_456),
        normal: [Linear::new(5000, 0, 1 << 20); 3],
    };
    let present = check_facet(&words, &format).expect("the same");
    let lines = (5..=17).map(|y| (30 - y).min(19) - 4 + 1);
    assert_eq!(present, lines.sum());
}

#[test]
fn what_has_no_equal_is_refused_by_name() {
    let (screen_box, planes) = (BOX, vec![PlaneWords::default(); 3]);
    let words = ProcessorWords::Polyhedron(PolyhedronWords { screen_box, planes });
    let refused = words.on_quadric_processor(&Format::BASE, 2).unwrap_err();
    assert_eq!(refused.to_string(), "needs 3 planes; the processor has 2");
    let fitted = fitted(|widths| widths.plane -= 3);
    let facet = ProcessorWords::Facet(FacetWords {
        screen_box: BOX,
        edges: vec![Linear::default(); 3],
        depth: Linear::default(),
        normal: Default::default(),
    });
    let refused = facet.on_quadric_processor(&fitted, 4);
    assert_eq!(refused, Err(AsQuadricError::Fitted));
}
