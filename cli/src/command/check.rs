//! `imogene check`.

use super::load_scene;
use crate::arguments::Check;
use crate::failure::Failure;
use crate::output;
use imogene_models::check::{
    Accumulators, CheckReport, ObjectReport, PartsReport, QuadricReport, Summary, check,
};

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
            "a word wraps, or a silhouette has no bound below its screen box; see the objects' problems"
                .into(),
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
                describe_quadric(o);
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
    describe_summary(&report.summary);
}

fn describe_quadric(o: &QuadricReport) {
    let by = match o.processor {
        "quadric" => String::new(),
        other => format!(", processor {other}"),
    };
    output::text(format!(
        "{}: {}, class {:?}{by}, {} pixels of {}",
        o.name, o.kind, o.class, o.visible_pixels, o.pixels
    ));
    if let Some(accumulators) = &o.accumulators {
        describe_accumulators(accumulators);
    }
}

fn describe_accumulators(a: &Accumulators) {
    let list = |bits: &[u32]| {
        let bits: Vec<String> = bits.iter().map(u32::to_string).collect();
        bits.join(" ")
    };
    let mut values = vec![format!("f1 {}", a.f1)];
    if let (Some(near), Some(far)) = (a.f1_minus_r, a.f1_plus_r) {
        values.push(format!("f1 - r {near}, f1 + r {far}"));
    }
    values.push(format!("f2 {}", a.f2));
    if let Some(root) = a.root {
        values.push(format!("root {root}"));
    }
    if !a.planes.is_empty() {
        values.push(format!("planes {}", list(&a.planes)));
    }
    if let Some(linear) = &a.normal_linear {
        values.push(format!("normal {}", list(linear)));
    }
    if let Some(sum) = &a.normal_sum {
        values.push(format!("with K r {}", list(sum)));
    }
    output::text(format!("  bits of its values: {}", values.join(", ")));
    let (f1, f2) = (&a.increments.f1, &a.increments.f2);
    output::text(format!(
        "  increments, which may wrap: f1 a {}, b {}, line {}; f2 2a {}, 2b {}, c {}, J {}, P {}, I {}, line {}",
        f1.a, f1.b, f1.line_value, f2.a2, f2.b2, f2.c, f2.j, f2.p, f2.i, f2.line_value
    ));
}

fn describe_summary(summary: &Summary) {
    for (what, objects) in [
        ("front view, needs half B", &summary.front_view),
        ("prisms", &summary.prisms),
        ("no curved surface", &summary.degenerate),
        ("perpendicular planes", &summary.perpendicular_planes),
        ("planes without effect", &summary.planes_without_effect),
        ("never shown", &summary.never_shown),
        ("without highlights", &summary.without_highlights),
    ] {
        if !objects.is_empty() {
            output::text(format!("{what}: {}", objects.join(", ")));
        }
    }
    if let Some(guards) = &summary.guards {
        let accepted = if guards.accepted {
            ""
        } else {
            ", more than this depth word can have"
        };
        output::text(format!(
            "guard bits from which on rounding adds at most a depth word to a quadric's face and decides no silhouette pixel: {}:{}{accepted}",
            guards.g1, guards.g2
        ));
    }
    let Some(machine) = &summary.machine else {
        return;
    };
    output::text(format!(
        "narrowest machine with the same picture: --widths {} --slots {}",
        machine.widths, machine.slots
    ));
    output::text(format!("  no shorter root: {}", machine.root_limit));
    output::text(format!("  no shorter plane word: {}", machine.plane_limit));
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
