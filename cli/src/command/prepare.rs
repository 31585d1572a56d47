//! `imogene prepare`.

use super::load_scene;
use crate::arguments::Prepare;
use crate::failure::Failure;
use crate::output;
use imogene_models::object::load::load_words;
use imogene_models::object::quadric::MAX_PLANES;
use imogene_models::prepare::PreparedObject;
use imogene_models::rational::to_f64;
use serde_json::{Value, json};

/// Shows the coefficient words of every object.
pub fn run(options: &Prepare, json: bool) -> Result<(), Failure> {
    let (_, scene) = load_scene(&options.scene)?;
    let object = |o: &PreparedObject| -> Value {
        let planes = o.words.planes.len().min(MAX_PLANES);
        json!({
            "name": o.name,
            "words": o.words,
            "preconditioned_f2": o.words.f2.preconditioned(scene.format.pe2_width()),
            "load_words": load_words(&o.words, &scene.format, planes),
            "needed_bits": o.needed,
            "rounding_bounds": o.bounds,
            "notes": o.notes,
        })
    };
    let objects: Vec<Value> = scene.objects.iter().map(object).collect();
    if json {
        output::json(&json!({
            "width": scene.width,
            "height": scene.height,
            "format": scene.format,
            "depth_scale": scene.depth_scale.to_string(),
            "objects": objects,
        }));
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
    for o in &scene.objects {
        describe(o);
    }
    Ok(())
}

fn describe(o: &PreparedObject) {
    let w = &o.words;
    let b = &w.screen_box;
    output::text(format!("\n{} ({:?})", o.name, w.class));
    if b.is_empty() {
        output::text("  box  empty");
    } else {
        output::text(format!(
            "  box  columns {}..{}, lines {}..{}",
            b.x0, b.x1, b.y0, b.y1
        ));
    }
    output::text(format!("  f1   {} {} {}", w.f1.a, w.f1.b, w.f1.c));
    let f2 = &w.f2;
    output::text(format!(
        "  f2   {} {} {} {} {} {}",
        f2.a, f2.b, f2.c, f2.d, f2.e, f2.f
    ));
    for (index, plane) in w.planes.iter().enumerate() {
        let d = &plane.depth;
        output::text(format!(
            "  cut {index} {:?} {} {} {}",
            plane.kind, d.a, d.b, d.c
        ));
    }
    for note in &o.notes {
        output::text(format!("  note: {note}"));
    }
}
