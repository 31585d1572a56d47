//! `imogene sweep`.

use crate::failure::{Failure, Result};
use crate::{arguments, output};
use imogene_golden::format::Format;
use imogene_studies::kit::DrawError;
use imogene_studies::sweep::{self, Sweep, SweepResult, plot, section};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

pub fn run(options: &arguments::Sweep, json: bool) -> Result {
    let chosen = chosen(&options.names)?;
    let format = Format::new(options.format)?;
    let steps: usize = chosen.iter().map(|sweep| sweep.scenes(format).len()).sum();
    let sweeps: Vec<SweepResult> = output::during(steps as u64, "steps", |bar| {
        let run = |sweep: &&Sweep| sweep.run(format, |_| true, || bar.inc(1));
        chosen.iter().map(run).collect()
    });
    let files = options.out.as_ref().map(|folder| write(folder, &sweeps));
    let files = files.transpose()?.unwrap_or_default();
    let report = BTreeMap::from([("sweeps", &sweeps)]);
    output::paged(json, report, files, page(&sweeps, None)?.trim_end());
    verdict(&sweeps)
}

/// The sweeps named, each once, in the order of the documentation; all if none is named.
fn chosen(names: &[String]) -> Result<Vec<&'static Sweep>> {
    let named = names.iter().map(|name| sweep::find(name));
    let named = named.collect::<Result<Vec<&Sweep>, _>>()?;
    let wanted = |sweep: &&Sweep| named.is_empty() || named.iter().any(|n| n.name == sweep.name);
    Ok(sweep::ALL.iter().filter(wanted).collect())
}

fn page(sweeps: &[SweepResult], pictures: Option<&str>) -> Result<String> {
    let sections = sweeps.iter().map(|sweep| section(sweep, pictures));
    let sections = sections.collect::<Result<Vec<String>, DrawError>>()?;
    Ok(sections.join("\n"))
}

fn write(folder: &Path, sweeps: &[SweepResult]) -> Result<Vec<PathBuf>> {
    let mut files = output::files();
    for sweep in sweeps {
        let picture = plot(sweep).map_err(|error| Failure::Check(error.to_string()))?;
        files.add_text(&folder.join(format!("{}.svg", sweep.name)), &picture)?;
    }
    let figures = output::json_text(&sweeps) + "\n";
    files.add_text(&folder.join("sweeps.json"), &figures)?;
    files.add_text(&folder.join("sweeps.md"), &page(sweeps, Some(""))?)?;
    Ok(files.finish()?)
}

fn verdict(sweeps: &[SweepResult]) -> Result {
    let broken = sweeps.iter().flat_map(|sweep| {
        let of = move |violation| format!("\n  {}: {violation}", sweep.name);
        sweep.violations.iter().map(of)
    });
    let broken: Vec<String> = broken.collect();
    Failure::unless(broken.is_empty(), || {
        format!("{} rules are broken:{}", broken.len(), broken.concat())
    })
}
