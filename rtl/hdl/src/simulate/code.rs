//! Operations on words that lie one behind the other.

use std::ops::Range;

/// The operations: how many words each reads, and its value from the words x, y and z and a constant count c.
macro_rules! operations {
    ($($(#[$about:meta])* $kind:ident $reads:literal |$x:tt, $y:tt, $z:tt, $c:tt| $value:expr;)*) => {
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub(super) enum Kind {
            $($(#[$about])* $kind,)*
        }

        impl Kind {
            pub(super) fn reads(self) -> usize {
                match self {
                    $(Kind::$kind => $reads,)*
                }
            }

            /// Runs operations of this kind one after the other.
            pub(super) fn run(self, code: &[Code], words: &mut [u64]) {
                match self {
                    $(Kind::$kind => {
                        for Code { from, count, to, mask, .. } in code {
                            let [$x, $y, $z] = from.map(|place| words[place as usize]);
                            let $c = *count;
                            words[*to as usize] = $value & mask;
                        }
                    })*
                }
            }
        }
    };
}

operations! {
    Add 2 |x, y, _, _| x.wrapping_add(y);
    Sub 2 |x, y, _, _| x.wrapping_sub(y);
    Mul 2 |x, y, _, _| x.wrapping_mul(y);
    And 2 |x, y, _, _| x & y;
    Or 2 |x, y, _, _| x | y;
    Xor 2 |x, y, _, _| x ^ y;
    Not 1 |x, _, _, _| !x;
    Equal 2 |x, y, _, _| u64::from(x == y);
    Less 2 |x, y, _, _| u64::from(x < y);
    /// The sign is at bit c.
    LessSigned 2 |x, y, _, c| u64::from(x ^ 1 << c < y ^ 1 << c);
    Select 3 |x, y, z, _| if x != 0 { y } else { z };
    Left 2 |x, y, _, _| x.checked_shl(y.min(64) as u32).unwrap_or(0);
    Right 2 |x, y, _, _| x.checked_shr(y.min(64) as u32).unwrap_or(0);
    /// There are c bits in front of the sign.
    RightSigned 2 |x, y, _, c| (((x << c) as i64 >> c) >> y.min(63)) as u64;
    /// From bit c upwards.
    Slice 1 |x, _, _, c| x >> c;
    /// The first above c bits of the second.
    Above 2 |x, y, _, c| x << c | y;
    /// With c bits of sign in front.
    Sign 1 |x, _, _, c| ((x << c) as i64 >> c) as u64;
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Code {
    pub(super) kind: Kind,
    /// The words that it reads; a word that it does not need is [`ONE`](super::ONE).
    pub(super) from: [u32; 3],
    pub(super) count: u32,
    pub(super) to: u32,
    pub(super) mask: u64,
}

/// Operations behind those whose results they read, those of one kind together as far as they may be.
pub(super) fn in_runs(code: Vec<Code>, words: usize) -> (Vec<Code>, Vec<(Kind, Range<usize>)>) {
    let mut level = vec![0u32; words];
    let mut leveled: Vec<(u32, Code)> = vec![];
    for code in code {
        let reads = &code.from[..code.kind.reads()];
        let before = reads.iter().map(|place| level[*place as usize]).max();
        let own = before.unwrap_or(0) + 1;
        level[code.to as usize] = own;
        leveled.push((own, code));
    }
    leveled.sort_by_key(|(level, code)| (*level, code.kind));
    let mut runs: Vec<(Kind, Range<usize>)> = vec![];
    let mut before = 0;
    for (index, (level, code)) in leveled.iter().enumerate() {
        match runs.last_mut() {
            Some((kind, range)) if *kind == code.kind && *level == before => range.end = index + 1,
            _ => runs.push((code.kind, index..index + 1)),
        }
        before = *level;
    }
    (leveled.into_iter().map(|(_, code)| code).collect(), runs)
}
