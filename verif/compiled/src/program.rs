//! A design as machine code, and where its ports are.

use crate::body;
use crate::code::Code;
use crate::layout::Layout;
use imogene_hdl::{Design, Direction, Module};
use std::collections::HashMap;

/// A port of the top module or a point inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Port {
    pub(crate) place: Place,
    pub(crate) width: u32,
}

/// Where the word of a port is: by its place among those of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Input(usize),
    Output(usize),
    Point(usize),
}

/// What a function of the program reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Given {
    Outputs,
    Points,
}

/// A design as machine code. Its instances share it, on any thread.
pub struct Program {
    code: Code,
    power_up: Vec<u64>,
    registers: Vec<usize>,
    ports: HashMap<String, Port>,
    input_masks: Vec<u64>,
    given: [usize; 2],
}

impl Program {
    /// Compiles a design. Points are what is read inside: a port of an instance, or a net with a name, behind the names
    /// of the instances around it, as in `processors_0.quadric.near_sum`.
    ///
    /// # Panics
    ///
    /// With the name of a value in a loop without a register, or with a point that the design does not have.
    pub fn new(design: &Design, points: &[String]) -> Program {
        let layout = Layout::of(design);
        let mut power_up = vec![0; layout.block(&design.top).size];
        layout.power_up(&design.top, &mut power_up);
        let mut registers = vec![];
        layout.registers(&design.top, 0, &mut registers);
        let outputs = design.top.ports_of(Direction::Out);
        let outputs: Vec<String> = outputs.map(|port| port.name.clone()).collect();
        let mut ports = HashMap::new();
        let mut add = |names: &[String], place: fn(usize) -> Place| {
            for (index, name) in names.iter().enumerate() {
                let width = width(&design.top, name);
                let width = width.unwrap_or_else(|| panic!("no point `{name}`"));
                let place = place(index);
                ports.entry(name.clone()).or_insert(Port { place, width });
            }
        };
        let inputs = design.top.ports_of(Direction::In);
        let inputs: Vec<String> = inputs.map(|port| port.name.clone()).collect();
        add(&inputs, Place::Input);
        add(&outputs, Place::Output);
        add(points, Place::Point);
        let inputs = design.top.ports_of(Direction::In);
        Program {
            input_masks: inputs.map(|port| u64::MAX >> (64 - port.width)).collect(),
            given: [outputs.len(), points.len()],
            code: Code::of(design, &layout, [&outputs, points]),
            power_up,
            registers,
            ports,
        }
    }

    /// The port or the point of this name.
    ///
    /// # Panics
    ///
    /// If there is none.
    pub fn port(&self, name: &str) -> Port {
        let found = self.ports.get(name);
        *found.unwrap_or_else(|| panic!("no port `{name}`"))
    }

    /// All words as they are at power-up.
    pub(crate) fn power_up(&self) -> &[u64] {
        &self.power_up
    }

    /// Where each register lies.
    pub(crate) fn registers(&self) -> &[usize] {
        &self.registers
    }

    /// The bits of each input.
    pub(crate) fn input_masks(&self) -> &[u64] {
        &self.input_masks
    }

    /// The numbers of outputs and of points.
    pub(crate) fn given(&self) -> [usize; 2] {
        self.given
    }

    /// The rising edge of the instance with these words.
    pub(crate) fn clock(&self, words: &mut [u64]) {
        assert_eq!(words.len(), self.power_up.len());
        self.code.clock(words);
    }

    /// What outputs or points give.
    pub(crate) fn read(&self, which: Given, words: &[u64], given: &mut [u64]) {
        assert_eq!(words.len(), self.power_up.len());
        assert_eq!(given.len(), self.given[which as usize]);
        self.code.read(which, words, given);
    }
}

/// The width of a net, by its path.
fn width(top: &Module, path: &str) -> Option<u32> {
    let mut module = top;
    let (instances, name) = path
        .rsplit_once('.')
        .map_or((None, path), |(instances, name)| (Some(instances), name));
    for name in instances.into_iter().flat_map(|path| path.split('.')) {
        let mut parts = module.instances.iter();
        module = &parts.find(|instance| instance.name == name)?.module;
    }
    Some(module.node(body::named(module, name)?).width)
}
