//! Levels: powers of two of the range that the camera suggests, between which content is looked for.

use std::ops::Range;

/// All of them.
pub(super) const LEVELS: Range<i32> = -24..24;

/// A power of two of the size of a level, exactly.
fn power(level: i32) -> f64 {
    f64::from_bits(((1023 + i64::from(level)) as u64) << 52)
}

/// The depths between a perspective level and the next.
pub(super) fn perspective_shell(level: i32, full: f64) -> [f64; 2] {
    [level, level + 1].map(|level| full * (1.0 - 2.0 * power(-level)))
}

/// The depths between an orthographic level and the next, on the far side.
pub(super) fn orthographic_shell(level: i32, full: f64) -> [f64; 2] {
    let inner = full * power(level);
    [inner, 2.0 * inner]
}

/// Least and greatest level that an object between two depths can have; `None` if it can have none.
pub(crate) fn levels_met(
    [low, high]: [f64; 2],
    full: f64,
    is_perspective: bool,
) -> Option<[i32; 2]> {
    if is_perspective {
        let is_met = |level: &i32| {
            let [near, far] = perspective_shell(*level, full);
            low <= far && high >= near
        };
        return Some([LEVELS.clone().find(is_met)?, LEVELS.clone().rfind(is_met)?]);
    }
    let greatest = low.abs().max(high.abs());
    let is_met = |level: &i32| greatest >= orthographic_shell(*level, full)[0];
    let level = LEVELS.clone().rfind(is_met)? + 1;
    Some([level; 2])
}

/// True if an object that is wholly on the screen and lies between two depths, each of which is at most `spare` beyond
/// it, surely has the level that [`levels_met`] gives.
pub(crate) fn is_level_of(
    level: i32,
    ([low, high], spare): ([f64; 2], f64),
    full: f64,
    is_perspective: bool,
) -> bool {
    if is_perspective {
        let [near, far] = perspective_shell(level, full);
        return near <= low && high <= far;
    }
    let [inner, outer] = orthographic_shell(level - 1, full);
    let greatest = low.abs().max(high.abs());
    inner <= greatest - spare && greatest <= outer
}
