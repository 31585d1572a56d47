use imogene_contract::video::VideoMode;
use imogene_golden::format::Format;
use imogene_golden::machine::tile::Tile;
use imogene_plan::tile::{factor, tile_words};
use imogene_prepare::{Framing, PreparedScene, prepare};
use imogene_scene::{FramedScene, SceneFile};

/// White on black, all of it ambient light: what is seen of the object is not black.
const SCENE: &str = r#"format = 1
title = "A cut egg"
background = [0, 0, 0]
ambient = [1, 1, 1]
camera = { kind = "orthographic", eye = [0.3, 0.2, 9], target = [0, 0, 0], view_height = 6, half_depth = 3 }
materials = [{ name = "chalk", colour = [1, 1, 1], ambient = 0.8, diffuse = 0.2 }]

[[objects]]
name = "egg"
kind = "ellipsoid"
radii = [1.3, 0.9, 1.1]
material = "chalk"
cuts = [{ point = [0.2, 0.3, 0], normal = [0.5, 1, 0.7] }, { point = [0.9, 0, 0], normal = [1, 0, -0.2] }]
"#;
const FORMAT: u32 = 16;

fn framed(text: &str, [width, height]: [u32; 2]) -> (FramedScene, PreparedScene) {
    let file = SceneFile::parse(text, "egg.toml").expect("a scene");
    let framed = file.frame(width, height).expect("it can be framed");
    let format = Format::new(FORMAT).expect("a format");
    let prepared = prepare(&framed, format).expect("words");
    (framed, prepared)
}

#[test]
fn the_first_frame_has_the_object_where_the_scene_has_it() {
    let mode = VideoMode::SMALL;
    let size = [mode.line.active as u32, mode.frame.active as u32];
    let (scene, prepared) = framed(SCENE, size);
    let words = tile_words(&scene, &prepared, mode).expect("one solid");
    let picture = Tile::new(&words).expect("words of its widths").frame();
    let frame = prepared.frame(|| ());
    let depths = frame.depth.iter();
    let there = depths.map(|depth| *depth != prepared.format.z_max());
    let seen = picture.chunks_exact(3).map(|levels| levels != [0; 3]);
    assert!(seen.eq(there), "another silhouette");
    // The first plane moves, and the window holds what is seen at either edge of the screen.
    assert!(words.drift > 0, "{}", words.drift);
    assert!(
        words.planes.len() == 2 && words.widths.plane >= FORMAT,
        "{words:?}"
    );
}

#[test]
fn what_a_tile_cannot_draw_is_refused_by_name() {
    let mode = VideoMode::SMALL;
    let size = [mode.line.active as u32, mode.frame.active as u32];
    let said = |text: &str| {
        let (scene, prepared) = framed(text, size);
        let refused = tile_words(&scene, &prepared, mode);
        refused.expect_err("no tile").to_string()
    };
    let surface = SCENE.replace(
        "kind = \"ellipsoid\"",
        "kind = \"ellipsoid\"\nmode = \"patch\"",
    );
    let surface = said(&surface);
    assert!(surface.contains("a bare surface"), "{surface}");
    let large = said(&SCENE.replace("view_height = 6", "view_height = 1.5"));
    assert!(large.contains("no room to move"), "{large}");
}

#[test]
fn a_factor_has_three_bits_and_a_sign() {
    for (step, expected) in [
        (0.35, (6, 4)),
        (-0.35, (-6, 4)),
        (0.0, (0, 11)),
        (9.0, (7, 0)),
    ] {
        assert_eq!(factor(step), expected, "{step}");
    }
}
