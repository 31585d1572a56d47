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
    /// Too little in so many clocks.
    #[error("the pins show no whole frame between two synchronisations in {0} clocks")]
    NoFrame(usize),
    /// A synchronisation that is not where the mode has it: pin, level, and the clock from the beginning of the
    /// vertical synchronisation.
    #[error("{0} is {1} at clock {2} of a frame, against the mode")]
    Sync(&'static str, bool, usize),
    /// A colour in the blanking, at a clock counted likewise.
    #[error("the pins show the colour {0:?} at clock {1} of a frame, which is blank")]
    Colour([u8; 3], usize),
}

/// What a screen shows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shown {
    /// Red, green, blue of every pixel of the whole frames, line by line.
    pub pictures: Vec<Vec<u8>>,
    /// Clocks between the last two vertical synchronisations; 0 before there were two.
    pub clocks: usize,
}

/// A screen: it finds a frame by the beginning of the vertical synchronisation alone, and every pin has to be as the
/// mode has it from there to the end of the shown part.
pub struct Screen<'a> {
    mode: &'a VideoMode,
    /// The end of the last pixel, counted from the beginning of the vertical synchronisation.
    end: usize,
    ticks: usize,
    /// The vertical synchronisation in the clock before.
    was_in_vsync: bool,
    /// When the last two frames began.
    starts: [Option<usize>; 2],
    picture: Vec<u8>,
    shown: Shown,
}

impl<'a> Screen<'a> {
    /// A screen that is given a mode.
    pub fn new(mode: &'a VideoMode) -> Screen<'a> {
        let lines = mode.frame.sync + mode.frame.back + mode.frame.active;
        Screen {
            mode,
            // From the beginning of a horizontal synchronisation to that of the blanking of the last line.
            end: (lines * mode.line.total() - mode.line.front) as usize,
            ticks: 0,
            was_in_vsync: true,
            starts: [None; 2],
            picture: vec![],
            shown: Shown::default(),
        }
    }

    /// One clock of the pixels. Fails when the pins are not as the mode has them.
    pub fn see(&mut self, tick: &Tick) -> Result<(), ScreenError> {
        let is_in_vsync = tick.vsync == self.mode.vsync_high;
        if is_in_vsync && !self.was_in_vsync {
            self.starts = [self.starts[1], Some(self.ticks)];
            self.picture.clear();
        }
        self.was_in_vsync = is_in_vsync;
        if let Some(start) = self.starts[1] {
            let at = self.ticks - start;
            if at < self.end && self.check(tick, at)? {
                self.picture.extend(tick.colour);
            }
            if at + 1 == self.end {
                self.shown.pictures.push(std::mem::take(&mut self.picture));
            }
        }
        self.ticks += 1;
        Ok(())
    }

    /// What was shown. Fails when there was no whole frame.
    pub fn shown(mut self) -> Result<Shown, ScreenError> {
        if self.shown.pictures.is_empty() {
            return Err(ScreenError::NoFrame(self.ticks));
        }
        if let [Some(before), Some(last)] = self.starts {
            self.shown.clocks = last - before;
        }
        Ok(self.shown)
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
        if let Some((pin, found, _)) = levels
            .into_iter()
            .find(|(_, found, wanted)| found != wanted)
        {
            return Err(ScreenError::Sync(pin, found, at));
        }
        if !is_shown && tick.colour != [0; 3] {
            return Err(ScreenError::Colour(tick.colour, at));
        }
        Ok(is_shown)
    }
}
