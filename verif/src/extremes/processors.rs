//! Extremes of the object processors beside the quadric processor, of the volumes, and of the elementary processors
//! with a mode or a memory: each configuration is a zone of one pixel, its words held until the result is out.

use super::units::{ends, every, inputs};
use super::{Extreme, driven};
use crate::subject::{Inputs, Subject};
use imogene_contract::Unit;

#[rustfmt::skip]
pub const CASES: &[Extreme] = &[
    driven("17.6", "patch-ties", Unit::PatchDecider, patch_ties,
        "Both roots and all planes at the same depth, one word beside it, and at both ends of the word: a face in a plane stays, a face past an end is none, the near face goes before the far one."),
    driven("17.6", "first-generation-contours-at-zero", Unit::FirstGenerationProcessor, contours_at_zero,
        "Conics and polar lines at 0, -1 and both ends of their words: zero is inside the quadric and on the kept side, so that a plane exactly at a root is the face of a solid and has removed that root of a surface."),
    driven("17.5", "polyhedron-without-thickness", Unit::PolyhedronProcessor, without_thickness,
        "Two planes of opposite sense at the same depth, one word apart either way, at both ends and beyond them, and perpendicular planes of 0 and -1: no thickness is there, less is absent."),
    driven("13.8", "facet-sides-at-zero", Unit::FacetProcessor, facet_sides,
        "Sides of 0, -1 and both ends of their words, depths at and beside both ends of the depth word: zero is inside, and a facet past an end is absent."),
    driven("13.8", "curved-sides-at-zero", Unit::CurvedFacetProcessor, curved_sides,
        "The same with sides and depth of second degree."),
    driven("17.4", "sphere-past-the-ends", Unit::SphereProcessor, sphere_depths,
        "Front and back depth at and beside both ends of the depth word, the outline at 0 and -1: one pixel is drawn on the outline itself, a cap where the front is past the near end, nothing where all of it is beyond."),
    driven("17.6", "cylinder-parts-tied", Unit::CylinderProcessor, cylinder_parts,
        "Sides and discs at 0 and -1 in every combination: the front disc goes before the body, and a pixel in none of the parts is absent."),
    driven("17.14", "volume-begins-at-the-point", Unit::QuadricVolume, volume_ties,
        "The visible point at the beginning and the end of a volume and one word beside them, with margins from 0 to half the depth word and units of depth from 1 to 256 words, in all four classes: the margin opens the beginning, the end stays closed, the background is in no volume."),
    driven("17.5", "volume-planes-past-the-depth-word", Unit::PolyhedralVolume, volume_planes,
        "Planes of a volume at the ends of their 36 bits and beside the point, of every kind: they are compared in full, without a clamp."),
    driven("17.12", "carry-at-the-middle", Unit::ProgrammablePe, carries,
        "Low halves of all ones in every word: split, no carry reaches the high half, and the four lanes wrap by themselves; whole, it does."),
    driven("17.12", "fields-in-any-order", Unit::MemoryPe2, fields,
        "The odd field twice, then the even one, then the odd one again, on the greatest and least words: every field begins with the words as they were loaded."),
];

/// The far end of the base format.
const FAR: i64 = (1 << 23) - 1;

/// A depth and its neighbours, and both ends of the depth word and theirs.
pub(super) const DEPTHS: [i64; 11] = [
    -FAR - 2,
    -FAR - 1,
    -FAR,
    -FAR + 1,
    -1,
    0,
    1,
    FAR - 1,
    FAR,
    FAR + 1,
    FAR + 2,
];

/// Zero, what is next to it, and both ends of the words of a polynomial of first degree.
const LINES: [i64; 4] = [-(1 << 35), -1, 0, (1 << 35) - 1];
/// The same of second degree.
const CONICS: [i64; 4] = [-(1 << 47), -1, 0, (1 << 47) - 1];

/// One pixel with these words, which stay until its result is out.
fn pixel(subject: &Subject, words: &[(&str, i64)]) -> Vec<Inputs> {
    let with = |flags: &[(&str, i64)]| inputs(subject, &[flags, words].concat());
    let mut clocks = vec![with(&[]); 1 + subject.latency];
    clocks[0] = with(&[("valid", 1), ("start", 1)]);
    clocks
}

