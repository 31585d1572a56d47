//! Text of the resource table.

use super::rows::{self, Section};
use super::{Measured, PICTURE, Table};
use crate::report::{CriticalPath, Figures};
use crate::target::Target;
use crate::tools::listed;
use imogene_contract::Unit;
use imogene_files::text::{counted, wrapped_page};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Pixel clocks of picture formats at 60 pictures per second, in MHz.
const VIDEO: [(f64, &str); 4] = [
    (148.5, "1920x1080"),
    (74.25, "1280x720"),
    (40.0, "800x600"),
    (25.175, "640x480"),
];

const UNITS: &str = "
Base format 24, 3 cut planes (4 of patches and volumes, 6 of the polyhedron), 1 row per stage, 4 objects. `quadric_pe` is the quadric core: both elementary processors, the root
and the sums that give both depths of a quadric on every pixel. `beam` is the machine; its clock is at most that of its slowest
unit, and is not measured; the clocks of the object processors beside the quadric processor are measured on ECP5. The other forms of the root are in [root-network.md](root-network.md).

On ECP5, tables are of four inputs (`synth_ecp5 -nowidelut`): [why](synthesis.md#tables-of-four-inputs).

";

const PLANES: &str = "
A plane adds a pipeline stage like those of the others; the clock is measured at 3 planes, above.
";

const RATIO: &str = "
A patch has no second half of its depth interval, no merge, no normals of planes, and its planes keep or remove faces in place of
cutting intervals. Its processor over the quadric processor with as many planes, in cells: ";

const ROWS: &str = "
The radicand has 48 bits, the root 24. 24 rows per stage are the whole network between two registers. `square_root` restores the
remainder where the divisor is too large, `square_root_non_restoring` adds it back in the next row; both hand on root and remainder.
";

impl Table {
    /// The page that shows it, as Markdown.
    pub fn markdown(&self) -> String {
        let mut text = heading(self);
        text += &opening(Section::Units, UNITS);
        text += &block_memory(self);
        text += &without_figures(self);
        for target in rows::DEVICES {
            text += &devices(self, Section::Units, target);
        }
        text += &reading(self);
        text += &opening(Section::Planes, PLANES);
        text += &devices(self, Section::Planes, Target::Ecp5With45k);
        text += &ratios(self);
        text += &opening(Section::Rows, ROWS);
        for target in rows::DEVICES {
            text += &devices(self, Section::Rows, target);
        }
        text += &format!(
            "\n![Cells, clock and latency of both root networks over the rows of a stage]({PICTURE})\n"
        );
        text += &opening(Section::Transistors, "");
        text += &super::transistors::write(self);
        wrapped_page(&text)
    }
}

fn opening(section: Section, text: &str) -> String {
    let title = match section {
        Section::Units => "The units",
        Section::Planes => "Object processors and their cut planes or sides",
        Section::Rows => "Root networks and their register stages",
        Section::Transistors => "Transistors",
    };
    format!("\n## {title}\n{text}")
}

fn heading(table: &Table) -> String {
    let mut tools = BTreeMap::new();
    for row in &table.rows {
        tools.extend(&row.tools);
    }
    format!(
        "# Resources

Made by `imogene synth --table`, which writes this page; `scripts/setup --synth` installs the tools. One row alone:
`imogene synth UNIT --target T`, such as `imogene synth quadric_pe --target ecp5-45k`, with the parameters of `imogene emit`. The same
figures for programs are in [resources.json](resources.json), from which `imogene synth --check` tells whether a row got worse; how they
are made and how to compare with another design is in [synthesis.md](synthesis.md).

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
        listed(tools),
        rows::SEEDS,
        Target::Ecp5With45k
            .place_and_route()
            .map_or(0, |device| device.goal_mhz),
        table.verilog,
    )
}

/// What the figures of the core and of the whole object processor come to.
fn reading(table: &Table) -> String {
    let mut text = "\n### Reading\n\n".to_owned();
    for target in rows::DEVICES {
        for unit in ["quadric_pe", "quadric_processor"] {
            let mut rows = table.section(Section::Units, target);
            let Some(row) = rows.find(|row| row.unit == unit) else {
                continue;
            };
            let _ = writeln!(
                text,
                "* `{unit}` on {}: {} cells, {} DSP, {}; draws {}.",
                target.name(),
                count(row.figures.cells),
                count(row.figures.dsp),
                clock(&row.figures),
                draws(&row.figures)
            );
        }
    }
    text + "
The core is limited by the accumulators of PE2, whose sum of 48 bits has to be ready for the next pixel and so cannot be pipelined.
What else an object processor has is in no loop, and has register stages for about that clock.
"
}

/// The patch processor over the quadric processor, plane by plane.
fn ratios(table: &Table) -> String {
    let cells = |unit: &str, planes: usize| {
        let mut rows = table.section(Section::Planes, Target::Ecp5With45k);
        let found =
            rows.find(|row| row.unit == unit && row.parameters.get("planes") == Some(&planes));
        found.and_then(|row| row.figures.cells)
    };
    let ratio = |planes: usize| {
        let patch = cells("patch_processor", planes)? as f64;
        let ratio = patch / cells("quadric_processor", planes)? as f64;
        Some(format!("{ratio:.2} with {planes}"))
    };
    let list: Vec<String> = rows::PLANES.into_iter().filter_map(ratio).collect();
    format!("{RATIO}{}.\n", list.join(", "))
}

/// The units that the table does not have.
fn without_figures(table: &Table) -> String {
    let missing = Unit::ALL.into_iter().filter(|unit| !table.has(*unit));
    let missing: Vec<String> = missing.map(|unit| format!("`{}`", unit.name())).collect();
    format!(
        "\nUnits without figures here, and without a baseline for `imogene synth --check`: {}.\n",
        missing.join(", ")
    )
}

/// Block memory has no column while no unit uses any.
fn block_memory(table: &Table) -> String {
    let users = table.rows.iter().filter(|row| row.figures.bram > Some(0));
    let user = |row: &Measured| {
        format!(
            "`{}` for {}: {}",
            row.unit,
            row.target,
            count(row.figures.bram)
        )
    };
    match users.map(user).collect::<Vec<_>>().join(", ") {
        none if none.is_empty() => "No unit of this table uses block memory.\n".to_owned(),
        users => format!("Block memories: {users}.\n"),
    }
}

fn devices(table: &Table, section: Section, target: Target) -> String {
    let mut text = format!(
        "\n### {}\n\n| unit | latency | LUT | FF | carry | DSP | cells | Fmax | draws | slowest path |\n",
        target.name()
    );
    text += "|---|---|---|---|---|---|---|---|---|---|\n";
    for row in table.section(section, target) {
        let own = &row.figures;
        let counts = [own.lut, own.ff, own.carry, own.dsp, own.cells].map(count);
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} |",
            name(row),
            row.latency,
            counts.join(" | "),
            clock(own),
            draws(own),
            path(row.slowest_path.as_ref()),
        );
    }
    text
}

