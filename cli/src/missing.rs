//! What a picture lacks: objects that cannot be drawn cost themselves, not the scene.
//!
//! By default they are left out with a warning, and the command ends with exit code 1; with `--strict` the scene is
//! refused, and with `--allow-missing` the command ends as if nothing were missing.

use crate::failure::{Failure, Result};
use crate::output;
use imogene::arguments::Policy;
use imogene_golden::format::Format;
use imogene_prepare::{Framing, Options, PreparedScene, refused};
use imogene_scene::{DepthRange, End, FramedScene, SceneFile};
use std::path::Path;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

static POLICY: OnceLock<Policy> = OnceLock::new();
static MISSING: AtomicUsize = AtomicUsize::new(0);

/// Sets the policy of this run, once.
pub fn set(policy: Policy) {
    POLICY
        .set(policy)
        .expect("set once, when the arguments are read");
}

fn policy() -> Policy {
    *POLICY.get().unwrap_or(&Policy::Strict)
}

/// How scenes are prepared under the policy.
pub fn options() -> Options {
    Options {
        without_refused: policy() != Policy::Strict,
        ..Options::default()
    }
}

/// Warns of everything that a prepared scene lacks, and of what an end of its depth cuts off; `place` says in which
/// frame, if in any. Fails if nothing is left to draw.
pub fn tell(place: &str, framed: &FramedScene, prepared: &PreparedScene) -> Result {
    let objects = prepared.missing.iter().filter(|missing| !missing.is_volume);
    if let Some(first) = prepared.missing.first()
        && objects.count() == framed.objects.len()
    {
        return Err(Failure::Input(format!("{place}{}", first.reason)));
    }
    for missing in &prepared.missing {
        output::warning(format_args!("{place}left out: {}", missing.reason));
    }
    tell_ends(place, &framed.range);
    MISSING.fetch_add(prepared.missing.len(), Ordering::Relaxed);
    Ok(())
}

/// Warns of what a scene lacks of the file that it was made from; `what` is the key of the scene. Fails with
/// `--strict`.
pub fn incomplete(path: &Path, what: Option<&str>) -> Result {
    let Some(what) = what else { return Ok(()) };
    if policy() == Policy::Strict {
        let problem = format!("{what}; without --strict the rest is drawn");
        return Err(Failure::at(path, problem));
    }
    output::warning(format_args!("{}: {what}", path.display()));
    MISSING.fetch_add(1, Ordering::Relaxed);
    Ok(())
}

/// A scene without the objects that machines cannot draw, each named, for commands that measure machines on what is
/// left. Fails with `--strict`, and if nothing is left.
pub fn reduced(
    mut file: SceneFile,
    (width, height): (u32, u32),
    format: Format,
    options: Options,
) -> Result<SceneFile> {
    if !file.images.is_empty() {
        return Ok(file);
    }
    let framed = file.frame(width, height)?;
    let list = refused(&framed, format, options);
    let Some((_, first)) = list.first() else {
        return Ok(file);
    };
    if policy() == Policy::Strict || list.len() == framed.objects.len() {
        return Err(Failure::Input(first.to_string()));
    }
    let names = list.iter().map(|(index, _)| framed.objects[*index].name());
    let names: Vec<&str> = names.collect();
    file.objects
        .retain(|object| !names.contains(&&*object.name));
    for (_, reason) in &list {
        output::warning(format_args!("left out: {reason}"));
    }
    MISSING.fetch_add(list.len(), Ordering::Relaxed);
    Ok(file)
}

/// Says which objects an end of the depth cuts.
fn tell_ends(place: &str, range: &DepthRange) {
    for cut in &range.cut {
        let report = range.report(1);
        let (end, at) = match cut.end {
            End::Near => ("near", report.near_units),
            End::Far => ("far", report.far_units.unwrap_or(f64::INFINITY)),
        };
        let from = match range.far {
            None => "from the eye",
            Some(_) => "from the screen plane",
        };
        output::complain(format_args!(
            "note: {place}object '{}' passes the {end} end of the depth, {at} units {from}: it is cut off there",
            cut.object
        ));
    }
}

/// The failure that a run ends with which has succeeded otherwise.
pub fn verdict() -> Result {
    match (MISSING.load(Ordering::Relaxed), policy()) {
        (0, _) | (_, Policy::Allow) => Ok(()),
        (n, _) => Err(Failure::Check(format!(
            "{} missing from the picture or the scene; \
             --allow-missing accepts that, --strict refuses such scenes",
            if n == 1 {
                "something is".to_owned()
            } else {
                format!("{n} things are")
            }
        ))),
    }
}
