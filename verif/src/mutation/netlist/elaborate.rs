//! Yosys: the elaborated unit, its list of mutants, and all mutants in one design.

use super::mutant::{Mutant, parse, selector};
use crate::mutation::score::{MutationError, Options};
use imogene_tools::{read, yosys};
use std::fmt::Write as _;
use std::path::Path;

/// The unit's Verilog in the working folder.
pub const SOURCE: &str = "unit.v";
/// The elaborated unit.
pub const NETLIST: &str = "unit.il";

/// Elaborates the unit, flat, and lists mutants; returns them and how many were possible. The Verilog is in the folder
/// as [`SOURCE`] already, and `text` is the same.
///
/// # Errors
///
/// When Yosys is missing or refuses the Verilog, or its list cannot be read.
pub fn elaborate(
    folder: &Path,
    top: &str,
    text: &str,
    options: &Options,
) -> Result<(Vec<Mutant>, usize), MutationError> {
    let script = format!(
        "read_verilog {SOURCE}\nhierarchy -check -top {top}\nproc\nflatten\nopt -full\nwreduce\n\
         opt -full\ndffunmap\nopt_expr -fine\nopt_clean\nstat\nwrite_rtlil {NETLIST}\n\
         mutate -list {} -seed {} -o mutants.txt\n",
        options.mutants, options.seed
    );
    let said = yosys(folder, "elaborate.ys", &script)?;
    let mut lines = said.lines();
    let size = lines.find_map(|line| line.strip_prefix("Raw database size: "));
    let candidates = size.and_then(|count| count.trim().parse().ok());
    let unread = || MutationError::List("no size of the database".into());
    let list = read(&folder.join("mutants.txt"))?;
    Ok((parse(&list, text)?, candidates.ok_or_else(unread)?))
}

/// The Verilog of all mutants in one module, with an input that selects one.
pub(super) fn all_mutants(
    folder: &Path,
    top: &str,
    mutants: &[Mutant],
) -> Result<String, MutationError> {
    let selector = selector(mutants.len());
    let mut script = format!("read_rtlil {NETLIST}\n");
    for mutant in mutants {
        let _ = writeln!(
            script,
            "mutate -module {top} {} -ctrl {} {} {}",
            mutant.command, selector.name, selector.width, mutant.number
        );
    }
    script += "write_verilog -noattr mutants.v\n";
    yosys(folder, "mutants.ys", &script)?;
    Ok(read(&folder.join("mutants.v"))?)
}
