//! The picture that a screen makes of its pins.

use imogene_contract::video::VideoMode;
use thiserror::Error;

/// What the pins show in one clock of the pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tick {
    /// Level of the synchronisation of the line.
    pub hsync: bool,
    /// Level of the synchronisation of the frame.
    pub vsync: bool,
    /// A pixel is shown; none where no pin says so.
    pub de: Option<bool>,
    /// Red, green, blue.
    pub colour: [u8; 3],
}

/// Pins that show no picture of the mode.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum ScreenError {
    /// Too little.
    #[error("the pins show no whole frame between two synchronisations in {ticks} clocks")]
    NoFrame {
        /// Clocks seen.
        ticks: usize,
    },
    /// A synchronisation that is not where the mode has it.
    #[error("{pin} is {found} at clock {at} of a frame, against the mode")]
    Sync {
        /// Which pin.
        pin: &'static str,
        /// Its level.
        found: bool,
        /// The clock, from the beginning of the vertical synchronisation.
        at: usize,
    },
    /// A colour in the blanking.
    #[error("the pins show the colour {colour:?} at clock {at} of a frame, which is blank")]
    Colour {
        /// The clock, from the beginning of the vertical synchronisation.
        at: usize,
        /// The colour.
        colour: [u8; 3],
    },
}

/// A picture that the pins show.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Red, green, blue of every pixel, line by line.
    pub picture: Vec<u8>,
    /// Clocks between the last two vertical synchronisations, none of which was seen if there is only one.
    pub clocks: usize,
}

/// The last whole frame: the screen finds it by the beginning of the vertical synchronisation alone, and every pin has
/// to be as the mode has it up to the end of the shown part.
///
/// # Errors
///
/// When there is no whole frame, or a pin is against the mode.
pub fn frame(ticks: &[Tick], mode: &VideoMode) -> Result<Frame, ScreenError> {
    let none = ScreenError::NoFrame { ticks: ticks.len() };
    let begins = |pair: &[Tick]| {
        let is_in = |tick: &Tick| tick.vsync == mode.vsync_high;
        !is_in(&pair[0]) && is_in(&pair[1])
    };
    let starts = ticks.windows(2).enumerate();
    let starts: Vec<usize> = starts
        .filter(|(_, pair)| begins(pair))
        .map(|(place, _)| place + 1)
        .collect();
    let layout = Layout::of(mode);
    let whole = |start: &&usize| **start + layout.end <= ticks.len();
    let last = starts.iter().rposition(|start| whole(&start)).ok_or(none)?;
    let before = last.checked_sub(1).map(|before| starts[before]);
    let mut picture = Vec::with_capacity(3 * (mode.line.active * mode.frame.active) as usize);
    for at in 0..layout.end {
        let tick = &ticks[starts[last] + at];
        if layout.check(tick, at)? {
            picture.extend(tick.colour);
        }
    }
    Ok(Frame {
        picture,
        clocks: before.map_or(0, |before| starts[last] - before),
    })
}

/// Where everything is in a frame, counted from the beginning of the vertical synchronisation.
struct Layout<'a> {
    mode: &'a VideoMode,
    /// The end of the last pixel.
    end: usize,
}

impl Layout<'_> {
    fn of(mode: &VideoMode) -> Layout<'_> {
        let lines = mode.frame.sync + mode.frame.back + mode.frame.active;
        Layout {
            mode,
            // From the beginning of a horizontal synchronisation to that of the blanking of the last line.
            end: (lines * mode.line.total() - mode.line.front) as usize,
        }
    }

    /// Checks a clock; whether a pixel is shown in it.
    fn check(&self, tick: &Tick, at: usize) -> Result<bool, ScreenError> {
        let (line, frame) = (self.mode.line, self.mode.frame);
        let (row, column) = (at as u64 / line.total(), at as u64 % line.total());
        // The vertical synchronisation changes with a horizontal one, which begins a row here.
        let in_hsync = column < line.sync;
        let in_vsync = row < frame.sync;
        // The shown part of a line follows its back porch; it is of the row of the frame that began before it.
        let is_shown = row >= frame.sync + frame.back
            && (line.sync + line.back..line.sync + line.back + line.active).contains(&column);
        let levels = [
            ("hsync", tick.hsync, in_hsync == self.mode.hsync_high),
            ("vsync", tick.vsync, in_vsync == self.mode.vsync_high),
            ("de", tick.de.unwrap_or(is_shown), is_shown),
        ];
        for (pin, found, wanted) in levels {
            if found != wanted {
                return Err(ScreenError::Sync { pin, found, at });
            }
        }
        if !is_shown && tick.colour != [0; 3] {
            let colour = tick.colour;
            return Err(ScreenError::Colour { at, colour });
        }
        Ok(is_shown)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use imogene_golden::machine::video_timing::VideoTiming;

    const MODE: VideoMode = VideoMode::SMALL;

    fn colour(x: u16, y: u16) -> [u8; 3] {
        [x as u8, y as u8, 7]
    }

    /// The clocks of two frames and a bit, by the golden raster.
    fn ticks() -> Vec<Tick> {
        let mut timing = VideoTiming::new(MODE, 0);
        let tick = |_| {
            let at = timing.clock(true);
            let colour = if at.now.active {
                colour(at.now.x, at.now.y)
            } else {
                [0; 3]
            };
            Tick {
                hsync: at.hsync,
                vsync: at.vsync,
                de: Some(at.now.active),
                colour,
            }
        };
        (0..2 * MODE.clocks() + 400).map(tick).collect()
    }

    #[test]
    fn the_picture_of_a_frame_is_found() {
        for has_de in [true, false] {
            let mut ticks = ticks();
            ticks
                .iter_mut()
                .for_each(|tick| tick.de = tick.de.filter(|_| has_de));
            let frame = frame(&ticks, &MODE).expect("a frame");
            assert_eq!(frame.clocks as u64, MODE.clocks());
            let pixels = (0..120).flat_map(|y| (0..160).map(move |x| colour(x, y)));
            assert_eq!(frame.picture, pixels.flatten().collect::<Vec<u8>>());
        }
    }

    #[test]
    fn pins_against_the_mode_are_refused() {
        let sound = ticks();
        assert!(frame(&sound[..9_000], &MODE).is_err());
        for (what, change) in [
            ("hsync", (|tick| tick.hsync ^= true) as fn(&mut Tick)),
            // A frame that begins where none does.
            ("against the mode", |tick| tick.vsync ^= true),
            ("de", |tick| tick.de = tick.de.map(|de| !de)),
            ("blank", |tick| tick.colour = [1; 3]),
        ] {
            let mut broken = sound.clone();
            // The first clock of the second frame is blank, and is not the beginning of its synchronisation.
            let blank = MODE.clocks() as usize + 2 * MODE.line.total() as usize + 1;
            change(&mut broken[blank + 4]);
            let error = frame(&broken, &MODE).expect_err(what).to_string();
            assert!(error.contains(what), "{error}");
        }
    }
}
