//! Options of `import` for molecules.

use clap::Args;

/// Options of molecules.
#[derive(Clone, Debug, Args)]
pub struct MoleculeOptions {}
