//! Smoothing filter behind the shading.

use std::collections::BTreeMap;

/// Weights of the filter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kernel {
    /// The picture as it is.
    #[default]
    Pass,
    /// Mean of 2 x 2: the pixel, those on its left and above, and the one between them.
    Box,
    /// 1 2 1, 2 4 2, 1 2 1 over 16.
    Binomial,
}

impl Kernel {
    /// The kernel of a word of 2 bits.
    pub fn from_word(word: i64) -> Self {
        match word {
            0 => Kernel::Pass,
            1 => Kernel::Box,
            _ => Kernel::Binomial,
        }
    }

    /// Weights of the pixels from one up and left to one down and right.
    fn weights(self) -> [[u32; 3]; 3] {
        match self {
            Kernel::Pass => [[0, 0, 0], [0, 1, 0], [0, 0, 0]],
            Kernel::Box => [[1, 1, 0], [1, 1, 0], [0, 0, 0]],
            Kernel::Binomial => [[1, 2, 1], [2, 4, 2], [1, 2, 1]],
        }
    }

    /// A pixel of the smooth picture: the convolution of lines, rounded to the nearest, halves up; beyond an edge the
    /// nearest pixel stands.
    pub fn at(self, lines: &[Vec<[u8; 3]>], x: usize, y: usize) -> [u8; 3] {
        let weights = self.weights();
        let total: u32 = weights.iter().flatten().sum();
        let near = |at: usize, step: usize, count: usize| (at + step).clamp(1, count) - 1;
        [0, 1, 2].map(|channel| {
            let mut sum = 0;
            for (down, row) in weights.iter().enumerate() {
                let line = &lines[near(y, down, lines.len())];
                for (right, weight) in row.iter().enumerate() {
                    sum += weight * u32::from(line[near(x, right, line.len())][channel]);
                }
            }
            ((sum + total / 2) / total) as u8
        })
    }

    /// The smooth picture.
    pub fn picture(self, lines: &[Vec<[u8; 3]>]) -> Vec<Vec<[u8; 3]>> {
        let line = |y: usize| (0..lines[y].len()).map(move |x| self.at(lines, x, y));
        (0..lines.len()).map(|y| line(y).collect()).collect()
    }
}

/// A pixel that comes or leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FilterPixel {
    /// Column.
    pub x: u16,
    /// Line.
    pub y: u16,
    /// Last pixel of its line.
    pub line_end: bool,
    /// Last pixel of the picture.
    pub last: bool,
    /// Red, green, blue.
    pub colour: [u8; 3],
}

/// Clocks from the pixel to the right in the next line.
pub const LATENCY: u64 = 6;

/// The filter, clock by clock: when each pixel leaves. What leaves is a part of [`Kernel::picture`].
#[derive(Clone, Debug, Default)]
pub struct PostFilter {
    kernel: Kernel,
    lines: Vec<Vec<[u8; 3]>>,
    clock: u64,
    leaving: BTreeMap<u64, FilterPixel>,
}

impl PostFilter {
    /// One clock; the pixel that is there after the edge.
    pub fn clock(&mut self, kernel: Kernel, pixel: Option<FilterPixel>) -> Option<FilterPixel> {
        self.clock += 1;
        if let Some(pixel) = pixel {
            self.take(kernel, &pixel);
        }
        self.leaving.remove(&self.clock)
    }

    fn take(&mut self, kernel: Kernel, pixel: &FilterPixel) {
        let (x, y) = (usize::from(pixel.x), usize::from(pixel.y));
        if x == 0 && y == 0 {
            self.kernel = kernel;
            self.lines.clear();
        }
        if x == 0 {
            self.lines.push(Vec::new());
        }
        self.lines[y].push(pixel.colour);
        if y > 0 {
            self.reached(self.clock, x, y - 1, pixel.line_end, false);
        }
        if pixel.last {
            // The line below the last one, from three clocks later on.
            for below in 0..=x {
                let clock = self.clock + 3 + below as u64;
                self.reached(clock, below, y, below == x, true);
            }
        }
    }

    /// What leaves of line y when column x of the line below it comes at a clock.
    fn reached(&mut self, clock: u64, x: usize, y: usize, line_end: bool, is_last_line: bool) {
        let out = clock + LATENCY - 1;
        if let Some(before) = x.checked_sub(1) {
            self.leave(out, before, y, false, false);
        }
        if line_end {
            self.leave(out + 1, x, y, true, is_last_line);
        }
    }

    fn leave(&mut self, clock: u64, x: usize, y: usize, line_end: bool, last: bool) {
        // Of the line below only the part up to column x + 1 has come; it is as long as this one for the convolution.
        let mut lines = self.lines.clone();
        let width = lines[0].len();
        for line in &mut lines {
            let fill = *line.last().expect("a line has a pixel");
            line.resize(width, fill);
        }
        let colour = self.kernel.at(&lines, x, y);
        let pixel = FilterPixel {
            x: x as u16,
            y: y as u16,
            line_end,
            last,
            colour,
        };
        self.leaving.insert(clock, pixel);
    }
}
