use imogene_oracle::crack::{Buffers, Crack, Rule, cracks};

type Pixel = (usize, usize);

/// What is behind where nothing is.
const NOTHING: (f64, i32) = (f64::INFINITY, -1);

const RULE: Rule = Rule {
    min_distance: 1.0,
    width: 1,
};

/// A wall of one face at distance 10, with what `behind` says behind the marked pixels.
fn wall(marked: &[Pixel], behind: (f64, i32)) -> Buffers {
    let mut buffers = Buffers {
        width: 20,
        height: 20,
        distance: vec![10.0; 400],
        face: vec![(0, 0); 400],
    };
    for (x, y) in marked {
        buffers.distance[y * 20 + x] = behind.0;
        buffers.face[y * 20 + x] = (behind.1, 0);
    }
    buffers
}

fn found(marked: &[Pixel], behind: (f64, i32), rule: Rule) -> Vec<Pixel> {
    let cracks = cracks(&wall(marked, behind), &rule);
    cracks.iter().map(|c| (c.x, c.y)).collect()
}

/// Whole columns.
fn columns<I: IntoIterator<Item = usize>>(columns: impl Fn() -> I) -> Vec<Pixel> {
    let lines = (0..20).flat_map(|y| columns().into_iter().map(move |x| (x, y)));
    lines.collect()
}

#[test]
fn every_crack_one_pixel_wide_is_found_and_nothing_else() {
    // A point, a level line, an upright one, both diagonals, a staircase, and a block of four.
    let at = |by: i64, k: i64| (8 + by * k) as usize;
    let line = |(u, v)| (0..5).map(|k| (at(u, k), at(v, k))).collect::<Vec<Pixel>>();
    let stairs = (0..8).map(|k: usize| (4 + k / 2, 4 + k.div_ceil(2)));
    let stairs = stairs.collect();
    let block = vec![(7, 7), (8, 7), (7, 8), (8, 8)];
    let lines = [(0, 0), (1, 0), (0, 1), (1, 1), (1, -1)].map(line);
    for mut marked in lines.into_iter().chain([stairs, block]) {
        marked.sort_by_key(|(x, y)| (*y, *x));
        marked.dedup();
        for behind in [NOTHING, (11.0, 1)] {
            assert_eq!(found(&marked, behind, RULE), marked);
        }
        // Too little behind, or the same face.
        assert_eq!(found(&marked, (10.9, 1), RULE), []);
        assert_eq!(found(&marked, (20.0, 0), RULE), []);
    }
}

#[test]
fn wider_cracks_need_the_wider_rule() {
    let of_width = |width| Rule { width, ..RULE };
    let band = columns(|| [9, 10]);
    assert_eq!(found(&band, NOTHING, RULE), []);
    assert_eq!(found(&band, NOTHING, of_width(2)), band);
    let three = columns(|| [9, 10, 11]);
    assert_eq!(found(&three, NOTHING, of_width(2)), []);
    assert_eq!(found(&three, NOTHING, of_width(3)), three);
}

/// A wedge of background that narrows to one pixel is flagged where it is narrow, and a crack within the surface is
/// not taken for its end.
#[test]
fn the_end_of_a_notch_is_told_from_a_crack() {
    let wedge = (0..16usize).flat_map(|y| (10 - (16 - y) / 4..=10).map(move |x| (x, y)));
    let marked: Vec<Pixel> = wedge.chain([(3, 15)]).collect();
    let all = cracks(&wall(&marked, NOTHING), &RULE);
    let (notches, closed): (Vec<&Crack>, Vec<&Crack>) = all.iter().partition(|c| c.notch);
    let closed: Vec<Pixel> = closed.iter().map(|c| (c.x, c.y)).collect();
    assert_eq!(closed, [(3, 15)]);
    let are_narrow = notches.len() >= 3 && notches.iter().all(|c| c.x == 10);
    assert!(are_narrow, "{all:?}");
}

#[test]
fn outlines_are_no_cracks() {
    for width in 1..4 {
        let half = columns(|| 10..20);
        assert_eq!(found(&half, NOTHING, Rule { width, ..RULE }), []);
    }
}
