//! Every cost table of the source counted again, beside the printed value (source: Nyiri, chapter 5; Chaillou, chapter
//! IV).
//!
//! The rows stand in `evaluation.toml`: what is printed, and of which counts ours is made. No figure of ours is typed
//! in. Operations are counted by running the algorithms in numbers that count ([`count`], [`work`]); words, beats and
//! clocks are those of the golden machines; parts of processors come from the hierarchy that is emitted and are handed
//! in as [`Hardware`]; cells and clock rates come from the table of resources.

pub mod count;
pub mod duplication;
pub mod figures;
mod hardware;
mod page;
mod plot;
pub mod row;
pub mod scenes;
pub mod steps;
mod table;
pub mod work;

pub use hardware::{Hardware, MACHINE_PROCESSORS, Parts};
pub use page::{markdown, page};
pub use plot::{duplication_plot, operations_plot};
pub use row::{Evaluation, Group, Omitted, Printed, Row};
pub use scenes::zone_machine;
pub use table::evaluate;

/// Why there is no evaluation: a defect of this workspace, since nothing is given that could be wrong.
pub type EvaluateError = Box<dyn std::error::Error + Send + Sync>;
