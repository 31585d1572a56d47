//! What is said of a work that takes long.

use std::time::Duration;

/// How far a work is, `done` of `length` steps, and how long it will still take if it goes on as it did; the length is
/// 0 where it is not known.
pub fn line(what: &str, done: u64, length: u64, taken: Duration) -> String {
    if length == 0 {
        return format!("{what}: {done}");
    }
    let percent = 100 * done.min(length) / length;
    if done == 0 {
        return format!("{what}: {percent} %");
    }
    let left = taken.as_secs_f64() * length.saturating_sub(done) as f64 / done as f64;
    format!("{what}: {percent} %, {left:.0} s left")
}
