//! Groups, cameras and images: where everything is in each frame, by matrices multiplied by hand and by scenes without
//! groups.

mod refusals;
mod reuse;

use imogene_algebra::rational::{fraction, integer};
use imogene_prepare::Framing;
use imogene_scene::animation::Playback;
use imogene_scene::{Beam, SceneFile, Step, Transform};
use imogene_testkit::scene_file;
use num_rational::BigRational;

/// A scene of one ball with more keys; `top` stands before the first table.
fn scene(top: &str, rest: &str) -> String {
    format!(
        "format = 1\ntitle = \"test\"\nimage = {{ width = 48, height = 36 }}\n{top}\n\
         [[materials]]\nname = \"plain\"\ncolour = [0.5, 0.5, 0.5]\n{rest}"
    )
}

const CAMERA: &str = "[camera]\nname = \"eye\"\nkind = \"perspective\"\neye = [0, 0, 10]\n\
                      target = [0, 0, 0]\nviewer_distance = 10\nview_height = 6\n";

fn ball(keys: &str) -> String {
    format!(
        "[[objects]]\nname = \"ball\"\nkind = \"sphere\"\nradius = 1\nmaterial = \"plain\"\n{keys}\n"
    )
}

fn parsed(top: &str, rest: &str) -> SceneFile {
    SceneFile::parse(&scene(top, rest), "test.toml").expect("a valid scene")
}

/// The placement of the first object in a frame.
fn placed(file: &SceneFile, frame: usize) -> Transform {
    let playback = Playback::new(file).expect("frames");
    let scene = playback.scene(frame).expect("a frame");
    Transform::placement(&scene.flattened().objects[0].place)
}

/// Where the origin of the first object is.
fn origin(file: &SceneFile, frame: usize) -> [BigRational; 3] {
    placed(file, frame).point(&[0, 0, 0].map(integer))
}

fn whole(rows: [[i64; 4]; 4]) -> Transform {
    Transform {
        rows: rows.map(|row| row.map(integer)),
    }
}

const NESTED: &str = r#"
[[groups]]
name = "outer"
place = [{ scale = 2 }, { translate = [0, 0, 5] }]
[[groups]]
name = "inner"
group = "outer"
place = [{ rotate = { axis = "z", degrees = 90 } }]
"#;

#[test]
fn nested_frames_are_the_product_of_their_matrices() {
    let place = "group = \"inner\"\nplace = [{ scale = [1, 3, 1] }, { translate = [1, 2, 3] }]";
    let file = parsed(CAMERA, &(NESTED.to_owned() + &ball(place)));
    // (x, y, z) -> (x + 1, 3y + 2, z + 3) -> (-(3y + 2), x + 1, z + 3) -> twice that, and 5 farther along z.
    let wanted = whole([[0, -6, 0, -4], [2, 0, 0, 2], [0, 0, 2, 11], [0, 0, 0, 1]]);
    let flat = file.flattened();
    assert_eq!(Transform::placement(&flat.objects[0].place), wanted);
    assert!(flat.groups.is_empty() && flat.objects[0].group.is_none());
}

#[test]
fn what_a_group_owns_is_where_its_members_would_be_without_it() {
    let members = |place: &str, group: &str, camera: &str, light: &str| {
        let cameras = format!("{camera}viewer_distance = 10\nview_height = 6\n{group}\n");
        let lights = format!(
            "[[lights]]\nkind = \"spot\"\n{light}half_angle = 20\nshadows = true\n{group}\n"
        );
        let groups = format!("[[groups]]\nname = \"rig\"\nplace = [{place}]\n");
        parsed(&(cameras + &lights), &(groups + &ball("")))
    };
    let rigged = members(
        "{ rotate = { axis = \"y\", degrees = 90 } }, { translate = [1, 0, -2] }",
        "group = \"rig\"",
        "[camera]\nkind = \"perspective\"\neye = [0, 1, 10]\ntarget = [0, 1, 0]\n",
        "position = [3, 5, 4]\ntarget = [0, 1, 2]\n",
    );
    // A quarter turn about y takes z to x and x to -z: (x, y, z) -> (z + 1, y, -x - 2).
    let by_hand = members(
        "",
        "",
        "[camera]\nkind = \"perspective\"\neye = [11, 1, -2]\ntarget = [1, 1, -2]\n",
        "position = [5, 5, -5]\ntarget = [3, 1, -2]\n",
    );
    let [rigged, by_hand] = [rigged, by_hand].map(|file| file.frame(48, 36).expect("valid"));
    assert_eq!(rigged, by_hand);
}

