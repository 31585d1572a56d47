//! Operations on words.

/// The operations: how many words each reads, and its value from the words x, y and z and a constant count c.
macro_rules! operations {
    ($($kind:ident $reads:literal |$x:tt, $y:tt, $z:tt, $c:tt| $value:expr;)*) => {
        /// An operation, as Rust has it on words of 64 bits x, y and z and a constant count c.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Kind {
            $(#[doc = concat!("`", stringify!($value), "`.")] $kind,)*
        }

        impl Kind {
            fn reads(self) -> usize {
                match self {
                    $(Kind::$kind => $reads,)*
                }
            }

            fn value(self, read: [u64; 3], count: u32) -> u64 {
                match self {
                    $(Kind::$kind => {
                        let ([$x, $y, $z], $c) = (read, count);
                        $value
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
    // The sign is at bit c.
    LessSigned 2 |x, y, _, c| u64::from(x ^ 1 << c < y ^ 1 << c);
    Select 3 |x, y, z, _| if x != 0 { y } else { z };
    // All is lost from 64 on.
    Left 2 |x, y, _, _| x.checked_shl(y.min(64) as u32).unwrap_or(0);
    Right 2 |x, y, _, _| x.checked_shr(y.min(64) as u32).unwrap_or(0);
    // There are c bits in front of the sign.
    RightSigned 2 |x, y, _, c| (((x << c) as i64 >> c) >> y.min(63)) as u64;
    Slice 1 |x, _, _, c| x >> c;
    Above 2 |x, y, _, c| x << c | y;
    Sign 1 |x, _, _, c| ((x << c) as i64 >> c) as u64;
}

/// An operation with the places of its words.
#[derive(Clone, Copy, Debug)]
pub struct Code {
    /// What it does.
    pub kind: Kind,
    /// The words that it reads; one that it does not need is the word 0, which is always 1.
    pub from: [u32; 3],
    /// The constant count that some kinds have.
    pub count: u32,
    /// Where the result goes.
    pub to: u32,
    /// The bits of the result that stay.
    pub mask: u64,
}

impl Code {
    /// The words that it needs.
    pub(super) fn reads(&self) -> &[u32] {
        &self.from[..self.kind.reads()]
    }

    pub(super) fn run(&self, words: &mut [u64]) {
        let read = self.from.map(|place| words[place as usize]);
        words[self.to as usize] = self.mask & self.kind.value(read, self.count);
    }
}
