//! Circuits as machine code, made in the process in milliseconds.
//!
//! Each distinct module that stands in a design more than once becomes one function, called per instance; small ones
//! become part of what is around them. A clock is one call. What a port gives is computed when it is asked for, from
//! what the registers hold.
//!
//! ```
//! use imogene_compiled::Compiled;
//! use imogene_hdl::{Bits, Design, Value, module};
//!
//! let design = Design::of(|| {
//!     module("counter", "top", ("enable", Bits::input(1)), |enable| {
//!         let count = Bits::register(4).named("count");
//!         count.load_when(enable, count + Bits::new(1, 4));
//!         ("value", count)
//!     });
//! });
//! let mut counter = Compiled::new(&design);
//! let (enable, value) = (counter.port("enable"), counter.port("value"));
//! counter.set(enable, 1);
//! (0..20).for_each(|_| counter.clock());
//! assert_eq!(counter.get(value), 4);
//! ```
#![warn(missing_docs)]

mod body;
mod code;
mod layout;
mod word;

use code::Code;
use imogene_hdl::{Design, Direction, Module};
use layout::Layout;
use std::collections::HashMap;
use std::rc::Rc;

/// A port of the top module or a point inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Port {
    place: Place,
    width: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// An input, by its place among them.
    Input(usize),
    /// What is read, by the order in which it was first asked for.
    Point(usize),
}

/// A design that runs, clock by clock: as many instances as there are lanes, each with words of its own.
pub struct Compiled {
    top: Rc<Module>,
    layout: Layout,
    code: Code,
    /// Outputs, then points, by their paths.
    points: Vec<String>,
    ports: HashMap<String, Port>,
    lanes: Vec<Lane>,
}

#[derive(Clone)]
struct Lane {
    words: Vec<u64>,
    /// What the points give, unless something changed since.
    given: Vec<u64>,
    is_read: bool,
}

impl Compiled {
    /// One instance of a design.
    pub fn new(design: &Design) -> Compiled {
        Compiled::in_lanes(design, 1)
    }

    /// So many instances of a design.
    pub fn in_lanes(design: &Design, lanes: usize) -> Compiled {
        let layout = Layout::of(design);
        let mut words = vec![0; layout.block(&design.top).size];
        layout.power_up(&design.top, &mut words);
        let code = Code::of(design, &layout);
        let lane = Lane {
            words,
            given: vec![],
            is_read: false,
        };
        let mut compiled = Compiled {
            top: design.top.clone(),
            layout,
            code,
            points: vec![],
            ports: HashMap::new(),
            lanes: vec![lane; lanes],
        };
        for (index, port) in design.top.ports_of(Direction::In).enumerate() {
            let (place, width) = (Place::Input(index), port.width);
            compiled
                .ports
                .insert(port.name.clone(), Port { place, width });
        }
        for port in design.top.ports_of(Direction::Out) {
            compiled.point(&port.name);
        }
        compiled
    }

    /// A point inside the design: a port of an instance, or a net with a name, behind the names of the instances around
    /// it, as in `processors_0.quadric.near_sum`. It may be read, not set.
    pub fn point(&mut self, path: &str) -> Option<Port> {
        if let Some(port) = self.ports.get(path) {
            return Some(*port);
        }
        let mut module = &self.top;
        let (instances, name) = path
            .rsplit_once('.')
            .map_or((None, path), |(a, b)| (Some(a), b));
        for name in instances.into_iter().flat_map(|path| path.split('.')) {
            let mut parts = module.instances.iter();
            module = &parts.find(|instance| instance.name == name)?.module;
        }
        let width = module.node(body::named(module, name)?).width;
        let place = Place::Point(self.points.len());
        self.points.push(path.to_owned());
        self.lanes.iter_mut().for_each(|lane| lane.is_read = false);
        let port = Port { place, width };
        self.ports.insert(path.to_owned(), port);
        Some(port)
    }

    /// The port of this name.
    ///
    /// # Panics
    ///
    /// If there is none.
    pub fn port(&self, name: &str) -> Port {
        let found = self.ports.get(name);
        *found.unwrap_or_else(|| panic!("no port `{name}`"))
    }

    /// Gives an input its word; bits beyond its width count nothing.
    ///
    /// # Panics
    ///
    /// If it is no input.
    pub fn set(&mut self, port: Port, value: u64) {
        self.set_lane(0, port, value);
    }

    /// Gives an input its word in one lane.
    ///
    /// # Panics
    ///
    /// If it is no input.
    pub fn set_lane(&mut self, lane: usize, port: Port, value: u64) {
        let Place::Input(place) = port.place else {
            panic!("{port:?} is no input");
        };
        let lane = &mut self.lanes[lane];
        let value = value & (u64::MAX >> (64 - port.width));
        lane.is_read &= lane.words[place] == value;
        lane.words[place] = value;
    }

    /// The word of a port in this clock.
    pub fn get(&mut self, port: Port) -> u64 {
        self.get_lane(0, port)
    }

    /// The word of a port in this clock in one lane.
    pub fn get_lane(&mut self, lane: usize, port: Port) -> u64 {
        let lane = &mut self.lanes[lane];
        let index = match port.place {
            Place::Input(place) => return lane.words[place],
            Place::Point(index) => index,
        };
        if !lane.is_read {
            self.code.add_points(&self.top, &self.layout, &self.points);
            lane.given.resize(self.points.len(), 0);
            self.code.read(&lane.words, &mut lane.given);
            lane.is_read = true;
        }
        lane.given[index]
    }

    /// The rising edge, in all lanes.
    pub fn clock(&mut self) {
        for lane in &mut self.lanes {
            self.code.clock(&mut lane.words);
            lane.is_read = false;
        }
    }
}
