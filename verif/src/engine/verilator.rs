//! The emitted Verilog in Verilator: compiled to a shared library, loaded, and clocked in process.
//!
//! A wrapper module gives the unit's ports the order of the signals, and a small C interface exchanges one `u64` word
//! per port, so that the host needs to know nothing of the C++ that Verilator writes. Libraries are kept by what they
//! depend on; see [`cache_folder`]. Only ports are visible, and a register without initial value reads 0, where Icarus
//! Verilog shows it undefined.

mod build;

pub use build::{CACHE_VARIABLE, cache_folder};

use super::design::{Design, DesignError, Instance, Source};
use build::{CLOCK, CREATE, DESTROY};
use libloading::Library;
use std::ffi::c_void;
use std::sync::Arc;

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
    inputs: usize,
    outputs: usize,
}

impl Model {
    /// Compiles a design with more options of Verilator and of the C++ compiler, or takes the library that is kept.
    pub fn compile(source: &Source, options: [&str; 2]) -> Result<Model, DesignError> {
        let path = build::library(source, options)?;
        let load = |source| DesignError::Load {
            path: path.clone(),
            source,
        };
        // SAFETY: the library was compiled from this source and keeps their C interface; it runs no code when it
        // is loaded but the constructors of Verilator's run time, which have no precondition.
        unsafe {
            let library = Library::new(&path).map_err(load)?;
            let create = *library.get::<Create>(CREATE).map_err(load)?;
            let destroy = *library.get::<Destroy>(DESTROY).map_err(load)?;
            let clock = *library.get::<Clock>(CLOCK).map_err(load)?;
            Ok(Model {
                _library: Arc::new(library),
                create,
                destroy,
                clock,
                inputs: source.inputs.len(),
                outputs: source.outputs.len(),
            })
        }
    }

    /// Instances of it.
    pub fn design(self) -> Design {
        Box::new(move || Box::new(self.instance()))
    }

    /// A fresh instance: registers have their initial values.
    pub fn instance(&self) -> VerilatedUnit {
        VerilatedUnit {
            // SAFETY: the library is loaded as long as `model` lives, which the instance holds.
            state: unsafe { (self.create)() },
            found: vec![0; self.outputs],
            model: self.clone(),
        }
    }
}

/// One instance of a design in Verilator.
pub struct VerilatedUnit {
    state: *mut c_void,
    found: Vec<u64>,
    model: Model,
}

// SAFETY: an instance has a Verilator context of its own and shares nothing that changes with another; it is used by
// one thread at a time because `clock_words` takes it exclusively.
unsafe impl Send for VerilatedUnit {}

impl VerilatedUnit {
    /// One clock on raw words: inputs before the edge, outputs after it, in the order of the signals. An unused high
    /// bit of an input must be 0. Panics when a slice has not one word per port.
    pub fn clock_words(&mut self, inputs: &[u64], outputs: &mut [u64]) {
        assert_eq!(inputs.len(), self.model.inputs, "words of the inputs");
        assert_eq!(outputs.len(), self.model.outputs, "words of the outputs");
        // SAFETY: the state is alive, and both slices have the lengths for which the library was compiled.
        unsafe { (self.model.clock)(self.state, inputs.as_ptr(), outputs.as_mut_ptr()) }
    }
}

impl Instance for VerilatedUnit {
    fn clock(&mut self, inputs: &[u64], outputs: &mut [Option<u64>]) {
        let mut found = std::mem::take(&mut self.found);
        self.clock_words(inputs, &mut found);
        for (place, word) in outputs.iter_mut().zip(&found) {
            *place = Some(*word);
        }
        self.found = found;
    }
}

impl Drop for VerilatedUnit {
    fn drop(&mut self) {
        // SAFETY: the state was made by `create` and is used no more.
        unsafe { (self.model.destroy)(self.state) }
    }
}
