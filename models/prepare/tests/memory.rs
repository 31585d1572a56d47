//! The memory that a preparation is said to take, held against what it takes: never less, and not much more.

#[path = "../examples/phases/molecule.rs"]
mod molecule;

use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_prepare::{Seen, memory, prepare};
use imogene_scene::SceneFile;
use std::alloc::{GlobalAlloc, Layout, System};
use std::hint::black_box;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Counts the bytes that are taken, and the most that ever were.
struct Counting;

static TAKEN: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);
/// One measurement at a time.
static ALONE: Mutex<()> = Mutex::new(());

/// What the system's allocator takes for it: a word more, in steps of two.
fn room(layout: Layout) -> usize {
    (layout.size() + 8).next_multiple_of(16).max(32)
}

// SAFETY: every call is handed on to the system's allocator as it is.
#[expect(
    clippy::undocumented_unsafe_blocks,
    reason = "said of all of them above"
)]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let size = room(layout);
        let taken = TAKEN.fetch_add(size, Ordering::Relaxed) + size;
        MOST.fetch_max(taken, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        TAKEN.fetch_sub(room(layout), Ordering::Relaxed);
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// Most bytes that a work takes beside what is taken before.
fn most(work: impl FnOnce()) -> u64 {
    let before = TAKEN.load(Ordering::Relaxed);
    MOST.store(before, Ordering::Relaxed);
    work();
    (MOST.load(Ordering::Relaxed) - before) as u64
}

const VIEWS: [[f64; 3]; 2] = [[0.0, 0.0, 1.0], [0.617, 0.523, 1.271]];

/// The memory beside the constant part, stated and taken.
fn assert_estimate(what: &str, stated: u64, taken: u64, base: u64) {
    println!("{what}: stated {stated}, taken {taken}");
    let rest = 16 << 20;
    assert!(
        stated - base >= taken,
        "{what}: stated {stated}, taken {taken}"
    );
    assert!(
        stated - rest <= 2 * taken,
        "{what}: stated {stated}, taken {taken}"
    );
}

fn whole(scene: &SceneFile) -> u64 {
    most(|| {
        let framed = scene.frame(1920, 1080).expect("valid");
        let prepared = prepare(&framed, Format::BASE).expect("fits");
        black_box((prepared.slots(), &prepared, &framed));
    })
}

#[test]
fn the_memory_of_a_whole_scene_is_known_before() {
    let _alone = ALONE
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner());
    for towards in VIEWS {
        for sticks in [false, true] {
            let scene = molecule::scene(if sticks { 1000 } else { 3000 }, sticks, towards);
            let what = format!("sticks {sticks}, towards {towards:?}");
            assert_estimate(&what, memory::of_scene(&scene), whole(&scene), 16 << 20);
        }
    }
}

#[test]
fn the_memory_of_what_is_seen_is_known_before() {
    let _alone = ALONE
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner());
    for towards in VIEWS {
        let scene = molecule::scene(30_000, false, towards);
        let mut stated = 0;
        let taken = most(|| {
            let seen = Seen::of(&scene, (1920, 1080), &Format::BASE, &|| ()).expect("valid");
            stated = seen.memory();
            let framed = seen.frame(&|| ()).expect("valid");
            let prepared = prepare(&framed, Format::BASE).expect("fits");
            black_box((prepared.slots(), &prepared, &framed));
        });
        // The depth buffer is part of the rest.
        assert_estimate(&format!("seen, towards {towards:?}"), stated, taken, 0);
        assert!(stated < memory::of_scene(&scene) / 2);
    }
}
