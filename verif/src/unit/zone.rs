//! What all object processors have in common: words held over a zone, a golden processor that runs over it, results a
//! fixed time later.

use super::description::{Description, behind_valid, late, scan};
use super::words::Ports;
use crate::signal::Delay;
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use proptest::prelude::*;

/// Ports before the first word: the flags, then the column and the line.
pub(super) const WORDS: usize = 5;

/// A processor with `N` outputs behind `out_valid`, `latency` clocks after the flags. `read` reads the words of a zone
/// from the ports over `words` of the same shape; `pixel` gives the outputs at a pixel of the zone, from what the ports
/// show `entry` clocks after the flags.
pub(super) fn zone<W: Clone + Send + Sync + 'static, const N: usize>(
    stimulus: impl Fn(&Subject, usize) -> BoxedStrategy<Vec<Inputs>> + Sync + 'static,
    format: Format,
    [entry, latency]: [u32; 2],
    words: W,
    read: fn(&mut Ports, &mut W),
    pixel: fn(&W, [i64; 2], &Format, &[i64]) -> [i64; N],
) -> Description {
    Description::new(stimulus, move || {
        let mut words = words.clone();
        let mut entered = Delay::new(entry as usize);
        let mut late = late((latency - entry) as usize);
        let mut zone = None;
        move |i: &[i64]| {
            let Some(raster) = entered.push([i[0], i[1], i[2], i[3], i[4]]) else {
                return behind_valid::<N>(None);
            };
            let [flags @ .., x, y] = raster;
            let start = || {
                let mut ports = Ports::of(Some(&i[WORDS..]), &format);
                ports.origin = [x, y];
                read(&mut ports, &mut words);
                (words.clone(), [0; 2])
            };
            let line_step = |(_, at): &mut (W, [i64; 2])| *at = [0, at[1] + 1];
            let seen = scan(&mut zone, &flags, start, line_step).map(|(words, at)| {
                let outputs = pixel(words, *at, &format, i);
                at[0] += 1;
                outputs
            });
            behind_valid(late.push(seen))
        }
    })
}
