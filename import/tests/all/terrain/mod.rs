//! Grids of heights from text to scene, and heights made at random.

mod exact;
mod ruled;

use crate::common::cases::cases;
use crate::common::{list, says};
use imogene_algebra::rational::{fraction, from_decimal, integer};
use imogene_import::terrain::random_field::{Field, FieldOptions, field, heights_text};
use imogene_import::terrain::{Cells, Region, TerrainOptions};
use imogene_import::{ImportError, Imported, terrain};
use imogene_scene::{Object, Quadric, SceneFile, Shape};
use num_traits::{Signed, Zero};
use proptest::prelude::*;

const HILLS: &str = "step 60 90\n10 20 30 20\n15 40.5 60 20\n10 30 - 10\n";

fn read(text: &str, change: impl FnOnce(&mut TerrainOptions)) -> Result<Imported, ImportError> {
    let mut options = TerrainOptions::default();
    change(&mut options);
    terrain::import(text.as_bytes(), "hills", &options)
}

fn import(text: &str, change: impl FnOnce(&mut TerrainOptions)) -> Imported {
    read(text, change).expect("a grid")
}

fn message(text: &str) -> String {
    read(text, |_| ()).unwrap_err().to_string()
}

fn cell<'a>(imported: &'a Imported, name: &str) -> &'a Object {
    let mut objects = imported.scene.objects.iter();
    objects.find(|o| o.name == name).expect(name)
}

/// Whether the surface of a cell passes heights at its corners: z00, z10, z01, z11.
fn passes(cell: &Object, heights: [f64; 4]) -> bool {
    let quadric = Quadric::from_shape(&cell.shape).expect("a quadric");
    let corners = [(0, 0), (1, 0), (0, 1), (1, 1)].into_iter().zip(heights);
    let at = |(u, v), height| quadric.value_at(&integer(u), &from_decimal(height), &integer(v));
    let mut values = corners.map(|(corner, height)| at(corner, height));
    values.all(|value| value.is_zero())
}

#[test]
fn both_formats_read_the_same_grid() {
    let esri = "NCOLS 3\nnrows 2\nxllcorner 12.5\nyllcorner -3\ndx 60\ndy 90\nNODATA_value -9999\n1 2.5 -9999 4\n-5 6e1\n";
    let plain = "# hills\nstep 60 90\n1 2.5 -\n4 -5 60 # the south\n";
    let [esri, plain] = [esri, plain].map(|text| import(text, |_| ()));
    assert_eq!((&esri.scene, &esri.report), (&plain.scene, &plain.report));
    assert!(passes(cell(&plain, "cell-0-0"), [1.0, 2.5, 4.0, -5.0]));
    assert_eq!(plain.report["step"], serde_json::json!([60.0, 90.0]));
    assert_eq!(plain.report["without_data"], 1);
}

#[test]
fn mistakes_are_shown_where_they_are() {
    let table = r"
ncols 2\nnrows 2\ncellsize 1\n1 2\n3 x4\n | hills:5:3: `x4` is no height
ncols 2\nnrows 2\ncellsize 0\n1 2 3 4 | hills:3:10: a distance of two nodes of `0`
ncols 2\nnrows 2\ncellsize 1\n1 2 3 | hills:4:5: the file ends after 3 of 2 x 2
ncols 2\nnrows 2\ncellsize 1\n1 2 3 4 5 | hills:4:9: more than 2 x 2
ncols 2\nncols 2\n | hills:2:1: ncols for the second time
ncols 2\nnrow 2\n | hills:2:1: `nrow` is no keyword
ncols 1\n | hills:1:7: `1` is no number of nodes
ncols 2\ncellsize 1\n1 | has no nrows
ncols 2\nnrows 2\n1 2 3 4 | cellsize
ncols 2\nnrows 2\ncellsize 1\ndx 1\n1 2 3 4 | cellsize
ncols 4000000000\nnrows 4000000000\ncellsize 1\n1 | 4000000000 x 4000000000 nodes
1 2\n3 4 5\n | hills:2:5: a row of 3 heights after rows of 2
1 2\nstep 1 1\n3 4\n | hills:2:1: `step` out of place
step 1\n1 2\n3 4\n | hills:1:1: a distance is missing
step 1 2 3\n1 2\n3 4\n | hills:1:10: `3` too many
1 2\n3 1e9\n | hills:2:3: `1e9` is no height
1 2\n3 nan\n | hills:2:3: `nan` is no height
1 2\n | 1 rows of 2 heights
 | 0 rows of 0 heights
- -\n- -\n | no node has a height
1 übel\n | hills:1:3: `übel` is no height
";
    for [text, why] in cases(table) {
        says(message(&text), &why);
    }
    let binary = terrain::import(b"1 2\n3 \xff4\n", "hills", &TerrainOptions::default());
    says(binary.unwrap_err(), "hills:2:3: this byte is no UTF-8 text");
}

