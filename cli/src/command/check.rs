//! `imogene check`.

use super::load_scene;
use crate::arguments::Check;
use crate::failure::Failure;
use crate::output;
use imogene_analysis::bounds::{
    Accumulators, CheckReport, ObjectReport, PartsReport, QuadricReport, Summary, check,
};
use imogene_files::text::counted;
use imogene_studies::picture;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// What was found; the keys are stable.
#[derive(Serialize)]
struct Output {
    #[serde(flatten)]
    report: CheckReport,
    files: Vec<PathBuf>,
}

/// Shows what a scene needs and how exact its picture is.
pub fn run(options: &Check, json: bool) -> Result<(), Failure> {
    let map = options.map.as_deref().map(Map::of).transpose()?;
    let (framed, prepared) = load_scene(&options.scene)?;
    let report = check(&framed, &prepared);
    let files: Vec<PathBuf> = options.map.iter().cloned().collect();
    if let Some(map) = map {
        map.write(&report, prepared.width as usize)?;
    }
    let output = Output { report, files };
    output::report(json, &output, |output| {
        describe(&output.report);
        output::wrote(&output.files);
    });
    verdict(&output.report)
}

fn verdict(report: &CheckReport) -> Result<(), Failure> {
    if report.ok {
        return Ok(());
    }
    let adrift = report.objects.iter().filter(|o| o.undecided().adrift > 0);
    let why = match output::joined(adrift.map(|o| format!("'{}'", o.name())), ", ") {
        none if none.is_empty() => "a word wraps".to_owned(),
        adrift => {
            format!("the outline of {adrift} may be a pixel or more away from the true one")
        }
    };
    Err(Failure::Check(format!("{why}; see the objects' problems")))
}

/// A file of the open pixels.
struct Map<'a> {
    path: &'a Path,
    is_picture: bool,
}

impl Map<'_> {
    fn of(path: &Path) -> Result<Map<'_>, Failure> {
        let extension = path.extension().and_then(|e| e.to_str());
        match extension {
            Some("png") | Some("npy") => Ok(Map {
                path,
                is_picture: extension == Some("png"),
            }),
            _ => Err(Failure::Input(format!(
                "--map '{}': neither a picture nor an array; give a name that ends in .png or .npy",
                path.display()
            ))),
        }
    }

    fn write(&self, report: &CheckReport, width: usize) -> Result<(), Failure> {
        let marks = report.marks();
        let mut files = output::files();
        files.add(self.path, |out| {
            if !self.is_picture {
                return picture::marks(out, width, &marks);
            }
            let colours = marks.iter().map(|&m| COLOURS[usize::from(m)]);
            let rgb: Vec<u8> = colours.flatten().collect();
            picture::png(out, width, marks.len() / width, &rgb)
        })?;
        files.finish()?;
        Ok(())
    }
}

/// Of the marks of a map: decided, object or face open, light open, both.
const COLOURS: [[u8; 3]; 4] = [[0, 0, 0], [255, 255, 255], [255, 160, 0], [255, 80, 80]];

fn describe(report: &CheckReport) {
    describe_bounds(report);
    for object in &report.objects {
        match object {
            ObjectReport::Quadric(o) => describe_quadric(o),
            ObjectReport::Parts(o) => describe_parts(o),
        }
        for problem in object.problems() {
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
    let list = |bits: &[u32]| output::joined(bits, " ");
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
        "depth within {:.1} LSB, silhouette within {:.2e} px, normal within {:.3} degrees; {} undecided",
        bounds.depth_lsb,
        bounds.silhouette_px,
        bounds.normal_deg,
        counted(report.undecided_pixels, "pixel")
    ));
    if report.undecided_light_pixels > 0 {
        output::text(format!(
            "light or shadow undecided at {} more pixels",
            report.undecided_light_pixels
        ));
    }
    let (needed, format) = (&report.widths.needed, &report.widths.format);
    output::text(format!(
        "bits needed / available: f1 -+ r {} / {}, f2 {} / {}, planes {} / {}",
        needed.sum, format.sum, needed.quadratic, format.quadratic, needed.plane, format.plane
    ));
}

fn describe_parts(o: &PartsReport) {
    output::text(format!(
        "{}: {}, {} of processor {}, {} pixels of {}, depth within {:.1} LSB, {} undecided",
        o.name,
        o.kind,
        o.processors,
        o.processor,
        o.visible_pixels,
        o.pixels,
        o.bounds.depth_lsb,
        o.undecided.silhouette + o.undecided.edge
    ));
    let needed = o.needed.iter();
    let needed = needed.map(|n| format!("{} {} / {}", n.word, n.needed, n.available));
    if !o.needed.is_empty() {
        let needed = output::joined(needed, ", ");
        output::text(format!("  bits needed / available: {needed}"));
    }
}
