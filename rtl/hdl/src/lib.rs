//! Circuits whose widths are known when they are built.
//!
//! A circuit is a function over values: [`Bits`] are unsigned words, [`Int`] two's complement numbers, each with a
//! width of 1 to 64 bits. Operators make nets; [`net!`] names them after the variables that hold them. [`module()`]
//! gives a function ports, so that it becomes a module of its own, instantiated as often as it is called.
//! [`Design::of`] holds what was built; the [simulator](Simulator), the [Verilog](verilog::write) and the
//! [blocks](block::Block) of rust-hdl all read the same tree.
//!
//! ```
//! use imogene_hdl::{Bits, Design, Simulator, Value, module, net};
//!
//! fn counter(at: &str, enable: Bits, width: u32) -> Bits {
//!     module("counter", at, ("enable", enable), |enable| {
//!         let count = Bits::register(width).named("count");
//!         net! { let next = count + Bits::new(1, width); }
//!         count.load_when(enable, next);
//!         ("value", count)
//!     })
//! }
//!
//! let design = Design::of(|| {
//!     counter("top", Bits::input(1), 4);
//! });
//! let mut simulator = Simulator::new(&design);
//! let (enable, value) = (simulator.port("enable"), simulator.port("value"));
//! simulator.set(enable, 1);
//! (0..20).for_each(|_| simulator.clock());
//! assert_eq!(simulator.get(value), 4);
//! ```
//!
//! What does not fit is refused where it is built, with the names of the values and the line that joined them: operands
//! of different widths, a literal that is too large, a register without an input, a loop without a register.

mod bare;
pub mod block;
mod build;
mod bundle;
mod scope;
mod simulate;
mod tree;
mod tuples;
mod value;
pub mod verilog;

pub use bare::{Plain, Ports};
pub use build::{Design, module};
#[doc(hidden)]
pub use bundle::{Bundle, Label};
#[doc(hidden)]
pub use scope::Handle;
pub use scope::unregistered;
pub use simulate::{Code, Flop, Kind, Levels, Port, Simulator, Store};
pub use tree::{Binary, Direction, Instance, Memory, Module, Net, Node, Op, PortRecord, Register};
pub use value::memory::{memory, read_only_memory};
pub use value::{Bits, Int, Value, join};
