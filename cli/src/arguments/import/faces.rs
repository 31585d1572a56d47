//! Options of `import` for face lists.

use clap::Args;

/// Options of face lists.
#[derive(Clone, Debug, Args)]
pub struct FaceOptions {}
