//! Stimuli of a zone: a raster anywhere on the screen, and words that are likely to decide something on it.

use super::description::WORDS;
use crate::signal::Signal;
use crate::stimulus::{mapped, word};
use crate::subject::{Inputs, Stimuli, Subject};
use imogene_contract::words::far_end;
use proptest::prelude::*;

/// One zone of random width, anywhere on the screen, with one set of words on the ports from [`WORDS`] on; every
/// eleventh clock is a gap, in which the raster stands still. Screen boxes are drawn in pixels of the zone.
pub(super) fn held(ports: &[Signal], words: BoxedStrategy<Inputs>, clocks: usize) -> Stimuli {
    let names = ports[WORDS..].iter().map(|port| port.name.as_str());
    let axis = names.map(|name| match name {
        "box_x0" | "box_x1" => Some(0),
        "box_y0" | "box_y1" => Some(1),
        _ => None,
    });
    let axis: Vec<Option<usize>> = axis.collect();
    // A first line of one pixel: a step that is late by a clock shows.
    let is_short = prop_oneof![3 => Just(false), 1 => Just(true)];
    mapped(
        (words, 1i64..24, is_short, [first_pixel(), first_pixel()]),
        move |(mut words, width, is_short, origin)| {
            let before = if is_short { width - 1 } else { 0 };
            for (word, axis) in words.iter_mut().zip(&axis) {
                *word = axis.map_or(*word, |axis| (*word + origin[axis]).min(LAST_PIXEL));
            }
            let clock = |n: i64| {
                let pixel = n - n / 11;
                // The pixels that the first line does not have.
                let place = if pixel == 0 { 0 } else { pixel + before };
                let (x, y) = (place % width, place / width);
                let flags = match n % 11 {
                    10 => [0; 3],
                    _ => [true, pixel == 0, x == 0 && y > 0].map(i64::from),
                };
                let at = [x + origin[0], (y + origin[1]) & LAST_PIXEL];
                let raster = flags.into_iter().chain(at);
                raster.chain(words.iter().copied()).collect()
            };
            (0..clocks as i64).map(clock).collect()
        },
    )
}

/// The last column, or line, that there can be.
const LAST_PIXEL: i64 = 0xfff;

/// The first column, or line, of a zone: often 0, or just before a power of two.
fn first_pixel() -> BoxedStrategy<i64> {
    let before_power = (3i64..12).prop_map(|bit| (1 << bit) - 4);
    prop_oneof![2 => Just(0), 1 => before_power, 1 => 0i64..4_000].boxed()
}

/// What the words of a port are likely to be on a zone of a few pixels, so that signs change and depths meet on it.
#[derive(Clone, Copy)]
pub(super) enum Likely {
    /// A polynomial of first degree, a depth in units of `2^-guard`, now and then at an end; any normal with it.
    Depth(u32),
    /// The same of second degree, in units of `2^-(W - 2)`.
    Bulge,
    /// A polynomial of first degree of which the sign counts.
    Line,
    /// The same of second degree.
    Conic,
    /// A number from 0 to this one.
    UpTo(i64),
    Any,
}

/// Words of a zone. Those of a polynomial, or of a box, are drawn together, apart from all others: most often what the
/// first entry of `plan` whose prefix they have makes likely, often of any size, often so that they decide nothing and
/// the others can be seen, now and then of full range. Now and then all are small, so that many values are equal.
pub(super) fn words(
    ports: &[Signal],
    depth_word: u32,
    plan: &[(&str, Likely)],
) -> BoxedStrategy<Inputs> {
    let ports = &ports[WORDS..];
    let groups = |of: fn(&[Signal], Likely, u32) -> BoxedStrategy<Inputs>| {
        let groups = ports.chunk_by(|a, b| owner(a) == owner(b)).map(|ports| {
            let mut plan = plan.iter();
            let entry = plan.find(|(prefix, _)| ports[0].name.starts_with(prefix));
            let likely = entry.map_or(Likely::Any, |(_, likely)| *likely);
            of(ports, likely, depth_word)
        });
        let groups: Vec<_> = groups.collect();
        groups.prop_map(|words| words.concat())
    };
    let words = prop_oneof![4 => groups(group), 1 => groups(small)];
    even_differences(ports, words.boxed())
}

