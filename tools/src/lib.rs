//! Outside programs: where they are, how they are run, and what is kept of their results.

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
