//! Operations against numbers, memories against a list.

use imogene_hdl::{Bits, Design, Int, Simulator, Value, join, memory, module};
use proptest::prelude::*;

/// All operations of two words and two numbers of one width, and what they should be.
fn outputs(width: u32) -> Design {
    Design::of(|| {
        let words = (("x", Bits::input(width)), ("y", Bits::input(width)));
        let numbers = (("a", Int::input(width)), ("b", Int::input(width)));
        module("all", "top", (words, numbers), |((x, y), (a, b))| {
            let words = vec![
                x + y,
                x - y,
                x & y,
                x | y,
                x ^ y,
                !x,
                x.left_by(y),
                x.right_by(y),
                x.less(y).select(x, y),
            ];
            let numbers = vec![a + b, a - b, a.right_by(y), a.less(b).select(a, b)];
            let flags = vec![x.equals(y), a.equals(b), a.is_negative(), x.top()];
            let wide =
                (width < 60).then(|| (a.extend(60), join([x.bit(0), x.low(1)]), x.extend(60)));
            (
                (("word", words), ("number", numbers)),
                (
                    ("flag", flags),
                    ("wide", wide.map_or(vec![], |(a, ..)| vec![a])),
                    ("more", wide.map_or(vec![], |(_, join, x)| vec![join, x])),
                ),
            )
        });
    })
}

proptest! {
    /// Every operation is that of whole numbers, modulo the width.
    #[test]
    fn operations_are_those_of_numbers(width in 1u32..=64, x: u64, y: u64, a: u64, b: u64, shift in 0u64..70) {
        let mask = u64::MAX >> (64 - width);
        let y = if shift < 66 && x % 3 == 0 { shift } else { y };
        let mut simulator = Simulator::new(&outputs(width));
        for (name, value) in [("x", x), ("y", y), ("a", a), ("b", b)] {
            let port = simulator.port(name);
            simulator.set(port, value);
        }
        let [x, y, a, b] = [x, y, a, b].map(|value| value & mask);
        let number = |bits: u64| i128::from(bits) - if bits >> (width - 1) == 1 { 1i128 << width } else { 0 };
        let (wide_x, wide_y) = (u128::from(x), u128::from(y));
        let shifted = |left: bool| match (y < 64, left) {
            (true, true) => wide_x << y,
            (true, false) => wide_x >> y,
            (false, _) => 0,
        };
        let words = [
            wide_x + wide_y,
            (wide_x + (1 << 64)) - wide_y,
            wide_x & wide_y,
            wide_x | wide_y,
            wide_x ^ wide_y,
            u128::from(!x),
            shifted(true),
            shifted(false),
            wide_x.min(wide_y),
        ];
        let (a, b) = (number(a), number(b));
        let numbers = [a + b, a - b, a >> y.min(127), a.min(b)];
        let flags = [x == y, a == b, a < 0, x >> (width - 1) == 1];
        let words = words.iter().map(|v| *v as u64 & mask);
        let numbers = numbers.iter().map(|v| *v as u64 & mask);
        let flags = flags.iter().map(|v| u64::from(*v));
        let groups = [("word", words.collect::<Vec<_>>()), ("number", numbers.collect()), ("flag", flags.collect())];
        for (group, expected) in groups {
            for (index, expected) in expected.into_iter().enumerate() {
                let port = simulator.port(&format!("{group}_{index}"));
                prop_assert_eq!(simulator.get(port), expected, "{} {}", group, index);
            }
        }
        if width < 60 {
            let [wide, joined, more] = ["wide_0", "more_0", "more_1"].map(|name| simulator.port(name));
            prop_assert_eq!(simulator.get(wide), a as u64 & (u64::MAX >> 4));
            prop_assert_eq!(simulator.get(joined), (x & 1) * 3);
            prop_assert_eq!(simulator.get(more), x);
        }
    }

    /// Products have the bits of both factors.
    #[test]
    fn products_are_whole(one in 1u32..=32, other in 1u32..=32, x: u64, y: u64) {
        let design = Design::of(|| {
            let words = (("x", Bits::input(one)), ("y", Bits::input(other)));
            let numbers = (("a", Int::input(one)), ("b", Int::input(other)));
            module("products", "top", (words, numbers), |((x, y), (a, b))| {
                (("word", x * y), ("number", a * b))
            });
        });
        let mut simulator = Simulator::new(&design);
        let [x, y] = [x >> (64 - one), y >> (64 - other)];
        for (name, value) in [("x", x), ("y", y), ("a", x), ("b", y)] {
            let port = simulator.port(name);
            simulator.set(port, value);
        }
        let number = |bits: u64, width: u32| bits as i64 - if bits >> (width - 1) == 1 { 1i64 << width } else { 0 };
        let [word, product] = ["word", "number"].map(|name| simulator.port(name));
        prop_assert_eq!(simulator.get(word), x * y);
        let mask = u64::MAX >> (64 - one - other);
        prop_assert_eq!(simulator.get(product), (number(x, one) * number(y, other)) as u64 & mask);
    }

    /// A memory gives what was written before the last clock; where collisions are upset, the inverted word instead.
    #[test]
    fn a_memory_reads_before_it_writes(
        steps in prop::collection::vec((any::<bool>(), 0u64..8, 0u64..256, 0u64..8), 1..60),
    ) {
        let design = Design::of(|| {
            let place = || Bits::input(3);
            let ports = (("write", Bits::input(1)), ("at", place()), ("data", Bits::input(8)), ("read", place()));
            module("words", "top", ports, |(write, at, data, read)| {
                ("value", memory("kept", 8, (write, at, data), read))
            });
        });
        let [plain, upset] = [Simulator::new(&design), Simulator::new(&design).with_upset_collisions()];
        for (mut simulator, inverted) in [(plain, 0), (upset, 0xff)] {
            let [write, at, data, read, value] =
                ["write", "at", "data", "read", "value"].map(|name| simulator.port(name));
            let mut words = [0; 8];
            for &(writes, place, word, from) in &steps {
                for (port, value) in [(write, u64::from(writes)), (at, place), (data, word), (read, from)] {
                    simulator.set(port, value);
                }
                simulator.clock();
                let collides = writes && place == from;
                let wanted = words[from as usize] ^ if collides { inverted } else { 0 };
                prop_assert_eq!(simulator.get(value), wanted);
                if writes {
                    words[place as usize] = word;
                }
            }
        }
    }
}
