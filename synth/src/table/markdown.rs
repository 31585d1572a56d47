//! Text of the resource table.

use super::{Section, Table};
use crate::report::SynthReport;
use crate::target::Target;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Pixel clocks of picture formats at 60 pictures per second, in MHz.
const VIDEO: [(f64, &str); 4] = [
    (148.5, "1920x1080"),
    (74.25, "1280x720"),
    (40.0, "800x600"),
    (25.175, "640x480"),
];

/// Units of the source's Table 5.10: name here, name there, transistors, bits there, bits here.
const SOURCE_TRANSISTORS: [(&str, &str, u64, u64, u64); 3] = [
    ("pe1", "PE1", 4_116, 24, 26),
    ("pe2", "PE2", 15_120, 48, 48),
    ("square_root", "root", 96_598, 48, 48),
];

const UNITS: &str = "
## Every unit of the machine

Base format 24, 3 cut planes, 1 row per stage, 4 objects. `quadric_pe` is the quadric core: both elementary processors, the root
and the sums that give both depths of a quadric on every pixel. `beam` is the machine; its clock is at most that of its slowest
unit, and is not measured. The other forms of the root are in [root-network.md](root-network.md).

On ECP5, Yosys joins look-up tables to wider ones. That speeds up the elementary processors, but alone in a netlist a multiplexer
that a comparison steers (`cut_plane`, `two_volume_merge`, `visibility_node`, `decider`) draws the comparison into each of its bits
and takes several times the cells of iCE40; the option `-nowidelut` of `synth_ecp5` prevents it, at the cost of the clock of the
quadric core.

";

const PLANES: &str = "
## Object processor and its cut planes

A plane adds a pipeline stage like those of the others; the clock is measured at 3 planes, above.
";

const ROWS: &str = "
## Root network and its register stages

The radicand has 48 bits, the root 24. 24 rows per stage are the whole network between two registers.
";

const TRANSISTORS: &str = "
## Transistors

Static CMOS gates of Yosys (`stat -tech cmos`: flip-flop 16, inverter 2, 2-input NAND or NOR 4, XOR 12), beside Table 5.10 of the
source (ES2 SOLO 1400, library ECPD15).

| unit | bits here | transistors here | per bit | bits there | transistors there | per bit |
|---|---|---|---|---|---|---|
";

const COMPARABILITY: &str = "
The two columns are comparable in kind, not in detail. The source counts library cells of its time, a full adder of 36 and a
flip-flop of 26 transistors; here there are neither adder cells nor pass gates, and the flip-flop is cheaper. PE1 has 24 bits there
and 26 here, as wide as a depth sum. An elementary processor here holds still on a clock without a pixel, which costs gates in every
bit of its registers. The root here has a register stage per row and hands on its remainder.
";

/// The whole page.
pub fn write(table: &Table) -> String {
    let mut text = heading(table);
    text += UNITS;
    text += &block_memory(table);
    for target in super::DEVICES {
        text += &devices(table, Section::Units, target, &|report| {
            format!("`{}`", report.unit)
        });
    }
    text += &reading(table);
    text += PLANES;
    text += &devices(
        table,
        Section::Planes,
        Target::Ecp5With45k,
        &|report| match report.parameters["planes"] {
            1 => "`quadric_processor`, 1 plane".to_owned(),
            planes => format!("`quadric_processor`, {planes} planes"),
        },
    );
    text += ROWS;
    for target in super::DEVICES {
        text += &devices(
            table,
            Section::Rows,
            target,
            &|report| match report.parameters["rows-per-stage"] {
                1 => "1 row per stage".to_owned(),
                rows => format!("{rows} rows per stage"),
            },
        );
    }
    text += &transistors(table);
    text
}

fn heading(table: &Table) -> String {
    let mut tools = BTreeMap::new();
    for (_, report) in &table.rows {
        tools.extend(&report.tools);
    }
    let tools: Vec<String> = tools
        .into_iter()
        .map(|(tool, version)| format!("{tool} {version}"))
        .collect();
    format!(
        "# Resources

Made by `imogene synth --table`, which writes this page; `scripts/setup --synth` installs the tools. One row alone:
`imogene synth UNIT --target T`, such as `imogene synth quadric_pe --target ecp5-45k`, with the parameters of `imogene emit`.

* Tools: {}.
* `ecp5-45k`: Lattice LFE5U-45F, package CABGA381, speed grade 6. `ice40-hx8k`: Lattice iCE40HX8K, package ct256.
* Resources are those of the unit alone. **LUT** counts look-up tables of logic, without carry chains; **carry** counts carry cells
  (2 bits each on ECP5, 1 bit on iCE40); **cells** counts logic cells after packing: TRELLIS_COMB on ECP5, of which a carry cell
  takes 2, and ICESTORM_LC on iCE40, where a flip-flop without a look-up table takes one too.
* **Fmax** is that of the unit in a harness that registers every input and output, so that every path goes from register to
  register: median of {} seeds of place and route, {} MHz asked for, worst case of the tools.
* **Draws** is the largest picture at 60 pictures per second whose pixel clock is within Fmax, one pixel per clock.
* **Slowest path** is that of the median seed; `inputs` and `results` are registers of the harness or nets to them.
* Verilog: {}
",
        tools.join(", "),
        super::SEEDS,
        Target::Ecp5With45k
            .place_and_route()
            .map_or(0, |device| device.goal_mhz),
        table.digest,
    )
}

