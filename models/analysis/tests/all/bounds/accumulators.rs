use imogene_analysis::bounds::accumulators::{linear_increments, quadratic_increments, root_bits};
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::range::{Range, bits};
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use proptest::prelude::*;

#[test]
fn roots_end_half_a_bit_below_their_word() {
    // Roots of K = 8 bits end at floor(2^7.5) = 181.
    assert_eq!(root_bits((1 << 15) - 1), 8);
    assert_eq!(root_bits(1 << 15), 9);
    assert_eq!((root_bits(0), root_bits(1)), (1, 1));
}

proptest! {
    /// The registers of both processors, run over a screen without ever wrapping.
    #[test]
    fn increments_are_those_of_the_registers(v in proptest::array::uniform6(-9000i128..9000), width in 1i64..12, height in 1i64..12) {
        let [a, b, c, d, e, f] = v;
        let q = Quadratic::new([a, b, c, d, e, f]);
        let screen = ScreenBox::of([0, width - 1], [0, height - 1]);
        let words = q.preconditioned(100);
        let (mut value, mut first, mut down) = (words.f, words.p0, words.i0);
        let [mut j, mut p, mut i, mut line] = [Range::NONE; 4];
        for _ in 0..height {
            (line, p, i) = (line.with(value), p.with(first), i.with(down));
            let mut step = first;
            for _ in 0..width {
                j = j.with(step);
                step += words.a2;
            }
            value += down;
            down += words.b2;
            first += words.c;
        }
        let found = quadratic_increments(&q, &screen);
        prop_assert_eq!([found.j, found.p, found.i, found.line_value], [j, p, i, line].map(|range| range.bits()));
        prop_assert_eq!([found.a2, found.b2, found.c], [words.a2, words.b2, words.c].map(bits));
        let p = Linear::new(a, b, c);
        let lines: Range = (0..height).map(|y| p.wrapped_at(0, y, 100)).collect();
        prop_assert_eq!(linear_increments(&p, &screen).line_value, lines.bits());
    }
}
