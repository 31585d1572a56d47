//! Parts that rest: while all that it reads stays as it is, what a clock does not change no other clock will.

use std::ops::Range;

/// Clocks with the same inputs before the first look whether a part still changes, and between two looks at the most.
const FIRST: u32 = 8;
const MOST: u32 = 4096;

/// What may rest.
pub(crate) struct Part {
    /// All that it writes.
    pub(crate) words: Vec<Range<usize>>,
    /// Not all 0 if an input is new.
    pub(crate) news: Range<usize>,
    /// The parts whose registers it reads, by their numbers.
    pub(crate) inner: Vec<usize>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    /// Clocks to the next look, and between the two before it.
    Awake(u32, u32),
    AtRest,
}

const AWAKE: State = State::Awake(FIRST, FIRST);

/// What is to be done with a part in a clock.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Turn {
    Rest,
    Run,
    /// It runs, and [`Rest::look`] wants to see it then.
    RunAndLook,
}

/// What is known of the parts of an instance.
pub(crate) struct Rest {
    states: Vec<State>,
    /// Room for what a part holds before a clock.
    before: Vec<u64>,
}

impl Rest {
    /// At power-up.
    pub(crate) fn of(parts: &[Part]) -> Rest {
        Rest {
            states: vec![AWAKE; parts.len()],
            before: vec![],
        }
    }

    /// The turn of a part whose inputs are there.
    pub(crate) fn turn(&mut self, index: usize, part: &Part, words: &[u64]) -> Turn {
        let is_awake = |inner: &usize| self.states[*inner] != State::AtRest;
        let is_new = words[part.news.clone()] != [0; 4] || part.inner.iter().any(is_awake);
        let (state, turn) = match self.states[index] {
            _ if is_new => (AWAKE, Turn::Run),
            State::AtRest => (State::AtRest, Turn::Rest),
            State::Awake(0, between) => {
                self.before.clear();
                for range in &part.words {
                    self.before.extend_from_slice(&words[range.clone()]);
                }
                let between = (2 * between).min(MOST);
                (State::Awake(between, between), Turn::RunAndLook)
            }
            State::Awake(clocks, between) => (State::Awake(clocks - 1, between), Turn::Run),
        };
        self.states[index] = state;
        turn
    }

    /// Lets a part rest if its clock changed nothing.
    pub(crate) fn look(&mut self, index: usize, part: &Part, words: &[u64]) {
        let now = part.words.iter().flat_map(|range| &words[range.clone()]);
        if now.eq(&self.before) {
            self.states[index] = State::AtRest;
        }
    }
}
