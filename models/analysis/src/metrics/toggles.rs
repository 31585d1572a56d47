//! The energy proxy: how many register bits change from clock to clock, counted in the incremental golden models.
//!
//! Counted are the registers that a pixel changes: the values of PE1 and the values and pixel increments of PE2 with
//! all guard bits, every register stage of the root network (digits found, remainder, rest of the radicand), and the
//! depth words: root, both sums, both depths handed on. Registers that change once a line or once a zone are left out,
//! and so is combinational logic.

use imogene_golden::format::{Format, word_max};
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::object::words::Words;
use imogene_golden::unit::pe1::{Linear, Pe1};
use imogene_golden::unit::pe2::{Pe2, Quadratic};
use serde::{Deserialize, Serialize};

/// Bits that change per pixel clock, all slots together; the keys are stable.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Toggles {
    /// Lines of the screen on which they were counted.
    pub lines: Vec<u32>,
    /// In the first-degree processors: depth, planes, normals.
    pub pe1: f64,
    /// In the second-degree processors.
    pub pe2: f64,
    /// In the register stages of the root networks.
    pub root: f64,
    /// In root, sums and depths handed on.
    pub depth: f64,
    /// All of these.
    pub total: f64,
}

const SAMPLE: u32 = 8;

/// The lines of the sample: the middles of eight bands of equal height, or all lines of a picture of no more.
pub fn sample(height: u32) -> Vec<u32> {
    if height <= SAMPLE {
        return (0..height).collect();
    }
    let middle = |band: u32| ((2 * band + 1) * height) / (2 * SAMPLE);
    (0..SAMPLE).map(middle).collect()
}

/// A rectangle of the screen and the words with which the slots of a machine draw it.
pub struct Part {
    /// Words for the whole screen.
    pub slots: Vec<QuadricWords>,
    /// Its pixels.
    pub window: ScreenBox,
}

/// Counts the slots of a machine on the sample of lines of a screen of so many lines, which its parts cover.
pub fn count(parts: &[Part], format: &Format, rows_per_stage: u32, height: u32) -> Toggles {
    let lines = sample(height);
    let mut sums = [0; 4];
    // A line of n pixels has n - 1 changes.
    let mut changes = 0;
    for part in parts {
        let ScreenBox { x0, x1, y0, y1 } = part.window;
        let within = lines.iter().map(|line| i64::from(*line));
        for line in within.filter(|line| (y0..=y1).contains(line)) {
            changes += x1 - x0;
            for words in &part.slots {
                let zone = words.for_zone(x0, line, x1 - x0 + 1, 1);
                let line = count_line(&zone, format, rows_per_stage, (x1 - x0 + 1) as u32);
                sums = std::array::from_fn(|k| sums[k] + line[k]);
            }
        }
    }
    let per_pixel = |bits: u64| bits as f64 / changes.max(1) as f64;
    let [pe1, pe2, root, depth] = sums;
    Toggles {
        pe1: per_pixel(pe1),
        pe2: per_pixel(pe2),
        root: per_pixel(root),
        depth: per_pixel(depth),
        total: per_pixel(pe1 + pe2 + root + depth),
        lines,
    }
}

/// Bits that change on a line: in pe1, in pe2, in the root, in depths.
fn count_line(words: &QuadricWords, format: &Format, rows: u32, width: u32) -> [u64; 4] {
    let planes = words.planes.iter();
    let planes = planes.map(|plane| (&plane.depth, format.plane));
    let normal = words.normal.g.iter().map(|g| (g, format.normal_linear));
    let f1 = [(&words.f1, format.pe1_width())];
    let all = planes.chain(normal).chain(f1);
    let changes = all.map(|(form, bits)| first_degree(form, bits, width));
    let (mut root, mut depth) = (0, 0);
    let (mut stages, mut depths) = (Bits::default(), Bits::default());
    for x in 0..width {
        let probe = words.probe_at(x.into(), 0, format);
        let core = &probe.depths;
        root += stages.change(root_stages(core.f2, core.root, format, rows));
        let own = [
            (core.root, format.root),
            (core.near, format.sum),
            (core.far, format.sum),
            (probe.output.zf, format.depth),
            (probe.output.zb, format.depth),
        ];
        depth += depths.change(own.map(|(v, width)| masked(i128::from(v), width)).into());
    }
    let pe2 = second_degree(&words.f2, format.pe2_width(), width);
    [changes.sum(), pe2, root, depth]
}

/// Bits that the value of a pe1 of so many bits changes over so many pixels of a line.
pub fn first_degree(coefficients: &Linear, width: u32, pixels: u32) -> u64 {
    let mut pe = Pe1::object_start(coefficients, width);
    let mut bits = Bits::default();
    (0..pixels)
        .map(|_| bits.change(vec![masked(pe.pixel(), width)]))
        .sum()
}

/// Bits that value and increment of a pe2 of so many bits change over so many pixels of a line.
pub fn second_degree(coefficients: &Quadratic, width: u32, pixels: u32) -> u64 {
    let mut pe = Pe2::object_start(coefficients, width);
    let mut bits = Bits::default();
    let mut value = masked(pe.pixel(), width);
    (0..pixels)
        .map(|_| {
            let next = masked(pe.pixel(), width);
            // The increment is the difference of two values, modulo the word.
            let increment = next.wrapping_sub(value) & masked(-1, width);
            bits.change(vec![std::mem::replace(&mut value, next), increment])
        })
        .sum()
}

/// What the register stages of a root network hold of one pixel: digits found, remainder and the rest of the radicand
/// after each stage but the last, whose digits are the root.
pub fn root_stages(f2: i64, root: i64, format: &Format, rows_per_stage: u32) -> Vec<u128> {
    let rows = format.root_rows();
    let dropped = format.dropped_rows;
    let radicand = masked(i128::from(f2), format.quadratic) >> (2 * dropped);
    let digits = (root as u128) >> dropped;
    let mut held = vec![];
    let mut done = rows_per_stage;
    while done < rows {
        let left = rows - done;
        let found = digits >> left;
        held.push(found);
        held.push((radicand >> (2 * left)) - found * found);
        held.push(radicand & ((1 << (2 * left)) - 1));
        done += rows_per_stage;
    }
    held
}

/// A word as its register holds it.
fn masked(value: i128, width: u32) -> u128 {
    value as u128 & (word_max(width + 1) as u128)
}

/// Registers over time.
#[derive(Default)]
struct Bits {
    last: Option<Vec<u128>>,
}

impl Bits {
    /// Bits that differ from the clock before; none at the first.
    fn change(&mut self, words: Vec<u128>) -> u64 {
        let last = self.last.replace(words);
        let (Some(last), Some(now)) = (last, &self.last) else {
            return 0;
        };
        let pairs = last.iter().zip(now);
        pairs.map(|(a, b)| u64::from((a ^ b).count_ones())).sum()
    }
}
