//! Rows of equal instances, which are written as loops over arrays.
//!
//! Instances `rows_0`, `rows_1`, .. of one module are a row if each of their inputs is an output of the one before, or
//! the same for all, or an output of the instance beside it in another row, or a value of its own for each. Where most
//! are of the last kind, as in a tree, a loop says less than its instances one by one.

use super::text::Name;
use crate::tree::{Direction, Instance, Module, Net, Op};
use std::ops::Range;
use std::sync::Arc;

/// Fewer equal instances are written one by one.
const LEAST: usize = 2;

/// Where an input comes from.
pub(super) enum Source {
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
    pub sources: Vec<Source>,
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
                    && Arc::ptr_eq(&other.module, &module.instances[first].module)
            };
            rest.take_while(same).count()
        });
        if let (Some(base), true) = (base, count >= LEAST) {
            let row = &module.instances[first..first + count];
            let sources = sources(module, row, first, &rows);
            let is_each = |source: &&Source| matches!(source, Source::Each(_));
            if 2 * sources.iter().filter(is_each).count() < sources.len() {
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

/// The output that nets are, each of the instance after that of the net before, and the first of these instances.
fn in_step(module: &Module, nets: &[Net]) -> Option<(usize, usize)> {
    let Op::Output(first, output) = module.node(nets[0]).op else {
        return None;
    };
    let mut ops = nets.iter().map(|net| &module.node(*net).op).zip(first..);
    let is_next = |(op, instance): (&Op, usize)| *op == Op::Output(instance, output);
    ops.all(is_next).then_some((first, output))
}

fn sources(module: &Module, row: &[Instance], first: usize, rows: &[Row]) -> Vec<Source> {
    let mut taken = vec![];
    let is_row = |base| {
        rows.iter()
            .any(|other| other.instances == (base..base + row.len()))
    };
    let source = |input: usize| {
        let nets: Vec<Net> = row.iter().map(|instance| instance.inputs[input]).collect();
        if nets.iter().all(|net| *net == nets[0]) {
            return Source::Common(nets[0]);
        }
        match (in_step(module, &nets), in_step(module, &nets[1..])) {
            (Some((base, output)), _) if is_row(base) => Source::Beside(base, output),
            (_, Some((base, output))) if base == first && !taken.contains(&output) => {
                taken.push(output);
                Source::Before(output, nets[0])
            }
            _ => Source::Each(nets),
        }
    };
    (0..row[0].inputs.len()).map(source).collect()
}

impl Row {
    pub fn module<'a>(&self, module: &'a Module) -> &'a Module {
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
                names[net.0] = Some(Name {
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

    /// What the instance of a number gives at this output.
    pub fn element(&self, module: &Module, output: usize) -> String {
        match self.array_of(module, output) {
            (name, 0) => format!("{name}[k]"),
            (name, _) => format!("{name}[k + 1]"),
        }
    }
}
