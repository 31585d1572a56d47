//! Machine code in memory.

use crate::assemble::Assembler;
use crate::functions::{Function, TASKS};
use crate::interpret::Work;
use crate::lanes::MOST_LANES;
use crate::registers::{self, Constants};
use crate::words::Words;
use memmap2::{Mmap, MmapMut};

/// The block of an instance, spilled vectors, words that are given, constants, the inputs of each lane.
#[cfg(target_arch = "x86_64")]
type Entry = unsafe extern "sysv64" fn(*mut u64, *mut u64, *mut u64, *const u64, *const *const i64);

pub(crate) struct Machine {
    pub(crate) code: Mmap,
    /// Where the functions begin.
    begins: Vec<usize>,
    /// The functions from this one on read the inputs of the whole.
    tasks: usize,
    constants: Words,
    /// Vectors that must be there for what is spilled.
    pub(crate) spilled: usize,
}

impl Machine {
    /// Nothing where the processor has no AVX2. Of the functions the last ones are called from outside, from one on.
    pub(crate) fn of(functions: &[Function], outer: usize, rows: usize) -> Option<Machine> {
        if !has_vectors() {
            return None;
        }
        let (mut begins, mut constants, mut spilled) = (vec![], Constants::default(), 0);
        let mut bytes = vec![];
        for (index, function) in functions.iter().enumerate() {
            let mut to = Assembler {
                bytes,
                lanes: function.lanes,
                has_masks: has_masks(),
                rows: usize::from(function.line.reads_inputs()) * rows,
            };
            let begin = to.bytes.len();
            to.begin();
            let more = registers::write(&function.line, &mut to, &mut constants, &begins);
            spilled = spilled.max(more);
            to.end(index >= outer);
            bytes = to.bytes;
            begins.push(begin);
        }
        let mut code = MmapMut::map_anon(bytes.len()).ok()?;
        code.copy_from_slice(&bytes);
        let constants = constants.words.as_flattened();
        let mut words = Words::new(constants.len());
        words.copy_from_slice(constants);
        Some(Machine {
            tasks: begins.len() - TASKS,
            begins,
            code: code.make_exec().ok()?,
            constants: words,
            spilled,
        })
    }

    /// Runs a function that may be called from outside; words, spilled vectors, inputs and what is given are as many as
    /// it was written for.
    #[cfg(target_arch = "x86_64")]
    pub(crate) fn run(&self, function: usize, work: &mut Work<'_>, spilled: &mut [u64]) {
        let mut rows = [std::ptr::null(); MOST_LANES];
        if function >= self.tasks {
            for (place, row) in rows.iter_mut().zip(work.rows) {
                *place = row.as_ptr();
            }
        }
        let begin = self.code[self.begins[function]..].as_ptr();
        // SAFETY: a function with this signature begins there.
        let entry = unsafe { std::mem::transmute::<*const u8, Entry>(begin) };
        // SAFETY: it stays within the slices: places come from the layout that they were made for, and an index of a
        // memory from a selection that bounds it.
        unsafe {
            entry(
                work.words.as_mut_ptr(),
                spilled.as_mut_ptr(),
                work.given.as_mut_ptr(),
                self.constants.as_ptr(),
                rows.as_ptr(),
            );
        }
    }

    #[cfg(not(target_arch = "x86_64"))]
    pub(crate) fn run(&self, _: usize, _: &mut Work<'_>, _: &mut [u64]) {
        unreachable!("there is no machine code for this processor");
    }
}

/// Has the processor AVX2?
fn has_vectors() -> bool {
    #[cfg(target_arch = "x86_64")]
    let has_vectors = std::arch::is_x86_feature_detected!("avx2");
    #[cfg(not(target_arch = "x86_64"))]
    let has_vectors = false;
    has_vectors
}

/// Has it the masks of AVX-512?
fn has_masks() -> bool {
    #[cfg(target_arch = "x86_64")]
    let has_masks = std::arch::is_x86_feature_detected!("avx512vl")
        && std::arch::is_x86_feature_detected!("avx512dq");
    #[cfg(not(target_arch = "x86_64"))]
    let has_masks = false;
    has_masks
}
