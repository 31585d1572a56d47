//! The functions of a design.

use crate::body::Body;
use crate::interpret::{self, Work};
use crate::layout::{Lanes, Layout};
use crate::line::{Line, Step};
use crate::machine::Machine;
use imogene_hdl::{Design, Module};
use std::collections::HashMap;
use std::sync::Arc;

/// What a program is asked for: the rising edge, or what outputs or points give.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Task {
    Clock,
    Outputs,
    Points,
}

pub(crate) const TASKS: usize = 3;

/// What is done in which lanes.
pub(crate) struct Function {
    pub(crate) line: Line,
    pub(crate) lanes: Lanes,
}

/// The functions of a design, those of the tasks last, and their machine code if the processor has AVX2.
pub(crate) struct Code {
    functions: Vec<Function>,
    machine: Option<Machine>,
}

impl Code {
    /// Of a design with these outputs and points.
    pub(crate) fn of(design: &Design, layout: &Layout, lanes: Lanes, read: [&[String]; 2]) -> Code {
        let modules = design.top.all();
        let called = modules.iter().filter(|module| layout.is_called(module));
        let called: Vec<&Arc<Module>> = called.collect();
        let number: HashMap<*const Module, usize> = called
            .iter()
            .enumerate()
            .map(|(index, module)| (Arc::as_ptr(module), index))
            .collect();
        let clock = |module, lanes| {
            let mut body = Body::new(layout, module, lanes);
            body.update(&|part: &Arc<Module>| number[&Arc::as_ptr(part)]);
            Function {
                line: body.to,
                lanes,
            }
        };
        let of_parts = called.iter().map(|module| clock(module, Lanes::Four));
        let mut functions: Vec<Function> = of_parts.collect();
        functions.push(clock(&design.top, lanes));
        functions.extend(read.map(|paths| Function {
            line: reading(&design.top, layout, lanes, paths),
            lanes,
        }));
        Code {
            machine: Machine::of(&functions),
            functions,
        }
    }

    /// Does without machine code.
    pub(crate) fn interpret(&mut self) {
        self.machine = None;
    }

    pub(crate) fn bytes(&self) -> Option<&[u8]> {
        self.machine.as_ref().map(Machine::bytes)
    }

    /// Vectors that its functions spill to.
    pub(crate) fn spilled(&self) -> usize {
        self.machine.as_ref().map_or(0, Machine::spilled)
    }

    /// Does a task with the words of an instance; only the other tasks than the clock give words.
    pub(crate) fn run(&self, task: Task, work: &mut Work<'_>, spilled: &mut [u64]) {
        let function = self.functions.len() - TASKS + task as usize;
        match &self.machine {
            Some(machine) => machine.run(function, work, spilled),
            None => interpret::run(&self.functions, function, 0, work),
        }
    }
}

/// What reads the nets at these paths.
fn reading(top: &Arc<Module>, layout: &Layout, lanes: Lanes, paths: &[String]) -> Line {
    let mut body = Body::new(layout, top, lanes);
    for (index, path) in paths.iter().enumerate() {
        let place = body.find(path);
        let value = body.zeros(place);
        body.to.add(Step::Give(value, index));
    }
    body.to
}
