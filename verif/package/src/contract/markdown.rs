//! A contract as a page.

use super::Contract;
use std::fmt::Write;

impl Contract {
    /// The contract as a Markdown page.
    pub fn markdown(&self) -> String {
        let mut text = format!("# {}\n\nComputes {}.\n\n", self.unit, self.computes);
        let clocks = if self.latency.clocks == 1 {
            "clock"
        } else {
            "clocks"
        };
        let latency = format!(
            "{} {clocks}, `{}`",
            self.latency.clocks, self.latency.formula
        );
        text += "| | |\n|---|---|\n";
        for (what, value) in [
            ("source", self.source),
            ("latency", &latency),
            ("throughput", self.throughput),
            ("reset", self.reset),
            ("ties", self.ties),
            ("error", &self.error),
            ("made by", &format!("`{}`", self.command)),
        ] {
            let _ = writeln!(text, "| {what} | {value} |");
        }
        text += "\n## Parameters\n\n| parameter | option | legal | here |\n|---|---|---|---|\n";
        for p in &self.parameters {
            let _ = writeln!(
                text,
                "| `{}` | `--{}` | {} | {} |",
                p.symbol, p.option, p.range, p.value
            );
        }
        text += "\n## Ports\n\n| port | direction | width | formula | format | meaning |\n|---|---|---|---|---|---|\n";
        for p in &self.ports {
            let _ = writeln!(
                text,
                "| `{}` | {} | {} | `{}` | {} | {} |",
                p.name, p.direction, p.width, p.formula, p.format, p.meaning
            );
        }
        text
    }
}
