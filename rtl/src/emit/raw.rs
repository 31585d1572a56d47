//! rust-hdl's own text of a unit. It is compared with ours and used for nothing else.

use super::{EmitError, EmitRequest, Task, with_block};
use crate::kernel::{BLOCK_MEMORY, Ports};
use crate::step::Clocked;
use rust_hdl::core::prelude::generate_verilog;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The Verilog that rust-hdl itself prints of a unit; the module of the unit is called `top`, its ports are those of [`emit`](super::emit)
/// in the same order, under rust-hdl's names.
///
/// # Errors
///
/// When a parameter is out of its legal range, rust-hdl's printer stops, which it does with a panic, or the unit has a block memory, which it cannot print.
pub fn raw(request: &EmitRequest) -> Result<String, EmitError> {
    with_block(request, Print)?.map_err(|said| {
        let problem = format!("stops rust-hdl's own printer: {said}");
        EmitError::block(request.unit.name(), &problem)
    })
}

struct Print;

impl Task for Print {
    type Outcome = Result<String, String>;

    fn run<B: Clocked + Ports + Send + 'static>(
        self,
        mut block: B,
    ) -> Result<Self::Outcome, EmitError> {
        block.connect_all();
        let text = catch_unwind(AssertUnwindSafe(|| generate_verilog(&block))).map_err(message);
        Ok(text.and_then(|text| {
            if text.contains(BLOCK_MEMORY) {
                Err("a block memory has no kernel".into())
            } else {
                Ok(text)
            }
        }))
    }
}

/// What a panic said.
fn message(panic: Box<dyn Any + Send>) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    text.unwrap_or("a panic without a message").to_owned()
}
