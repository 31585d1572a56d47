//! Co-simulation of the imogene hardware against its golden model.
//!
//! The only place where `rtl` and `models` meet. A [`subject::Subject`] puts a unit's hardware and golden model side by
//! side and compares every output on every clock; [`unit`](mod@unit) has one for each unit, [`scene`] does the same for
//! a whole machine drawing a scene. [`waveform`] writes the waveforms of both. The hardware runs in an [`engine`];
//! [`mutation`] measures what the stimuli notice; [`equivalence`] proves two texts the same circuit.
//!
//! ```
//! use imogene_contract::{Request, RequestError, Unit};
//! use imogene_verif::unit::subject;
//!
//! let mut subject = subject(&Request::of(Unit::Pe1, 16))?;
//! let stimulus = subject.seeded_stimulus(1000, 1);
//! let (report, _) = subject.run(&stimulus, false);
//! assert_eq!(report.mismatches, 0);
//! assert!(report.cycles >= 1000 && report.passed());
//!
//! // A golden model that always says zero is found out.
//! subject.golden = Box::new(|| Box::new(|_: &[i64]| vec![Some(0)]));
//! let (report, _) = subject.run(&stimulus, false);
//! assert!(report.mismatches > 0 && report.first_mismatches[0].signal == "value");
//! # Ok::<(), RequestError>(())
//! ```

pub mod bench;
pub mod display;
pub mod engine;
pub mod equivalence;
pub mod extremes;
pub mod formal;
pub mod mutation;
pub mod random;
pub mod report;
pub mod scene;
pub mod signal;
pub mod stimulus;
pub mod subject;
pub mod unit;
pub mod waveform;
