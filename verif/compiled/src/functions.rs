//! The functions of a program: one for each module that is called, and one for each task.

use crate::body::Body;
use crate::layout::{Lanes, Layout};
use crate::line::{Line, Step};
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

/// The functions of a design with these outputs and points, those of the tasks last.
pub(crate) fn functions(
    design: &Design,
    layout: &Layout,
    lanes: Lanes,
    read: [&[String]; 2],
) -> Vec<Function> {
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
    let of_parts = called.iter().map(|module| clock(module, lanes.of_called()));
    let mut functions: Vec<Function> = of_parts.collect();
    functions.push(clock(&design.top, lanes));
    functions.extend(read.map(|paths| Function {
        line: reading(&design.top, layout, lanes, paths),
        lanes,
    }));
    functions
}

/// What reads the nets at these paths.
fn reading(top: &Arc<Module>, layout: &Layout, lanes: Lanes, paths: &[String]) -> Line {
    let mut body = Body::new(layout, top, lanes);
    for (index, path) in paths.iter().enumerate() {
        let place = body.find(path);
        let place = place.unwrap_or_else(|| panic!("no point `{path}`"));
        let value = body.zeros(place);
        body.to.add(Step::Give(value, index));
    }
    body.to
}
