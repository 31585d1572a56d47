//! What is left out because nobody sees it changes nothing that is drawn: range, words, depths, ids and faces are those
//! of the whole scene.

use imogene_analysis::exact::render::render;
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_prepare::Framing;
use imogene_prepare::{Options, PreparedScene, prepare_with};
use imogene_scene::{Absent, FramedObject, FramedScene, SceneFile};
use proptest::prelude::*;
use std::fmt::Write;

const SIZE: (u32, u32) = (96, 72);

/// A ball: place and radius.
type Ball = ([f64; 3], f64);

fn scene(camera: &str, balls: &[Ball], more: &str) -> SceneFile {
    let mut text = format!(
        "format = 1\ntitle = \"balls\"\n[camera]\n{camera}\n[[materials]]\nname = \"m\"\ncolour = [0.5, 0.5, 0.5]\n"
    );
    for (k, ([x, y, z], radius)) in balls.iter().enumerate() {
        writeln!(
            text,
            "[[objects]]\nname = \"ball {k}\"\nkind = \"sphere\"\nradius = {radius:?}\nmaterial = \"m\"\n\
             place = [{{ translate = [{x:?}, {y:?}, {z:?}] }}]"
        )
        .expect("text");
    }
    SceneFile::parse(&(text + more), "balls").expect("valid")
}

struct Drawn {
    framed: FramedScene,
    prepared: PreparedScene,
    frame: Frame,
}

fn drawn(framed: FramedScene, format: Format) -> Drawn {
    let options = Options {
        without_refused: true,
        ..Options::default()
    };
    let prepared = prepare_with(&framed, format, options).expect("without what is refused");
    let frame = prepared.frame(|| ());
    Drawn {
        framed,
        prepared,
        frame,
    }
}

/// The scene with all its objects, and with those that are seen.
fn both(file: &SceneFile, format: Format) -> [Drawn; 2] {
    let (width, height) = SIZE;
    let whole = file.frame(width, height).expect("valid");
    let seen = file.frame_seen(width, height, &format).expect("valid");
    [whole, seen].map(|framed| drawn(framed, format))
}

fn assert_same([whole, seen]: &[Drawn; 2]) -> Result<(), TestCaseError> {
    prop_assert_eq!(&whole.framed.range, &seen.framed.range);
    prop_assert_eq!(&whole.prepared.missing, &seen.prepared.missing);
    let objects = seen.framed.objects.iter().zip(&whole.framed.objects);
    let prepared = seen.prepared.objects.iter().zip(&whole.prepared.objects);
    for ((own, other), (words, other_words)) in objects.zip(prepared) {
        prop_assert_eq!(own.name(), other.name());
        prop_assert_eq!(own.material(), other.material());
        if matches!(own, FramedObject::Unseen(_)) {
            prop_assert!(words.words().is_empty());
        } else {
            prop_assert_eq!(own, other);
            prop_assert_eq!(words.words(), other_words.words());
        }
    }
    prop_assert!(whole.frame.id == seen.frame.id, "id");
    prop_assert!(whole.frame.depth == seen.frame.depth, "depth");
    prop_assert!(whole.frame.number == seen.frame.number, "number");
    prop_assert!(whole.frame.normal == seen.frame.normal, "normal");
    Ok(())
}

fn absent(drawn: &Drawn) -> Absent {
    Absent::of(&drawn.framed.objects)
}

fn ball() -> impl Strategy<Value = Ball> {
    let thousandths = |n: i32| f64::from(n) / 1000.0;
    let place = [-6000i32..6000, -5000..5000, -6000..6000].prop_map(move |p| p.map(thousandths));
    (place, (300i32..2500).prop_map(thousandths))
}

