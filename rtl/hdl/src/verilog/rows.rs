//! Rows of equal instances as generate loops over arrays.
//!
//! Instances `rows_0`, `rows_1`, .. of one module are a row if each of their inputs is an output of the one before, or
//! the same for all, or an output of the instance beside it in another row, or a value of its own for each. Where most
//! are of the last kind, as in a tree, a loop says less than its instances one by one.

use super::names::Name;
use super::text::filled;
use crate::tree::{Direction, Instance, Module, Net, Op};
use std::fmt::Write;
use std::ops::Range;
use std::rc::Rc;

/// Fewer equal instances are written one by one.
const LEAST: usize = 2;

/// Where an input comes from.
enum Source {
    /// The same for all.
    Common(Net),
    /// This output of the one before; of the first this net.
    Before(usize, Net),
    /// An output of the instance with the same number of the row that begins there.
    Beside(usize, usize),
    /// Another for each.
    Each(Vec<Net>),
}

/// A row of instances.
pub(super) struct Row {
    pub base: String,
    pub instances: Range<usize>,
    sources: Vec<Source>,
}

/// The rows of a module.
pub(super) fn of(module: &Module) -> Vec<Row> {
    let mut rows: Vec<Row> = vec![];
    let mut first = 0;
    while first < module.instances.len() {
        let base = base_of(&module.instances[first], 0);
        let count = base.map_or(1, |base| {
            let rest = module.instances[first..].iter().enumerate();
            let same = |(k, other): &(usize, &Instance)| {
                base_of(other, *k) == Some(base)
                    && Rc::ptr_eq(&other.module, &module.instances[first].module)
            };
            rest.take_while(same).count()
        });
        if let (Some(base), true) = (base, count >= LEAST) {
            let row = &module.instances[first..first + count];
            let sources = sources(module, row, first, &rows);
            let each = sources
                .iter()
                .filter(|source| matches!(source, Source::Each(_)));
            if 2 * each.count() < sources.len() {
                rows.push(Row {
                    base: base.to_owned(),
                    instances: first..first + count,
                    sources,
                });
            }
        }
        first += count.max(1);
    }
    rows
}

/// The name of an instance without its number.
fn base_of(instance: &Instance, number: usize) -> Option<&str> {
    instance.name.strip_suffix(&format!("_{number}"))
}

fn sources(module: &Module, row: &[Instance], first: usize, rows: &[Row]) -> Vec<Source> {
    let mut taken = vec![];
    let source = |input: usize| {
        let nets: Vec<Net> = row.iter().map(|instance| instance.inputs[input]).collect();
        if nets.iter().all(|net| *net == nets[0]) {
            return Source::Common(nets[0]);
        }
        let beside = match module.node(nets[0]).op {
            Op::Output(base, output) => {
                let follows =
                    |(k, net): (usize, &Net)| module.node(*net).op == Op::Output(base + k, output);
                let is_row = |other: &Row| other.instances == (base..base + row.len());
                let holds = rows.iter().any(is_row) && nets.iter().enumerate().all(follows);
                holds.then_some(Source::Beside(base, output))
            }
            _ => None,
        };
        if let Some(beside) = beside {
            return beside;
        }
        let output = |k: usize| match module.node(nets[k]).op {
            Op::Output(from, output) if from + 1 == first + k => Some(output),
            _ => None,
        };
        match output(1) {
            Some(before)
                if !taken.contains(&before)
                    && (1..row.len()).all(|k| output(k) == Some(before)) =>
            {
                taken.push(before);
                Source::Before(before, nets[0])
            }
            _ => Source::Each(nets),
        }
    };
    (0..row[0].inputs.len()).map(source).collect()
}

