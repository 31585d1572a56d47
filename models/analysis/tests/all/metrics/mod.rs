//! The metrics on pictures that differ from the truth in known ways.

mod map_colours;
mod spread;
mod toggles;

use imogene_analysis::exact::render::DEPTH_FRACTION;
use imogene_analysis::metrics::{Drawing, Metrics, Truth, cracks, map, measure};
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_prepare::{Framing, prepare};
use imogene_scene::{FramedScene, Surface};
use imogene_testkit::{WIDTH, object, scene, scene_file, sphere};
use std::sync::LazyLock;

const F: Format = Format::BASE;

/// A cut ball before a greater one, and their truth.
static SCENE: LazyLock<(FramedScene, Truth)> = LazyLock::new(|| {
    let near = sphere([10, 5, 100], 40);
    let near = object("near", Surface::Solid, near, &[[1, 0, -1, 80]]);
    let far = object("far", Surface::Patch, sphere([0, 0, 300], 90), &[]);
    let scene = scene(vec![near, far]);
    let truth = Truth::new(&scene, || ());
    (scene, truth)
});

fn golden() -> Drawing {
    Drawing::of(&prepare(&SCENE.0, F).unwrap(), &SCENE.0)
}

/// A drawing that is the truth rounded down to words.
fn perfect() -> Drawing {
    let (_, truth) = &*SCENE;
    let mut drawing = golden();
    let words = |depth: i64| depth >> DEPTH_FRACTION;
    for (index, pixel) in truth.pixels.iter().enumerate() {
        let frame = &mut drawing.frame;
        let Some(pixel) = pixel else {
            frame.id[index] = -1;
            frame.depth[index] = F.z_max();
            continue;
        };
        frame.id[index] = pixel.id as i32;
        frame.number[index] = pixel.number;
        frame.depth[index] = words(pixel.depth);
        drawing.backs[index] = words(truth.backs[index].unwrap().depth);
        let direction = truth.normals[index];
        let length = direction.iter().map(|v| v * v).sum::<f64>().sqrt();
        frame.normal[index] = direction.map(|v| (v / length * 32767.0).round() as i16);
    }
    drawing.rgb = truth.rgb.clone();
    drawing
}

/// Pixels that show object `id` with everything else of it around them.
fn inside(id: u32) -> impl Iterator<Item = usize> {
    let (scene, truth) = &*SCENE;
    let (width, height) = (scene.width as usize, scene.height as usize);
    (0..width * height).filter(move |&index| {
        let (x, y) = (index % width, index / width);
        let shows = |k: usize| truth.pixels[k].is_some_and(|p| p.id == id);
        (1..width - 1).contains(&x)
            && (1..height - 1).contains(&y)
            && (y - 1..=y + 1).all(|v| (x - 1..=x + 1).all(|u| shows(v * width + u)))
    })
}

fn measured(change: impl FnOnce(&mut Drawing)) -> Metrics {
    let mut drawing = perfect();
    change(&mut drawing);
    measure(&SCENE.1, &drawing).0
}

#[test]
fn the_truth_itself_has_no_errors_but_its_rounding() {
    let metrics = measured(|_| ());
    assert!(metrics.covered > 10_000, "{}", metrics.covered);
    let wrong = metrics.silhouette + metrics.visible_part + metrics.cracks;
    assert_eq!((wrong, metrics.back_differs), (0, 0));
    // Rounded down: below a word, half a word on average.
    assert!(metrics.depth_words.max < 1.0 && metrics.depth_words.mean > 0.4);
    assert!(metrics.back_words.max < 1.0 && metrics.back_words.count > 10_000);
    assert_eq!(metrics.depth_words.count, metrics.covered);
    assert!(metrics.normal_deg.max < 0.003, "{}", metrics.normal_deg.max);
    assert_eq!(metrics.colour.max, 0.0);
    let counted: usize = metrics.depth_histogram.iter().map(|c| c.count).sum();
    assert_eq!(counted, metrics.covered);
    assert_eq!(metrics.depth_histogram.last().unwrap().below, 1.0);
}

