//! `imogene check`.

use super::load_scene;
use crate::arguments::Check;
use crate::failure::Failure;
use crate::output;
use imogene_models::check::{CheckReport, ObjectReport, PartsReport, check};

/// Shows what a scene needs and how exact its picture is.
pub fn run(options: &Check, json: bool) -> Result<(), Failure> {
    let (framed, prepared) = load_scene(&options.scene)?;
    let report = check(&framed, &prepared);
    if json {
        output::json(&report);
    } else {
        describe(&report);
    }
    if report.ok {
        Ok(())
    } else {
        Err(Failure::Check(
            "a silhouette has no bound below its screen box; see the objects' problems".into(),
        ))
    }
}

fn describe(report: &CheckReport) {
    if report.objects.iter().any(|o| o.quadric().is_some()) {
        describe_bounds(report);
    } else {
        output::text("no object is drawn by a quadric or patch processor, the ones with bounds");
    }
    for object in &report.objects {
        let problems = match object {
            ObjectReport::Quadric(o) => {
                let by = match o.processor {
                    "quadric" => String::new(),
                    other => format!(", processor {other}"),
                };
                output::text(format!("{}: {}, class {:?}{by}", o.name, o.kind, o.class));
                &o.problems
            }
            ObjectReport::Parts(o) => {
                describe_parts(o);
                &o.problems
            }
        };
        for problem in problems {
            output::text(format!("  {problem}"));
        }
    }
}

fn describe_bounds(report: &CheckReport) {
    let bounds = &report.bounds;
    output::text(format!(
        "depth within {:.1} LSB, silhouette within {:.2e} px, normal within {:.3} degrees; {} pixels undecided",
        bounds.depth_lsb, bounds.silhouette_px, bounds.normal_deg, report.undecided_pixels
    ));
    let (needed, format) = (&report.widths.needed, &report.widths.format);
    output::text(format!(
        "bits needed / available: f1 -+ r {} / {}, f2 {} / {}, planes {} / {}",
        needed.sum, format.sum, needed.quadratic, format.quadratic, needed.plane, format.plane
    ));
}

fn describe_parts(o: &PartsReport) {
    output::text(format!(
        "{}: {}, {} of processor {}, {} pixels, no bounds",
        o.name, o.kind, o.processors, o.processor, o.pixels
    ));
    let needed: Vec<String> = o
        .needed
        .iter()
        .map(|n| format!("{} {} / {}", n.word, n.needed, n.available))
        .collect();
    if !needed.is_empty() {
        output::text(format!("  bits needed / available: {}", needed.join(", ")));
    }
}
