//! Extremes of single units: the words themselves at their ends. Each configuration of an object processor, a volume or
//! an elementary processor with a mode or a memory is a zone of one pixel, its words held until the result is out.

use super::{Extreme, driven};
use crate::signal::Signal;
use crate::subject::{Inputs, Subject};
use imogene_contract::Unit;

#[rustfmt::skip]
pub const CASES: &[Extreme] = &[
    driven("17.3", "f2-at-the-ends-of-its-word", Unit::QuadricPe, f2_ends,
        "f2 = 0, 1, 2^47 - 1: inside, with the roots 0, 1 and 11863283; f2 = -1, -2^47: outside. Presence is the sign bit, so that zero is inside."),
    driven("17.10", "smallest-radicands", Unit::SquareRootLinear, |s| radicands(s, 0..16),
        "Radicands 0 to 15 in the piecewise linear root: the floors of short words take over from the percentages; hardware and golden model floor at the same places."),
    driven("17.10", "radicands-at-powers-of-four", Unit::SquareRootQuadratic, |s| radicands(s, powers(48).chain([(1 << 48) - 1])),
        "4^m - 1, 4^m, 4^m + 1 and the same of 2 * 4^m, up to the top bit: the places where the pair of octaves of an approximation changes."),
    driven("17.10", "squares-and-their-neighbours", Unit::SquareRoot, squares,
        "n^2 - 1, n^2, n^2 + 2n at both ends of the root and at every power of two: the only places where floor(sqrt) can step wrongly."),
    driven("17.6", "plane-ties", Unit::CutPlane, plane_ties,
        "zp = zf, zp = zb, zf = zb, all three equal, at both ends of the word, for every kind of plane: the tests are closed, so a face in the plane stays."),
    driven("17.5", "plane-slope-of-one", Unit::PlaneDepth, plane_slopes,
        "A plane of slope 0, +1 and -1 of the last place: depth steps by exactly one word a pixel through zero."),
    driven("17.5", "plane-past-its-word", Unit::PlaneDepth, plane_past_its_word,
        "A plane whose depth runs over both ends of the depth word: it is clamped one below the near end and at the far end, its sign kept, so that it removes all or nothing instead of wrapping."),
    driven("17.12", "lines-after-the-last", Unit::Pe2, lines_after_the_last,
        "Line steps after the last line of a zone go on with the polynomial modulo 2^48: nothing but a start loads anew."),
    driven("17.15", "normal-without-length", Unit::NormalUnit, normal_words,
        "K = 0 and g = 0 on every component, at every root: the normal is (0, 0, 0), an apex; with the greatest negative words the sum wraps as stated and nothing else happens."),
    driven("17.4", "roots-past-the-depth-word", Unit::QuadricCut, past_the_depth_word,
        "f1 - r and f1 + r at and beside both ends of the depth word in all four classes: clamped where a solid reaches past an end, absent where all of it lies beyond."),
    driven("17.6", "patch-ties", Unit::PatchDecider, patch_ties,
        "Both roots and all planes at the same depth, one word beside it, and at both ends of the word: a face in a plane stays, a face past an end is none, the near face goes before the far one."),
    driven("17.6", "first-generation-contours-at-zero", Unit::FirstGenerationProcessor, contours_at_zero,
        "Conics and polar lines at 0, -1 and both ends of their words: zero is inside the quadric and on the kept side, so that a plane exactly at a root is the face of a solid and has removed that root of a surface."),
    driven("17.5", "polyhedron-without-thickness", Unit::PolyhedronProcessor, without_thickness,
        "Two planes of opposite sense at the same depth, one word apart either way, at both ends and beyond them, and perpendicular planes of 0 and -1: no thickness is there, less is absent."),
    driven("13.8", "facet-sides-at-zero", Unit::FacetProcessor, |s| sides_and_depths(s, &LINES, ["side_0_c", "side_1_c", "depth_c"], PLANE_GUARD),
        "Sides of 0, -1 and both ends of their words, depths at and beside both ends of the depth word: zero is inside, and a facet past an end is absent."),
    driven("13.8", "curved-sides-at-zero", Unit::CurvedFacetProcessor, |s| sides_and_depths(s, &CONICS, ["side_0_f", "side_1_f", "depth_f"], BULGE_GUARD),
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

/// The least and greatest words of a signed port, and those about zero.
fn ends(signal: &Signal) -> [i64; 7] {
    let half = 1i64 << (signal.width - 1);
    [-half, -half + 1, -1, 0, 1, half - 2, half - 1]
}

/// Every combination of a value of each list, the last list fastest.
fn every<const N: usize>(lists: [&[i64]; N]) -> impl Iterator<Item = [i64; N]> {
    let count: usize = lists.iter().map(|list| list.len()).product();
    (0..count).map(move |mut rest| {
        let mut one = [0; N];
        for (value, list) in one.iter_mut().zip(lists).rev() {
            *value = list[rest % list.len()];
            rest /= list.len();
        }
        one
    })
}

/// Inputs with some ports set and the others zero.
fn inputs(subject: &Subject, set: &[(&str, i64)]) -> Inputs {
    let value = |signal: &Signal| {
        let found = set.iter().find(|(name, _)| *name == signal.name);
        found.map_or(0, |&(_, value)| value)
    };
    let is_port = |name: &str| subject.inputs.iter().any(|signal| signal.name == name);
    debug_assert!(set.iter().all(|(name, _)| is_port(name)));
    subject.inputs.iter().map(value).collect()
}

/// Values with the names of their ports.
fn named<const N: usize>(names: &'static str, values: [i64; N]) -> [(&'static str, i64); N] {
    let mut names = names.split(' ');
    values.map(|value| (names.next().expect("a name for each value"), value))
}

/// Clocks that carry nothing, until the last result is out.
fn flushed(subject: &Subject, mut stimulus: Vec<Inputs>) -> Vec<Inputs> {
    stimulus.extend(std::iter::repeat_n(inputs(subject, &[]), 40));
    stimulus
}

fn f2_ends(subject: &Subject) -> Vec<Inputs> {
    // The f1 processor starts later than the f2 processor, so each start is followed by a pause.
    let starts = [0, 1, (1 << 47) - 1, -1, -(1 << 47)].map(|f2| {
        let start = [("valid", 1), ("start", 1), ("f2_f", f2)];
        let mut clocks = vec![inputs(subject, &[("f2_f", f2)]); 41];
        clocks[0] = inputs(subject, &start);
        clocks
    });
    starts.concat()
}

fn radicands(subject: &Subject, values: impl Iterator<Item = u64>) -> Vec<Inputs> {
    let one = |value: u64| inputs(subject, &[("radicand", value as i64)]);
    flushed(subject, values.map(one).collect())
}

/// The powers of two of so many places, and what is beside them.
fn powers(places: u32) -> impl Iterator<Item = u64> {
    let powers = (0..places).map(|place| 1u64 << place);
    powers.flat_map(|power| [power - 1, power, power + 1])
}

fn squares(subject: &Subject) -> Vec<Inputs> {
    let last = (1u64 << 24) - 1;
    let around = |n: u64| [(n * n).saturating_sub(1), n * n, n * n + 2 * n];
    let roots = powers(24).chain([last - 1, last]);
    radicands(subject, roots.flat_map(around))
}

fn plane_ties(subject: &Subject) -> Vec<Inputs> {
    let words = ends(&subject.inputs[3]);
    let all = every([&[0, 1, 2, 3], &[0, 1], &words, &words, &words]);
    let ordered = all.filter(|[_, _, zf, zb, _]| zb >= zf);
    let one = |[kind, surface, zf, zb, zp]: [i64; 5]| {
        let values = [kind, surface, 5, zp, zf, zb, 1];
        inputs(subject, &named("kind surface number zp zf zb nb", values))
    };
    ordered.map(one).collect()
}

/// One line of `pixels` pixels of each plane, of this slope and this first depth.
fn plane_lines(subject: &Subject, planes: &[(i64, i64)], pixels: usize) -> Vec<Inputs> {
    let line = |&(a, c): &(i64, i64)| {
        let mut line = vec![inputs(subject, &[("valid", 1), ("a", a), ("c", c)]); pixels];
        line[0] = inputs(subject, &[("valid", 1), ("start", 1), ("a", a), ("c", c)]);
        line
    };
    flushed(subject, planes.iter().flat_map(line).collect())
}

fn plane_slopes(subject: &Subject) -> Vec<Inputs> {
    plane_lines(subject, &[(0, 0), (1, -20), (-1, 20)], 41)
}

fn plane_past_its_word(subject: &Subject) -> Vec<Inputs> {
    let far = 1i64 << 23;
    let through = (far - 1) / 40;
    let [least, .., most] = LINES;
    let short = [(1, far - 20), (-1, 20 - far)];
    let long = [(through, -2 * far), (-through, 2 * far)];
    let level = [(0, most), (0, least)];
    plane_lines(subject, &[short, long, level].concat(), 200)
}

fn lines_after_the_last(subject: &Subject) -> Vec<Inputs> {
    let values = [6, -10, 7, 1 << 40, -(1 << 45), (1 << 47) - 5];
    let words = named("a2 b2 c p0 i0 f", values);
    let with = |flags: &[(&str, i64)]| inputs(subject, &[flags, &words].concat());
    let mut line = vec![with(&[("valid", 1)]); 4];
    line[0] = with(&[("valid", 1), ("line", 1)]);
    let first = with(&[("valid", 1), ("start", 1)]);
    [vec![first], vec![line; 64].concat()].concat()
}

fn normal_words(subject: &Subject) -> Vec<Inputs> {
    let (g, k) = (-(1 << 23), -(1 << 15));
    let words = [(0, 0), (0, k), (g, 0), (g, k), (-1 - g, k)];
    let all = every([&[0, 1, 2, 3, 4], &[0, 1, (1 << 15) - 1], &[0, 1, 2, 15]]);
    let one = |[pair, root, number]: [i64; 3]| {
        let (g, k) = words[pair as usize];
        let names = "valid start number scaled_root gx_c gy_c gz_c kx ky kz";
        inputs(
            subject,
            &named(names, [1, 1, number, root, g, g, g, k, k, k]),
        )
    };
    flushed(subject, all.map(one).collect())
}

fn past_the_depth_word(subject: &Subject) -> Vec<Inputs> {
    let depths = [&[-(1 << 25)], &DEPTHS[..10], &[(1 << 25) - 1]].concat();
    let all = every([&[0, 1, 2, 3], &depths, &depths, &[0, 1]]);
    let ordered = all.filter(|[_, near, far, _]| near <= far);
    let one = |[class, near, far, inside]: [i64; 4]| {
        let names = "near_sum far_sum is_inside in_box object_class front back";
        // The limits of no plane.
        let [front, back] = [-(1 << 23), (1 << 23) - 1];
        let values = [near, far, inside, 1, class, front, back];
        inputs(subject, &named(names, values))
    };
    flushed(subject, ordered.map(one).collect())
}

/// The far end of the base format.
const FAR: i64 = (1 << 23) - 1;

/// A depth and its neighbours, and both ends of the depth word and theirs.
const DEPTHS: [i64; 11] = [
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
fn pixels<const N: usize, W: AsRef<[(&'static str, i64)]>>(
    subject: &Subject,
    lists: [&[i64]; N],
    words: impl Fn([i64; N]) -> W,
) -> Vec<Inputs> {
    let one = |values| pixel(subject, words(values).as_ref());
    every(lists).flat_map(one).collect()
}

fn patch_ties(subject: &Subject) -> Vec<Inputs> {
    let kinds = [[1, 1], [1, 2], [2, 2], [3, 1], [0, 2]];
    // Without those that leave the word.
    let planes = &DEPTHS[1..9];
    let all = every([&DEPTHS, &DEPTHS, planes, &[0, 1, 2, 3, 4]]);
    let ordered = all.filter(|[near, far, ..]| near <= far);
    let one = |[near, far, plane, pair]: [i64; 4]| {
        let [first, second] = kinds[pair as usize];
        let names =
            "near_sum far_sum is_inside in_box plane_0_zp plane_1_zp plane_0_kind plane_1_kind";
        let face = near.clamp(-FAR - 1, FAR);
        let values = [near, far, 1, 1, plane, face, first, second];
        inputs(subject, &named(names, values))
    };
    let rest = std::iter::repeat_n(inputs(subject, &[]), subject.latency);
    ordered.map(one).chain(rest).collect()
}

fn contours_at_zero(subject: &Subject) -> Vec<Inputs> {
    let lists = [&[0, 1][..], &CONICS, &CONICS, &LINES];
    let names =
        "surface f2_f conic_0_f conic_1_f polar_0_c polar_1_c depth_0_c depth_1_c plane_0_nz";
    pixels(subject, lists, |[surface, front, back, polar]| {
        let other = -1 - polar;
        named(names, [surface, 25, front, back, polar, other, -5, 5, -7])
    })
}

fn without_thickness(subject: &Subject) -> Vec<Inputs> {
    let lists = [&DEPTHS[..], &[-1, 0, 1], &[-1, 0]];
    pixels(subject, lists, |[depth, gap, half_plane]| {
        let kinds = named("plane_0_kind plane_1_kind plane_2_kind", [1, 2, 3]);
        let places = [depth, depth + gap, half_plane];
        let places = named("plane_0_c plane_1_c plane_2_c", places);
        let normals = named("plane_0_nz plane_1_nz", [-1, 1]);
        [&kinds[..], &places, &normals].concat()
    })
}

/// Units of a first-degree depth below the depth word.
const PLANE_GUARD: i64 = 1 << 10;
/// Units of a second-degree depth below the depth word.
const BULGE_GUARD: i64 = 1 << 22;

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
        let values = [outline, near * BULGE_GUARD, near + far, -(1 << 47)];
        named("outline_f front_f depth_sum nz_f", values)
    })
}

fn cylinder_parts(subject: &Subject) -> Vec<Inputs> {
    let lists = [&[0, -1][..]; 6];
    pixels(subject, lists, |[disc_1, disc_0, sides @ ..]| {
        let sides = named("side_3_c side_2_c side_1_c side_0_c", sides);
        let values = [disc_0, disc_1, -(1 << 46), 1 << 20, -9];
        let rest = named("disc_0_f disc_1_f body_f lid_c lid_nz", values);
        [&sides[..], &rest].concat()
    })
}

fn volume_ties(subject: &Subject) -> Vec<Inputs> {
    let names = "object_class depth margin depth_shift f2_f";
    let depths = [-FAR, -4, -3, -2, 0, 2, 3, 4, FAR - 1, FAR];
    let (classes, margins) = ([0, 1, 2, 3], [0, 1, 5, FAR]);
    let lists = [&classes[..], &depths, &margins, &[0, 1, 8], &[-1, 0, 9]];
    pixels(subject, lists, |values| named(names, values))
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
            let values = [word, word, word, word, word, word, split, 15];
            let words = named("a2 b2 c i0 p0 f split used", values);
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
        let values = [1, address, words[word]];
        let words = named("load_valid load_address load_data", values);
        list.push(inputs(subject, &words));
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
