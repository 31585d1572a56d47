//! `imogene check`.

use super::load_scene;
use crate::arguments::Check;
use crate::failure::Failure;
use crate::output;
use imogene_models::check::{CheckReport, check};

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
    for object in &report.objects {
        output::text(format!(
            "{}: {}, class {:?}",
            object.name, object.kind, object.class
        ));
        for problem in &object.problems {
            output::text(format!("  {problem}"));
        }
    }
}
