//! `imogene roots`.

use crate::arguments::Roots;
use crate::failure::Failure;
use crate::output;
use imogene_golden::format::Format;
use imogene_studies::root_errors::{RootRow, table};

const HEAD: &str = "\
| member | max % | mean % | max lsb | mean lsb | rms lsb | monotone | largest step | sphere max px | sphere mean px | adder cells | multipliers | shifters | latency | clocks per result |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|";

/// Prints the measured table of the family of square root networks, as Markdown or JSON.
pub fn run(options: &Roots, json: bool) -> Result<(), Failure> {
    let format = Format::new(options.format)?;
    output::report(json, &table(&format), |rows| {
        output::text(HEAD);
        rows.iter().for_each(|row| output::text(line(row)));
    });
    Ok(())
}

fn line(row: &RootRow) -> String {
    let sphere = row.sphere.map_or(["-".into(), "-".into()], |depth| {
        [depth.max_px, depth.mean_px].map(figure)
    });
    let cells = [
        row.label.clone(),
        figure(row.error.max_percent),
        figure(row.error.mean_percent),
        figure(row.error.max_lsb),
        figure(row.error.mean_lsb),
        figure(row.error.rms_lsb),
        if row.steps.monotone { "yes" } else { "no" }.into(),
        row.steps.largest.to_string(),
        sphere[0].clone(),
        sphere[1].clone(),
        row.cost.adder_cells.to_string(),
        row.cost.multipliers.to_string(),
        row.cost.shifters.to_string(),
        row.cost.latency.to_string(),
        row.cost.interval.to_string(),
    ];
    format!("| {} |", cells.join(" | "))
}

/// Four significant digits, without an exponent.
fn figure(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let decimals = (3 - value.abs().log10().floor() as i32).max(0) as usize;
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::figure;

    #[test]
    fn figures_have_four_significant_digits() {
        let found = [0.0, 0.00477, 6.0660, 56_077.4, 0.54].map(figure);
        assert_eq!(found, ["0", "0.004770", "6.066", "56077", "0.5400"]);
    }
}