#[test]
fn a_scene_is_one_that_can_be_read_back() {
    for cells in [Cells::Bilinear, Cells::Auto, Cells::Ruled] {
        let made = import(HILLS, |o| o.cells = cells);
        let text = made.scene.to_toml().unwrap();
        assert_eq!(SceneFile::parse(&text, "again").unwrap(), made.scene);
        assert_eq!(made.report["cells"], 4);
        assert_eq!(made.report["without_data"], 2);
        assert!(made.notes[0].contains("2 cells without a height"));
    }
}

/// Every patch passes its corners and the mean of them in its middle, with the ground below. Neighbours reach a little
/// beyond their common edge; where there is no neighbour a cell ends at its edge.
#[test]
fn neighbours_meet_in_their_edge_and_overlap() {
    let made = import(HILLS, |_| ());
    for (name, [z00, z10, z01, z11], reaches) in [
        // West, east, north and south.
        ("cell-0-0", [10.0, 20.0, 15.0, 40.5], [0, 1, 0, 1]),
        ("cell-1-0", [20.0, 30.0, 40.5, 60.0], [1, 1, 0, 0]),
        ("cell-2-0", [30.0, 20.0, 60.0, 20.0], [1, 0, 0, 0]),
        ("cell-0-1", [15.0, 40.5, 10.0, 30.0], [0, 0, 1, 0]),
    ] {
        let cell = cell(&made, name);
        assert!(passes(cell, [z00, z10, z01, z11]), "{name}");
        let quadric = Quadric::from_shape(&cell.shape).unwrap();
        let (half, mean) = (fraction(1, 2), from_decimal((z00 + z10 + z01 + z11) / 4.0));
        assert!(quadric.value_at(&half, &mean, &half).is_zero());
        let below = quadric.value_at(&half, &(mean - integer(1)), &half);
        assert!(below.is_negative(), "{name}");
        let kept = |u: f64, v: f64| {
            cell.cuts.iter().all(|cut| {
                let from = [u - cut.point[0], 0.0, v - cut.point[2]];
                cut.normal.iter().zip(from).map(|(n, d)| n * d).sum::<f64>() <= 0.0
            })
        };
        for (edge, reach) in reaches.into_iter().enumerate() {
            let at = |beyond: f64| match edge {
                0 => kept(-beyond, 0.5),
                1 => kept(1.0 + beyond, 0.5),
                2 => kept(0.5, -beyond),
                _ => kept(0.5, 1.0 + beyond),
            };
            let reach = f64::from(reach) / 256.0;
            assert!(at(reach) && !at(reach + 1e-9), "{name}, edge {edge}");
        }
    }
}

#[test]
fn facets_look_upwards() {
    for text in ["1 2\n3 4\n", "step 90 90\n1 2\n3 4.01\n"] {
        let made = import(text, |o| o.cells = Cells::Auto);
        let Shape::Mesh(mesh) = &cell(&made, "cell-0-0").shape else {
            panic!("facets")
        };
        for face in &mesh.faces {
            let [p, q, r] = [0, 1, 2].map(|k| mesh.vertices[face[k]]);
            let (s, t) = ([q[0] - p[0], q[2] - p[2]], [r[0] - p[0], r[2] - p[2]]);
            assert!(s[1] * t[0] - s[0] * t[1] > 0.0);
        }
    }
}

#[test]
fn a_part_keeps_every_second_node_of_a_region() {
    let rows = (0..5).map(|row| (0..6).map(|k| (6 * row + k).to_string() + " ").collect());
    let rows: Vec<String> = rows.collect();
    let text = format!("step 2 3\n{}\n", rows.join("\n"));
    let (first, nodes) = ([1, 2], [5, 3]);
    let made = import(&text, |o| {
        o.region = Some(Region { first, nodes });
        o.every = 2;
    });
    let report = &made.report;
    assert_eq!(report["columns"], 3);
    assert_eq!(report["rows"], 2);
    assert_eq!(report["step"], serde_json::json!([4.0, 6.0]));
    assert!(passes(cell(&made, "cell-0-0"), [13.0, 15.0, 25.0, 27.0]));
    assert!(passes(cell(&made, "cell-1-0"), [15.0, 17.0, 27.0, 29.0]));
}

#[test]
fn what_does_not_fit_is_refused() {
    let (first, nodes) = ([2, 0], [3, 2]);
    let out = read(HILLS, |o| o.region = Some(Region { first, nodes }));
    says(out.unwrap_err(), "within the grid of 4 x 3 nodes");
    let wide = read(HILLS, |o| o.every = 3);
    says(wide.unwrap_err(), "every 3 of them");
    let back = read(HILLS, |o| {
        o.eye = Some([0.0, 100.0, -1000.0]);
        o.target = Some([0.0, 100.0, -2000.0]);
    });
    says(back.unwrap_err(), "every cell lies behind the eye");
    let many = message(&("0 ".repeat(200) + "\n").repeat(200));
    says(many, "39601 cells");
}

proptest! {
    #[test]
    fn no_bytes_make_it_panic(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let _ = terrain::import(&bytes, "noise", &TerrainOptions::default());
    }

    #[test]
    fn no_header_makes_it_panic(words in proptest::collection::vec("(ncols|nrows|cellsize|dx|dy|NODATA_value|step|-|#|\n|[0-9.e+-]{1,6}) ?", 0..40)) {
        let _ = read(&words.concat(), |_| ());
    }
}

