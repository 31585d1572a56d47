//! Designs and Verilog of units and machines.
//!
//! [`design`](emit::design) builds a unit, [`emit`](emit::emit) writes its Verilog. What units and machines are is in
//! `imogene-circuits`, what is stated of them in `imogene-contract`.
//!
//! ```
//! use imogene_contract::{Request, RequestError, Unit};
//! use imogene_rtl::emit::{emit, emit_with_prefix};
//!
//! // A depth sum has two bits more than the depth word.
//! let request = Request::of(Unit::Pe1, 16);
//! let text = emit(&request)?.bundle();
//! assert!(text.contains("module pe1 (") && text.contains("[17:0] value"));
//! // Plain Verilog: no system function, no directive.
//! assert!(!text.contains(['$', '`']));
//!
//! // Several configurations fit in one design under names of their own.
//! let own = emit_with_prefix(&request, "short_")?;
//! assert_eq!(own.top, "short_pe1");
//! # Ok::<(), RequestError>(())
//! ```

pub mod emit;
