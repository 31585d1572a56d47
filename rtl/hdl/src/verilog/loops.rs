//! Rows of equal instances as generate loops.

use super::expressions::Writer;
use super::rows::{Row, Source};
use super::text::filled;
use crate::scope::is_reserved;
use crate::tree::{Direction, Net};
use std::fmt::Write;

impl Writer<'_> {
    /// The loop, and what its first element takes.
    pub(super) fn row(&self, row: &Row) -> String {
        let (module, own) = (self.module, row.module(self.module));
        let value = |net: &Net| self.value(*net, false);
        let mut text = String::new();
        let mut values = vec![];
        for (source, port) in row.sources.iter().zip(own.ports_of(Direction::In)) {
            let name = format!("{}_{}", row.base, port.name);
            values.push(match source {
                Source::Common(net) => value(net),
                Source::Beside(base, output) => {
                    let mut rows = self.names.rows.iter();
                    let other = rows.find(|other| other.instances.start == *base);
                    other.expect("a row").element(module, *output)
                }
                Source::Before(_, first) => {
                    writeln!(text, "    assign {name}[0] = {};", value(first)).unwrap();
                    format!("{name}[k]")
                }
                Source::Each(nets) => {
                    let values: Vec<String> = nets.iter().rev().map(value).collect();
                    let values = filled(&format!("    assign {name} = {{"), &values, 8);
                    writeln!(text, "{values}}};").unwrap();
                    match port.width {
                        1 => format!("{name}[k]"),
                        width => format!("{name}[{width} * k +: {width}]"),
                    }
                }
            });
        }
        let outputs = own.ports_of(Direction::Out).enumerate();
        values.extend(outputs.map(|(output, _)| row.element(module, output)));
        let one = row.base.strip_suffix('s');
        let one = one.filter(|name| !is_reserved(name)).unwrap_or("one");
        let (base, count) = (&row.base, row.instances.len());
        text + &format!("    for (k = 0; k < {count}; k = k + 1) begin : {base}\n")
            + &self.instance(own, one, values.into_iter(), 8)
            + "    end\n"
    }
}
