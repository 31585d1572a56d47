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

/// The whole page.
pub fn write(table: &Table) -> String {
    let mut text = heading(table);
    text += "\n## Every unit\n\nBase format 24, 3 cut planes, 1 row per stage, 4 objects.\n";
    for target in super::DEVICES {
        text += &devices(table, Section::Units, target, &|report| report.unit.clone());
    }
    text += "\n## The quadric core\n\n";
    text += "`quadric_pe` is the heart of every object: two elementary processors, the root and the two sums that give both depths \
             of a\nquadric on every pixel.\n\n";
    text += &core(table);
    text += "\n## Object processor and its cut planes\n";
    text += &devices(table, Section::Planes, Target::Ecp5With45k, &|report| {
        format!(
            "`quadric_processor`, {} planes",
            report.parameters["planes"]
        )
    });
    text += "\n## Root network and its register stages\n\nThe radicand has 48 bits, the root 24.\n";
    for target in super::DEVICES {
        text += &devices(table, Section::Rows, target, &|report| {
            format!("{} rows per stage", report.parameters["rows-per-stage"])
        });
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
`imogene synth UNIT --target T`, such as `imogene synth quadric_pe --target ecp5-45k`.

* Tools: {}.
* Devices: `ecp5-45k` is the LFE5U-45F, package CABGA381, speed grade 6; `ice40-hx8k` the iCE40HX8K, package ct256.
* Resources are those of the unit alone. LUT: look-up tables of logic, carry chains not among them; carry: cells of carry chains
  (2 bits each on ECP5, 1 bit on iCE40); cells: logic cells after packing (TRELLIS_COMB, ICESTORM_LC), where carry chains and
  flip-flops without a look-up table count too on iCE40, and carry chains with 2 per carry cell on ECP5. No unit uses block memory.
* Fmax is the median of {} seeds of place and route, with {} MHz asked for, of the unit in a harness that registers every input and
  output, so that every path is from register to register. Worst-case corner of the tools, as they report it.
* Draws: the largest picture at 60 pictures per second whose pixel clock is not above Fmax, one pixel per clock.
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

fn devices(
    table: &Table,
    section: Section,
    target: Target,
    name: &dyn Fn(&SynthReport) -> String,
) -> String {
    let mut text = format!(
        "\n### {}\n\n| unit | latency | LUT | FF | carry | DSP | cells | Fmax | draws |\n",
        target.name()
    );
    text += "|---|---|---|---|---|---|---|---|---|\n";
    for report in table.section(section, target) {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            name(report),
            report.latency,
            count(report.lut),
            count(report.ff),
            count(report.carry),
            count(report.dsp),
            count(report.logic_cells),
            clock(report),
            draws(report),
        );
    }
    text
}

fn count(value: Option<u64>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| value.to_string())
}

fn clock(report: &SynthReport) -> String {
    match (&report.does_not_fit, report.fmax_mhz) {
        (Some(excess), _) => format!("does not fit: {excess}"),
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

/// The quadric core, with the path that limits it.
fn core(table: &Table) -> String {
    let mut text = String::new();
    for target in super::DEVICES {
        let mut reports = table.section(Section::Units, target);
        let Some(report) = reports.find(|report| report.unit == "quadric_pe") else {
            continue;
        };
        let _ = write!(
            text,
            "* `{}`: {} cells, {} FF, {} DSP, {} block memories, {}",
            target.name(),
            count(report.logic_cells),
            count(report.ff),
            count(report.dsp),
            count(report.bram),
            clock(report),
        );
        let path = report
            .median_seed()
            .and_then(|run| run.critical_path.as_ref());
        if let Some(path) = path {
            let _ = write!(
                text,
                ";\n  slowest path `{}` to `{}`, {:.2} ns in cells and {:.2} ns in wires",
                path.from, path.to, path.logic_ns, path.routing_ns
            );
        }
        text += ".\n";
    }
    text
}

fn transistors(table: &Table) -> String {
    let mut text = "\n## Transistors\n\n\
        Static CMOS gates of Yosys (`stat -tech cmos`: flip-flop 16, inverter 2, 2-input NAND or NOR 4, XOR 12), beside Table 5.10 \
        of the\nsource (ES2 SOLO 1400, library ECPD15).\n\n\
        | unit | bits here | transistors here | per bit | bits there | transistors there | per bit |\n\
        |---|---|---|---|---|---|---|\n"
        .to_owned();
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
    text + "\nThe two columns are comparable in kind, not in detail. The source counts library cells of its time: full adder 36, \
        flip-flop 26\ntransistors, and so on; the gates here have neither adder cells nor pass gates, and a cheaper flip-flop. PE1 has 24 bits \
        there and 26 here,\nas wide as a depth sum. The registers differ too: the root here has one register stage per row and hands \
        on its\nremainder.\n"
}
