//! The circuits of imogene, as functions over values: see `imogene_hdl`.
//!
//! A circuit that is a module of its own takes the name of its instance first. Widths follow from the values that it
//! is given. Sections without a name are those of Nyiri 1994.
//!
//! ```
//! use imogene_circuits::raster::{Flags, Linear, pe1};
//! use imogene_hdl::{Design, Simulator};
//!
//! // a x + b y + c in words of 16 bits.
//! let design = Design::of(|| {
//!     pe1("top", Flags::input(), Linear::input(16));
//! });
//! let mut simulator = Simulator::new(&design);
//! let [start, value] = ["start", "value"].map(|name| simulator.port(name));
//! for (name, word) in [("valid", 1), ("a", 3), ("b", 5), ("c", 7)] {
//!     simulator.set(simulator.port(name), word);
//! }
//! for x in 0..3 {
//!     simulator.set(start, u64::from(x == 0));
//!     simulator.clock();
//!     assert_eq!(simulator.get(value), 3 * x + 7);
//! }
//! ```

pub mod arith;
pub mod machine;
pub mod machines;
pub mod object;
pub mod raster;
mod rows;
pub mod shade;
pub mod tree;
pub mod units;
pub mod video;
