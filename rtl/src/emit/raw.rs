//! rust-hdl's own text of a unit. It is compared with ours and used for nothing else.

use super::design;
use imogene_contract::{Request, RequestError};
use imogene_hdl::block::Block;
use rust_hdl::core::prelude::generate_verilog;

/// The Verilog that rust-hdl itself prints of a unit; the module of the unit is called `top`, its ports are those of
/// [`emit`](super::emit).
///
/// # Errors
///
/// When a parameter is out of its legal range.
pub fn raw(request: &Request) -> Result<String, RequestError> {
    Ok(generate_verilog(&Block::of(&design(request)?.top)))
}
