//! Random stalls of a stream.

use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// Stalls one clock in three, or never.
pub struct Stalls(Option<TestRng>);

impl Stalls {
    /// Stalls of a seed; without one there are none.
    pub fn new(seed: Option<u64>) -> Stalls {
        Stalls(seed.map(|seed| {
            let mut bytes = [0u8; 32];
            bytes[..8].copy_from_slice(&seed.to_le_bytes());
            TestRng::from_seed(RngAlgorithm::ChaCha, &bytes)
        }))
    }

    /// Does the stream stall on the next clock?
    pub fn stall(&mut self) -> bool {
        let random = self.0.as_mut();
        random.is_some_and(|random| random.next_u32().is_multiple_of(3))
    }
}
