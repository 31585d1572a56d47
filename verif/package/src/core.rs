//! A unit as an IP core: a folder with Verilog, contract, self-checking bench and FuseSoC core file.

use crate::contract::{Contract, of_emitted};
use imogene_contract::{Request, RequestError, Unit};
use imogene_rtl::emit::emit;
use imogene_verif::bench;
use imogene_verif::unit::subject;
use std::fmt::{Display, Write};

/// Seed of the vectors: the same package each time.
const SEED: u64 = 1;

/// A file of a package: path below its folder, with `/`, and text.
pub type File = (String, String);

/// Units at the base format with default parameters, each in a folder, and a `README.md` that lists them.
///
/// `clocks` are those of random stimulus in a bench; with 0 there are no benches and no target `sim`.
pub fn package(units: &[Unit], clocks: usize) -> Result<Vec<File>, RequestError> {
    let mut files = vec![("README.md".to_owned(), readme(units, clocks))];
    for &unit in units {
        files.extend(inside(unit.name(), core(unit, clocks)?));
    }
    Ok(files)
}

/// The files of one core.
pub fn core(unit: Unit, clocks: usize) -> Result<Vec<File>, RequestError> {
    let request = Request::new(unit);
    let emitted = emit(&request)?;
    let contract = of_emitted(&request, &emitted)?;
    let verilog = inside("rtl", emitted.files());
    let core_file = core_file(&contract, &verilog, clocks > 0);
    let mut files = vec![
        (format!("{}.core", unit.name()), core_file),
        ("CONTRACT.md".to_owned(), contract.markdown()),
        ("contract.json".to_owned(), contract.json()),
    ];
    files.extend(verilog);
    if clocks > 0 {
        let subject = subject(&request)?;
        let stimulus = subject.seeded_stimulus(clocks, SEED);
        let bench = bench::files(&subject, &emitted.top, &stimulus);
        files.extend(inside("bench", bench));
    }
    Ok(files)
}

fn inside<N: Display>(folder: &str, files: Vec<(N, String)>) -> Vec<File> {
    let inside = |(path, text)| (format!("{folder}/{path}"), text);
    files.into_iter().map(inside).collect()
}

/// The FuseSoC description of a core (CAPI2).
fn core_file(contract: &Contract, verilog: &[File], has_bench: bool) -> String {
    let (unit, version) = (contract.unit, env!("CARGO_PKG_VERSION"));
    // A JSON string is a YAML string.
    let description = serde_json::Value::from(contract.computes);
    let mut text = format!(
        "CAPI=2:\n\nname: imogene:ip:{unit}:{version}\ndescription: {description}\n\nfilesets:\n  rtl:\n    files:\n"
    );
    for (name, _) in verilog {
        let _ = writeln!(text, "      - {name}");
    }
    text += "    file_type: verilogSource-2005\n";
    if has_bench {
        text += "  bench:\n    files:\n      - bench/bench.v: {file_type: verilogSource-2005}\n";
        for name in ["stimulus.hex", "expected.hex", "mask.hex"] {
            let _ = writeln!(
                text,
                "      - bench/{name}: {{file_type: user, copyto: {name}}}"
            );
        }
    }
    let _ = write!(
        text,
        "
targets:
  default:
    filesets: [rtl]
    toplevel: {unit}
  lint:
    filesets: [rtl]
    toplevel: {unit}
    flow: lint
    flow_options:
      tool: verilator
      verilator_options: [-Wall]
  synth:
    filesets: [rtl]
    toplevel: {unit}
    flow: generic
    flow_options:
      tool: yosys
      arch: ecp5
      output_format: json
"
    );
    if has_bench {
        text += "  sim:
    filesets: [rtl, bench]
    toplevel: bench
    flow: sim
    flow_options:
      tool: icarus
      iverilog_options: [-g2005]
";
    }
    text
}

fn readme(units: &[Unit], clocks: usize) -> String {
    let names: Vec<&str> = units.iter().map(|unit| unit.name()).collect();
    let names = match units.len() == Unit::ALL.len() {
        true => String::new(),
        false => format!("{} ", names.join(" ")),
    };
    let mut text = String::from(
        "# The units of imogene as IP cores\n\n\
         Base format 24, the planes that `imogene units` gives as default, 1 row of the root network per\n\
         register stage, 4 objects. Each folder holds the Verilog of a unit (`rtl/`, one file for each module),\n\
         its contract (`CONTRACT.md`, `contract.json`) and a FuseSoC core file.\n",
    );
    let _ = writeln!(
        text,
        "\nDo not edit; made by:\n\n    imogene package {names}--clocks {clocks} --out DIR\n\n| unit | computes |\n|---|---|"
    );
    for unit in units {
        let (name, computes) = (unit.name(), unit.record().computes);
        let _ = writeln!(text, "| [{name}]({name}/CONTRACT.md) | {computes} |");
    }
    text
}
