//! `imogene prepare`.

use super::load_scene;
use crate::arguments::Scene;
use crate::failure::Result;
use crate::output;
use imogene_algebra::rational::to_f64;
use imogene_golden::format::Format;
use imogene_golden::object::load::load_words;
use imogene_golden::object::load_volume::load_volume;
use imogene_golden::object::quadric::{MAX_PLANES, ScreenBox};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::unused;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use imogene_prepare::volume::PreparedVolume;
use imogene_prepare::{PreparedObject, PreparedParts, PreparedQuadric};
use imogene_scene::FramedObject;
use serde::Serialize;
use serde_json::{Value, json};

/// The words of a scene, keys in the order of their letters.
#[derive(Serialize)]
struct Report<'a> {
    depth_scale: String,
    format: Format,
    height: u32,
    objects: Vec<ObjectReport<'a>>,
    unused: Value,
    volumes: Vec<Value>,
    width: u32,
}

#[derive(Serialize)]
#[serde(untagged)]
enum ObjectReport<'a> {
    Quadric(Value),
    Parts(PartsReport<'a>),
}

/// An object of other processors than quadric and patch: a list of their words, which can be longer than a number of a
/// [`Value`].
#[derive(Serialize)]
struct PartsReport<'a> {
    name: &'a str,
    needed_bits: Value,
    notes: &'a [String],
    processor: &'static str,
    processors: Vec<ProcessorWords>,
    screen_box: &'a ScreenBox,
}

pub fn run(options: &Scene, json: bool) -> Result {
    let (framed, scene) = load_scene(options)?;
    let object = |(framed, o)| {
        let o: &PreparedObject = o;
        let Some(q) = o.quadric() else {
            return ObjectReport::Parts(parts(framed, o));
        };
        let planes = q.words.planes.len().min(MAX_PLANES);
        ObjectReport::Quadric(json!({
            "name": q.name,
            "processor": framed.processor(),
            "words": q.words.wrapped(&scene.format),
            "preconditioned_f2": q.words.f2.preconditioned(scene.format.pe2_width()),
            "load_words": load_words(&q.words, &scene.format, planes),
            "needed_bits": q.needed,
            "rounding_bounds": q.bounds,
            "notes": q.notes,
        }))
    };
    let volume = |v: &PreparedVolume| -> Value {
        let f2 = v.words.quadric.map(|q| q.f2);
        json!({
            "name": v.name,
            "words": v.words.wrapped(&scene.format),
            "preconditioned_f2": f2.map(|f2| f2.preconditioned(scene.format.pe2_width())),
            "load_words": load_volume(&v.words, &scene.format, v.words.planes.len()),
            "needed_bits": v.needed,
            "rounding_bounds": v.bounds,
            "notes": v.notes,
        })
    };
    let pairs = || framed.objects.iter().zip(&scene.objects);
    let objects = pairs().map(object).collect();
    let volumes: Vec<Value> = scene.volumes.iter().map(volume).collect();
    if json {
        output::json(&Report {
            depth_scale: scene.depth_scale.to_string(),
            format: scene.format,
            height: scene.height,
            objects,
            unused: json!(unused::every_kind()),
            volumes,
            width: scene.width,
        });
        return Ok(());
    }
    output::text(format!(
        "{} x {} pixels, depth word {}, guard bits {}:{}, {:.6} depth words per pixel",
        scene.width,
        scene.height,
        scene.format.depth,
        scene.format.guard_linear,
        scene.format.guard_quadratic,
        to_f64(&scene.depth_scale)
    ));
    for (framed, object) in pairs() {
        match object {
            PreparedObject::Quadric(o) | PreparedObject::Patch(o) => describe(framed, o),
            PreparedObject::Parts(o) => describe_parts(framed, o),
            PreparedObject::Unseen(_) => unreachable!("every object is framed"),
        }
    }
    for v in &scene.volumes {
        describe_volume(v);
    }
    Ok(())
}

fn parts<'a>(framed: &FramedObject, o: &'a PreparedObject) -> PartsReport<'a> {
    let needed = match o {
        PreparedObject::Parts(parts) => json!(parts.needed),
        _ => json!([]),
    };
    PartsReport {
        name: o.name(),
        needed_bits: needed,
        notes: o.notes(),
        processor: framed.processor(),
        processors: o.words(),
        screen_box: o.screen_box(),
    }
}

fn describe_parts(framed: &FramedObject, o: &PreparedParts) {
    let (count, kind) = (o.words.len(), framed.processor());
    let heading = format!("{} ({count} of processor {kind})", o.name);
    let words = o.words.iter().map(serde_json::to_string);
    let words =
        words.map(|words| format!("  {}", words.expect("words have no unserialisable keys")));
    tell(&heading, &o.screen_box, words.collect(), &o.notes);
}

fn describe_volume(v: &PreparedVolume) {
    let w = &v.words;
    let mut lines = vec![];
    if let Some(q) = &w.quadric {
        lines.push(format!("  margin {}, {:?}", w.margin, q.class));
        lines.extend(quadric(&q.f1, &q.f2));
    }
    for (index, plane) in w.planes.iter().enumerate() {
        lines.push(plane_line("plane", index, plane.kind, &plane.depth));
    }
    tell(&v.name, &w.screen_box, lines, &v.notes);
}

fn describe(framed: &FramedObject, o: &PreparedQuadric) {
    let w = &o.words;
    let heading = match framed.processor() {
        "quadric" => format!("{} ({:?})", o.name, w.class),
        other => format!("{} ({:?}, processor {other})", o.name, w.class),
    };
    let mut lines = quadric(&w.f1, &w.f2).to_vec();
    for (index, plane) in w.planes.iter().enumerate() {
        lines.push(plane_line("cut", index, plane.kind, &plane.depth));
    }
    tell(&heading, &w.screen_box, lines, &o.notes);
}

fn tell(heading: &str, b: &ScreenBox, lines: Vec<String>, notes: &[String]) {
    output::text(format!("\n{heading}"));
    match b.is_empty() {
        true => output::text("  box  empty"),
        false => output::text(format!(
            "  box  columns {}..{}, lines {}..{}",
            b.x0, b.x1, b.y0, b.y1
        )),
    }
    let notes = notes.iter().map(|note| format!("  note: {note}"));
    lines.into_iter().chain(notes).for_each(output::text);
}

fn quadric(f1: &Linear, f2: &Quadratic) -> [String; 2] {
    let Quadratic { a, b, c, d, e, f } = f2;
    [
        format!("  f1   {} {} {}", f1.a, f1.b, f1.c),
        format!("  f2   {a} {b} {c} {d} {e} {f}"),
    ]
}

fn plane_line(what: &str, index: usize, kind: PlaneKind, d: &Linear) -> String {
    format!("  {what} {index} {kind:?} {} {} {}", d.a, d.b, d.c)
}
