//! Bad input: one clear message on standard error, exit code 2, no panic, nothing half-written.

use crate::common::{Place, Run, columns, rows, run, scene};

/// A scene with one sphere; `object` replaces its shape lines, `camera` its camera.
fn scene_text(camera: &str, object: &str) -> String {
    format!(
        "format = 1\ntitle = \"t\"\n\n[camera]\n{camera}\n\n[[materials]]\nname = \"m\"\ncolour = [1, 1, 1]\n\n[[objects]]\nname = \"thing\"\nmaterial = \"m\"\n{object}\n"
    )
}

const CAMERA: &str = "kind = \"perspective\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\nviewer_distance = 10\nview_height = 4";
const SPHERE: &str = "kind = \"sphere\"\nradius = 1";

/// Renders a scene text; the refusal says so in one message, and writes nothing.
fn refused(text: impl AsRef<[u8]>, parts: &[&str]) {
    let place = Place::new();
    place.write("scene.toml", text);
    let run = place.run("render --size 64x48 -o picture.png scene.toml");
    let run = run.refused(parts);
    assert!(run.said.starts_with("error: "), "{}", run.said);
    assert_eq!(place.names(), ["scene.toml"], "something was written");
}

#[test]
fn the_template_itself_is_accepted() {
    let place = Place::new();
    place.write("scene.toml", scene_text(CAMERA, SPHERE));
    place.run("render --size 64x48 scene.toml").ended(0);
}

#[test]
fn every_truncation_of_a_scene_is_refused_or_a_scene() {
    let whole = std::fs::read(scene("teapot.toml")).unwrap();
    refused(&whole[..whole.len() / 2], &["scene.toml:"]);
    // A shorter text may be a complete scene with fewer objects; it must never be a panic or another exit code.
    let whole = std::fs::read(scene("cut-sphere.toml")).unwrap();
    let place = Place::new();
    for length in (0..whole.len()).step_by(whole.len() / 40) {
        place.write("scene.toml", &whole[..length]);
        let Run { code, said, .. } = place.run("prepare --size 16x12 scene.toml");
        assert!(matches!(code, Some(0 | 2)), "{length}: {said}");
        assert!(!said.contains("panicked"), "{said}");
    }
}

#[test]
fn what_a_scene_must_not_say_is_refused() {
    let orthographic = CAMERA.replace("perspective", "orthographic");
    let orthographic = orthographic.replace("viewer_distance = 10", "near = 3\nfar = -3");
    let small = CAMERA.replace("view_height = 4", "view_height = 1e-306");
    // The eye is a thousandth off a ball of which a slice is drawn by a processor that has roots alone.
    let slice = "kind = \"sphere\"\nradius = 9.999\nprocessor = \"first_generation\"\n\
        cuts = [{ point = [0, 0, 1], normal = [0, 0, 1] }, { point = [0, 0, -1], normal = [0, 0, -1] }]";
    let with = |line: &str| format!("{SPHERE}\n{line}");
    let radius = |radius: &str| format!("kind = \"sphere\"\nradius = {radius}");
    #[rustfmt::skip]
    let cases: [(&str, String, &[&str]); 8] = [
        (CAMERA, with("color = 3"), &["scene.toml:", "color"]),
        (CAMERA, radius("nan"), &["thing", "radius"]),
        (CAMERA, radius("0"), &["thing", "radius"]),
        (CAMERA, with("cuts = [{ point = [0, 0, 0], normal = [0, 0, 0] }]"), &["thing", "normal"]),
        (CAMERA, with("place = [{ scale = [1, 0, 1] }]"), &["thing", "scale"]),
        (&orthographic, SPHERE.into(), &["far", "not behind `near`", "greater number"]),
        (&small, SPHERE.into(), &["view_height", "too small", "1e-30"]),
        (CAMERA, slice.into(), &["thing", "too large", "bits", "`near = "]),
    ];
    for (camera, object, parts) in cases {
        refused(scene_text(camera, &object), parts);
    }
}

#[test]
fn missing_file_folder_and_binary_noise() {
    run("check no/such/scene.toml").refused(&["no/such/scene.toml"]);
    refused([0xff, 0xfe, 0x00, 0x80, 0x31], &["scene.toml"]);
    refused("", &[]);
}

/// Command lines in an empty folder are refused with messages that have the parts beside them, and write nothing.
fn all_refused(table: &str) {
    let place = Place::new();
    for row in rows(table) {
        let (line, parts) = (row[0], &row[1..]);
        place.run(line).refused(parts);
        assert!(place.names().is_empty(), "{line}");
    }
}

#[test]
fn unwritable_output_folder() {
    // A file stands where the folder should be: refused for every user, also the superuser.
    let place = Place::new();
    place.write("obstacle", "x");
    let render = "render scenes/teapot.toml --size 32x24 -o";
    for command in ["demo --out", "emit pe1 --out", render] {
        let run = place.run(&format!("{command} obstacle/out"));
        run.refused(&["cannot write", "obstacle"]);
    }
    assert_eq!(place.names(), ["obstacle"]);
}