fn camera() -> impl Strategy<Value = String> {
    let from =
        [-2000i32..2000, -2000..2000, 500..2000].prop_map(|v| v.map(|n| f64::from(n) / 1000.0));
    // Far away, close to the first balls, and among them.
    let distance = prop_oneof![Just(60.0), Just(25.0), Just(9.0), Just(4.0), Just(1.0)];
    // At whole places, at half ones, and at others.
    let at = prop_oneof![Just([0.0, 0.0]), Just([0.5, 0.5]), Just([-0.375, 0.875])];
    (from, distance, 3.0f64..14.0, any::<bool>(), any::<bool>(), at).prop_map(|(from, distance, height, along, flat, at)| {
        let from = if along { [0.0, 0.0, 1.0] } else { from };
        let length = from.iter().map(|v| v * v).sum::<f64>().sqrt();
        let eye = from.map(|v| (v / length * distance * 1e3).round() / 1e3);
        let height = (height * 1e2).round() / 1e2;
        match flat {
            true => format!("kind = \"orthographic\"\neye = {eye:?}\ntarget = [0, 0, 0]\nview_height = {height}\nsample_at = {at:?}"),
            false => format!(
                "kind = \"perspective\"\neye = {eye:?}\ntarget = [0, 0, 0]\nviewer_distance = {distance}\nview_height = {height}\nsample_at = {at:?}"
            ),
        }
    })
}

/// Objects that are no balls: they are always kept, hide nothing, and are drawn as they are.
const OTHERS: &str = "[[objects]]\nname = \"egg\"\nkind = \"ellipsoid\"\nradii = [1, 2, 1.5]\nmaterial = \"m\"\n\
    [[objects]]\nname = \"stick\"\nkind = \"elliptic_cylinder\"\nradii = [0.4, 0.4]\nmaterial = \"m\"\n\
    cuts = [{ point = [0, -3, 0], normal = [0.1, -1, 0.05] }, { point = [0, 3, 0], normal = [0.1, 1, 0.05] }]\n\
    place = [{ rotate = { axis = [1, 2, 3], degrees = 50 } }]\n";

proptest! {
    #[test]
    fn pictures_ranges_and_words_are_those_of_the_whole_scene(
        balls in proptest::collection::vec(ball(), 1..120), camera in camera(), others in any::<bool>(), depth in 0usize..3, guards in any::<bool>()
    ) {
        let format = Format::new([16, 24, 32][depth]).expect("of the catalogue");
        let format = if guards && depth < 2 { format.with_guards(2, 3).expect("room") } else { format };
        let file = scene(&camera, &balls, if others { OTHERS } else { "" });
        assert_same(&both(&file, format))?;
    }
}

const AHEAD: &str = "kind = \"perspective\"\neye = [0, 0, 40]\ntarget = [0, 0, 0]\nviewer_distance = 40\nview_height = 10";

/// One ball before five, one beside them in full view, two off the picture, one behind the viewer, one that the edge
/// of the picture cuts.
#[test]
fn what_is_left_out_is_counted() {
    let front = [([0.0, 0.0, 0.0], 2.5)];
    let behind = (0..5).map(f64::from);
    let behind = behind.map(|k| ([0.3 * k - 0.6, 0.2, -6.0 - 3.0 * k], 1.0));
    let rest = [
        ([4.0, -3.0, 0.0], 1.0),
        ([40.0, 0.0, 0.0], 1.0),
        ([0.0, -30.0, -9.0], 1.5),
        ([0.0, 0.0, 60.0], 1.0),
        ([0.0, 5.0, 0.0], 1.0),
    ];
    let balls: Vec<Ball> = front.into_iter().chain(behind).chain(rest).collect();
    let pictures = both(&scene(AHEAD, &balls, ""), Format::BASE);
    assert_same(&pictures).unwrap();
    let [whole, seen] = &pictures;
    assert_eq!((absent(seen).hidden, absent(seen).off_screen), (5, 3));
    assert_eq!(absent(whole), Absent::default());
    // The last ones are those that are seen, by their own numbers.
    assert!(seen.frame.id.contains(&6) && seen.frame.id.contains(&10));
}