fn options_of(levels: u32, smoothness: f64, relief: f64, seed: u64) -> FieldOptions {
    FieldOptions {
        levels,
        smoothness,
        relief,
        seed,
    }
}

fn field_of(levels: u32, seed: u64) -> FieldOptions {
    options_of(levels, 0.6, 100.0, seed)
}

/// The source's maxima; one vertex more because the centre has two estimates for a moment.
#[test]
fn storage_is_what_the_source_states() {
    for n in 3..=9 {
        let made = field(&field_of(n, 1)).unwrap();
        let n = n as usize;
        assert_eq!(made.most_vertices, (1 << (n + 1)) + 3 * n - 1 + 1);
        assert_eq!(made.most_edges, (1 << (n + 2)) + 10 * n - 6);
    }
}

#[test]
fn seeds_give_fields_of_their_own() {
    let made = field(&field_of(5, 7)).unwrap();
    assert_eq!(made, field(&field_of(5, 7)).unwrap());
    assert_ne!(made.heights, field(&field_of(5, 8)).unwrap().heights);
    assert_eq!(made.heights.len(), 33 * 33);
    assert!(made.heights.iter().all(|h| h.is_finite() && *h != 0.0));
}

/// Deviations of the displacements of the middles of edges and of centres at a level, from the finished field
/// alone.
fn deviations(made: &Field, level: u32) -> [f64; 2] {
    let width = (made.side - 1) >> level;
    let half = width / 2;
    let at = |x: usize, y: usize| made.heights[y * made.side + x];
    let (mut edges, mut centres) = (vec![], vec![]);
    for y in (0..made.side).step_by(width) {
        for x in (0..made.side).step_by(width) {
            if x + width < made.side {
                edges.push(at(x + half, y) - 0.5 * (at(x, y) + at(x + width, y)));
            }
            if y + width < made.side {
                edges.push(at(x, y + half) - 0.5 * (at(x, y) + at(x, y + width)));
            }
            if x + width < made.side && y + width < made.side {
                let (north, south) = (at(x + half, y), at(x + half, y + width));
                let (west, east) = (at(x, y + half), at(x + width, y + half));
                let mean = 0.25 * (north + south + west + east);
                centres.push(at(x + half, y + half) - mean);
            }
        }
    }
    [edges, centres].map(|list| {
        let sum: f64 = list.iter().map(|d| d * d).sum();
        (sum / list.len() as f64).sqrt()
    })
}

/// From 2^12 edges on the deviation of a level is known to about 1 %, so the ratio of two levels to better than 5
/// %.
#[test]
fn levels_are_smoother_by_their_factor() {
    for smoothness in [0.0, 0.3, 0.6, 1.0] {
        let made = field(&options_of(9, smoothness, 100.0, 3)).unwrap();
        for level in 5..8 {
            let [edge, centre] = deviations(&made, level);
            let [next, _] = deviations(&made, level + 1);
            let expected = 100.0 * (-smoothness * f64::from(level + 1)).exp2();
            let ratio = next / edge / (-smoothness).exp2();
            // The mean of two estimates.
            let of_centre = centre / edge * 2f64.sqrt();
            for ratio in [ratio, of_centre, edge / expected] {
                let place = format!("h {smoothness}, level {level}: {ratio}");
                assert!((ratio - 1.0).abs() < 0.05, "{place}");
            }
        }
    }
}

#[test]
fn options_out_of_range_are_refused() {
    for (levels, smoothness, relief, why) in [
        (0, 0.6, 100.0, "0 levels; 1 to 10"),
        (11, 0.6, 100.0, "11 levels"),
        (3, -0.1, 100.0, "a roughness exponent h of -0.1"),
        (3, 0.6, 0.0, "a relief of 0"),
        (3, f64::NAN, 100.0, ""),
    ] {
        says(
            field(&options_of(levels, smoothness, relief, 1)).unwrap_err(),
            why,
        );
    }
}

#[test]
fn shipped_heights_are_those_of_their_first_line() {
    let options = options_of(4, 0.8, 40.0, 3);
    let text = heights_text(&field(&options).unwrap(), &options, 10.0);
    assert_eq!(text, list::text("scenes/terrain/hills.heights"));
}

#[test]
fn the_reader_reads_what_is_written() {
    let options = field_of(4, 5);
    let made = field(&options).unwrap();
    let imported = import(&heights_text(&made, &options, 2.5), |_| ());
    assert_eq!(imported.report["step"], serde_json::json!([2.5, 2.5]));
    assert_eq!(imported.report["cells"], 256);
    let rounded = |column: usize, row: usize| {
        let height = made.heights[row * made.side + column];
        (height * 1000.0).round() / 1000.0
    };
    for (column, row) in [(0, 0), (7, 3), (15, 15)] {
        let corners = [(0, 0), (1, 0), (0, 1), (1, 1)];
        let heights = corners.map(|(u, v)| rounded(column + u, row + v));
        let cell = cell(&imported, &format!("cell-{column}-{row}"));
        assert!(passes(cell, heights), "{column}, {row}");
    }
}
