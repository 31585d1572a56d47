//! What fails a check by trial, and what is said of it.

use crate::failure::{Failure, Result};
use imogene_files::text::counted;
use imogene_studies::shading_trial::ShadingErrors;
use imogene_studies::trial::TrialReport;

/// The widths of the hardware have to keep every level within one.
pub fn of_levels(errors: &ShadingErrors) -> Result {
    let (beyond, greatest, worst) = (errors.beyond, errors.greatest, &errors.worst);
    Failure::unless(beyond == 0, || {
        format!(
            "{beyond} levels differ by more than 1 from the formula, by {greatest} at most; the worst case: {worst:?}"
        )
    })
}

/// No error may be beyond its bound in any format; the seed makes the cases again.
pub fn of_bounds(seed: u64, formats: &[TrialReport]) -> Result {
    let violations: u64 = formats.iter().map(|format| format.tally.violations).sum();
    if violations == 0 {
        return Ok(());
    }
    let mut text = format!("beyond the bounds: {}", counted(violations, "error"));
    for format in formats {
        for v in &format.tally.first_violations {
            text += &format!(
                "\n  widths {}, case {} of seed {seed}, pixel {:?}: {} {:e} beyond {:e}",
                format.widths,
                v.case,
                v.pixel,
                v.term.name(),
                v.observed,
                v.bound
            );
        }
    }
    Err(Failure::Check(text))
}
