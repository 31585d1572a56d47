//! A design as machine code, and where its ports are.

use crate::body;
use crate::code::{Code, Task};
use crate::interpret::Work;
use crate::layout::{Lanes, Layout, Register};
use crate::words::Words;
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

/// A design as machine code. Its instances share it, on any thread.
pub struct Program {
    code: Code,
    lanes: Lanes,
    size: usize,
    registers: Vec<Register>,
    /// Words of memories at power-up, beside zeros.
    contents: Vec<(usize, u64)>,
    ports: HashMap<String, Port>,
    inputs: usize,
    given: [usize; 2],
}

impl Program {
    /// Compiles a design. Points are what is read inside: a port of an instance, or a net with a name, behind the names
    /// of the instances around it, as in `processors_0.quadric.near_sum`.
    ///
    /// Without AVX2 the steps of the code are interpreted.
    ///
    /// # Panics
    ///
    /// With the name of a value in a loop without a register, or with a point that the design does not have.
    pub fn new(design: &Design, points: &[String]) -> Program {
        Program::of(design, points, Lanes::One)
    }

    /// As [`Program::new`], for four runs side by side at the price of one.
    pub fn in_lanes(design: &Design, points: &[String]) -> Program {
        Program::of(design, points, Lanes::Four)
    }

    fn of(design: &Design, points: &[String], lanes: Lanes) -> Program {
        let layout = Layout::of(design, lanes);
        let mut ports = HashMap::new();
        let mut add = |names: &[String], place: fn(usize) -> Place| {
            for (index, name) in names.iter().enumerate() {
                let width = width(&design.top, name);
                let width = width.unwrap_or_else(|| panic!("no point `{name}`"));
                let place = place(index);
                ports.entry(name.clone()).or_insert(Port { place, width });
            }
        };
        let [inputs, outputs] = [Direction::In, Direction::Out].map(|direction| {
            let ports = design.top.ports_of(direction);
            ports.map(|port| port.name.clone()).collect::<Vec<_>>()
        });
        add(&inputs, Place::Input);
        add(&outputs, Place::Output);
        add(points, Place::Point);
        Program {
            inputs: inputs.len(),
            given: [outputs.len(), points.len()],
            code: Code::of(design, &layout, lanes, [&outputs, points]),
            lanes,
            size: layout.size,
            registers: layout.registers(&design.top, lanes),
            contents: layout.contents(&design.top, lanes),
            ports,
        }
    }

    /// The same program without machine code: its steps are interpreted, one by one.
    pub fn interpreted(mut self) -> Program {
        self.code.interpret();
        self
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

    /// The machine code, for a disassembler; none without AVX2.
    pub fn machine_code(&self) -> Option<&[u8]> {
        self.code.bytes()
    }

    /// How many runs lie side by side: 1 or 4.
    pub fn lanes(&self) -> usize {
        self.lanes.count()
    }

    /// All words as they are at power-up.
    pub(crate) fn power_up(&self) -> Words {
        let mut words = Words::new(self.size);
        for register in &self.registers {
            for lane in 0..self.lanes() {
                words[register.place + lane] = register.initial;
            }
        }
        for &(place, word) in &self.contents {
            words[place..place + self.lanes()].fill(word);
        }
        words
    }

    /// Room for what does not fit into registers.
    pub(crate) fn spilled(&self) -> Words {
        Words::new(4 * self.code.spilled())
    }

    /// A register, by its number in the design.
    pub(crate) fn register(&self, index: usize) -> &Register {
        &self.registers[index]
    }

    /// How many inputs each lane has.
    pub(crate) fn inputs(&self) -> usize {
        self.inputs
    }

    /// How many words outputs and points give.
    pub(crate) fn given(&self) -> [usize; 2] {
        self.given.map(|count| count * self.lanes())
    }

    /// Does a task for an instance, whose words are those of [`Program::power_up`], with the room for spilled words.
    ///
    /// # Panics
    ///
    /// If a row of inputs has not as many words as there are.
    pub(crate) fn run(&self, task: Task, work: &mut Work<'_>, spilled: &mut Words) {
        let is_whole = |row: &&[i64]| row.len() == self.inputs;
        assert!(work.rows.iter().all(is_whole), "a word for each input");
        self.code.run(task, work, spilled);
    }
}

/// The width of a net, by its path.
fn width(top: &Module, path: &str) -> Option<u32> {
    let mut module = top;
    let mut names: Vec<&str> = path.split('.').collect();
    let last = names.pop()?;
    for name in names {
        let mut parts = module.instances.iter();
        module = &parts.find(|instance| instance.name == name)?.module;
    }
    Some(module.node(body::named(module, last)?).width)
}