/// The name of a port without its last part.
fn owner(port: &Signal) -> &str {
    let parts = port.name.rsplit_once('_');
    parts.map_or(&port.name, |(owner, _)| owner)
}

/// The last part of the name of a port.
fn part(port: &Signal) -> &str {
    port.name.rsplit('_').next().unwrap_or_default()
}

/// A polynomial whose values are a few units about 0, or a depth about an end.
fn small(ports: &[Signal], likely: Likely, depth_word: u32) -> BoxedStrategy<Inputs> {
    let unit = match likely {
        Likely::Depth(guard) => guard,
        Likely::Bulge => depth_word - 2,
        _ => 0,
    };
    let is_quadratic = is_quadratic(ports);
    let far = far_end(depth_word);
    let each = ports.iter().map(|port| match part(port) {
        "c" if is_quadratic => spread(2, unit),
        "a" | "b" | "a2" | "b2" | "i0" | "p0" => spread(2, unit),
        "c" | "f" if unit > 0 || matches!(likely, Likely::Depth(_)) => near_an_end(8, far, unit),
        "c" | "f" => spread(8, unit),
        "margin" => (0i64..20).boxed(),
        // Front and back are then about the two ends.
        "sum" => (-20i64..20).boxed(),
        _ => one(port, likely, depth_word),
    });
    each.collect::<Vec<_>>().boxed()
}

/// Are these the words of a polynomial of second degree?
fn is_quadratic(ports: &[Signal]) -> bool {
    ports.iter().any(|port| part(port) == "f")
}

/// The words of one polynomial, or of what else stands together.
fn group(ports: &[Signal], likely: Likely, depth_word: u32) -> BoxedStrategy<Inputs> {
    let likely_words = ports.iter().map(|port| one(port, likely, depth_word));
    let likely_words: Vec<_> = likely_words.collect();
    let any_words: Vec<_> = ports.iter().map(word).collect();
    prop_oneof![
        4 => likely_words,
        3 => sized(ports),
        2 => idle(ports, likely, depth_word),
        1 => any_words,
    ]
    .boxed()
}

/// A polynomial of any size whose values change within a few pixels: a word is the longer the less it is added.
fn sized(ports: &[Signal]) -> BoxedStrategy<Inputs> {
    let is_quadratic = is_quadratic(ports);
    let bits = |port: &Signal| match (part(port), is_quadratic) {
        ("f", _) => Some(8),
        ("i0" | "p0", _) | ("c", false) => Some(4),
        ("a" | "b" | "a2" | "b2" | "c", _) => Some(0),
        _ => None,
    };
    let words = ports.iter().map(|port| (word(port), any::<i64>()));
    let words: Vec<_> = words.collect();
    let ports = ports.iter().map(|port| (port.clone(), bits(port)));
    let ports: Vec<_> = ports.collect();
    mapped((1u32..64, words), move |(size, words)| {
        let each = ports.iter().zip(words);
        let each = each.map(|((port, bits), (other, drawn))| match bits {
            Some(bits) => port.value((drawn >> (64 - (size + bits).min(port.width))) as u64),
            None => other,
        });
        each.collect()
    })
}

/// A polynomial that is the same everywhere, positive where its sign counts; a box around all.
fn idle(ports: &[Signal], likely: Likely, depth_word: u32) -> BoxedStrategy<Inputs> {
    let is_quadratic = is_quadratic(ports);
    let each = ports.iter().map(|port| match (part(port), likely) {
        ("a" | "b" | "a2" | "b2" | "i0" | "p0" | "x0" | "y0", _) => Just(0).boxed(),
        ("x1" | "y1", _) => Just(LAST_PIXEL).boxed(),
        ("c", _) if is_quadratic => Just(0).boxed(),
        ("c" | "f", Likely::Line | Likely::Conic) => Just(1 << (port.width - 3)).boxed(),
        _ => one(port, likely, depth_word),
    });
    each.collect::<Vec<_>>().boxed()
}

/// The same words, second differences even: they are twice a coefficient.
pub(super) fn even_differences(
    ports: &[Signal],
    words: BoxedStrategy<Inputs>,
) -> BoxedStrategy<Inputs> {
    let is_second = |port: &Signal| port.name.ends_with("_a2") || port.name.ends_with("_b2");
    let masks = ports.iter().map(|port| !i64::from(is_second(port)));
    let masks: Vec<i64> = masks.collect();
    let masked = move |mut words: Inputs| {
        let each = words.iter_mut().zip(&masks);
        each.for_each(|(word, mask)| *word &= mask);
        words
    };
    words.prop_map(masked).boxed()
}