#[test]
fn hidden_groups_hide_their_members_and_their_shadows() {
    let light = "[[lights]]\nkind = \"point\"\nposition = [0, 5, 5]\ngroup = \"inner\"\n";
    let groups = NESTED.replacen("name = \"outer\"", "name = \"outer\"\nvisible = false", 1);
    let top = CAMERA.to_owned() + light;
    let two = ball("group = \"inner\"") + &ball("").replace("ball", "other");
    let file = |groups: &str| parsed(&top, &(groups.to_owned() + &two));
    let frame = |groups: &str| file(groups).frame(48, 36).unwrap();
    let (shown, hidden) = (frame(NESTED), frame(&groups));
    assert_eq!((shown.objects.len(), shown.sources.len()), (2, 1));
    assert_eq!((hidden.objects.len(), hidden.sources.len()), (1, 0));
    assert_eq!(hidden.objects[0].name(), "other");
}

const CHAIN: &str = r#"
[[images]]
name = "turned"
parent = "moved"
actions = [{ target = "ball", rotate = { axis = "z", degrees = 90 } }]
[[images]]
name = "fresh"
actions = [{ target = "ball", translate = [0, 0, 1] }]
[[images]]
name = "moved"
active = false
actions = [{ target = "ball", translate = [1, 0, 0] }]
[[images]]
name = "own"
parent = "turned"
actions = [{ target = "ball", translate = [0, 3, 0], frame = "own" }]
"#;

#[test]
fn images_start_from_their_parents_and_not_from_the_image_before() {
    let objects = ball("place = [{ translate = [5, 0, 0] }]");
    let file = parsed(CAMERA, &(objects + CHAIN));
    let playback = Playback::new(&file).unwrap();
    let shown = (0..playback.count()).map(|i| playback.frame(i).image);
    let shown: Vec<String> = shown.collect();
    // The inactive image is no frame, and a later image may be a parent.
    assert_eq!(shown, ["turned", "fresh", "own"]);
    // (5, 0, 0) moved to (6, 0, 0), then turned about the scene's origin.
    assert_eq!(origin(&file, 0), [0, 6, 0].map(integer));
    // Image -1: nothing of the other images.
    assert_eq!(origin(&file, 1), [5, 0, 1].map(integer));
    // Up in the ball's own frame, which has been turned a quarter: along -x.
    assert_eq!(origin(&file, 2), [-3, 6, 0].map(integer));
}

#[test]
fn actions_are_done_in_their_order() {
    let turn = "{ target = \"ball\", rotate = { axis = \"z\", degrees = 90 } }";
    let shift = "{ target = \"ball\", translate = [1, 0, 0] }";
    let after = |first: &str, second: &str| {
        let images = format!("[[images]]\nname = \"one\"\nactions = [{first}, {second}]\n");
        origin(&parsed(CAMERA, &(ball("") + &images)), 0)
    };
    assert_eq!(after(turn, shift), [1, 0, 0].map(integer));
    assert_eq!(after(shift, turn), [0, 1, 0].map(integer));
}

#[test]
fn frames_in_between_are_equal_parts() {
    let images = r#"
[[images]]
name = "way"
steps = 4
actions = [
  { target = "ball", scale = [16, 1, 1] },
  { target = "ball", translate = [1, 0, 2] },
  { target = "ball", rotate = { axis = "y", degrees = 360 }, frame = "own" },
]
"#;
    let file = parsed(CAMERA, &(ball("") + images));
    assert_eq!(Playback::new(&file).unwrap().count(), 4);
    let turns = [[2, 0, 1], [4, -1, 0], [8, 0, -1], [16, 1, 0]];
    for (frame, [factor, cos, sin]) in turns.into_iter().enumerate() {
        // The own turn by quarters first, then the factor 16^(k/4), then k/4 of the way.
        let part = fraction(frame as i64 + 1, 4);
        let turn = [
            [factor * cos, 0, factor * sin, 0],
            [0, 1, 0, 0],
            [-sin, 0, cos, 0],
        ];
        let mut wanted = whole([turn[0], turn[1], turn[2], [0, 0, 0, 1]]);
        wanted.rows[2][3] = &part * integer(2);
        wanted.rows[0][3] = part;
        assert_eq!(placed(&file, frame), wanted, "frame {frame}");
    }
}

