//! What all object processors have in common: words held over a zone, a golden processor that runs over it, results a fixed time later.

use super::{Late, bit};
use crate::signal::{Delay, Signal};
use crate::stimulus::word;
use crate::subject::{Golden, GoldenFn, Inputs};
use imogene_golden::object::screen_box::ScreenBox;
use imogene_golden::object::words::{Object, ObjectPixel, Running};
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use proptest::prelude::*;

/// Ports before the first word: the flags, then the column and the line.
pub(super) const WORDS: usize = 5;

/// A golden processor at work.
pub(super) trait Processor: Send {
    /// Next line.
    fn line_step(&mut self);
    /// Outputs of the next pixel, from what the ports show when its depth comes in.
    fn pixel(&mut self, inputs: &[i64]) -> Vec<i64>;
}

impl<W: Object + Send> Processor for Running<W> {
    fn line_step(&mut self) {
        Running::line_step(self);
    }

    fn pixel(&mut self, _inputs: &[i64]) -> Vec<i64> {
        object_values(&self.step(W::at))
    }
}

/// Clocks of a processor.
#[derive(Clone, Copy)]
pub(super) struct Timing {
    /// From the flags to the clock whose other moving inputs belong to the pixel.
    pub entry: usize,
    /// From the flags to the results.
    pub latency: usize,
}

impl Timing {
    /// A processor whose only moving inputs are the raster's.
    pub fn of(latency: u32) -> Timing {
        Timing {
            entry: 0,
            latency: latency as usize,
        }
    }
}

/// The golden side of a processor with `outputs` outputs behind `out_valid`; `start` makes the processor of a zone from the ports.
pub(super) fn golden(
    timing: Timing,
    outputs: usize,
    start: impl Fn(&[i64]) -> Box<dyn Processor> + Clone + Send + Sync + 'static,
) -> Box<dyn Fn() -> Box<dyn Golden> + Sync> {
    Box::new(move || {
        let start = start.clone();
        let mut entered = Delay::new(timing.entry);
        let mut late = Late::new(timing.latency - timing.entry);
        let mut processor: Option<Box<dyn Processor>> = None;
        Box::new(GoldenFn(move |i: &[i64]| {
            let Some([valid, first, line]) = entered.push([i[0], i[1], i[2]].map(bit)) else {
                return vec![None; 1 + outputs];
            };
            if valid && first {
                processor = Some(start(i));
            } else if valid && line {
                processor.iter_mut().for_each(|p| p.line_step());
            }
            let pixel = match &mut processor {
                Some(processor) if valid => Some(processor.pixel(i)),
                _ => None,
            };
            match late.push(pixel) {
                Some(Some(values)) => [1].into_iter().chain(values).map(Some).collect(),
                Some(None) => [vec![Some(0)], vec![None; outputs]].concat(),
                None => vec![None; 1 + outputs],
            }
        }))
    })
}

/// Depths, face and normal of an object, behind `out_valid`.
pub(super) fn object_values(p: &ObjectPixel) -> Vec<i64> {
    let [nx, ny, nz] = p.normal.map(i64::from);
    vec![p.zf, p.zb, p.number.into(), nx, ny, nz]
}

/// Reads the ports of a processor one after the other.
pub(super) struct Reader<'a> {
    words: &'a [i64],
}

