//! Memory with a write port and a synchronous read port.

use crate::kernel::*;
use crate::kernel::{BLOCK_MEMORY, InputPort, Part, Ports};

/// Keeps `2^A` words of `D` bits, or fewer: `2^a`, of whose addresses the low `a` bits count.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `write` | in | write `write_data` to `write_address` |
/// | `write_address` | in | `A` bits |
/// | `write_data` | in | `D` bits |
/// | `read_address` | in | `A` bits |
/// | `read_data` | out | `D` bits, the word at `read_address` one clock before |
///
/// Latency 1. A word read in the clock that writes it is the old one. All words are zero at power-up. The Verilog is an array of `reg` with a registered
/// read, which synthesis maps to block memory.
pub struct BlockMemory<const A: usize, const D: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Write.
    pub write: Signal<In, Bit>,
    /// Where to write.
    pub write_address: Signal<In, Word<A>>,
    /// What to write.
    pub write_data: Signal<In, Word<D>>,
    /// Where to read.
    pub read_address: Signal<In, Word<A>>,
    /// What was read.
    pub read_data: Signal<Out, Word<D>>,
    kept: Vec<Word<D>>,
}

impl<const A: usize, const D: usize> BlockMemory<A, D> {
    /// A memory of zeros.
    ///
    /// # Panics
    ///
    /// When there are more than 24 bits of address.
    pub fn new() -> Self {
        Self::of_address_bits(A)
    }

    /// A memory of `2^bits` zeros.
    ///
    /// # Panics
    ///
    /// When `bits` is not in `1..=A`, or more than 24.
    pub fn of_address_bits(bits: usize) -> Self {
        assert!(
            (1..=A.min(24)).contains(&bits),
            "a block memory has 1 to 24 bits of address, no more than its ports"
        );
        Self {
            clock: Signal::default(),
            write: Signal::default(),
            write_address: Signal::default(),
            write_data: Signal::default(),
            read_address: Signal::default(),
            read_data: Signal::default(),
            kept: vec![Word::default(); 1 << bits],
        }
    }

    /// Clocks from the address to the word.
    pub const fn latency() -> usize {
        1
    }
}

impl<const A: usize, const D: usize> Default for BlockMemory<A, D> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const A: usize, const D: usize> Logic for BlockMemory<A, D> {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            let place = |address: Word<A>| address.index() & (self.kept.len() - 1);
            let (read, write) = (
                place(self.read_address.val()),
                place(self.write_address.val()),
            );
            self.read_data.next = self.kept[read];
            if self.write.val() {
                self.kept[write] = self.write_data.val();
            }
        }
    }

    fn connect(&mut self) {
        self.read_data.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(format!("{BLOCK_MEMORY}{}", self.kept.len().ilog2()))
    }
}

/// In the order of rust-hdl's register, so that a memory takes the values that the registers around it take.
impl<const A: usize, const D: usize> Block for BlockMemory<A, D> {
    fn connect_all(&mut self) {
        self.connect();
        self.clock.connect_all();
        self.write.connect_all();
        self.write_address.connect_all();
        self.write_data.connect_all();
        self.read_address.connect_all();
        self.read_data.connect_all();
    }

    fn update_all(&mut self) {
        self.update();
        self.clock.update_all();
        self.write.update_all();
        self.write_address.update_all();
        self.write_data.update_all();
        self.read_address.update_all();
        self.read_data.update_all();
    }

    fn has_changed(&self) -> bool {
        self.clock.has_changed()
            || self.write.has_changed()
            || self.write_address.has_changed()
            || self.write_data.has_changed()
            || self.read_address.has_changed()
            || self.read_data.has_changed()
    }

    fn accept(&self, name: &str, probe: &mut dyn Probe) {
        probe.visit_start_scope(name, self);
        self.clock.accept("clock", probe);
        self.write.accept("write", probe);
        self.write_address.accept("write_address", probe);
        self.write_data.accept("write_data", probe);
        self.read_address.accept("read_address", probe);
        self.read_data.accept("read_data", probe);
        probe.visit_end_scope(name, self);
    }
}

impl<const A: usize, const D: usize> Part for BlockMemory<A, D> {}

impl<const A: usize, const D: usize> Ports for BlockMemory<A, D> {
    fn set_inputs(&mut self, words: &mut dyn Iterator<Item = u64>) {
        self.write.set(words);
        self.write_address.set(words);
        self.write_data.set(words);
        self.read_address.set(words);
    }

    fn outputs(&self) -> Vec<u64> {
        vec![self.read_data.val().word()]
    }
}

clocked!(BlockMemory<const A: usize, const D: usize>);
