//! Plain delays of the flags and words that travel beside a computation.

use crate::kernel::*;

/// Delays the three raster flags by a number of clocks, which may be 0.
///
/// Delaying the start of an elementary processor takes the place of delaying its wide value.
pub struct FlagDelay {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the zone.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// `valid`, delayed.
    pub late_valid: Signal<Out, Bit>,
    /// `start`, delayed.
    pub late_start: Signal<Out, Bit>,
    /// `line`, delayed.
    pub late_line: Signal<Out, Bit>,
    valid_at: Vec<DFF<Bit>>,
    start_at: Vec<DFF<Bit>>,
    line_at: Vec<DFF<Bit>>,
    _first: usize,
    _count: usize,
    _asleep: bool,
}

block! {
    [] FlagDelay []
    inputs { clock, valid, start, line }
    parts { late_valid, late_start, late_line, valid_at, start_at, line_at }
    data { _first, _count }
}

impl FlagDelay {
    /// A delay of `clocks` clocks.
    pub fn new(clocks: usize) -> Self {
        Self {
            clock: Signal::default(),
            valid: Signal::default(),
            start: Signal::default(),
            line: Signal::default(),
            late_valid: Signal::default(),
            late_start: Signal::default(),
            late_line: Signal::default(),
            valid_at: repeat(clocks, DFF::default),
            start_at: repeat(clocks, DFF::default),
            line_at: repeat(clocks, DFF::default),
            _first: clocks.min(1),
            _count: clocks,
            _asleep: false,
        }
    }
}

impl Logic for FlagDelay {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("flag_delay");
        self.late_valid.next = self.valid.val();
        self.late_start.next = self.start.val();
        self.late_line.next = self.line.val();
        for i in 0..self._first {
            self.valid_at[i].d.next = self.valid.val();
            self.start_at[i].d.next = self.start.val();
            self.line_at[i].d.next = self.line.val();
        }
        for i in 1..self._count {
            self.valid_at[i].d.next = self.valid_at[i - 1].q.val();
            self.start_at[i].d.next = self.start_at[i - 1].q.val();
            self.line_at[i].d.next = self.line_at[i - 1].q.val();
        }
        for i in 0..self._count {
            self.valid_at[i].clock.next = self.clock.val();
            self.start_at[i].clock.next = self.clock.val();
            self.line_at[i].clock.next = self.clock.val();
            self.late_valid.next = self.valid_at[i].q.val();
            self.late_start.next = self.start_at[i].q.val();
            self.late_line.next = self.line_at[i].q.val();
        }
    }
}

/// Delays a word by a number of clocks, which may be 0.
pub struct WordDelay<T: PortValue> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// The word.
    pub word: Signal<In, T>,
    /// The word, delayed.
    pub late: Signal<Out, T>,
    word_at: Vec<DFF<T>>,
    _first: usize,
    _count: usize,
    _asleep: bool,
}

block! {
    [T: PortValue] WordDelay [T]
    inputs { clock, word }
    parts { late, word_at }
    data { _first, _count }
}

impl<T: PortValue> WordDelay<T> {
    /// A delay of `clocks` clocks.
    pub fn new(clocks: usize) -> Self {
        Self {
            clock: Signal::default(),
            word: Signal::default(),
            late: Signal::default(),
            word_at: repeat(clocks, DFF::default),
            _first: clocks.min(1),
            _count: clocks,
            _asleep: false,
        }
    }
}

impl<T: PortValue> Logic for WordDelay<T> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("word_delay");
        self.late.next = self.word.val();
        for i in 0..self._first {
            self.word_at[i].d.next = self.word.val();
        }
        for i in 1..self._count {
            self.word_at[i].d.next = self.word_at[i - 1].q.val();
        }
        for i in 0..self._count {
            self.word_at[i].clock.next = self.clock.val();
            self.late.next = self.word_at[i].q.val();
        }
    }
}