impl Row {
    fn module<'a>(&self, module: &'a Module) -> &'a Module {
        &module.instances[self.instances.start].module
    }

    /// The array that an output is an element of, and how many elements on.
    fn array_of(&self, module: &Module, output: usize) -> (String, usize) {
        let own = self.module(module);
        let mut inputs = self.sources.iter().zip(own.ports_of(Direction::In));
        let follows =
            inputs.find(|(source, _)| matches!(source, Source::Before(o, _) if *o == output));
        let (port, on) = match follows {
            Some((_, input)) => (input, 1),
            None => (own.ports_of(Direction::Out).nth(output).expect("a port"), 0),
        };
        (format!("{}_{}", self.base, port.name), on)
    }

    /// Calls each output an element of an array.
    pub fn name_outputs(&self, module: &Module, names: &mut [Option<Name>]) {
        for (k, index) in self.instances.clone().enumerate() {
            for (output, net) in module.instances[index].outputs.iter().enumerate() {
                let (text, on) = self.array_of(module, output);
                names[net.0 as usize] = Some(Name {
                    text,
                    element: Some((k + on) as u32),
                });
            }
        }
    }

    /// What it declares, each with its width: arrays of what goes from one to the next and of what comes out, which
    /// simulators take apart, and vectors of what each is given.
    pub fn vectors(&self, module: &Module) -> Vec<(String, u32)> {
        let own = self.module(module);
        let count = self.instances.len() as u32;
        let inputs = self.sources.iter().zip(own.ports_of(Direction::In));
        let inputs = inputs.filter_map(|(source, port)| {
            let name = format!("{}_{}", self.base, port.name);
            match source {
                Source::Common(_) | Source::Beside(..) => None,
                Source::Before(..) => Some((format!("{name} [0:{count}]"), port.width)),
                Source::Each(_) => Some((name, count * port.width)),
            }
        });
        let outputs = own.ports_of(Direction::Out).enumerate();
        let outputs = outputs.filter_map(|(output, port)| {
            let (name, on) = self.array_of(module, output);
            (on == 0).then(|| (format!("{name} [0:{}]", count - 1), port.width))
        });
        inputs.chain(outputs).collect()
    }

    /// The loop, and what its first element takes.
    pub fn written(
        &self,
        module: &Module,
        prefix: &str,
        rows: &[Row],
        value: &dyn Fn(Net) -> String,
    ) -> String {
        let own = self.module(module);
        let mut text = String::new();
        let mut lines = vec![];
        if own.is_clocked() {
            lines.push(".clock(clock)".to_owned());
        }
        for (source, port) in self.sources.iter().zip(own.ports_of(Direction::In)) {
            let (name, width) = (format!("{}_{}", self.base, port.name), port.width);
            let connected = match source {
                Source::Common(net) => value(*net),
                Source::Beside(base, output) => {
                    let other = rows.iter().find(|row| row.instances.start == *base);
                    let (name, on) = other.expect("a row").array_of(module, *output);
                    element(&name, on)
                }
                Source::Before(_, first) => {
                    writeln!(text, "    assign {name}[0] = {};", value(*first)).unwrap();
                    element(&name, 0)
                }
                Source::Each(nets) => {
                    let values: Vec<String> = nets.iter().rev().map(|net| value(*net)).collect();
                    let values = filled(&format!("    assign {name} = {{"), &values, 8);
                    writeln!(text, "{values}}};").unwrap();
                    part(&name, width)
                }
            };
            lines.push(format!(".{}({connected})", port.name));
        }
        for (output, port) in own.ports_of(Direction::Out).enumerate() {
            let (name, on) = self.array_of(module, output);
            lines.push(format!(".{}({})", port.name, element(&name, on)));
        }
        let one = self.base.strip_suffix('s').unwrap_or("one");
        let (base, count) = (&self.base, self.instances.len());
        let lines = filled("            ", &lines, 12);
        write!(
            text,
            "    for (k = 0; k < {count}; k = k + 1) begin : {base}\n        \
             {prefix}{} {one} (\n{lines});\n    end\n",
            own.name
        )
        .unwrap();
        text
    }
}

/// An element of an array by the number of its instance, or the one after it.
fn element(name: &str, on: usize) -> String {
    match on {
        0 => format!("{name}[k]"),
        _ => format!("{name}[k + 1]"),
    }
}

/// What the instance of a number takes of a vector.
fn part(name: &str, width: u32) -> String {
    match width {
        1 => format!("{name}[k]"),
        _ => format!("{name}[{width} * k +: {width}]"),
    }
}