/// A pixel for each combination of values.
fn pixels<const N: usize, const M: usize>(
    subject: &Subject,
    lists: [&[i64]; N],
    words: impl Fn([i64; N]) -> [(&'static str, i64); M],
) -> Vec<Inputs> {
    let all = every(lists);
    all.flat_map(|values| pixel(subject, &words(values)))
        .collect()
}

fn patch_ties(subject: &Subject) -> Vec<Inputs> {
    let kinds = [[1, 1], [1, 2], [2, 2], [3, 1], [0, 2]];
    // Without those that leave the word.
    let planes = &DEPTHS[1..9];
    let all = every([&DEPTHS, &DEPTHS, planes, &[0, 1, 2, 3, 4]]);
    let ordered = all.filter(|[near, far, ..]| near <= far);
    let one = |[near, far, plane, pair]: [i64; 4]| {
        let [first, second] = kinds[pair as usize];
        let set = [
            ("near_sum", near),
            ("far_sum", far),
            ("is_inside", 1),
            ("in_box", 1),
            ("plane_0_zp", plane),
            ("plane_1_zp", near.clamp(-FAR - 1, FAR)),
            ("plane_0_kind", first),
            ("plane_1_kind", second),
        ];
        inputs(subject, &set)
    };
    let rest = std::iter::repeat_n(inputs(subject, &[]), subject.latency);
    ordered.map(one).chain(rest).collect()
}

fn contours_at_zero(subject: &Subject) -> Vec<Inputs> {
    let lists = [&[0, 1][..], &CONICS, &CONICS, &LINES];
    pixels(subject, lists, |[surface, front, back, polar]| {
        [
            ("surface", surface),
            ("f2_f", 25),
            ("conic_0_f", front),
            ("conic_1_f", back),
            ("polar_0_c", polar),
            ("polar_1_c", -1 - polar),
            ("depth_0_c", -5),
            ("depth_1_c", 5),
            ("plane_0_nz", -7),
        ]
    })
}

fn without_thickness(subject: &Subject) -> Vec<Inputs> {
    let lists = [&DEPTHS[..], &[-1, 0, 1], &[-1, 0]];
    pixels(subject, lists, |[depth, gap, half_plane]| {
        [
            ("plane_0_kind", 1),
            ("plane_0_c", depth),
            ("plane_1_kind", 2),
            ("plane_1_c", depth + gap),
            ("plane_2_kind", 3),
            ("plane_2_c", half_plane),
            ("plane_0_nz", -1),
            ("plane_1_nz", 1),
        ]
    })
}

/// Units of a first-degree depth below the depth word.
const PLANE_GUARD: i64 = 1 << 10;
/// Units of a second-degree depth below the depth word.
const BULGE_GUARD: i64 = 1 << 22;

fn facet_sides(subject: &Subject) -> Vec<Inputs> {
    let names = ["side_0_c", "side_1_c", "depth_c"];
    sides_and_depths(subject, &LINES, names, PLANE_GUARD)
}

fn curved_sides(subject: &Subject) -> Vec<Inputs> {
    let names = ["side_0_f", "side_1_f", "depth_f"];
    sides_and_depths(subject, &CONICS, names, BULGE_GUARD)
}

fn sides_and_depths(
    subject: &Subject,
    values: &[i64],
    [side_0, side_1, depth]: [&'static str; 3],
    guard: i64,
) -> Vec<Inputs> {
    // The last unit below the next word as well: depths are rounded down.
    let rests = [0, guard - 1];
    let lists = [&DEPTHS[..], &rests, values, &[-1, 0]];
    pixels(subject, lists, |[z, rest, first, second]| {
        let sides = [(side_0, first), (side_1, second)];
        [sides[0], sides[1], (depth, z * guard + rest)]
    })
}

fn sphere_depths(subject: &Subject) -> Vec<Inputs> {
    let lists = [&DEPTHS[..], &DEPTHS, &[-1, 0]];
    pixels(subject, lists, |[near, far, outline]| {
        [
            ("outline_f", outline),
            ("front_f", near * BULGE_GUARD),
            ("depth_sum", near + far),
            ("nz_f", -(1 << 47)),
        ]
    })
}

fn cylinder_parts(subject: &Subject) -> Vec<Inputs> {
    let lists = [&[0, -1][..]; 6];
    pixels(subject, lists, |[disc_1, disc_0, sides @ ..]| {
        [
            ("side_0_c", sides[3]),
            ("side_1_c", sides[2]),
            ("side_2_c", sides[1]),
            ("side_3_c", sides[0]),
            ("disc_0_f", disc_0),
            ("disc_1_f", disc_1),
            ("body_f", -(1 << 46)),
            ("lid_c", 1 << 20),
            ("lid_nz", -9),
        ]
    })
}

fn volume_ties(subject: &Subject) -> Vec<Inputs> {
    let names = ["object_class", "depth", "margin", "depth_shift", "f2_f"];
    let depths = [-FAR, -4, -3, -2, 0, 2, 3, 4, FAR - 1, FAR];
    let margins = [0, 1, 5, FAR];
    let lists = [
        &[0, 1, 2, 3][..],
        &depths,
        &margins,
        &[0, 1, 8],
        &[-1, 0, 9],
    ];
    pixels(subject, lists, |values| {
        std::array::from_fn::<_, 5, _>(|k| (names[k], values[k]))
    })
}

fn volume_planes(subject: &Subject) -> Vec<Inputs> {
    let plane = subject.inputs.iter().find(|port| port.name == "plane_0_c");
    let words = ends(plane.expect("a volume has planes"));
    let depths = [-FAR, -1, 0, 1, FAR - 1, FAR];
    let one = |[depth, margin, kind]: [i64; 3]| {
        let places = words.into_iter().chain([depth - 1, depth, depth + 1]);
        places.flat_map(move |at| {
            let point = [("depth", depth), ("margin", margin)];
            let plane = [("plane_0_kind", kind), ("plane_0_c", at)];
            pixel(subject, &[point, plane].concat())
        })
    };
    let all = every([&depths, &[0, 1, FAR], &[0, 1, 2, 3]]);
    all.flat_map(one).collect()
}

fn carries(subject: &Subject) -> Vec<Inputs> {
    let low = (1i64 << 24) - 1;
    let mut list = Vec::new();
    for split in 0..2 {
        for high in [0, -1, 1 << 22] {
            let word = high << 24 | low;
            let names = ["a2", "b2", "c", "i0", "p0", "f"];
            let mut words: Vec<(&str, i64)> = names.map(|name| (name, word)).to_vec();
            words.extend([("split", split), ("used", 15)]);
            let with = |flags: &[(&str, i64)]| inputs(subject, &[flags, &words].concat());
            list.push(with(&[("valid", 1), ("start", 1)]));
            for _ in 0..4 {
                list.extend(std::iter::repeat_n(with(&[("valid", 1)]), 4));
                list.push(with(&[("valid", 1), ("line", 1)]));
            }
        }
    }
    list
}

fn fields(subject: &Subject) -> Vec<Inputs> {
    let half = 1i64 << 47;
    let words = [-half, half - 2, -half, half - 1, -half, half - 1];
    let mut list: Vec<Inputs> = vec![];
    for (address, word) in (0..).zip((0..6).chain([3, 4, 5])) {
        let load = [("load_valid", 1), ("load_address", address)];
        let data = [("load_data", words[word])];
        list.push(inputs(subject, &[&load[..], &data].concat()));
    }
    for odd in [1, 1, 0, 1] {
        list.push(inputs(subject, &[("field_start", 1), ("odd_field", odd)]));
        list.extend(std::iter::repeat_n(inputs(subject, &[]), 5));
        for _ in 0..3 {
            list.push(inputs(subject, &[("line_start", 1)]));
            // Long enough for two steps; a field's first line may take one.
            list.extend(std::iter::repeat_n(inputs(subject, &[]), 26));
            list.extend(std::iter::repeat_n(inputs(subject, &[("pixel", 1)]), 4));
        }
    }
    list
}
