//! `imogene contract`.

use super::emit_request;
use crate::arguments::Contract;
use crate::failure::Failure;
use crate::output;
use imogene_models::picture::write_whole;
use imogene_package::contract::contract;
use std::io::Write;

/// Prints the contract of a unit, or writes it to a file.
pub fn run(options: &Contract, json: bool) -> Result<(), Failure> {
    let request = emit_request(&options.unit, options.shape)?;
    let contract = contract(&request).map_err(Failure::input)?;
    let text = if json {
        contract.json()
    } else {
        contract.markdown()
    };
    match &options.out {
        Some(path) => {
            write_whole(path, |out| out.write_all(text.as_bytes())).map_err(Failure::input)
        }
        None => {
            output::text(text.trim_end());
            Ok(())
        }
    }
}
