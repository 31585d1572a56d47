//! Files: what is written appears whole or not at all, alone and in sets; what is read has a limit of size.
//!
//! [`Outputs`] is the one way by which commands write. Every file is filled beside its destination, and all of them
//! are renamed together when the last one is complete. Links are followed, modes are kept, devices and pipes are
//! written to and stay what they are. [`end_process`] clears away what an interrupted process has begun.
//! [`text`] makes the sentences and lines that are written.
//!
//! ```
//! use imogene_files::Outputs;
//!
//! let folder = tempfile::tempdir()?;
//! let [picture, report] = ["picture.png", "report.json"].map(|name| folder.path().join(name));
//!
//! // Dropped before it is finished, a set leaves nothing.
//! let mut set = Outputs::new();
//! set.add_text(&picture, "half a picture")?;
//! drop(set);
//! assert!(!picture.exists());
//!
//! let mut set = Outputs::new();
//! set.add_text(&picture, "a picture")?;
//! set.add_text(&report, "{}")?;
//! assert!(!picture.exists() && !report.exists());
//! set.finish()?;
//! assert_eq!(std::fs::read_to_string(&picture)?, "a picture");
//! assert!(report.exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod litter;
pub mod memory;
mod outputs;
mod read;
mod target;
pub mod text;

pub use litter::{Scratch, end_process, end_process_at_once};
pub use memory::{free_memory, limit_memory, memory_limit};
pub use outputs::{Outputs, WriteError, write_whole};
pub use read::{read, read_text};
pub use target::{Identity, Target, check_folder};
