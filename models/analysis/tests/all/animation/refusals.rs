//! What an author of groups, cameras and images is told.

use super::{CAMERA, CHAIN, ball, scene};
use imogene_scene::animation::{MAX_MOVES, Playback};
use imogene_scene::{MAX_NESTING, SceneFile};
use imogene_testkit::rows;

/// Asserts that a scene is refused with all of these parts of a message.
fn refused(top: &str, rest: &str, parts: &[&str]) {
    let refusal = SceneFile::parse(&scene(top, rest), "test.toml").expect_err("a refusal");
    let message = refusal.to_string();
    for part in parts {
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
    assert!(message.starts_with("test.toml"));
}

/// Line and column of a text in a scene, as messages give them.
fn place_of(text: &str, top: &str, rest: &str) -> String {
    let scene = scene(top, rest);
    let offset = scene.find(text).expect("the text is there");
    let before = &scene[..offset];
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap().len() + 1;
    format!("test.toml:{line}:{column}:")
}

fn with_group(name: &str, parent: Option<&str>) -> String {
    let parent = parent.map_or(String::new(), |p| format!("group = \"{p}\"\n"));
    format!("[[groups]]\nname = \"{name}\"\n{parent}")
}

fn with_image(keys: &str) -> String {
    ball("") + "[[images]]\nname = \"one\"\n" + keys + "\n"
}

fn with_action(action: &str) -> String {
    with_image(&format!("actions = [{action}]"))
}

/// Each row has what `rest` makes the rest of a scene of, and the parts of the message.
fn refused_each(rest: fn(&str) -> String, table: &str) {
    for row in rows(table) {
        refused(CAMERA, &rest(&row[0].replace("\\n", "\n")), &row[1..]);
    }
}

/// The same of cameras: a part of the usual one, what stands in its place, and the parts of the message.
fn refused_cameras(table: &str) {
    for row in rows(table) {
        let [old, new] = [row[0], row[1]].map(|text| text.replace("\\n", "\n"));
        refused(&CAMERA.replace(&old, &new), &ball(""), &row[2..]);
    }
}

fn parallel_camera() -> String {
    let parallel = CAMERA.replace("perspective", "orthographic");
    parallel.replace("viewer_distance", "half_depth")
}

#[test]
fn groups_that_do_not_exist() {
    let none = ball("group = \"arm\"");
    let parts = [
        "object `ball`, group",
        "`arm` is not a group",
        "no `[[groups]]` yet",
    ];
    refused(CAMERA, &none, &parts);
    let other = with_group("leg", None) + &none;
    refused(CAMERA, &other, &["the scene has `leg`"]);
    let parent = with_group("leg", Some("hip")) + &ball("");
    let parts = ["group `leg`, group", "`hip` is not a group"];
    refused(CAMERA, &parent, &parts);
    let camera = format!("{CAMERA}group = \"rig\"\n");
    refused(&camera, &ball(""), &["camera `eye`, group", "`rig`"]);
    let light =
        format!("{CAMERA}[[lights]]\nkind = \"point\"\nposition = [0, 5, 0]\ngroup = \"rig\"\n");
    refused(&light, &ball(""), &["lights[0], group", "`rig`"]);
}

#[test]
fn groups_within_themselves() {
    let circle =
        with_group("a", Some("b")) + &with_group("b", Some("c")) + &with_group("c", Some("a"));
    let parts = [
        "group `a`, group",
        "the group is within itself: `a` in `b` in `c` in `a`",
    ];
    refused(CAMERA, &(circle.clone() + &ball("")), &parts);
    let own = with_group("a", Some("a")) + &ball("");
    refused(CAMERA, &own, &["`a` in `a`", "outside it"]);
    // A group that leads into a circle it is not part of.
    let beside = with_group("z", Some("a")) + &circle + &ball("");
    refused(CAMERA, &beside, &["group `z`", "circle"]);
}

#[test]
fn groups_nested_too_deeply() {
    let chain = |depth: usize| {
        let one = |i: usize| {
            with_group(
                &format!("g{i}"),
                (i > 0).then(|| format!("g{}", i - 1)).as_deref(),
            )
        };
        (0..depth).map(one).collect::<String>() + &ball("")
    };
    assert!(SceneFile::parse(&scene(CAMERA, &chain(MAX_NESTING)), "test.toml").is_ok());
    let beyond = chain(MAX_NESTING + 2);
    refused(CAMERA, &beyond, &["64 groups", "at most 64"]);
}

#[test]
fn names_taken_by_another_class() {
    let parts = ["group `ball`", "taken by an earlier object", "unique"];
    refused(CAMERA, &(with_group("ball", None) + &ball("")), &parts);
    let light =
        format!("{CAMERA}[[lights]]\nname = \"ball\"\nkind = \"point\"\nposition = [0, 5, 0]\n");
    refused(&light, &ball(""), &["light `ball`", "earlier object"]);
    let light = light.replace("\"ball\"", "\"eye\"");
    refused(&light, &ball(""), &["camera `eye`", "earlier light"]);
    let twice = ball("") + CHAIN + "[[images]]\nname = \"moved\"\n";
    refused(CAMERA, &twice, &["image `moved`", "earlier image"]);
}

#[test]
fn cameras_that_cannot_be() {
    let parts = ["test.toml:1:1:", "missing field `camera`", "[[cameras]]"];
    refused("", &ball(""), &parts);
    refused_cameras(
        r#"
        [camera]\nname = "eye" | [[cameras]] | cameras[0] has no `name`
        [camera] | active_camera = "top"\n[camera] | active_camera | `top` is not a camera | the scene has `eye`
        view_height = 6 | focal = 0.5 | focal: 0.5 is out of range | from 1 to 10000 millimetres
        view_height = 6 | focal = nan | focal: NaN is out of range
        view_height = 6 | field_of_view = 175 | field_of_view: 175 | 0.1 to 170 degrees
        "#,
    );
    let both = CAMERA.to_owned() + "focal = 50\n";
    let table = place_of("[camera]", &both, "");
    let several = "one of `view_height`, `focal`, `field_of_view`; found several";
    refused(&both, &ball(""), &[&table, several]);
    let parallel = parallel_camera().replace("view_height = 6", "focal = 50");
    let parts = ["an orthographic camera has no `focal`"];
    refused(&parallel, &ball(""), &parts);
}

#[test]
fn actions_on_what_does_not_exist_or_cannot_do_it() {
    refused_each(
        with_action,
        r#"
        { target = "bal", translate = [1, 0, 0] } | image `one`, actions[0].target | nothing of this scene has the name `bal` | `ball`, `eye`
        { target = "eye", show = false } | actions[0].target | `eye` is a camera | object or group or light is needed
        { light = "ball", intensity = 0.5 } | actions[0].light | `ball` is an object
        { camera = "ball", focal = 50 } | actions[0].camera | `ball` is not a camera | the scene has `eye`
        { active_camera = "top" } | actions[0].active_camera | `top` is not a camera
        { camera = "eye", focal = 1e9 } | focal | millimetres is possible
        { target = "ball", scale = 0 } | actions[0].scale | singular
        "#,
    );
    let parts = ["`eye` is an orthographic camera and has no lens"];
    let action = with_action("{ camera = \"eye\", focal = 50 }");
    refused(&parallel_camera(), &action, &parts);
}

#[test]
fn actions_that_say_nothing_or_too_much() {
    let table = r#"
        { target = "ball" } | the action on `ball` is empty
        { translate = [1, 0, 0] } | does not name what it changes
        { target = "ball", translate = [1, 0, 0], scale = 2 } | several steps in one table
        { target = "ball", show = true, scale = 2 } | moves and shows at once
        { target = "ball", focal = 50 } | an action with `target` has no `focal`
        { light = "ball" } | needs `intensity`
        { camera = "eye", intensity = 1 } | an action with `camera` has no `intensity`
        { active_camera = "eye", show = true } | an action with `active_camera` has no `show`
        { target = "ball", translate = [1, 0] } | 2 numbers found
        { target = "ball", scale = 2, frame = "scene" } | unknown variant `scene`
        { target = "ball", sclae = 2 } | unknown field `sclae`
        "#;
    for row in rows(table) {
        let rest = with_action(row[0]);
        let line = place_of("actions = [", CAMERA, &rest);
        let line = line.rsplit_once(':').unwrap().0.rsplit_once(':').unwrap().0;
        refused(CAMERA, &rest, &[row[1], &format!("{line}:")]);
    }
    let rest = with_action("{ target = \"ball\", sclae = 2 }");
    refused(CAMERA, &rest, &[&place_of("sclae", CAMERA, &rest)]);
    let rest = with_image("lasts = 3");
    let place = place_of("lasts", CAMERA, &rest);
    let parts = [&*place, "unknown field `lasts`", "`duration`"];
    refused(CAMERA, &rest, &parts);
}

#[test]
fn images_that_cannot_be_played() {
    refused_each(
        with_image,
        r#"
        duration = 0 | image `one`, duration | 0.001 to 60
        duration = nan | duration | NaN
        steps = 0 | image `one`, steps | 1 to 100000
        steps = -1 | test.toml: | whole number that is not negative
        steps = 100000\n[[images]]\nname = "two" | images | 100001 frames | at most 100000
        steps = 2\nactions = [{ target = "ball", scale = [-1, 1, 1] }] | actions[0].scale | mirrors | steps = 1
        parent = "zero" | image `one`, parent | `zero` is not an image | `one`
        parent = "two"\n[[images]]\nname = "two"\nparent = "one" | image `one`, parent | `one` from `two` from `one`
        "#,
    );
}

#[test]
fn placements_do_not_grow_without_end() {
    // Two axes in turn, so that no two turns are one.
    let pair = "{ target = \"ball\", rotate = { axis = \"x\", degrees = 1 } }, { target = \"ball\", rotate = { axis = \"y\", degrees = 1 } },";
    let file = |pairs: usize| {
        let rest = with_action(&pair.repeat(pairs));
        SceneFile::parse(&scene(CAMERA, &rest), "test.toml").expect("valid")
    };
    let (most, beyond) = (file(MAX_MOVES / 2), file(MAX_MOVES / 2 + 1));
    assert!(Playback::new(&most).unwrap().scene(0).is_ok());
    let refusal = Playback::new(&beyond).unwrap().scene(0).unwrap_err();
    let refusal = refusal.to_string();
    let said = "image `one`: the placement of `ball` has more than 64 steps";
    assert!(refusal.contains(said), "{refusal}");
}

#[test]
fn nothing_to_play() {
    let inactive = with_image("active = false");
    let file = SceneFile::parse(&scene(CAMERA, &inactive), "test.toml").expect("valid");
    let refusal = Playback::new(&file).err().expect("a refusal").to_string();
    assert!(refusal.contains("no images to play"));
}

/// The messages shown on the page of the format are the real ones.
#[test]
fn documented_messages_are_real() {
    // A long message goes on in an indented line behind its semicolon.
    let page = include_str!("../../../../../docs/scene-format.md").replace(";\n  ", "; ");
    let circle = with_group("a", Some("b")) + &with_group("b", Some("a")) + &ball("");
    let camera = CAMERA.replace("name = \"eye\"\n", "");
    let image = |keys: &str| with_image(keys).replace("\"one\"", "\"reach\"");
    for rest in [
        circle,
        image("actions = [{ target = \"forarm\", scale = 2 }]"),
        image("parent = \"rest\""),
    ] {
        let refusal = SceneFile::parse(&scene(&camera, &rest), "demo.toml").expect_err("a refusal");
        let message = refusal.to_string();
        assert!(page.contains(&message), "not on the page: {message}");
    }
}
