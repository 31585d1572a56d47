//! Lights with shadows and spots in the scene file: what is read, what is refused, and with which words.

use imogene_algebra::rational::{fraction, integer};
use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_prepare::volume::pairs;
use imogene_prepare::{PreparedScene, prepare};
use imogene_scene::{Aim, Beam, SceneFile};
use imogene_testkit::rows;

const GOOD: &str = r#"
format = 1
title = "Lights"

[camera]
kind = "perspective"
eye = [0, 0, 10]
target = [0, 0, 0]
viewer_distance = 10
view_height = 5

[[materials]]
name = "clay"
colour = [0.8, 0.4, 0.3]

[[objects]]
name = "ball"
kind = "sphere"
radius = 1
material = "clay"
"#;

const SPOT: &str = "kind = \"spot\"\nposition = [4, 0, 0]\ntarget = [0, 0, 0]\nhalf_angle = 45";

fn with_light(light: &str) -> String {
    format!("{GOOD}\n[[lights]]\n{light}\n")
}

fn scene(text: &str) -> SceneFile {
    SceneFile::parse(text, "demo.toml").expect("a valid scene")
}

/// A row has the keys of a light and words of the refusal, which names the file.
fn refused(table: &str) {
    for row in rows(table) {
        let light = row[0].replace("\\n", "\n");
        let error = SceneFile::parse(&with_light(&light), "demo.toml").expect_err(&light);
        let message = error.to_string();
        assert!(message.starts_with("demo.toml:"), "{message}");
        for word in &row[1..] {
            assert!(message.contains(word), "`{word}` is not in: {message}");
        }
    }
}

#[test]
fn lights_are_read_and_written_back() {
    let directional = "kind = \"directional\"\nfrom = [1, 2, 3]\nshadows = true";
    let towards = "kind = \"spot\"\nposition = [4, 0, 0]\ntowards = [-1, 0, 0]\nhalf_angle = 12.5";
    for light in [directional, SPOT, towards] {
        let read = scene(&with_light(light));
        assert_eq!(scene(&read.to_toml().expect("valid")), read);
    }
    let lights = scene(&with_light(SPOT)).lights;
    let Beam::Spot {
        aim, half_angle, ..
    } = &lights[0].beam
    else {
        panic!("not a spot");
    };
    assert_eq!(
        (*aim, *half_angle, lights[0].shadows),
        (Aim::Target([0.0; 3]), 45.0, false)
    );
    let light = &scene(&with_light(directional)).lights[0];
    assert!(matches!(light.beam, Beam::Directional { .. }) && light.shadows);
}

#[test]
fn objects_without_a_shadow_are_read_and_written_back() {
    let light = "kind = \"directional\"\nfrom = [1, 2, 3]\nshadows = true";
    let casting = scene(&with_light(light));
    assert!(casting.objects[0].casts_shadow);
    assert_eq!(pairs(&casting.frame(64, 48).expect("valid")), [(0, 0)]);
    let text = with_light(light).replace("radius = 1", "radius = 1\ncasts_shadow = false");
    let silent = scene(&text);
    assert!(!silent.objects[0].casts_shadow);
    assert_eq!(scene(&silent.to_toml().expect("valid")), silent);
    assert_eq!(pairs(&silent.frame(64, 48).expect("valid")), []);
    let lit = with_light("kind = \"directional\"\nfrom = [1, 2, 3]");
    assert_eq!(pairs(&scene(&lit).frame(64, 48).expect("valid")), []);
}

/// The cone of 45 degrees about the x axis from (4, 0, 0) towards the origin, exactly: y^2 + z^2 <= (x - 4)^2, x <= 4.
#[test]
fn the_cone_of_a_spot_is_exact() {
    let framed = scene(&with_light(SPOT)).frame(50, 50).expect("valid");
    let source = &framed.sources[0];
    // Ten pixels to the unit; the eye is 100 pixels before the screen plane, at z = 0 of the picture.
    assert_eq!(source.point, [40, 0, 0, 1].map(integer));
    let cone = source.cone.as_ref().expect("a spot");
    let values = |x: i64, y: i64, z: i64| {
        let [x, y, z] = [x, y, z].map(integer);
        (
            cone.quadric.value_at(&x, &y, &z),
            cone.plane.value_at(&x, &y, &z),
        )
    };
    let zero = integer(0);
    for (x, y, z) in [(0, 40, 0), (30, 6, -8), (-10, 30, 40), (50, 10, 0)] {
        let (quadric, plane) = values(x, y, z);
        assert_eq!(quadric, zero, "({x}, {y}, {z}) lies on the cone");
        assert_eq!(plane > zero, x > 40);
    }
    assert!(values(0, 39, 0).0 < zero && values(0, 41, 0).0 > zero);
    assert_eq!(values(40, 0, 0), (zero.clone(), zero));
    // 60 degrees: tan^2 = 3 up to the one rounding of cos 120 degrees.
    let wide = scene(&with_light(&SPOT.replace("45", "60")))
        .frame(50, 50)
        .expect("valid");
    let quadric = &wide.sources[0].cone.as_ref().expect("a spot").quadric;
    let ratio = -&quadric.a / &quadric.b;
    let off = ratio - integer(3);
    assert!(off < fraction(1, 1 << 48) && off > -fraction(1, 1 << 48));
}

