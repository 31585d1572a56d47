//! What the language's run time does not tell of a process: that standard output was closed before it began, and that
//! memory has ended.

use imogene_files::end_process_at_once;
use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};

static CLOSED: AtomicBool = AtomicBool::new(false);
static ENDING: AtomicBool = AtomicBool::new(false);

/// The caller closed standard output (`>&-`).
pub fn was_standard_output_closed() -> bool {
    CLOSED.load(Ordering::Relaxed)
}

// Run before the run time, which opens /dev/null in the place of what is closed.
#[cfg(target_os = "linux")]
#[used]
#[unsafe(link_section = ".init_array")]
static NOTE_CLOSED: extern "C" fn() = note_closed;

#[cfg(target_os = "linux")]
extern "C" fn note_closed() {
    // SAFETY: asking for the flags of a number that may be no open file changes nothing.
    let flags = unsafe { libc::fcntl(1, libc::F_GETFD) };
    CLOSED.store(flags == -1, Ordering::Relaxed);
}

/// The system's allocator; where it has nothing left, the process ends with a message and exit code 2 instead of an
/// abort.
struct Telling;

#[global_allocator]
static ALLOCATOR: Telling = Telling;

// SAFETY: every call goes to the system's allocator as it is, and what it returns is returned unless it is null.
#[expect(
    clippy::undocumented_unsafe_blocks,
    reason = "said of all of them above"
)]
unsafe impl GlobalAlloc for Telling {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        there(unsafe { System.alloc(layout) })
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        unsafe { System.dealloc(memory, layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        there(unsafe { System.alloc_zeroed(layout) })
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        there(unsafe { System.realloc(memory, layout, size) })
    }
}

fn there(memory: *mut u8) -> *mut u8 {
    if memory.is_null() {
        out_of_memory();
    }
    memory
}

#[cold]
fn out_of_memory() -> ! {
    // The message takes a little memory itself; if not even that is there, nothing can be said.
    if ENDING.swap(true, Ordering::Relaxed) {
        std::process::abort();
    }
    let _ = writeln!(
        std::io::stderr(),
        "error: the memory has ended; a scene of fewer objects, a smaller picture or a machine of more memory is needed"
    );
    end_process_at_once(2)
}
