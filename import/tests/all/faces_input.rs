//! Texts of face lists: what is refused and where, and that no text makes the reader panic.

use crate::common::cases::cases;
use crate::common::says;
use imogene_import::faces::{FaceOptions, read};
use imogene_import::{ImportError, Imported};
use proptest::prelude::*;

const LIST: &str = "format = 1
title = \"Cup\"
[[materials]]
name = \"m\"
colour = [1, 1, 1]
[vertices]
a = [1, 0, 0]
b = [-1, 0, 0]
[[edges]]
name = \"low\"
kind = \"circle\"
centre = [0, 0, 0]
axis = [0, 1, 0]
radius = 1
[[edges]]
name = \"high\"
kind = \"circle\"
centre = [0, 2, 0]
axis = [0, 1, 0]
radius = 1
[[edges]]
name = \"half\"
kind = \"circle\"
centre = [0, 0, 0]
axis = [0, 1, 0]
radius = 1
start = \"a\"
end = \"b\"
[[faces]]
name = \"side\"
surface = { kind = \"cylinder\", origin = [0, 0, 0], axis = [0, 1, 0], radius = 1 }
loops = [[\"low\"], [\"-high\"]]
[[faces]]
name = \"floor\"
surface = { kind = \"plane\", origin = [0, 0, 0], normal = [0, -1, 0] }
loops = [[\"-low\"]]
[[solids]]
name = \"cup\"
material = \"m\"
faces = [\"side\", \"floor\"]
";

fn import(bytes: &[u8]) -> Result<Imported, ImportError> {
    read(bytes, "cup", &FaceOptions::default())
}

#[test]
fn the_list_itself_is_read() {
    let imported = import(LIST.as_bytes()).unwrap();
    // Open at the top, so that it is no volume: the wall and the floor.
    assert_eq!(imported.scene.objects.len(), 2);
    assert_eq!(imported.report["total"]["exact"], 2);
    let text = imported.scene.to_toml().unwrap();
    let again = imogene_scene::SceneFile::parse(&text, "again").unwrap();
    assert_eq!(again, imported.scene);
}

#[test]
fn the_shared_plane_has_one_description() {
    let imported = import(LIST.as_bytes()).unwrap();
    let [wall, floor] = &imported.scene.objects[..] else {
        panic!("two objects")
    };
    let mut cuts = wall.cuts.iter();
    let cut = cuts.find(|c| c.point == floor.cuts[0].point).unwrap();
    assert!(floor.cuts.contains(cut));
    let opposite = cut.normal.map(|v| 0.0 - v);
    assert!(floor.cuts.iter().any(|c| c.normal == opposite));
}

#[test]
fn slips_are_reported_where_they_are() {
    let table = r#"
format = 1 | format = 2 | :1:10: version 2
format = 1 |  | missing field `format`
axis = [0, 1, 0]\nradius = 1\nstart | axis = [0, 0, 0]\nradius = 1\nstart | :25:8: [0.0, 0.0, 0.0] has no direction
axis = [0, 1, 0], radius = 1 } | axis = [0, 1, 0], radius = -1 } | :31:79: -1 is not above 0
axis = [0, 1, 0], radius = 1 } | axis = [0, 1, 0] } | :31:11: a cylinder needs `radius`
kind = "plane", origin | kind = "plane", radius = 3, origin | :35:11: a plane has no `radius`
kind = "plane", origin | kind = "plain", origin | :35:20: `plain` is not a kind of surface
loops = [["-low"]] | loops = [["-lob"]] | :36:11: `lob` is not an edge
loops = [["-low"]] | loops = [["half"]] | :36:11: `half` does not end where `half` begins
loops = [["-low"]] | loops = [] | :34:8: face `floor` has no loop
loops = [["-low"]] | loops = [[]] | :36:10: the loop has no edge
end = "b" | end = "c" | :28:7: `c` is not a vertex
end = "b" |  | it has one of `start` and `end`
b = [-1, 0, 0] | b = [-1.5, 0, 0] | :22:8: edge `half`: an end is 5e-1 off the curve
b = [-1, 0, 0] | b = [inf, 0, 0] | :8:5: inf is out of range
faces = ["side", "floor"] | faces = ["side"] | :34:8: face `floor` belongs to no solid
"#;
    for [from, to, expected] in cases(table) {
        assert!(LIST.contains(&from), "{from}");
        let message = import(LIST.replacen(&from, &to, 1).as_bytes()).unwrap_err();
        says(&message, &expected);
        let mut ways = "needed possible has reads must belongs follow".split(' ');
        let is_said = ways.any(|way| message.error.accepted.contains(way));
        assert!(is_said, "{message}");
    }
}

#[test]
fn a_list_without_drawable_faces_is_refused_with_its_verdicts() {
    let wall = "kind = \"cylinder\", origin = [0, 0, 0], axis = [0, 1, 0], radius = 1";
    let floor = "kind = \"plane\", origin = [0, 0, 0], normal = [0, -1, 0]";
    let text = LIST.replace(wall, "kind = \"bspline\"");
    let text = text.replace(floor, "kind = \"other\"");
    let message = import(text.as_bytes()).unwrap_err();
    says(&message, "a bspline is no quadric");
    says(&message, "2 rejected");
}

#[test]
fn text_that_is_no_text_names_the_byte() {
    let mut bytes = LIST.as_bytes().to_vec();
    bytes[15] = 0xff;
    let error = import(&bytes).unwrap_err();
    says(error, "cup:2:5: this byte is no UTF-8 text");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Random edits of a list: a scene or one message, never a panic.
    #[test]
    fn no_text_makes_it_panic(edits in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..4_u8), 1..12)) {
        let mut bytes = LIST.as_bytes().to_vec();
        for (at, value, what) in edits {
            let at = at.index(bytes.len());
            match what {
                0 => bytes[at] = value,
                1 => { bytes.remove(at); }
                2 => bytes.insert(at, b"0123456789.-e[]\",=\n"[usize::from(value) % 19]),
                _ => bytes[at] = b"0123456789"[usize::from(value) % 10],
            }
        }
        let _ = import(&bytes);
    }

    /// Random numbers in the places of numbers: the geometry of nonsense.
    #[test]
    fn no_geometry_makes_it_panic(numbers in proptest::collection::vec(prop_oneof![-3.0..3.0_f64, Just(0.0), Just(1.0), Just(1e9), Just(-1e-9)], 40)) {
        let mut numbers = numbers.into_iter();
        let mut text = String::new();
        for line in LIST.lines() {
            let geometric = ["axis", "centre", "radius", "a =", "b =", "surface"].iter().any(|key| line.starts_with(key));
            for c in line.chars() {
                match c {
                    '0' | '1' if geometric => text += &format!("{:?}", numbers.next().unwrap_or(1.0)),
                    _ => text.push(c),
                }
            }
            text.push('\n');
        }
        let _ = import(text.as_bytes());
    }
}
