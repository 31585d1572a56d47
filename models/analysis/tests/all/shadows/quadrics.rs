//! Random cut quadrics.

use super::compare::{Tally, compare};
use super::{before_a_wall, sources};
use crate::pictures::Pictures;
use imogene_scene::{FramedQuadric, Surface};
use imogene_testkit::*;

/// A quadric of random shape about a centre: ellipsoid, cylinder, hyperboloid of one or two sheets, cone.
fn random_caster(random: &mut Random, name: &str) -> FramedQuadric {
    const KINDS: [([i64; 3], i64); 6] = [
        ([1, 1, 1], 12),
        ([1, 1, 1], 9),
        ([1, 1, 0], 7),
        ([1, 1, -1], 5),
        ([1, 1, -1], 0),
        ([1, 1, -1], -5),
    ];
    let mut whole = |most: f64| (random.signed() * most).round() as i64;
    let kind = (whole(2.99) + 2).clamp(0, 5) as usize;
    let (signs, size) = KINDS[kind];
    let m: [[i64; 3]; 3] = std::array::from_fn(|_| std::array::from_fn(|_| whole(9.0)));
    // m' diag(signs) m is a quadric of that kind unless m is singular; its constant makes it some pixels wide.
    let entry = |i: usize, j: usize| -> i64 { (0..3).map(|k| signs[k] * m[k][i] * m[k][j]).sum() };
    let scale = (0..3).map(|k| entry(k, k).abs()).fold(1, i64::max);
    let centre: [i64; 3] = std::array::from_fn(|_| whole(16.0));
    let moved: [i64; 3] = std::array::from_fn(|i| (0..3).map(|j| entry(i, j) * centre[j]).sum());
    let about: i64 = (0..3).map(|i| moved[i] * centre[i]).sum();
    let q = whole_quadric([
        entry(0, 0),
        entry(1, 1),
        entry(2, 2),
        entry(0, 1),
        entry(0, 2),
        entry(1, 2),
        -moved[0],
        -moved[1],
        -moved[2],
        about - size * size.abs() * scale,
    ]);
    let plane_at = |n: [i64; 3], distance: i64| {
        let at: i64 = (0..3).map(|k| n[k] * centre[k]).sum();
        [n[0], n[1], n[2], -at - distance]
    };
    let mut cuts: Vec<[i64; 4]> = vec![];
    for _ in 0..(whole(2.49) + 1).clamp(0, 3) {
        let n: [i64; 3] = std::array::from_fn(|_| whole(20.0));
        cuts.push(plane_at(n, 20 * (whole(7.0) + 4)));
    }
    if kind >= 2 {
        // Endless ones are cut on both sides.
        cuts.extend([1, -1].map(|side| plane_at([3 * side, 20 * side, 5 * side], 200)));
    }
    cuts.retain(|c| c[..3] != [0; 3]);
    object(name, Surface::Solid, q, &cuts)
}

/// Random cut quadrics before a wall, a point source and a directional one, in both projections.
#[test]
fn random_cut_quadrics_have_the_shadows_of_the_exact_rays() {
    let mut random = Random(7);
    let mut tally = Tally::default();
    let (mut prepared_scenes, mut refused, mut parts) = (0, 0, 0);
    let rounds = if is_full() { 24 } else { 12 };
    for round in 0..rounds {
        let casters = ["first", "second"].map(|name| random_caster(&mut random, name).into());
        let mut framed = before_a_wall(round, casters);
        framed.sources = sources(&mut random);
        match Pictures::of(framed, super::F) {
            Ok(pictures) => {
                prepared_scenes += 1;
                parts += pictures.prepared.volumes.len();
                compare(&pictures, &mut tally);
            }
            Err(_) => refused += 1,
        }
    }
    eprintln!("{prepared_scenes} scenes, {refused} refused, {parts} volumes, {tally:?}");
    assert!(prepared_scenes + refused == rounds);
    assert!(3 * prepared_scenes >= 2 * rounds && parts > 8 * rounds);
    let lit = 4000 * rounds;
    assert!(tally.lit > lit && 4 * tally.dark > lit, "{tally:?}");
    assert!(tally.differing * 1000 < tally.flags, "{tally:?}");
    assert!(tally.open * 20 < tally.flags, "{tally:?}");
    assert_eq!(tally.differing, tally.at_an_edge, "{tally:?}");
}
