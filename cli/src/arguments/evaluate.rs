//! Arguments of `evaluate`.

use clap::Args;
use std::path::PathBuf;

/// Arguments of `evaluate`.
#[derive(Debug, Args)]
pub struct Evaluate {
    /// Folder for index.html, evaluation.json, evaluation.md and images/; nothing is written without it.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
