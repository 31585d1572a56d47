//! The reference tables of `docs/scene-format.md` against the reader: every key stands in both, defaults are what is
//! read without the key, and the ends of a range are the last values that are accepted.

use imogene_scene::{SceneError, SceneFile};

const PAGE: &str = include_str!("../../../../docs/scene-format.md");

/// A scene with a place for one more line in every table; each takes the line of its name.
const SCENE: &str = r#"
format = 1
title = "Reference"
#top
[camera]
kind = "perspective"
eye = [0, 0, 9]
target = [0, 0, 0]
viewer_distance = 9
#camera
[[lights]]
kind = "spot"
position = [1, 2, 3]
target = [0, 0, 0]
#light
[[materials]]
name = "m"
colour = [1, 1, 1]
#material
[[objects]]
name = "ball"
kind = "sphere"
radius = 1
material = "m"
#object
[[groups]]
name = "g"
#group
[[images]]
name = "i"
#image
"#;

/// The heading of each table on the page, its place in the scene, and a line that the scene needs there unless another
/// stands in its place.
const TABLES: [(&str, &str, &str); 8] = [
    ("## Top level", "#top", ""),
    ("## Camera", "#camera", "view_height = 4"),
    ("## Lights", "#light", "half_angle = 30"),
    ("## Materials", "#material", ""),
    ("## Objects", "#object", ""),
    ("## Molecules", "#molecule", ""),
    ("## Groups", "#group", ""),
    ("| key of an image", "#image", ""),
];

/// Keys that stand in the place of the line that is needed.
const LENSES: [&str; 4] = ["view_height", "focal", "field_of_view", "half_angle"];

/// The scene with a line in one of its tables.
fn scene(place: &str, line: &str) -> Result<SceneFile, SceneError> {
    let mut text = match place {
        "#molecule" => SCENE.replace(
            "[[images]]\nname = \"i\"\n#image",
            "[[molecules]]\nfile = \"a.cif\"\n#molecule",
        ),
        _ => SCENE.to_owned(),
    };
    for (_, other, needed) in TABLES {
        let lines = match other == place {
            true if LENSES.iter().any(|key| line.starts_with(key)) => line.to_owned(),
            true => format!("{needed}\n{line}"),
            false => needed.to_owned(),
        };
        text = text.replace(other, &lines);
    }
    let mut scene = SceneFile::parse(&text, "reference.toml")?;
    for object in &mut scene.objects {
        // What draws it counts, not whether it was asked for.
        object.processor = object.drawn_by();
    }
    Ok(scene)
}

/// The rows of a table of the page: keys, meaning, default.
fn rows(heading: &str) -> Vec<[String; 3]> {
    let from = PAGE.find(heading);
    let from = from.unwrap_or_else(|| panic!("{heading} is on the page"));
    let lines = PAGE[from..].lines();
    let lines = lines.skip_while(|line| !line.starts_with('|'));
    let rows = lines.skip(2).take_while(|line| line.starts_with('|'));
    rows.map(|line| {
        let mut cells = line.trim_matches('|').split(" | ");
        std::array::from_fn(|_| {
            let cell = cells.next().unwrap_or_default();
            cell.trim_matches(['|', ' ']).to_owned()
        })
    })
    .collect()
}

/// What stands between backticks.
fn quoted(cell: &str) -> Vec<String> {
    let parts = cell.split('`').skip(1).step_by(2);
    parts
        .map(|key| key.trim_matches(['[', ']']).to_owned())
        .collect()
}

#[test]
fn every_key_is_on_the_page_and_no_other() {
    for (heading, place, _) in TABLES {
        let refusal = scene(place, "unknown_key = 1").expect_err("an unknown key");
        let refusal = refusal.to_string();
        let (_, expected) = refusal.split_once("expected one of ").expect(&refusal);
        let mut read = quoted(expected.lines().next().expect("a line"));
        let told = rows(heading)
            .into_iter()
            .flat_map(|[keys, ..]| quoted(&keys));
        let mut told: Vec<String> = told.collect();
        read.sort();
        told.sort();
        assert_eq!(told, read, "{heading}");
    }
}

#[test]
fn defaults_are_what_is_read_without_the_key() {
    let mut count = 0;
    for (heading, place, _) in TABLES {
        let without = scene(place, "").unwrap();
        for [keys, _, default] in rows(heading) {
            let Some(value) = default
                .strip_prefix('`')
                .and_then(|rest| rest.split('`').next())
            else {
                continue;
            };
            for key in quoted(&keys) {
                let with = scene(place, &format!("{key} = {value}"))
                    .unwrap_or_else(|e| panic!("{key}: {e}"));
                assert_eq!(with, without, "{key} of {heading}");
                count += 1;
            }
        }
    }
    assert!(count >= 25, "{count} defaults found");
}

#[test]
fn ranges_end_where_the_page_says() {
    let mut count = 0;
    for (heading, place, _) in TABLES {
        for [keys, meaning, _] in rows(heading) {
            let words: Vec<&str> = meaning.split([' ', ',', ';']).collect();
            let range = words.windows(3).find_map(|three| match three {
                [low, "to", high] => Some([low.parse::<f64>().ok()?, high.parse::<f64>().ok()?]),
                _ => None,
            });
            let keys = quoted(&keys);
            let ([key], Some([low, high])) = (keys.as_slice(), range) else {
                continue;
            };
            let accepts = |value: f64| {
                let value = match key.as_str() {
                    "image" => format!("{{ width = {value}, height = {value} }}"),
                    "sample_at" => format!("[{value:?}, 0]"),
                    _ => value.to_string(),
                };
                scene(place, &format!("{key} = {value}")).is_ok()
            };
            let is_whole = ["image", "exponent", "steps"].contains(&key.as_str());
            let step = if is_whole { 1.0 } else { 1e-6 * high };
            assert!(accepts(low) && accepts(high), "{key}");
            assert!(!accepts(low - step) && !accepts(high + step), "{key}");
            count += 1;
        }
    }
    assert!(count >= 10, "{count} ranges found");
}