/// One zone with words that `plan` makes likely ([`words`], [`held`]); kinds of planes are drawn evenly.
pub(super) fn planned(
    plan: &'static [(&str, Likely)],
) -> impl Fn(&Subject, usize) -> Stimuli + Sync + 'static {
    move |subject, clocks| {
        let words = words(&subject.inputs, subject.outputs[1].width, plan);
        held(&subject.inputs, planes_any_kind(words, subject), clocks)
    }
}

/// The same words, the kinds of all planes drawn evenly.
pub(super) fn planes_any_kind(
    words: BoxedStrategy<Inputs>,
    subject: &Subject,
) -> BoxedStrategy<Inputs> {
    let ports = subject.inputs[WORDS..].iter().enumerate();
    let kinds = ports.filter(|(_, port)| port.name.ends_with("_kind"));
    let kinds: Vec<usize> = kinds.map(|(place, _)| place).collect();
    if kinds.is_empty() {
        return words;
    }
    mapped(
        (words, proptest::collection::vec(0i64..4, kinds.len())),
        move |(mut words, drawn)| {
            let kinds = kinds.iter().zip(drawn);
            kinds.for_each(|(&place, kind)| words[place] = kind);
            words
        },
    )
}

/// A word that `likely` says of its polynomial.
fn one(port: &Signal, likely: Likely, depth_word: u32) -> BoxedStrategy<i64> {
    let far = far_end(depth_word);
    let part = part(port);
    match (port.name.as_str(), likely) {
        ("box_x0" | "box_y0", _) => (0i64..4).boxed(),
        ("box_x1" | "box_y1", _) => (4i64..30).boxed(),
        ("shift", _) => (0i64..3).boxed(),
        (_, Likely::Any) => word(port),
        (_, Likely::UpTo(most)) => {
            prop_oneof![2 => 0..=most.min(3), 1 => 0..=most.min(40), 1 => 0..=most].boxed()
        }
        (_, Likely::Depth(guard)) => match part {
            "a" | "b" => spread(300, guard),
            "nx" | "ny" | "nz" => word(port),
            _ => near_an_end(6_000, far, guard),
        },
        (_, Likely::Bulge) => match part {
            "a2" | "b2" | "c" => spread(20, depth_word - 2),
            "i0" | "p0" => spread(300, depth_word - 2),
            _ => near_an_end(6_000, far, depth_word - 2),
        },
        (_, Likely::Line) => match part {
            "a" | "b" => spread(2_000, 0),
            _ => (-4_000i64..20_000).boxed(),
        },
        (_, Likely::Conic) => match part {
            "a2" | "b2" => spread(1 << 18, 0),
            "c" => spread(1 << 16, 0),
            "i0" | "p0" => spread(1 << 22, 0),
            _ => {
                let positive = 0..1i64 << (port.width - 1).min(62);
                prop_oneof![3 => -(1i64 << 25)..1 << 27, 1 => positive].boxed()
            }
        },
    }
}

/// A number of at most so many units of `2^guard`, either sign.
fn spread(most: i64, guard: u32) -> BoxedStrategy<i64> {
    (-most..=most).prop_map(move |v| v << guard).boxed()
}

/// A depth, now and then about an end of the depth word, one bit away from its least word, or anywhere and beyond.
fn near_an_end(most: i64, far: i64, guard: u32) -> BoxedStrategy<i64> {
    let about = |middle: i64, most: i64| (-most..=most).prop_map(move |v| v + middle);
    let one_bit = (0..far.ilog2()).prop_map(move |bit| (1 << bit) - far - 1);
    let depth = prop_oneof![
        6 => about(0, most),
        1 => one_bit,
        1 => about(far, most),
        1 => about(-far, most),
        1 => about(0, 2 * far),
    ];
    // About a unit, or half of one: what rounding decides.
    let (half, step) = match guard {
        0 => (0, 0),
        _ => (1i64 << (guard - 1), 1),
    };
    let rest = prop_oneof![2 => Just(0), 1 => -step..=step, 1 => half - step..=half + step];
    mapped((depth, rest), move |(v, rest)| (v << guard) + rest)
}
