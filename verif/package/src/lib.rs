//! Units as IP cores: the contract of each, and a folder with Verilog, contract, bench and FuseSoC core file.
//!
//! [`contract`] is the one source of what a unit promises; Markdown and JSON are two forms of it. [`core`] makes the
//! files of a package; [`census`] counts what a unit is made of; [`processors`] puts the object processors beside their
//! sources.
//!
//! ```
//! use imogene_contract::{Request, RequestError, Unit};
//! use imogene_package::{contract::contract, core::core};
//!
//! // At a depth word of 16 bits, pe1 gives a word of two bits more; each of its ports has a row on the page.
//! let contract = contract(&Request::of(Unit::Pe1, 16))?;
//! let page = contract.markdown();
//! for name in ["clock", "valid", "start", "line", "a", "b", "c", "value"] {
//!     assert!(page.contains(&format!("\n| `{name}` | ")));
//! }
//! assert!(page.contains("| `value` | output | 18 | `W + 2` | two's complement |"));
//!
//! // The core has it beside the Verilog.
//! let files: Vec<String> = core(Unit::Pe1, 0)?.into_iter().map(|(path, _)| path).collect();
//! assert_eq!(files, ["pe1.core", "CONTRACT.md", "contract.json", "rtl/pe1.v"]);
//! # Ok::<(), RequestError>(())
//! ```

pub mod census;
pub mod contract;
pub mod core;
pub mod processors;