#[test]
fn keys_of_another_kind_of_light_are_refused() {
    refused(
        r#"
        kind = "point"\nposition = [1, 2, 3]\nhalf_angle = 10 | a point light has no `half_angle` | `position`
        kind = "directional"\nfrom = [1, 2, 3]\ntarget = [0, 0, 0] | a directional light has no `target` | `from`
        kind = "spot"\nfrom = [1, 2, 3]\nhalf_angle = 10 | a spot has no `from` | `half_angle`
        kind = "point"\nposition = [1, 2, 3]\nshadow = true | unknown field `shadow` | `shadows`
        kind = "point"\nposition = [1, 2, 3]\nshadows = 1 | boolean
        kind = "lamp" | unknown variant `lamp` | `spot`
        "#,
    );
}

#[test]
fn spots_that_lack_a_key_or_a_cone_are_refused() {
    refused(
        r#"
        kind = "spot"\ntarget = [0, 0, 0]\nhalf_angle = 10 | a spot needs `position`
        kind = "spot"\nposition = [4, 0, 0]\ntarget = [0, 0, 0] | a spot needs `half_angle` | degrees
        kind = "spot"\nposition = [4, 0, 0]\nhalf_angle = 10 | a spot needs `target` | `towards`
        kind = "spot"\nposition = [4, 0, 0]\ntarget = [0, 0, 0]\ntowards = [1, 0, 0]\nhalf_angle = 45 | `target` or `towards` | both
        kind = "spot"\nposition = [4, 0, 0]\ntarget = [0, 0]\nhalf_angle = 45 | 2 numbers found
        kind = "spot"\nposition = [4, 0, 0]\ntarget = [4, 0, 0]\nhalf_angle = 45 | lights[0].target | position of the spot itself | away from
        kind = "spot"\nposition = [4, 0, 0]\ntowards = [0, 0, 0]\nhalf_angle = 45 | lights[0].towards | no direction
        kind = "spot"\nposition = [4, 0, 0]\ntarget = [0, 0, 0]\nhalf_angle = nan | lights[0].half_angle | finite number
        "#,
    );
    for angle in ["0", "-5", "90", "89.5", "0.05"] {
        let light = SPOT.replace("45", angle).replace('\n', "\\n");
        let words = "lights[0].half_angle | degrees is out of range | from 0.1 to 89 degrees";
        refused(&format!("{light} | {words}"));
    }
}

#[test]
fn more_sources_than_a_pixel_has_flags_for_are_refused() {
    let text = format!("{GOOD}{}", format!("\n[[lights]]\n{SPOT}").repeat(17));
    let error = SceneFile::parse(&text, "demo.toml").expect_err("17 lights");
    assert!(
        error.to_string().contains("17 lights; at most 16"),
        "{error}"
    );
    scene(&format!(
        "{GOOD}{}",
        format!("\n[[lights]]\n{SPOT}").repeat(16)
    ));
}

/// The message of a preparation that is refused.
fn unprepared(text: &str) -> String {
    let framed = scene(text).frame(64, 48).expect("valid");
    prepare(&framed, Format::BASE)
        .expect_err("refused")
        .to_string()
}

#[test]
fn a_source_inside_what_casts_its_shadow_is_refused_by_name() {
    let light = "kind = \"point\"\nposition = [0, 0.5, 0]\nshadows = true";
    let message = unprepared(&with_light(light));
    for word in [
        "object 'ball'",
        "lights[0] is inside this solid",
        "casts_shadow = false",
    ] {
        assert!(message.contains(word), "{message}");
    }
    // On its surface is inside as well; just outside, or without a shadow, is possible.
    unprepared(&with_light(&light.replace("0.5", "1")));
    for text in [
        with_light(&light.replace("0.5", "1.001")),
        with_light(&light.replace("true", "false")),
        with_light(light).replace("radius = 1", "radius = 1\ncasts_shadow = false"),
    ] {
        prepare(&scene(&text).frame(64, 48).expect("valid"), Format::BASE).expect("prepared");
    }
}