/// A ball slides out from behind another. As soon as it has a pixel of the whole picture it is kept; a bound of the
/// outline that is too tight by less than a pixel would leave it out where it has one.
#[test]
fn a_ball_that_shows_one_pixel_is_kept() {
    let (mut single, mut hidden) = (0, 0);
    for step in 0..600 {
        let x = 1.4 + 0.001 * f64::from(step);
        let file = scene(AHEAD, &[([0.0, 0.0, 0.0], 2.5), ([x, 0.1, -4.0], 1.0)], "");
        let pictures = both(&file, Format::BASE);
        assert_same(&pictures).unwrap();
        let [whole, seen] = &pictures;
        let pixels = whole.frame.id.iter().filter(|&&id| id == 1).count();
        hidden += absent(seen).hidden;
        single += usize::from(pixels == 1);
        assert!(pixels == 0 || absent(seen).hidden == 0);
    }
    assert!(single > 0, "it never shows one pixel alone");
    assert!(hidden > 0, "it is never left out");
}

/// A ball in another that is larger by less and less: in the end both have the same words of depth, and the first one,
/// which is the inner one, is seen, though true depths say that it is hidden.
#[test]
fn a_ball_that_only_rounding_shows_is_kept() {
    let (mut let_through, mut hidden) = (0, 0);
    for step in 0..40 {
        let inner = 2.5 - 0.5 * 0.6f64.powi(step);
        let file = scene(AHEAD, &[([0.0; 3], inner), ([0.0; 3], 2.5)], "");
        for format in [Format::new(16), Format::new(24)].map(Result::unwrap) {
            let pictures = both(&file, format);
            assert_same(&pictures).unwrap();
            let [whole, seen] = &pictures;
            let_through += usize::from(inner < 2.5 && whole.frame.id.contains(&0));
            hidden += absent(seen).hidden;
        }
    }
    assert!(let_through > 0, "rounding never shows it");
    assert!(hidden > 10, "it is hardly ever left out");
}

/// Shadows and spots need what is hidden.
#[test]
fn a_scene_with_shadows_keeps_all_its_objects() {
    let light = |keys: &str| format!("[[lights]]\ncolour = [1, 1, 1]\n{keys}\n");
    let balls = [([0.0, 0.0, 0.0], 2.5), ([0.0, 0.0, -6.0], 1.0)];
    let hidden = |keys: &str| {
        let pictures = both(&scene(AHEAD, &balls, &light(keys)), Format::BASE);
        assert_same(&pictures).unwrap();
        absent(&pictures[1]).hidden
    };
    assert_eq!(hidden("kind = \"directional\"\nfrom = [1, 1, 1]"), 1);
    let sun = "kind = \"directional\"\nfrom = [1, 1, 1]\nshadows = true";
    assert_eq!(hidden(sun), 0);
    let lamp = "kind = \"point\"\nposition = [9, 9, 9]\nshadows = true";
    assert_eq!(hidden(lamp), 0);
    let spot = "kind = \"spot\"\nposition = [0, 0, 30]\ntarget = [0, 0, 0]\nhalf_angle = 20";
    assert_eq!(hidden(spot), 0);
}

/// The golden picture of what is left is that of the exact reference of the whole scene, as far as that of the whole
/// scene is.
#[test]
fn the_exact_picture_needs_no_more() {
    let balls: Vec<Ball> = (0..60)
        .map(|k| {
            let k = f64::from(k);
            let (x, z) = ((k * 0.71).sin() * 3.0, (k * 2.11).sin() * 3.0);
            let place = [x, (k * 1.37).cos() * 2.0, z];
            (place.map(|v| (v * 1e3).round() / 1e3), 1.2)
        })
        .collect();
    let [whole, seen] = both(&scene(AHEAD, &balls, ""), Format::BASE);
    assert!(absent(&seen).hidden > 5);
    let exact = |framed: &FramedScene| render(framed, &Format::BASE, || ());
    assert_eq!(exact(&whole.framed), exact(&seen.framed));
}
