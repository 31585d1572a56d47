//! The main circuits of imogene as plain kernels of rust-hdl, with its own derive, `Bits`, `Signed` and `DFF`.
//!
//! They are an example for those who know rust-hdl, and a witness: rust-hdl's own simulation and printer run on them,
//! and no code of ours. `rtl/circuits` has the same circuits as functions, with widths known when they are built;
//! `docs/kernels.md` says how both are proven the same. Rules that keep the Verilog what the simulation is: one
//! arithmetic operation a signal, constants of the exact width, no comparison of a sum, mixed operators in parentheses.
//!
//! ```
//! let verilog = imogene_kernels::verilog(&mut imogene_kernels::Pe1::<16>::default());
//! assert!(verilog.contains("input wire signed [15:0] a;"));
//! // Registers: the first pixel of the next line, and the pixel.
//! assert_eq!(verilog.matches("posedge clock").count(), 2);
//! ```

mod cut_plane;
mod decider;
mod pe1;
mod pe2;
mod square_root;
mod visibility_node;

pub use cut_plane::CutPlane;
pub use decider::Decider;
pub use pe1::Pe1;
pub use pe2::Pe2;
pub use square_root::{SquareRoot, SquareRootRow, SquareRootStage};
pub use visibility_node::{Candidate, Nearest, VisibilityNode};

use rust_hdl::core::prelude::{Block, generate_verilog};

/// What rust-hdl prints of a kernel, as module `top`. Ports are called as in `rtl/circuits`: `_` stands for its `$`,
/// and outputs have no name together.
///
/// # Panics
///
/// With what rust-hdl's check found: a signal that is not driven, or a loop.
pub fn verilog<K: Block>(kernel: &mut K) -> String {
    kernel.connect_all();
    generate_verilog(kernel)
        .replace('$', "_")
        .replace("nearest_", "")
}
