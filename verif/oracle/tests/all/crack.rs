use imogene_oracle::crack::{Buffers, Crack, Rule, cracks};

const RULE: Rule = Rule {
    min_distance: 1.0,
    width: 1,
};

/// A wall of one face at distance 10, with what `behind` says behind the marked pixels.
fn wall(width: usize, height: usize, marked: &[(usize, usize)], behind: (f64, i32)) -> Buffers {
    let mut buffers = Buffers {
        width,
        height,
        distance: vec![10.0; width * height],
        face: vec![(0, 0); width * height],
    };
    for (x, y) in marked {
        buffers.distance[y * width + x] = behind.0;
        buffers.face[y * width + x] = (behind.1, 0);
    }
    buffers
}

fn found(buffers: &Buffers, rule: Rule) -> Vec<(usize, usize)> {
    cracks(buffers, &rule).iter().map(|c| (c.x, c.y)).collect()
}

#[test]
fn every_crack_one_pixel_wide_is_found_and_nothing_else() {
    // A point, a level line, an upright one, both diagonals, a staircase, and a block of four.
    let line = |u: i64, v: i64| -> Vec<(usize, usize)> {
        (0..5)
            .map(|k| ((8 + u * k) as usize, (8 + v * k) as usize))
            .collect()
    };
    let stairs = (0..8usize)
        .map(|k| (4 + k / 2, 4 + k.div_ceil(2)))
        .collect();
    let block = vec![(7, 7), (8, 7), (7, 8), (8, 8)];
    let lines = [(0, 0), (1, 0), (0, 1), (1, 1), (1, -1)].map(|(u, v)| line(u, v));
    for mut marked in lines.into_iter().chain([stairs, block]) {
        marked.sort_by_key(|(x, y)| (*y, *x));
        marked.dedup();
        for behind in [(f64::INFINITY, -1), (11.0, 1)] {
            assert_eq!(found(&wall(20, 20, &marked, behind), RULE), marked);
        }
        // Too little behind, or the same face.
        assert_eq!(found(&wall(20, 20, &marked, (10.9, 1)), RULE), []);
        assert_eq!(found(&wall(20, 20, &marked, (20.0, 0)), RULE), []);
    }
}

#[test]
fn wider_cracks_need_the_wider_rule() {
    let band: Vec<(usize, usize)> = (0..20).flat_map(|y| [9, 10].map(|x| (x, y))).collect();
    let buffers = wall(20, 20, &band, (f64::INFINITY, -1));
    assert_eq!(found(&buffers, RULE), []);
    let wide = Rule { width: 2, ..RULE };
    assert_eq!(found(&buffers, wide), band);
    let three: Vec<(usize, usize)> = (0..20).flat_map(|y| [9, 10, 11].map(|x| (x, y))).collect();
    let buffers = wall(20, 20, &three, (f64::INFINITY, -1));
    assert_eq!(found(&buffers, wide), []);
    assert_eq!(found(&buffers, Rule { width: 3, ..RULE }), three);
}

/// A wedge of background that narrows to one pixel is flagged where it is narrow, and a crack within the surface is
/// not taken for its end.
#[test]
fn the_end_of_a_notch_is_told_from_a_crack() {
    let wedge = (0..16usize).flat_map(|y| (10 - (16 - y) / 4..=10).map(move |x| (x, y)));
    let mut marked: Vec<(usize, usize)> = wedge.collect();
    marked.push((3, 15));
    let all = cracks(&wall(20, 20, &marked, (f64::INFINITY, -1)), &RULE);
    let (notches, closed): (Vec<&Crack>, Vec<&Crack>) = all.iter().partition(|c| c.notch);
    assert_eq!(
        closed.iter().map(|c| (c.x, c.y)).collect::<Vec<_>>(),
        [(3, 15)]
    );
    assert!(
        notches.len() >= 3 && notches.iter().all(|c| c.x == 10),
        "{all:?}"
    );
}

#[test]
fn outlines_are_no_cracks() {
    let half: Vec<(usize, usize)> = (0..20)
        .flat_map(|y| (10..20).map(move |x| (x, y)))
        .collect();
    for width in 1..4 {
        let rule = Rule { width, ..RULE };
        assert_eq!(found(&wall(20, 20, &half, (f64::INFINITY, -1)), rule), []);
    }
}