/// How a row is called in its section.
fn name(row: &Measured) -> String {
    let (unit, parameters) = (&row.unit, &row.parameters);
    let counted = |count: usize, what: &str| format!("`{unit}`, {}", counted(count, what));
    match row.section {
        Section::Units | Section::Transistors => format!("`{unit}`"),
        Section::Planes => match parameters.get("sides") {
            Some(sides) => counted(*sides, "side"),
            None => counted(parameters["planes"], "plane"),
        },
        Section::Rows => counted(parameters["rows-per-stage"], "row"),
    }
}

fn count(value: Option<u64>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| value.to_string())
}

fn clock(figures: &Figures) -> String {
    match (&figures.does_not_fit, figures.fmax_mhz) {
        (Some(excess), _) => format!("does not fit, {excess} with the harness"),
        (None, Some(fmax)) => format!("{fmax:.1} MHz"),
        (None, None) => "not measured".to_owned(),
    }
}

fn draws(figures: &Figures) -> &'static str {
    let reached = |fmax| VIDEO.into_iter().find(|(clock, _)| fmax >= *clock);
    let found = figures.fmax_mhz.and_then(reached);
    found.map_or("-", |(_, format)| format)
}

fn path(path: Option<&CriticalPath>) -> String {
    let text = path.map(|path| {
        let (from, to) = (register(&path.from), register(&path.to));
        let (logic, routing) = (path.logic_ns, path.routing_ns);
        format!("`{from}` to `{to}`, {logic:.1} ns in cells, {routing:.1} ns in wires")
    });
    text.unwrap_or_else(|| "-".to_owned())
}

/// Name of the register of a cell; the tools add to it how the cell was made.
fn register(cell: &str) -> &str {
    let name = cell.strip_prefix("unit.").unwrap_or(cell);
    let ends = ["_TRELLIS_FF", "_SB_DFF", "_SB_LUT4", "_LUT4", "_CCU2C"];
    let end = ends.iter().filter_map(|end| name.find(end)).min();
    &name[..end.unwrap_or(name.len())]
}