#[test]
fn usage_and_parameters_out_of_range() {
    let table = "
        emit quadric_pe --root-form cubic1 --out out                       | --root-form | 'cubic1' is no form | restoring
        emit quadric_pe --root-form linear3 --out out                      | linear3 | 0 to 2 corrections
        emit pe1 --root-form linear2 --out out                             | pe1 | root-form
        cosim quadric_volume --format 16 --root-form leading17             | leading root = 17 | 1 to 16
        cosim x.toml --root-form linear2                                   | --root-form | --widths depth=24,root_form=linear2
        emit beam --root-form iterative --out out                          | iterative | streams its picture
        render x.toml --widths depth=11,root_form=quadratic1               | quadratic root of 11 bits | 12 to 32
        emit pe3 --out out                                                 | pe3 | pe2
        emit pe1 --prefix 1st- --out out                                   | 1st- | begin with a letter
        emit pe1 --format 33 --out out                                     | 33 | 8 to 32
        emit quadric_processor --planes 13 --out out                       | 13 | 12
        emit square_root --rows-per-stage 0 --out out                      | 0 | 24
        emit square_root_rows --digits 25 --out out                        | digits | 25 | 1 to 24
        cosim pe1 --corrections 1                                          | pe1 | corrections
        emit beam --objects 257 --out out                                  | 257 | 256
        cosim pe1 --format 7                                               | 7 | 8 to 32
        cosim nothing                                                      | nothing | pe1
        cosim pe1 --widths depth=20                                        | --widths | scene
        cosim pe1 --size 20x20                                             | --size | a scene, not for a unit
        cosim x.toml --clocks 10                                           | --clocks | a unit, not for a scene
        cosim x.toml --objects 3                                           | --objects | a unit, not for a scene
        cosim extremes --engine icarus                                     | --engine | not for an extreme
        speed x.toml --planes 3                                            | --planes | a unit, not for a scene
        emit --machine x.toml --planes 3 --out out                         | --machine | --planes
        synth --machine x.toml --target ecp5-45k --objects 3               | --machine | --objects
        synth --table --format 20                                          | --table | --format
        synth pe1 --target ecp5-45k --widths depth=20 --slots 1            | --widths | beam | pe1
        synth beam --target ecp5-45k --widths depth=20 --slots 1 --seeds 9 | --widths | --seeds
        synth --check --rows-per-stage 3                                   | --check | --rows-per-stage
        render x.toml --size 10by10 -o p.png                               | 10by10 | 320x240
    ";
    all_refused(table);
}

/// Only the words of the quadric and the patch processor have bounds; waveforms and faults are those of the beam
/// machine.
#[test]
fn scenes_of_other_processors_are_refused_where_the_quadric_processor_is_meant() {
    let table = "
        bounds MESH                     | mesh.toml      | no object    | quadric or patch processor
        cosim MESH --vcd trace.vcd      | --vcd          | beam machine | quadric processors
        cosim MESH --inject-fault 0:1:2 | --inject-fault | beam machine | quadric processors
        cosim MESH --guards 2:2         | --guards       | beam machine | quadrics
    ";
    all_refused(&table.replace("MESH", "scenes/processors/mesh.toml"));
}

#[test]
fn guard_bits_and_bounds_that_cannot_be_had_are_refused() {
    let table = "
        render CONE --size 32x24 --guards 3               | expected G1:G2
        render CONE --size 32x24 --guards 17:0            | at most 16
        render CONE --size 32x24 --guards 0:4 --format 32 | 64 | at most 0
        render CONE --size 32x24 --format 7               | 7 bits | 8 to 32
        render CONE --size 32x24 --format 40 --model rtl  | 40 bits | 8 to 32
        bounds --sizes 64x48                              | required
        bounds CONE --cases 5                             | cannot be used with
        bounds CONE --formats 40                          | 40 | 8 to 32
        bounds nowhere.toml                               | nowhere.toml
    ";
    all_refused(&table.replace("CONE", "scenes/cone.toml"));
}

/// A scene of a ball and a box, and a solid of them.
fn solid_text(of: &str, ball: &str) -> String {
    let ball = format!("kind = \"sphere\"\nradius = 1\n{ball}");
    let text = scene_text(CAMERA, &ball);
    format!(
        "{text}\n[[objects]]\nname = \"other\"\nmaterial = \"m\"\nkind = \"sphere\"\nradius = 0.5\n\n\
         [[solids]]\nname = \"part\"\nof = {of}\n"
    )
}

#[test]
fn a_solid_that_cannot_be_had_names_the_object_and_what_would_do() {
    let table = r#"
        { difference = ["thing", "hole"] } |  | solid `part`, object `hole` | `thing`, `other`
        { difference = ["thing"] } |  | solid `part` | two operands
        { less = ["thing", "other"] } |  | unknown variant `less` | `difference`
        { union = ["thing", 3] } |  | invalid type | the name of an object
        { difference = ["thing", "other"] } | mode = "patch" | surface without inside | mode = "solid"
    "#;
    for [of, ball, first, second] in columns(table) {
        refused(solid_text(of, ball), &[first, second]);
    }
    let both = r#"{ difference = ["thing", "other"] }"#;
    let parallel = solid_text(both, "processor = \"paraboloid\"")
        .replace("perspective", "orthographic")
        .replace("viewer_distance = 10\n", "");
    refused(parallel, &["hands on no back", "quadric processor"]);
    let shadows = solid_text(both, "")
        + "\n[[lights]]\nkind = \"directional\"\nfrom = [0, 5, 5]\nshadows = true\n";
    refused(shadows, &["solid 'part'", "casts_shadow = false"]);
    let double = solid_text(both, "").replace("kind = \"sphere\"\nradius = 1\n", "kind = \"cone\"\nradii = [1, 1, 1]\nplace = [{ rotate = { axis = \"x\", degrees = 90 } }]\n");
    let remedy = "cut one of its two parts off";
    refused(double, &["object 'thing' is met twice", remedy]);
}
