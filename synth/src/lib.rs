//! Synthesis of the emitted Verilog with open tools: Yosys for resources, nextpnr for the clock.
//!
//! Two runs make a report, because one cannot be honest about both questions:
//!
//! * **resources** come from the unit alone, without anything around it;
//! * **Fmax** comes from the unit inside a [`harness`] that registers every input and output. A unit alone meets ports
//!   on both sides, and paths from or to a port do not count as register-to-register paths: it would look faster than
//!   it is.
//!
//! Place and route depends on its seed, so Fmax is the median of several.
//!
//! ```
//! use imogene_contract::{Request, RequestError, Unit};
//! use imogene_rtl::emit::emit;
//! use imogene_synth::{digest, harness};
//!
//! // At a depth word of 16 bits, three flags and three words of 18 bits go into pe1, and one word comes out.
//! let unit = emit(&Request::of(Unit::Pe1, 16))?;
//! let (inputs, outputs) = (3 + 3 * 18, 18);
//! let text = harness::verilog(&unit);
//! assert!(text.contains(&format!("reg  [{}:0] inputs", inputs - 1)));
//! assert!(text.contains(&format!("reg  [{}:0] outputs", outputs - 1)));
//!
//! // Figures are kept by the digest of the Verilog, in which comments do not count.
//! let verilog = unit.bundle();
//! assert_eq!(digest(&format!("// Another header\n{verilog}")), digest(&verilog));
//! assert_ne!(digest(&verilog.replace(" + ", " - ")), digest(&verilog));
//! # Ok::<(), RequestError>(())
//! ```
#![warn(missing_docs)]

pub mod baseline;
mod bench;
mod cache;
mod error;
pub mod fitted;
mod flow;
mod fold;
pub mod harness;
pub mod netlist;
mod nextpnr;
pub mod peer;
pub mod regression;
mod report;
pub mod table;
mod target;
pub mod tools;
mod yosys;

pub use cache::{Cache, digest, kept};
pub use error::SynthError;
pub use flow::{synthesise, synthesise_design};
pub use fold::{FOLDS, Folded, fold};
pub use netlist::{Netlist, cell_models, netlist};
pub use nextpnr::{RouteReport, RoutedClock, parse_report};
pub use report::{CriticalPath, Figures, SeedResult, SynthReport, median};
pub use target::{Family, TIMING_WEIGHT, Target, UnknownTarget};
pub use yosys::{CellCounts, Resources, Statistics, parse_statistics, resources, run as run_yosys};