#[test]
fn each_error_is_counted_where_it_belongs() {
    let (_, truth) = &*SCENE;
    let of_near: Vec<usize> = inside(0).take(3).collect();
    let background = truth.pixels.iter().position(Option::is_none).unwrap();
    let metrics = measured(|d| {
        d.frame.id[of_near[0]] = -1;
        d.frame.depth[of_near[0]] = F.z_max();
        d.frame.id[background] = 1;
        d.frame.depth[background] = 0;
        d.frame.id[of_near[1]] = 1;
        d.frame.number[of_near[2]] ^= 1;
    });
    assert_eq!((metrics.missing, metrics.extra), (1, 1));
    assert_eq!(metrics.silhouette, 2);
    assert_eq!((metrics.wrong_object, metrics.wrong_face), (1, 1));
    assert_eq!(metrics.visible_part, 2);
    // The four are in no statistics of the same face, and all in those of the colour.
    assert_eq!(metrics.depth_words.count, metrics.covered - 3);
    assert_eq!(metrics.colour.count, metrics.covered + 1);
    assert_eq!(metrics.colour_same_face.count, metrics.covered - 3);
    // One looks through the near ball; the wrong object has the right depth.
    assert_eq!(metrics.cracks, 1);
}

#[test]
fn depth_errors_are_in_words_and_in_pixels_of_depth() {
    let (_, truth) = &*SCENE;
    let index = inside(0).next().unwrap();
    let metrics = measured(|d| {
        d.frame.depth[index] += 1000;
        d.backs[index] -= 3000;
    });
    let (front, back) = (metrics.depth_words.max, metrics.back_words.max);
    assert!((999.0..=1000.0).contains(&front), "{front}");
    assert!((3000.0..3001.0).contains(&back), "{back}");
    assert_eq!(metrics.depth_px.max, front / truth.words_per_pixel);
    assert_eq!(metrics.depth_histogram.last().unwrap().below, 1024.0);
    assert_eq!(metrics.depth_histogram.last().unwrap().count, 1);
    // One of so many is within the thousandth that the quantile leaves out.
    assert!(metrics.depth_words.quantile_999 < 1.0);
}

#[test]
fn a_patch_with_a_face_too_few_is_counted_and_not_measured() {
    let index = inside(1).next().unwrap();
    let metrics = measured(|d| d.backs[index] = d.frame.depth[index]);
    assert_eq!(metrics.back_differs, 1);
    assert!(metrics.back_words.max < 1.0);
    assert_eq!(metrics.back_words.count, metrics.covered - 1);
}

#[test]
fn normals_are_lines_and_colours_are_channels() {
    let pixels: Vec<usize> = inside(1).take(2).collect();
    let metrics = measured(|d| {
        let [x, y, z] = d.frame.normal[pixels[0]];
        // Turned round: the same line. And a right angle.
        d.frame.normal[pixels[0]] = [-x, -y, -z];
        let [x, y, _] = d.frame.normal[pixels[1]];
        d.frame.normal[pixels[1]] = [y, -x, 0];
        for (k, by) in [(0, 3), (1, 9), (2, 5)] {
            let value = &mut d.rgb[3 * pixels[0] + k];
            *value = value.checked_sub(by).unwrap_or_else(|| *value + by);
        }
    });
    assert!((metrics.normal_deg.max - 90.0).abs() < 0.01);
    assert!(metrics.normal_deg.quantile_999 < 0.003);
    assert_eq!(metrics.colour.max, 9.0);
    assert_eq!(metrics.colour_same_face.max, 9.0);
    assert_eq!(metrics.colour.quantile_999, 0.0);
}

