//! A contract as a page.

use super::{Contract, PortEntry};
use std::fmt::Write;

pub(super) fn page(contract: &Contract) -> String {
    let mut text = format!("# {}\n\nComputes {}.\n\n", contract.unit, contract.computes);
    let clocks = if contract.latency.clocks == 1 {
        "clock"
    } else {
        "clocks"
    };
    let latency = format!(
        "{} {clocks}, `{}`",
        contract.latency.clocks, contract.latency.formula
    );
    text += "| | |\n|---|---|\n";
    for (what, value) in [
        ("source", contract.source),
        ("latency", &latency),
        ("throughput", contract.throughput),
        ("reset", contract.reset),
        ("ties", contract.ties),
        ("error", &contract.error),
        ("made by", &format!("`{}`", contract.command)),
    ] {
        let _ = writeln!(text, "| {what} | {value} |");
    }
    text += "\n## Parameters\n\n| parameter | option | legal | here |\n|---|---|---|---|\n";
    for p in &contract.parameters {
        let _ = writeln!(
            text,
            "| `{}` | `--{}` | {} | {} |",
            p.symbol, p.option, p.range, p.value
        );
    }
    text += "\n## Ports\n\n| port | direction | width | formula | format | meaning |\n|---|---|---|---|---|---|\n";
    contract.ports.iter().for_each(|port| text += &row(port));
    text
}

fn row(port: &PortEntry) -> String {
    format!(
        "| `{}` | {} | {} | `{}` | {} | {} |\n",
        port.name, port.direction, port.width, port.formula, port.format, port.meaning
    )
}