#[test]
fn switches_lights_and_lenses_change_too() {
    let top = CAMERA.to_owned()
        + "[[cameras]]\nname = \"other\"\nkind = \"perspective\"\neye = [10, 0, 0]\ntarget = [0, 0, 0]\n\
           viewer_distance = 10\nfocal = 50\n\
           [[lights]]\nname = \"lamp\"\nkind = \"point\"\nposition = [0, 5, 5]\nintensity = 1\n";
    let images = r#"
[[images]]
name = "change"
steps = 2
actions = [
  { target = "lamp", translate = [0, 1, 0] },
  { target = "ball", show = false },
  { light = "lamp", intensity = 0.5 },
  { camera = "other", focal = 100 },
  { active_camera = "other" },
]
"#;
    let two = ball("") + &ball("").replace("ball", "two");
    let file = parsed(&top, &(two + images));
    let playback = Playback::new(&file).unwrap();
    for (frame, intensity, height) in [(0, 0.75, 3.2), (1, 0.5, 2.4)] {
        let scene = playback.scene(frame).unwrap();
        assert!(!scene.objects[0].visible && scene.objects[1].visible);
        let light = &scene.lights[0];
        assert!(matches!(light.beam, Beam::Point { .. }));
        assert_eq!(light.intensity, intensity);
        let place = [Step::Translate([0.0, [0.5, 1.0][frame], 0.0])];
        assert_eq!(light.node.place, place);
        let camera = scene.active();
        // 24 mm : f = height : 10, with f = 75 and 100.
        assert_eq!((camera.view_height, camera.eye[0]), (height, 10.0));
        assert!(scene.images.is_empty());
    }
}

#[test]
fn lenses_have_the_field_of_view_of_the_table() {
    // Vertical fields of view for 24 x 36 film (course, table 1.1), rounded there to a tenth of a degree.
    let table = [
        (400, 3.4),
        (200, 6.9),
        (100, 13.7),
        (50, 27.0),
        (35, 37.8),
        (28, 46.4),
        (24, 53.1),
    ];
    let height = |window: &str| {
        let camera = CAMERA.replace("view_height = 6", window);
        parsed(&camera, &ball("")).camera.view_height
    };
    for (focal, field) in table {
        let lens = height(&format!("focal = {focal}"));
        let least = height(&format!("field_of_view = {}", field - 0.05));
        let most = height(&format!("field_of_view = {}", field + 0.05));
        assert!(least <= lens && lens <= most, "{focal} mm");
    }
    // 24 x 10 / 50, exactly.
    assert_eq!(height("focal = 50"), 4.8);
}

#[test]
fn the_first_camera_is_active_unless_another_is_named() {
    let camera = |name: &str, x: u32| {
        format!(
            "[[cameras]]\nname = \"{name}\"\nkind = \"orthographic\"\neye = [{x}, 0, 9]\ntarget = [0, 0, 0]\n\
             view_height = 6\nhalf_depth = 9\n"
        )
    };
    let cameras = camera("one", 1) + &camera("two", 2);
    let eye = |file: &SceneFile| file.active().eye[0];
    let mut file = parsed(&cameras, &ball(""));
    assert_eq!(eye(&file), 1.0);
    let named = format!("active_camera = \"two\"\n{cameras}");
    assert_eq!(eye(&parsed(&named, &ball(""))), 2.0);
    file.look_through("two").unwrap();
    assert_eq!(eye(&file), 2.0);
    let [flat, own] = [file.flattened().as_ref(), &file].map(|f| f.frame(48, 36).unwrap());
    assert_eq!(flat, own);
}

#[test]
fn animated_scenes_are_written_and_read_back() {
    for name in ["arm", "moon"] {
        let file = scene_file(&format!("animation/{name}"));
        let text = file.to_toml().expect("a valid scene");
        assert_eq!(SceneFile::parse(&text, name).expect("valid"), file);
        // A frame is a scene of its own.
        let playback = Playback::new(&file).unwrap();
        assert!(playback.count() >= 24);
        let frame = playback.scene(playback.count() / 2).unwrap();
        let text = frame.to_toml().expect("a valid scene");
        assert_eq!(SceneFile::parse(&text, name).expect("valid"), frame);
    }
}

#[test]
fn the_example_of_the_page_is_an_animation() {
    let page = include_str!("../../../../../docs/scene-format.md");
    let section = page.split("\n## Animation\n").nth(1).expect("the section");
    let example = section.split("```toml\n").nth(1).expect("an example");
    let example = example.split("```").next().unwrap();
    let file =
        SceneFile::parse(example, "scene-format.md").unwrap_or_else(|error| panic!("{error}"));
    let playback = Playback::new(&file).unwrap();
    assert_eq!(playback.count(), 13);
    let scenes = playback.scenes("lever.toml").unwrap();
    assert_eq!(
        scenes[12].0,
        "lever.toml, image `from close by`, frame 1 of 1"
    );
    assert_eq!(scenes[12].1, playback.scene(12).unwrap());
    for frame in 0..13 {
        let scene = playback.scene(frame).unwrap();
        let framed = scene.frame(32, 24);
        framed.unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn scenes_without_groups_are_flat_already() {
    let file = parsed(CAMERA, &ball(""));
    assert!(matches!(file.flattened(), std::borrow::Cow::Borrowed(_)));
}