impl<'a> Reader<'a> {
    /// From the first word on.
    pub fn new(inputs: &'a [i64]) -> Reader<'a> {
        Reader {
            words: &inputs[WORDS..],
        }
    }

    pub fn word(&mut self) -> i64 {
        let (first, rest) = self.words.split_first().expect("a port for each word");
        self.words = rest;
        *first
    }

    pub fn linear(&mut self) -> Linear {
        let [a, b, c] = [(); 3].map(|()| i128::from(self.word()));
        Linear::new(a, b, c)
    }

    pub fn quadratic(&mut self) -> Quadratic {
        let [a2, b2, c, i0, p0, f] = [(); 6].map(|()| i128::from(self.word()));
        let (a, b) = (a2 / 2, b2 / 2);
        Quadratic {
            a,
            b,
            c,
            d: p0 - a,
            e: i0 - b,
            f,
        }
    }

    pub fn screen_box(&mut self) -> ScreenBox {
        let [x0, x1, y0, y1] = [(); 4].map(|()| self.word());
        ScreenBox { x0, x1, y0, y1 }
    }

    pub fn vector(&mut self) -> [i16; 3] {
        [(); 3].map(|()| self.word() as i16)
    }
}

/// One zone of random width with one set of words on the ports from [`WORDS`] on; every eleventh clock is a gap, in which the raster stands still.
pub(super) fn held(words: BoxedStrategy<Inputs>, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    (words, 1i64..24)
        .prop_map(move |(words, width)| {
            let clock = |n: i64| {
                let pixel = n - n / 11;
                let (x, y) = (pixel % width, pixel / width);
                let flags = if n % 11 == 10 {
                    [0, 0, 0]
                } else {
                    [1, i64::from(pixel == 0), i64::from(x == 0 && y > 0)]
                };
                let raster = flags.into_iter().chain([x, y & 0xfff]);
                raster.chain(words.iter().copied()).collect()
            };
            (0..clocks as i64).map(clock).collect()
        })
        .boxed()
}

/// What the words of a port are likely to be on a zone of a few pixels, so that signs change and depths meet on it.
#[derive(Clone, Copy)]
pub(super) enum Likely {
    /// A polynomial of first degree that is a depth in units of `2^-guard`, now and then at an end of the depth word.
    Depth(u32),
    /// The same of second degree.
    Bulge(u32),
    /// A polynomial of first degree of which the sign counts.
    Line,
    /// The same of second degree.
    Conic,
    /// A number from 0 to this one.
    UpTo(i64),
    /// Anything.
    Any,
}

/// Words of a zone: full-range ones now and then, mostly those of the first entry of `plan` whose prefix the port has.
pub(super) fn words(
    ports: &[Signal],
    depth_word: u32,
    plan: &[(&str, Likely)],
) -> BoxedStrategy<Inputs> {
    let ports = &ports[WORDS..];
    let any_word: Vec<_> = ports.iter().map(word).collect();
    let likely: Vec<_> = ports
        .iter()
        .map(|port| {
            let entry = plan
                .iter()
                .find(|(prefix, _)| port.name.starts_with(prefix));
            let likely = entry.map_or(Likely::Any, |(_, likely)| *likely);
            one(port, likely, depth_word)
        })
        .collect();
    let names: Vec<String> = ports.iter().map(|port| port.name.clone()).collect();
    prop_oneof![1 => any_word, 4 => likely]
        .prop_map(move |mut words| {
            // Second differences are even: they are twice a coefficient.
            for (word, name) in words.iter_mut().zip(&names) {
                if name.ends_with("_a2") || name.ends_with("_b2") {
                    *word &= !1;
                }
            }
            words
        })
        .boxed()
}

fn one(port: &Signal, likely: Likely, depth_word: u32) -> BoxedStrategy<i64> {
    let far = (1i64 << (depth_word - 1)) - 1;
    let part = port.name.rsplit('_').next().unwrap_or_default();
    match (port.name.as_str(), likely) {
        ("box_x0" | "box_y0", _) => (0i64..4).boxed(),
        ("box_x1" | "box_y1", _) => (4i64..30).boxed(),
        ("shift", _) => (0i64..3).boxed(),
        (_, Likely::Any) => word(port),
        (_, Likely::UpTo(most)) => prop_oneof![3 => 0..=most.min(3), 1 => 0..=most].boxed(),
        (_, Likely::Depth(guard)) => match part {
            "a" | "b" => spread(300, guard),
            _ => near_an_end(6_000, far, guard),
        },
        (_, Likely::Bulge(guard)) => match part {
            "a2" | "b2" | "c" => spread(20, guard),
            "i0" | "p0" => spread(300, guard),
            _ => near_an_end(6_000, far, guard),
        },
        (_, Likely::Line) => match part {
            "a" | "b" => spread(2_000, 0),
            _ => (-4_000i64..20_000).boxed(),
        },
        (_, Likely::Conic) => match part {
            "a2" | "b2" => spread(1 << 18, 0),
            "c" => spread(1 << 16, 0),
            "i0" | "p0" => spread(1 << 22, 0),
            _ => (-(1i64 << 25)..1 << 27).boxed(),
        },
    }
}

/// A number of at most so many units of `2^guard`, either sign.
fn spread(most: i64, guard: u32) -> BoxedStrategy<i64> {
    (-most..=most).prop_map(move |v| v << guard).boxed()
}

/// A depth, now and then about an end of the depth word.
fn near_an_end(most: i64, far: i64, guard: u32) -> BoxedStrategy<i64> {
    (
        -most..=most,
        prop_oneof![6 => Just(0), 1 => Just(far), 1 => Just(-far)],
    )
        .prop_map(move |(v, end)| (v + end) << guard)
        .boxed()
}
