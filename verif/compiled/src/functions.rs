//! The functions of a program: one for each module that is called, and one for each task.

use crate::body::Body;
use crate::lanes::Lanes;
use crate::layout::Layout;
use crate::line::{Line, Step};
use crate::size::Size;
use crate::split::split;
use imogene_hdl::{Design, Direction, Module};
use std::sync::Arc;

/// What a program is asked for: the rising edge, or what outputs or points give.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Task {
    Clock,
    Outputs,
    Points,
}

pub(crate) const TASKS: usize = 3;

/// What is done in which lanes; eight are vectors of four.
pub(crate) struct Function {
    pub(crate) line: Line,
    pub(crate) lanes: Lanes,
}

/// The functions of a design with these outputs and points: those of modules, one for each part apart, one for each
/// group that calls one of those, and those of the tasks.
pub(crate) fn functions(
    design: &Design,
    layout: &Layout,
    lanes: Lanes,
    shares_inputs: bool,
    read: [&[String]; 2],
) -> Vec<Function> {
    let modules = design.top.all();
    let called = called(&modules, layout, lanes);
    let number = |module: &Arc<Module>, lanes: Lanes| {
        let mut called = called.iter();
        let place = called.position(|(known, of)| Arc::ptr_eq(known, module) && *of == lanes);
        place.expect("a function for what is called")
    };
    let inputs = design.top.ports_of(Direction::In).count();
    let inputs = (!shares_inputs).then_some(inputs);
    let function = |line, lanes| match lanes {
        Lanes::Eight => Function {
            line: split(&line, inputs),
            lanes: Lanes::Four,
        },
        lanes => Function { line, lanes },
    };
    let clock = |module, lanes| {
        let mut body = Body::new(layout, module, lanes);
        body.update(&number);
        function(body.to, lanes)
    };
    let of_parts = called.iter().map(|(module, lanes)| clock(module, *lanes));
    let mut functions: Vec<Function> = of_parts.collect();
    for apart in &layout.apart {
        let mut body = Body::apart(layout, apart);
        body.update(&number);
        functions.push(function(body.to, Lanes::One));
    }
    for group in &layout.groups {
        let mut line = Line::default();
        line.add(Step::Call(number(&group.module, group.lanes), group.place));
        functions.push(function(line, Lanes::One));
    }
    functions.push(clock(&design.top, lanes));
    let reading = |paths| function(reading(&design.top, layout, lanes, paths), lanes);
    functions.extend(read.map(reading));
    functions
}

/// The modules with functions of their own and their lanes, those that a module calls before it.
fn called(modules: &[Arc<Module>], layout: &Layout, lanes: Lanes) -> Vec<(Arc<Module>, Lanes)> {
    let groups = layout
        .groups
        .iter()
        .map(|group| (group.module.all(), group.lanes));
    let all: Vec<(Vec<Arc<Module>>, Lanes)> = match lanes {
        Lanes::One => groups.collect(),
        lanes => vec![(modules.to_vec(), lanes)],
    };
    let mut found: Vec<(Arc<Module>, Lanes)> = vec![];
    for (modules, lanes) in all {
        for module in modules
            .into_iter()
            .filter(|module| layout.is_called(module))
        {
            let is_this =
                |(known, of): &(Arc<Module>, Lanes)| Arc::ptr_eq(known, &module) && *of == lanes;
            if !found.iter().any(is_this) {
                found.push((module, lanes));
            }
        }
    }
    found
}

/// What reads the nets at these paths.
fn reading(top: &Arc<Module>, layout: &Layout, lanes: Lanes, paths: &[String]) -> Line {
    let mut body = Body::new(layout, top, lanes);
    for (index, path) in paths.iter().enumerate() {
        let place = body.find(path);
        let place = place.unwrap_or_else(|| panic!("no point `{path}`"));
        let value = body.zeros_to(place, Size::Whole);
        body.to.add(Step::Give(value, index * lanes.count()));
    }
    body.to
}
