//! Hardware at any widths.
//!
//! The widths of rust-hdl's words are constants of the compiler, and a machine that is fitted to a scene may have any of some millions of
//! sets of them. [`emit_machines`] writes a program of a few lines that instantiates the blocks of `imogene-rtl` at the sets that are asked for,
//! has it compiled without optimisation (about a second for a set), runs it, and keeps the Verilog.
#![warn(missing_docs)]

mod cache;
mod compile;
mod error;
mod program;

pub use error::GeneratorError;
use imogene_rtl::emit::Emitted;
use imogene_rtl::emit::machine::MachineRequest;

/// The Verilog of machines, in the order of the requests.
///
/// # Errors
///
/// When the sources or the compiler are missing, the program does not compile, or a request is refused.
pub fn emit_machines(requests: &[MachineRequest]) -> Result<Vec<Emitted>, GeneratorError> {
    let cache = cache::Cache::open()?;
    let mut found: Vec<Option<Emitted>> = requests.iter().map(|r| cache.load(r)).collect();
    let missing: Vec<MachineRequest> = requests
        .iter()
        .zip(&found)
        .filter(|(_, found)| found.is_none())
        .map(|(request, _)| request.clone())
        .collect();
    if !missing.is_empty() {
        let mut made = compile::run(&missing)?.into_iter();
        let places = found.iter_mut().zip(requests);
        for (place, request) in places.filter(|(place, _)| place.is_none()) {
            let answer = made.next().ok_or(GeneratorError::Answer)?;
            let emitted = answer.map_err(GeneratorError::Refused)?;
            cache.store(request, &emitted)?;
            *place = Some(emitted);
        }
    }
    Ok(found.into_iter().flatten().collect())
}

/// The Verilog of one machine.
///
/// # Errors
///
/// As [`emit_machines`].
pub fn emit_machine(request: &MachineRequest) -> Result<Emitted, GeneratorError> {
    let mut emitted = emit_machines(std::slice::from_ref(request))?;
    emitted.pop().ok_or(GeneratorError::Answer)
}