#[test]
fn a_solid_endless_towards_the_light_is_refused_by_name() {
    let bowl = with_light("kind = \"directional\"\nfrom = [0, 1, 0]\nshadows = true").replace(
        "kind = \"sphere\"\nradius = 1",
        "kind = \"elliptic_paraboloid\"\nradii = [1, 1, 1]",
    );
    assert!(unprepared(&bowl).contains("endless towards it"));
    let cut = format!("{bowl}\n").replace(
        "material = \"clay\"\n\n[[lights]]",
        "material = \"clay\"\ncuts = [{ point = [0, 1, 0], normal = [0, 1, 0] }]\n\n[[lights]]",
    );
    assert_ne!(cut, bowl);
    let framed = scene(&cut).frame(64, 48).expect("valid");
    prepare(&framed, Format::BASE).expect("a cut solid ends");
}

/// The viewer on the cone of a spot: the depth of the cone is no square root.
#[test]
fn a_viewer_on_a_volume_is_refused_by_name() {
    let light = "kind = \"spot\"\nposition = [10, 0, 0]\ntowards = [-1, 0, 0]\nhalf_angle = 45";
    let message = unprepared(&with_light(light));
    assert!(
        message.contains("the cone of the spot lights[0]: the viewer lies exactly on"),
        "{message}"
    );
    let beside = with_light(&light.replace("45", "44"));
    prepare(&scene(&beside).frame(64, 48).expect("valid"), Format::BASE).expect("prepared");
}

/// Patches: a closed one casts the shadow of its inside, a cut one none, and says so.
#[test]
fn a_cut_patch_casts_no_shadow_and_says_so() {
    let light = "kind = \"directional\"\nfrom = [0, 1, 0]\nshadows = true";
    let patch = with_light(light).replace("radius = 1", "radius = 1\nmode = \"patch\"");
    let floor = "\n[[objects]]\nname = \"floor\"\nkind = \"sphere\"\nradius = 1.5\nmaterial = \"clay\"\nplace = [{ translate = [0, -2, 0] }]\n";
    let prepared = |text: &str| {
        let framed = scene(&format!("{text}{floor}"))
            .frame(64, 48)
            .expect("valid");
        prepare(&framed, Format::BASE).expect("prepared")
    };
    let shadows = |scene: &PreparedScene| {
        let of_ball = scene.volumes.iter().filter(|v| v.name.contains("'ball'"));
        of_ball.count()
    };
    let closed = prepared(&patch);
    assert_eq!(shadows(&closed), 1);
    assert!(closed.objects[0].notes().is_empty());
    let cut = patch.replace(
        "radius = 1\n",
        "radius = 1\ncuts = [{ point = [0, 0, 0], normal = [0, 1, 0] }]\n",
    );
    assert_ne!(cut, patch);
    let open = prepared(&cut);
    assert_eq!(shadows(&open), 0);
    assert!(open.objects[0].notes()[0].contains("casts no shadow: the shadow of a cut patch"));
}

/// What the first generation draws has no shadow volumes: where a light casts shadows, it says so, unless it is
/// told to cast none; a mesh has one of each facet, unless it is told so.
#[test]
fn what_has_no_shadow_volumes_says_so() {
    let of = |text: &str, quiet: bool| {
        let lit = text.replacen("[[lights]]\n", "[[lights]]\nshadows = true\n", 1);
        let mut file = scene(&lit);
        for object in &mut file.objects {
            object.casts_shadow = !quiet;
        }
        let framed = file.frame(64, 48).expect("valid");
        let prepared = prepare(&framed, Format::BASE).expect("prepared");
        let notes = prepared.objects.iter().map(|o| o.notes().join(" "));
        let says = |note: String| note.contains("casts no shadow: there are no shadow volumes");
        (
            notes.map(says).collect::<Vec<bool>>(),
            prepared.volumes.len(),
        )
    };
    let mesh = include_str!("../../../../scenes/processors/mesh.toml");
    let (notes, volumes) = of(mesh, false);
    assert!(
        !notes.contains(&true) && volumes > 10,
        "{notes:?}, {volumes}"
    );
    assert_eq!(of(mesh, true), (vec![false; notes.len()], 0));
    let first = include_str!("../../../../scenes/processors/first-generation.toml");
    let (notes, volumes) = of(first, false);
    assert!(
        notes.contains(&true) && volumes == 0,
        "{notes:?}, {volumes}"
    );
    assert_eq!(of(first, true), (vec![false; notes.len()], 0));
}
