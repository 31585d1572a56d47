//! Clocks: the dividers of a PLL, found among all of them, as exact rationals.

use crate::description::{Board, Family};
use crate::error::BoardError;
use num_rational::Ratio;
use num_traits::{Signed, ToPrimitive};
use std::collections::BTreeMap;

/// A frequency in Hz.
type Hertz = Ratio<i128>;

const MEGA: i128 = 1_000_000;

/// The dividers of a PLL, by their names in the template of its family (`top/clock_*.v`), whose search says what they
/// are.
pub type Dividers = BTreeMap<&'static str, i128>;

/// What a PLL can make: the clock of the pixels, its rank among equal clocks, and the dividers. The first of equal ones
/// has the fastest phase detector, and the feedback of an output that is there anyway.
type Candidate = (Hertz, (i128, bool), Dividers);

/// A PLL.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pll {
    input: i128,
    wanted: i128,
    ratio: i128,
    /// The clock of the pixels in Hz, exactly.
    pub pixel_hertz: Hertz,
    /// Its dividers; none where the clock is that of the board, as a board that is only simulated has it.
    pub dividers: Dividers,
}

impl Pll {
    /// The PLL of a board whose pixels come nearest to a clock. Fails when no dividers keep to the limits of the part.
    pub fn of(board: &Board, wanted_hertz: u64) -> Result<Pll, BoardError> {
        let (input, wanted) = (i128::from(board.clock.hertz), i128::from(wanted_hertz));
        let ratio = i128::from(board.fast_ratio());
        let candidates = match board.part.as_ref().map(|part| part.family) {
            Some(Family::Ecp5) => ecp5(input, wanted, ratio),
            Some(Family::Ice40) => ice40(input),
            Some(Family::Gowin) => gowin(board, input, ratio),
            Some(Family::Xilinx7) => xilinx7(input, wanted),
            None => vec![(Ratio::from(wanted), (0, false), Dividers::new())],
        };
        let distance = |pixel: &Hertz| (pixel - wanted).abs();
        let candidates = candidates.into_iter();
        let best = candidates.min_by_key(|(pixel, rank, _)| (distance(pixel), *rank));
        let (pixel_hertz, _, dividers) =
            best.ok_or(BoardError::NoClock(wanted_hertz, board.clock.hertz))?;
        Ok(Pll {
            input,
            wanted,
            ratio,
            pixel_hertz,
            dividers,
        })
    }

    /// The clock of the pixels in MHz.
    pub fn pixel_mhz(&self) -> f64 {
        mhz(self.pixel_hertz)
    }

    /// The clock of the pairs of bits in MHz.
    pub fn fast_mhz(&self) -> f64 {
        mhz(self.pixel_hertz * self.ratio)
    }

    /// How far the pixels are from the clock of their mode, in percent.
    pub fn deviation_percent(&self) -> f64 {
        let part: Hertz = (self.pixel_hertz - self.wanted) / self.wanted;
        100.0 * part.to_f64().unwrap_or(f64::NAN)
    }

    /// The input in MHz.
    pub fn input_mhz(&self) -> f64 {
        mhz(Ratio::from(self.input))
    }
}

fn mhz(hertz: Hertz) -> f64 {
    (hertz / MEGA).to_f64().unwrap_or(f64::NAN)
}

/// Is the frequency between these numbers of kHz?
fn within(hertz: Hertz, (least, most): (i128, i128)) -> bool {
    (Ratio::from(1000 * least)..=Ratio::from(1000 * most)).contains(&hertz)
}

/// The dividers whose clock is between these numbers of kHz, with that clock.
fn within_each(
    dividers: std::ops::RangeInclusive<i128>,
    clock: impl Fn(i128) -> Hertz,
    limits: (i128, i128),
) -> impl Iterator<Item = (i128, Hertz)> {
    let each = dividers.map(move |divider| (divider, clock(divider)));
    each.filter(move |(_, clock)| within(*clock, limits))
}

/// ECP5: the oscillator runs at input / `reference` x `feedback` x `looped`, the fast clock at its `fast`th part, the
/// pixels at its `pixel`th; what is fed back is the fast clock, or an output of its own where `looped` differs.
///
/// All dividers within the limits of the sysCLOCK PLL (family data sheet; those of `ecppll`): phase
/// detector from 3.125 MHz, oscillator 400 to 800 MHz, outputs 3.125 to 400 MHz, dividers 1 to 128, that of the
/// feedback to 80.
fn ecp5(input: i128, wanted: i128, ratio: i128) -> Vec<Candidate> {
    let input = Ratio::from(input);
    let mut found = Vec::new();
    for (reference, detected) in within_each(1..=128, |by| input / by, (3_125, 400_000)) {
        for fast in 1..=128 / ratio {
            // The oscillator that would be exact, and the multiples of the detected clock on both sides of it.
            let exact = Ratio::from(wanted * ratio * fast) / detected;
            for product in [exact.floor().to_integer(), exact.ceil().to_integer()] {
                let oscillator = detected * product;
                let outputs = [oscillator / fast, oscillator / (fast * ratio)];
                let is_legal = within(oscillator, (400_000, 800_000))
                    && outputs
                        .iter()
                        .all(|&output| within(output, (3_125, 400_000)));
                let factors = factors(product, fast, oscillator).filter(|_| is_legal);
                if let Some((feedback, looped)) = factors {
                    let dividers = Dividers::from([
                        ("reference", reference),
                        ("feedback", feedback),
                        ("looped", looped),
                        ("fast", fast),
                        ("pixel", fast * ratio),
                    ]);
                    found.push((outputs[1], (reference, looped != fast), dividers));
                }
            }
        }
    }
    found
}

