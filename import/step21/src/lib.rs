//! The exchange structure of STEP files (ISO 10303-21): entities and their parameters, whatever they mean.
//!
//! A file is read as a whole. Its entities are asked for by their numbers or names, and their parameters by place and
//! kind; what is not as asked for is an [`Error`] with line and column.
//!
//! ```
//! let file = b"ISO-10303-21; HEADER; ENDSEC; DATA;
//!     #1 = DIRECTION('up', (0., 0., 1.)); #2 = AXIS1_PLACEMENT('', $, #1);
//!     ENDSEC; END-ISO-10303-21;";
//! let file = step21::Exchange::parse(file)?;
//! for axis in file.all(&["AXIS1_PLACEMENT"]) {
//!     let direction = axis.named(2, &["DIRECTION"])?;
//!     assert_eq!(direction.numbers(1)?, [0.0, 0.0, 1.0]);
//!     assert!(axis.maybe(1)?.is_none());
//! }
//! let wrong = file.get(1).unwrap().need(&["DIRECTION"])?.number(0).unwrap_err();
//! assert_eq!(wrong.to_string(), "2:20: `#1` DIRECTION: parameter 1 is a string; a number is needed");
//! # Ok::<(), step21::Error>(())
//! ```

mod args;
mod error;
mod parser;
mod text;
mod token;
mod value;

pub use args::{Args, Entity};
pub use error::{Error, Place, Result};
pub use parser::Exchange;
pub use text::{decoded, with_article};
pub use value::{Instance, Kind, Record, Value};