/// Seen through: behind all nine true points by more than a pixel. Beside an outline the far object is truly near by,
/// which is no crack.
#[test]
fn cracks_are_not_outlines() {
    let (_, truth) = &*SCENE;
    let width = WIDTH as usize;
    let index = inside(0).nth(50).unwrap();
    let pixel = F.z_max() / 50;
    let seen_through = |by: i64| {
        measured(|d| {
            d.frame.id[index] = 1;
            d.frame.number[index] = 1;
            d.frame.depth[index] += by;
        })
        .cracks
    };
    assert_eq!((seen_through(1), seen_through(pixel)), (0, 1));
    // On the outline of the near ball with the far one beside it.
    let shows = |k: usize| truth.pixels[k].map(|p| p.id);
    let outline = |&k: &usize| {
        let around = [k - width, k, k + width].map(|k| [k - 1, k, k + 1]);
        let mut around = around.into_iter().flatten();
        shows(k) == Some(0) && around.all(|n| shows(n).is_some()) && shows(k + 1) == Some(1)
    };
    let mut places = width + 1..truth.pixels.len() - width - 1;
    let edge = places.find(outline).unwrap();
    let metrics = measured(|d| {
        d.frame.id[edge] = 1;
        d.frame.number[edge] = 0;
        d.frame.depth[edge] = d.frame.depth[edge + 1];
    });
    assert_eq!((metrics.wrong_object, metrics.cracks), (1, 0));
    let metrics = measured(|d| {
        d.frame.id[edge] = -1;
        d.frame.depth[edge] = F.z_max();
    });
    assert_eq!((metrics.missing, metrics.cracks), (1, 1));
}

#[test]
fn the_map_marks_what_is_wrong() {
    let index = inside(0).next().unwrap();
    let mut drawing = perfect();
    drawing.frame.id[index] = 1;
    let (_, rgb) = measure(&SCENE.1, &drawing);
    let count = |colour: [u8; 3]| rgb.chunks(3).filter(|c| *c == colour).count();
    assert_eq!(rgb[3 * index..3 * index + 3], map::OBJECT);
    let covered = SCENE.1.covered();
    assert_eq!(count(map::BACKGROUND), SCENE.1.pixels.len() - covered);
    let others = [map::PRESENCE, map::FACE, map::CRACK];
    assert_eq!(others.map(count), [0; 3]);
}

/// The golden picture in shorter and shorter words: the errors of a word of W bits are at least those of the missing
/// bits.
#[test]
fn errors_of_short_words_are_given_in_words_of_the_base_format() {
    let mut last = 0.0;
    for depth in [24, 20, 16] {
        let format = Format::fitted(&MachineWords {
            depth,
            ..Format::new(depth).unwrap().widths()
        });
        let prepared = prepare(&SCENE.0, format.unwrap()).unwrap();
        let (metrics, _) = measure(&SCENE.1, &Drawing::of(&prepared, &SCENE.0));
        let word = f64::from(1u32 << (24 - depth));
        let median = metrics.depth_words.mean;
        assert!(median > 0.2 * word && median > last, "{depth}: {median}");
        last = median;
    }
}

/// The golden picture of a real scene: true backs are those of the processors.
#[test]
fn backs_of_the_scenes_agree_with_the_processors() {
    let scenes = [
        ("teapot", 60.0),
        ("cut-sphere", 20.0),
        ("front-view", 80.0),
        ("crossing-cylinders", 80.0),
    ];
    for (name, most) in scenes {
        let scene = scene_file(name).frame(160, 120).unwrap();
        let truth = Truth::new(&scene, || ());
        let drawing = Drawing::of(&prepare(&scene, F).unwrap(), &scene);
        let (metrics, _) = measure(&truth, &drawing);
        assert!(metrics.back_words.count > 1000, "{name}");
        assert!(metrics.back_words.max < most, "{name}: {metrics:?}");
        assert!(metrics.back_differs <= 2, "{name}: {metrics:?}");
        let golden = imogene_analysis::metrics::Golden {
            format: &drawing.format,
            frame: &drawing.frame,
            backs: None,
            numbered: &drawing.numbered,
        };
        assert_eq!(cracks(&truth, golden).len(), metrics.cracks);
    }
}
