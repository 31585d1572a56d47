//! Outside programs: where they are, how they are run, and what is kept of their results.
//!
//! ```
//! use imogene_tools::{Kept, Program, ToolError, find, scratch};
//!
//! let folder = scratch()?;
//! let program = Program::new("no-such-program", "its-package");
//! assert_eq!(find(&[folder.path().to_owned()], &[program.name]), None);
//! let wrong = program.run(["--version"], folder.path()).unwrap_err();
//! assert!(wrong.to_string().contains("install the package 'its-package'"));
//!
//! // A result is found by all that it depends on, here a version of the program and its input.
//! let place = |input| Kept::new(Some(folder.path().join("kept")), &["1.0", input]);
//! place("a circuit").store(&42)?;
//! assert_eq!(place("a circuit").load(), Some(42));
//! assert_eq!(place("another circuit").load::<u32>(), None);
//! # Ok::<(), ToolError>(())
//! ```

mod file;
mod find;
mod kept;
mod program;

pub use file::{FileError, read, scratch, write};
pub use find::{
    FOLDER_VARIABLE, find, own_folders, path_folders, search_folders, target_folder, version,
};
pub use kept::{Kept, digest, made};
pub use program::{
    COMPILER, ICARUS, Program, Said, ToolError, VERILATOR, VVP, YOSYS, YOSYS_ABC, call, last_lines,
    yosys,
};