/// The two dividers in the feedback: that of the fast clock, or the smallest other one.
fn factors(product: i128, fast: i128, oscillator: Hertz) -> Option<(i128, i128)> {
    let mut loops = std::iter::once(fast).chain(1..=128);
    let fits = |looped: &i128| {
        let output = oscillator / looped;
        product % looped == 0 && product / looped <= 80 && within(output, (3_125, 400_000))
    };
    let looped = loops.find(fits)?;
    Some((product / looped, looped))
}

/// iCE40: input / (`divr` + 1) x (`divf` + 1) / 2^`divq`; `filter` is the range of the filter for the phase detector.
///
/// All dividers within the limits of the PLL with simple feedback (those of `icepll`): phase detector 10
/// to 133 MHz, oscillator 533 to 1066 MHz, output 16 to 275 MHz.
fn ice40(input: i128) -> Vec<Candidate> {
    let input = Ratio::from(input);
    let mut found = Vec::new();
    for (divr, detected) in within_each(0..=15, |by| input / (by + 1), (10_000, 133_000)) {
        let oscillator = |by: i128| detected * (by + 1);
        for (divf, oscillator) in within_each(0..=127, oscillator, (533_000, 1_066_000)) {
            let output = |by: i128| oscillator / (1 << by);
            for (divq, output) in within_each(1..=6, output, (16_000, 275_000)) {
                let dividers = [
                    ("divr", divr),
                    ("divf", divf),
                    ("divq", divq),
                    ("filter", filter(detected)),
                ];
                found.push((output, (divr, false), Dividers::from(dividers)));
            }
        }
    }
    found
}

/// 7 series: input / `reference` x `feedback` / `output`, both in eighths.
///
/// All dividers within the limits of the MMCM, speed grade 1 (Artix-7 data sheet): phase detector 10 to
/// 450 MHz, oscillator 600 to 1200 MHz, output from 4.69 MHz; dividers of feedback and output in eighths, from 2 to 64
/// and from 2 to 128.
fn xilinx7(input: i128, wanted: i128) -> Vec<Candidate> {
    let input = Ratio::from(input);
    let mut found = Vec::new();
    for (reference, detected) in within_each(1..=106, |by| input / by, (10_000, 450_000)) {
        let oscillator = |eighths: i128| detected * eighths / 8;
        for (feedback, oscillator) in within_each(16..=512, oscillator, (600_000, 1_200_000)) {
            // The divider that would be exact, in eighths, and its neighbours.
            let exact = oscillator * 8 / wanted;
            for output in [exact.floor().to_integer(), exact.ceil().to_integer()] {
                let made = oscillator * 8 / output.max(1);
                if (16..=1024).contains(&output) && within(made, (4_690, 800_000)) {
                    let dividers = [
                        ("reference", reference),
                        ("feedback", feedback),
                        ("output", output),
                    ];
                    let is_apart = feedback % 8 > 0 || output % 8 > 0;
                    found.push((made, (reference, is_apart), Dividers::from(dividers)));
                }
            }
        }
    }
    found
}

/// The range of the filter, as `icepll` has it.
fn filter(detected: Hertz) -> i128 {
    let bounds = [17, 26, 44, 66, 101].map(|mhz| Ratio::from(mhz * MEGA));
    1 + bounds.iter().filter(|&&bound| detected >= bound).count() as i128
}

/// Limits of the rPLL in kHz (family data sheets): phase detector, oscillator, output.
const GOWIN: [(&str, [(i128, i128); 3]); 2] = [
    (
        "GW1N",
        [(3_000, 400_000), (400_000, 1_200_000), (3_125, 600_000)],
    ),
    (
        "GW2A",
        [(3_000, 500_000), (500_000, 1_250_000), (3_906, 625_000)],
    ),
];
/// What the oscillator can be divided by.
const GOWIN_OUTPUTS: [i128; 11] = [2, 4, 8, 16, 32, 48, 64, 80, 96, 112, 128];

/// Gowin: the fast clock is input / (`input` + 1) x (`feedback` + 1), its oscillator `output` times that; a divider
/// makes the fifth part of it for the pixels. All dividers within the limits of the rPLL of the part.
fn gowin(board: &Board, input: i128, ratio: i128) -> Vec<Candidate> {
    let device = board.part.as_ref().map_or("", |part| &part.device);
    let mut parts = GOWIN.into_iter();
    let Some((_, [detector, oscillator, fast])) = parts.find(|(name, _)| device.starts_with(name))
    else {
        return vec![];
    };
    let hertz = Ratio::from(input);
    let mut found = Vec::new();
    for (input, detected) in within_each(0..=63, |by| hertz / (by + 1), detector) {
        for (feedback, made) in within_each(0..=63, |by| detected * (by + 1), fast) {
            let mut outputs = GOWIN_OUTPUTS.into_iter();
            if let Some(output) = outputs.find(|&output| within(made * output, oscillator)) {
                let dividers = [("input", input), ("feedback", feedback), ("output", output)];
                found.push((made / ratio, (input, false), Dividers::from(dividers)));
            }
        }
    }
    found
}
