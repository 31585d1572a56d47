//! What hardware and golden models share: names, widths, addresses and the record of every unit, and no behaviour.
//!
//! ```
//! use imogene_contract::{Request, Unit};
//!
//! // A root of 24 digits, four rows of the network between registers.
//! let request = Request { rows_per_stage: 4, ..Request::of(Unit::SquareRoot, 24) };
//! assert_eq!(request.unit.record().latency, "ceil(W / R)");
//! assert_eq!(request.latency(), 24 / 4);
//! assert_eq!(request.command(), "imogene emit square_root --format 24 --rows-per-stage 4 --out DIR");
//!
//! // There cannot be more rows than digits.
//! let wrong = Request::given("square_root", 24, &[("rows-per-stage", Some(25))]).unwrap_err();
//! assert_eq!(wrong.to_string(), "rows-per-stage = 25 is out of range; legal values are 1 to 24");
//! ```

mod catalogue;
pub mod command_stream;
mod decider_form;
pub mod formula;
mod machine_words;
pub mod object;
pub mod parameters;
mod record;
pub mod request;
mod root_form;
pub mod shading;
pub mod slots;
pub mod tile;
pub mod unit;
pub mod video;
pub mod volume;
pub mod words;

pub use decider_form::{DeciderForm, DeciderFormError};
pub use machine_words::MachineWords;
pub use record::Record;
pub use request::{Request, RequestError};
pub use root_form::{RootForm, RootFormError};
pub use unit::Unit;
