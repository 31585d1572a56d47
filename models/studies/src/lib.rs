//! Studies: what a machine costs, how fast it is and how far its pictures are from the truth.
//!
//! ```
//! use imogene_golden::{format::Format, unit::root::Method};
//! use imogene_studies::root_errors::table;
//!
//! let rows = table(&Format::new(20)?);
//! let row = |method| rows.iter().find(|row| row.method == method).ok_or("a row of the table");
//!
//! // The exact root is rounded down: less than one off, a digit in each of its 20 clocks.
//! let exact = row(Method::Restoring)?;
//! assert!(exact.error.max_lsb < 1.0 && exact.cost.latency == 20);
//! // The chord (1 + x) / 2 of the root is farthest off at x = 2, in one clock.
//! let chord = row(Method::Linear { corrections: 0 })?;
//! let most = 100.0 * (1.5 / 2f64.sqrt() - 1.0);
//! assert!((chord.error.max_percent - most).abs() < 0.02 && chord.cost.latency == 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod detail;
pub mod evaluate;
pub mod fit;
pub mod growth_plot;
pub mod kit;
pub mod primitives;
pub mod root_errors;
pub mod shading_trial;
pub mod sweep;
pub mod trade;
pub mod trial;
pub mod zones;

pub use kit::{picture, sheet};
