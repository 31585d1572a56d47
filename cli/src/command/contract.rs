//! `imogene contract`.

use crate::arguments::Contract;
use crate::failure::Failure;
use crate::output;
use imogene_package::contract::contract;

/// Prints the contract of a unit, or writes it to a file.
pub fn run(options: &Contract, json: bool) -> Result<(), Failure> {
    let request = options.shape.request(&options.unit)?;
    let contract = contract(&request)?;
    let text = if json {
        contract.json()
    } else {
        contract.markdown()
    };
    match &options.out {
        Some(path) => output::write_text(path, &text),
        None => {
            output::text(text.trim_end());
            Ok(())
        }
    }
}
