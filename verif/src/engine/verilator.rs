//! The emitted Verilog in Verilator: compiled to a shared library, loaded, and clocked in process.
//!
//! A wrapper module gives the unit's ports the order of the signals, and a small C interface exchanges one `u64` word per port, so that
//! the host needs to know nothing of the C++ that Verilator writes. Libraries are kept by what they depend on; see [`cache_folder`].
//! Only ports are visible, and a register without initial value reads 0, where Icarus Verilog shows it undefined.

pub mod beam;
mod build;
mod shim;

pub use build::{CACHE_VARIABLE, cache_folder};

use crate::signal::Signal;
use crate::subject::{Hardware, Subject};
use crate::tool::ToolError;
use libloading::Library;
use std::ffi::c_void;
use std::path::PathBuf;
use std::sync::Arc;
use thiserror::Error;

/// Why a unit cannot be run in Verilator.
#[derive(Debug, Error)]
pub enum VerilatorError {
    /// A program is missing or refused the design.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// The library cannot be loaded.
    #[error("{}: {source}; remove the file and try again", path.display())]
    Load {
        /// Library.
        path: PathBuf,
        /// What the loader says.
        source: libloading::Error,
    },
}

type Create = unsafe extern "C" fn() -> *mut c_void;
type Destroy = unsafe extern "C" fn(*mut c_void);
type Clock = unsafe extern "C" fn(*mut c_void, *const u64, *mut u64);

/// A compiled design; makes any number of instances.
#[derive(Clone)]
pub struct Model {
    /// Keeps the code loaded that the functions below point into.
    _library: Arc<Library>,
    create: Create,
    destroy: Destroy,
    clock: Clock,
    inputs: Arc<[Signal]>,
    outputs: Arc<[Signal]>,
}

impl Model {
    /// Compiles module `top` of a Verilog text, or takes the library that is kept from before.
    ///
    /// `inputs` and `outputs` are ports of the module by name, each at most 64 bits; the clock is the port `clock`.
    ///
    /// # Errors
    ///
    /// When Verilator or the C++ compiler is missing or refuses the text, or a file cannot be written.
    pub fn compile(
        top: &str,
        text: &str,
        inputs: &[Signal],
        outputs: &[Signal],
    ) -> Result<Model, VerilatorError> {
        let sources = shim::Sources::new(top, text, inputs, outputs);
        let path = build::library(&sources)?;
        let load = |source| VerilatorError::Load {
            path: path.clone(),
            source,
        };
        // SAFETY: the library was compiled from the sources above and keeps their C interface; it runs no code when it is loaded but the
        // constructors of Verilator's run time, which have no precondition.
        unsafe {
            let library = Library::new(&path).map_err(load)?;
            let create = *library.get::<Create>(shim::CREATE).map_err(load)?;
            let destroy = *library.get::<Destroy>(shim::DESTROY).map_err(load)?;
            let clock = *library.get::<Clock>(shim::CLOCK).map_err(load)?;
            Ok(Model {
                _library: Arc::new(library),
                create,
                destroy,
                clock,
                inputs: inputs.into(),
                outputs: outputs.into(),
            })
        }
    }

    /// A fresh instance: registers have their initial values.
    pub fn instance(&self) -> VerilatedUnit {
        VerilatedUnit {
            // SAFETY: the library is loaded as long as `model` lives, which the instance holds.
            state: unsafe { (self.create)() },
            words: vec![0; self.inputs.len()],
            found: vec![0; self.outputs.len()],
            model: self.clone(),
        }
    }
}

/// One instance of a design in Verilator.
pub struct VerilatedUnit {
    state: *mut c_void,
    words: Vec<u64>,
    found: Vec<u64>,
    model: Model,
}

// SAFETY: an instance has a Verilator context of its own and shares nothing that changes with another; it is used by one thread at a time
// because `clock_words` takes it exclusively.
unsafe impl Send for VerilatedUnit {}

impl VerilatedUnit {
    /// One clock on raw words: inputs before the edge, outputs after it, in the order of the signals. An unused high bit of an input must
    /// be 0.
    ///
    /// # Panics
    ///
    /// When a slice has not one word per port.
    pub fn clock_words(&mut self, inputs: &[u64], outputs: &mut [u64]) {
        assert_eq!(inputs.len(), self.model.inputs.len(), "words of the inputs");
        assert_eq!(
            outputs.len(),
            self.model.outputs.len(),
            "words of the outputs"
        );
        // SAFETY: the state is alive, and both slices have the lengths for which the library was compiled.
        unsafe { (self.model.clock)(self.state, inputs.as_ptr(), outputs.as_mut_ptr()) }
    }
}

impl Hardware for VerilatedUnit {
    fn clock(&mut self, inputs: &[i64]) -> Vec<i64> {
        let (mut words, mut found) = (
            std::mem::take(&mut self.words),
            std::mem::take(&mut self.found),
        );
        for ((word, signal), value) in words.iter_mut().zip(&*self.model.inputs).zip(inputs) {
            *word = signal.bits(*value);
        }
        self.clock_words(&words, &mut found);
        let values = self.model.outputs.iter().zip(&found);
        let values = values.map(|(signal, bits)| signal.value(*bits)).collect();
        (self.words, self.found) = (words, found);
        values
    }
}

impl Drop for VerilatedUnit {
    fn drop(&mut self) {
        // SAFETY: the state was made by `create` and is used no more.
        unsafe { (self.model.destroy)(self.state) }
    }
}

/// Puts the emitted Verilog `text` (module `top`) in the place of the subject's hardware.
///
/// # Errors
///
/// As [`Model::compile`].
pub fn verilate(subject: Subject, top: &str, text: &str) -> Result<Subject, VerilatorError> {
    let model = Model::compile(top, text, &subject.inputs, &subject.outputs)?;
    Ok(Subject {
        engine: "verilator",
        hardware: Box::new(move || Box::new(model.instance())),
        ..subject
    })
}
