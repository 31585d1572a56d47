//! Scenes of many objects: what nobody sees is left out and counted, and memory is looked at before it is taken.

use crate::common::{Place, Run};
use std::fmt::Write;

/// A folder with a scene: a wall of balls before others that it hides, and one beside the picture.
fn wall(side: u32) -> Place {
    let mut text = String::from(
        "format = 1\ntitle = \"wall\"\n[camera]\nkind = \"perspective\"\neye = [0, 0, 40]\ntarget = [0, 0, 0]\n\
         viewer_distance = 40\nview_height = 8\n[[materials]]\nname = \"m\"\ncolour = [0.5, 0.5, 0.5]\n",
    );
    let mut ball = |name: String, place: [f64; 3], radius: f64| {
        writeln!(
            text,
            "[[objects]]\nname = \"{name}\"\nkind = \"sphere\"\nradius = {radius}\nmaterial = \"m\"\nplace = [{{ translate = {place:?} }}]"
        )
        .expect("text");
    };
    let step = 8.0 / f64::from(side);
    let at = |k: u32| (f64::from(k) + 0.5) * step - 4.0;
    for (k, l) in (0..side).flat_map(|k| (0..side).map(move |l| (k, l))) {
        // Overlapping, so that nothing shows between them.
        ball(format!("wall {k} {l}"), [at(k), at(l), 0.0], step);
    }
    for k in 0..7 {
        ball(format!("behind {k}"), [at(k), 0.3, -9.0], 0.4);
    }
    ball("beside".into(), [30.0, 0.0, 0.0], 1.0);
    let place = Place::new();
    place.write("wall.toml", text);
    place
}

/// A picture of a scene that stands in a folder.
fn render(place: &Place, more: &str) -> Run {
    place.run(&format!("render wall.toml --size 200x200 {more}"))
}

#[test]
fn what_nobody_sees_is_counted() {
    let place = wall(10);
    let report = render(&place, "--json").ended(0).json();
    assert_eq!(report["hidden"], 7);
    assert_eq!(report["off_screen"], 1);
    // In pieces every object counts as work, and none is left out.
    let report = render(&place, "--json --split lines:4").ended(0).json();
    assert_eq!(report["hidden"], 0);
}

#[test]
fn a_scene_that_does_not_fit_into_memory_is_refused_with_what_would_do() {
    let place = wall(60);
    let refused = render(&place, "--max-memory 48M");
    let Run { said, .. } = refused.refused(&["preparing 3608 objects takes up to"]);
    assert!(!place.has("wall.png"));
    let mut words = said.split_whitespace();
    words.find(|word| *word == "--max-memory");
    let enough = words.next().expect("a size");
    render(&place, &format!("--max-memory {enough}")).ended(0);
}

#[test]
fn a_size_that_is_none_is_refused() {
    let place = wall(2);
    for size in ["2GB", "0", "much"] {
        let refused = render(&place, &format!("--max-memory {size}"));
        refused.refused(&["such as 512M or 2G"]);
    }
}