/// What the figures of the core and of the whole object processor come to.
fn reading(table: &Table) -> String {
    let mut text = "\n### Reading\n\n".to_owned();
    for target in super::DEVICES {
        for unit in ["quadric_pe", "quadric_processor"] {
            let mut reports = table.section(Section::Units, target);
            let Some(report) = reports.find(|report| report.unit == unit) else {
                continue;
            };
            let _ = writeln!(
                text,
                "* `{unit}` on {}: {} cells, {} DSP, {}; draws {}.",
                target.name(),
                count(report.logic_cells),
                count(report.dsp),
                clock(report),
                draws(report)
            );
        }
    }
    text + "
The core is limited by the accumulators of PE2, whose sum of 48 bits has to be ready for the next pixel and so cannot be pipelined.
The object processor is limited by the cut plane, a comparison that steers a multiplexer in one clock, and by the normal unit, a
product and a negation in one clock; neither is in a loop.
"
}

/// Block memory has no column while no unit uses any.
fn block_memory(table: &Table) -> String {
    let reports = table.reports().into_iter();
    let users: Vec<String> = reports
        .filter(|report| report.bram > Some(0))
        .map(|report| {
            format!(
                "`{}` for {}: {}",
                report.unit,
                report.target,
                count(report.bram)
            )
        })
        .collect();
    if users.is_empty() {
        "No unit uses block memory.\n".to_owned()
    } else {
        format!("Block memories: {}.\n", users.join(", "))
    }
}

fn devices(
    table: &Table,
    section: Section,
    target: Target,
    name: &dyn Fn(&SynthReport) -> String,
) -> String {
    let mut text = format!(
        "\n### {}\n\n| unit | latency | LUT | FF | carry | DSP | cells | Fmax | draws | slowest path |\n",
        target.name()
    );
    text += "|---|---|---|---|---|---|---|---|---|---|\n";
    for report in table.section(section, target) {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            name(report),
            report.latency,
            count(report.lut),
            count(report.ff),
            count(report.carry),
            count(report.dsp),
            count(report.logic_cells),
            clock(report),
            draws(report),
            path(report),
        );
    }
    text
}

fn count(value: Option<u64>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| value.to_string())
}

fn clock(report: &SynthReport) -> String {
    match (&report.does_not_fit, report.fmax_mhz) {
        (Some(excess), _) => format!("does not fit, {excess} with the harness"),
        (None, Some(fmax)) => format!("{fmax:.1} MHz"),
        (None, None) => "not measured".to_owned(),
    }
}

fn draws(report: &SynthReport) -> &'static str {
    let reached = |fmax| VIDEO.into_iter().find(|(clock, _)| fmax >= *clock);
    report
        .fmax_mhz
        .and_then(reached)
        .map_or("-", |(_, format)| format)
}

fn path(report: &SynthReport) -> String {
    let path = report
        .median_seed()
        .and_then(|run| run.critical_path.as_ref());
    path.map_or_else(
        || "-".to_owned(),
        |path| {
            format!(
                "`{}` to `{}`, {:.1} ns in cells, {:.1} ns in wires",
                register(&path.from),
                register(&path.to),
                path.logic_ns,
                path.routing_ns
            )
        },
    )
}

/// Name of the register of a cell; the tools add to it how the cell was made.
fn register(cell: &str) -> &str {
    let name = cell.strip_prefix("unit.").unwrap_or(cell);
    let ends = ["_TRELLIS_FF", "_SB_DFF", "_SB_LUT4", "_LUT4", "_CCU2C"];
    let end = ends.iter().filter_map(|end| name.find(end)).min();
    &name[..end.unwrap_or(name.len())]
}

fn transistors(table: &Table) -> String {
    let mut text = TRANSISTORS.to_owned();
    for report in table.section(Section::Transistors, Target::Transistors) {
        let here = report.transistors.unwrap_or_default();
        let source = SOURCE_TRANSISTORS.iter().find(|row| row.0 == report.unit);
        let _ = match source {
            Some((unit, name, there, bits_there, bits)) => writeln!(
                text,
                "| `{unit}` ({name}) | {bits} | {here} | {} | {bits_there} | {there} | {} |",
                here / bits,
                there / bits_there
            ),
            None => writeln!(text, "| `{}` | - | {here} | - | - | - | - |", report.unit),
        };
    }
    text + COMPARABILITY
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_names_registers() {
        assert_eq!(
            register("unit.f2.first_step_TRELLIS_FF_Q_4"),
            "f2.first_step"
        );
        assert_eq!(
            register("unit.f2.line_value_SB_DFFE_Q_44_D_SB_LUT4_O_LC"),
            "f2.line_value"
        );
        assert_eq!(register("inputs_SB_DFFE_Q_DFFLC"), "inputs");
        assert_eq!(register("plain"), "plain");
    }
}
