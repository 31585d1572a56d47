//! `imogene package`.

use crate::arguments::Package;
use crate::failure::Result;
use crate::output;
use imogene_contract::Unit;
use imogene_files::text::counted;
use imogene_package::core::package;
use serde::Serialize;
use std::path::PathBuf;

/// What was written; the keys are stable.
#[derive(Serialize)]
struct PackageReport {
    cores: usize,
    bytes: usize,
    files: Vec<PathBuf>,
}

pub fn run(options: &Package, json: bool) -> Result {
    let units = options.units.iter().map(|name| Unit::from_name(name));
    let mut units = units.collect::<Result<Vec<Unit>, _>>()?;
    if units.is_empty() {
        units = Unit::ALL.to_vec();
    }
    let texts = package(&units, options.clocks)?;
    let mut files = output::files();
    for (name, text) in &texts {
        files.add_text(&options.out.join(name), text)?;
    }
    let report = PackageReport {
        cores: units.len(),
        bytes: texts.iter().map(|(_, text)| text.len()).sum(),
        files: files.finish()?,
    };
    output::report(json, &report, |report| {
        let (cores, bytes) = (counted(report.cores, "core"), counted(report.bytes, "byte"));
        let (files, folder) = (counted(report.files.len(), "file"), options.out.display());
        output::text(format!("wrote {cores}, {files}, {bytes} below {folder}"));
    });
    Ok(())
}
