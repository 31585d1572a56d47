//! Random stalls of a stream.

use crate::random::generator;
use proptest::prelude::Rng;
use proptest::test_runner::TestRng;

/// Stalls one clock in three, or never.
pub struct Stalls(Option<TestRng>);

impl Stalls {
    /// Stalls of a seed; without one there are none.
    pub fn new(seed: Option<u64>) -> Stalls {
        Stalls(seed.map(generator))
    }

    /// Does the stream stall on the next clock?
    pub fn stall(&mut self) -> bool {
        let random = self.0.as_mut();
        random.is_some_and(|random| random.next_u32().is_multiple_of(3))
    }
}
