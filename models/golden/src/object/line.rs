//! The quadric processor over whole lines, for pictures: the same values as [`super::quadric`], many pixels at a time,
//! visiting only the pixels of the screen box.

use super::lanes::draw_line;
use super::quadric::{ObjectPixel, QuadricWords};
use crate::format::Format;

/// Vector instructions that the lanes are compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Instructions {
    /// Those that every processor has.
    Any,
    /// 256 bits.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// 512 bits.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Instructions {
    /// All that this processor has, the best last.
    pub fn available() -> impl Iterator<Item = Instructions> {
        #[cfg(target_arch = "x86_64")]
        let all = [Instructions::Any, Instructions::Avx2, Instructions::Avx512];
        #[cfg(not(target_arch = "x86_64"))]
        let all = [Instructions::Any];
        all.into_iter().filter(|&one| one <= Instructions::here())
    }

    /// The best that this processor has.
    #[inline]
    fn here() -> Instructions {
        #[cfg(target_arch = "x86_64")]
        {
            let has_512 =
                is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq");
            if has_512
                && is_x86_feature_detected!("avx512bw")
                && is_x86_feature_detected!("avx512vl")
            {
                return Instructions::Avx512;
            }
            if is_x86_feature_detected!("avx2") {
                return Instructions::Avx2;
            }
        }
        Instructions::Any
    }
}

/// Calls `sink(x, pixel)` for every pixel of line `y` (zone coordinates) at which the object is present, left to right.
pub fn for_each_present(
    words: &QuadricWords,
    format: &Format,
    y: i64,
    sink: impl FnMut(i64, ObjectPixel),
) {
    for_each_present_by(Instructions::here(), words, format, y, sink);
}

/// As [`for_each_present`], with no better instructions than `most`.
#[inline]
pub fn for_each_present_by(
    most: Instructions,
    words: &QuadricWords,
    format: &Format,
    y: i64,
    sink: impl FnMut(i64, ObjectPixel),
) {
    let window = &words.screen_box;
    if window.is_empty() || y < window.y0 || y > window.y1 {
        return;
    }
    match most.min(Instructions::here()) {
        Instructions::Any => draw_line(words, format, y, sink),
        // SAFETY: no better than [`Instructions::here`] has found on this processor.
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx2 => unsafe { avx2(words, format, y, sink) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx512 => unsafe { avx512(words, format, y, sink) },
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2(words: &QuadricWords, format: &Format, y: i64, sink: impl FnMut(i64, ObjectPixel)) {
    draw_line(words, format, y, sink);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl")]
fn avx512(words: &QuadricWords, format: &Format, y: i64, sink: impl FnMut(i64, ObjectPixel)) {
    draw_line(words, format, y, sink);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::object::quadric::{PlaneWords, ScreenBox};
    use crate::object::words::Object;
    use crate::testing::{class, kind, root_form};
    use crate::unit::depth_interval::Class;
    use crate::unit::normal::NormalWords;
    use crate::unit::pe1::Linear;
    use crate::unit::pe2::Quadratic;
    use crate::unit::root::fast_root;
    use imogene_contract::{MachineWords, RootForm};
    use proptest::prelude::*;

    /// Columns of the zones: several times as many as there are lanes.
    const WIDTH: i64 = 200;
    const HEIGHT: i64 = 3;

    /// Every word of the machine at any width.
    fn format() -> impl Strategy<Value = Format> {
        // Equal depths are seldom unless words are short.
        let depth = prop_oneof![8u32..=10, 8u32..=32];
        let own = depth.prop_flat_map(|depth| {
            let root = prop_oneof![1 => 4..=depth, 1 => Just(depth)];
            let own = (root, depth..=depth + 12, 10u32..=16);
            own.prop_map(move |(root, plane, normal)| (depth, root, plane, normal))
        });
        let last = prop_oneof![1 => 0u32..=8, 1 => Just(0)];
        let widths = (own, 0u32..=16, 0u32..=16, last).prop_map(
            |((depth, root, plane, normal), g1, g2, last)| MachineWords {
                plane,
                normal,
                root,
                // The 32-bit word leaves no room for guard bits of f2, and none is narrower than what it rests on.
                guard_quadratic: g2.min(64 - 2 * root),
                guard_linear: g1,
                dropped_rows: last.min(root - 1),
                ..MachineWords::of(depth)
            },
        );
        widths.prop_flat_map(|widths| {
            let forms = root_form(widths.root - widths.dropped_rows);
            forms.prop_map(move |root_form| {
                let widths = MachineWords {
                    root_form,
                    ..widths
                };
                Format::fitted(&widths).unwrap()
            })
        })
    }

    /// The same, now and then with accumulators that are too short for what the machine's words need.
    fn any_format() -> impl Strategy<Value = Format> {
        let shorter = |longest: u32| prop_oneof![1 => Just(longest), 1 => 8..=longest];
        let short = move |format: Format| {
            let widths = [format.sum, format.quadratic, format.plane].map(shorter);
            let short = widths.prop_map(move |[sum, quadratic, plane]| Format {
                sum,
                quadratic,
                plane,
                ..format
            });
            prop_oneof![2 => Just(format), 1 => short]
        };
        format().prop_flat_map(short)
    }

    /// A number of at most `bits` bits, of any length, half of them among the longest.
    fn number(bits: u32) -> impl Strategy<Value = i128> {
        let less = prop_oneof![0..3.min(bits), 0..bits];
        let parts = (any::<i64>(), less);
        parts.prop_map(move |(value, less)| i128::from(value) >> (64 - bits + less))
    }

    /// Slopes that cross the zone, or any that wrap.
    fn linear(width: u32) -> impl Strategy<Value = Linear> {
        let slope =
            move || prop_oneof![3 => number(width.saturating_sub(6).max(2)), 1 => number(64)];
        (slope(), slope(), number(width)).prop_map(|(a, b, c)| Linear::new(a, b, c))
    }

    /// Bowls and saddles that change their sign in the zone, or any words.
    fn quadratic(width: u32) -> impl Strategy<Value = Quadratic> {
        let up_to = move |less: u32| number(width.saturating_sub(less).max(2));
        let crossing = [14, 14, 14, 7, 7, 0].map(up_to);
        let any = [(); 6].map(|()| number(64));
        prop_oneof![3 => crossing, 1 => any].prop_map(Quadratic::new)
    }

    fn words(format: Format) -> impl Strategy<Value = QuadricWords> {
        let g = move || linear(format.normal_linear);
        let normal = ([g(), g(), g()], any::<[i16; 3]>(), 0u8..32)
            .prop_map(|(g, k, shift)| NormalWords { g, k, shift });
        let plane = (kind(), linear(format.plane), any::<[i16; 3]>());
        let plane = plane.prop_map(|(kind, depth, normal)| PlaneWords::new(kind, depth, normal));
        // Many planes leave little.
        let most = prop_oneof![3 => 0usize..=2, 1 => 0usize..=12];
        let planes = (prop::collection::vec(plane, 12), most).prop_map(|(mut planes, most)| {
            planes.truncate(most);
            planes
        });
        let side = |most: i64| [0..most, 0..most].prop_map(|[a, b]| [a.min(b), a.max(b)]);
        let window = (side(WIDTH), side(HEIGHT)).prop_map(|(x, y)| ScreenBox::of(x, y));
        let (f1, f2) = (linear(format.pe1_width()), quadratic(format.pe2_width()));
        let parts = (class(), window, f1, f2, normal, planes);
        parts.prop_map(|(class, screen_box, f1, f2, normal, planes)| QuadricWords {
            class,
            screen_box,
            f1,
            f2,
            normal,
            planes,
        })
    }

    fn assert_equal_the_processor(words: &QuadricWords, format: &Format, y: i64) {
        let present = |x| {
            let pixel = words.at(x, y, format);
            (pixel.zf != format.z_max()).then_some((x, pixel))
        };
        let expected: Vec<(i64, ObjectPixel)> = (0..WIDTH).filter_map(present).collect();
        for instructions in Instructions::available() {
            let mut line = vec![];
            let sink = |x, pixel| line.push((x, pixel));
            for_each_present_by(instructions, words, format, y, sink);
            assert_eq!(line, expected, "{instructions:?}");
        }
    }

    /// A square whose root reaches the end of the word, or of 32 bits, in the midst of a line: either sum.
    #[test]
    fn sums_wrap_where_those_of_the_processor_do() {
        for (depth, guards) in [(8, 0), (24, 0), (24, 16), (30, 2), (31, 0), (32, 0)] {
            let format = Format::new(depth).unwrap();
            let format = format.with_guards(guards, 0).unwrap();
            let square = (1i128 << (format.quadratic - 1)) - 1;
            let end = 1 << (format.sum - 1).min(31);
            let middle = end - i128::from(fast_root(square as i64));
            for (class, f1) in Class::ALL
                .into_iter()
                .flat_map(|class| [middle, -middle, end, -end].map(|f1| (class, f1)))
            {
                let words = QuadricWords {
                    class,
                    screen_box: ScreenBox::of([0, WIDTH - 1], [0, 0]),
                    f1: Linear::new(1 << guards, 0, (f1 - i128::from(WIDTH / 2)) << guards),
                    f2: Quadratic::new([0, 0, 0, 0, 0, square]),
                    normal: NormalWords::default(),
                    planes: vec![],
                };
                assert_equal_the_processor(&words, &format, 0);
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn exact_roots_make_the_same_processor(
            (format, words) in any_format().prop_flat_map(|format| (Just(format), words(format))), x in 0..WIDTH
        ) {
            let of = |root_form| words.probe_at(x, 0, &Format { root_form, ..format });
            prop_assert_eq!(of(RootForm::Restoring), of(RootForm::NonRestoring));
        }

        #[test]
        fn lines_equal_the_processor_pixel_by_pixel(
            (format, words) in any_format().prop_flat_map(|format| (Just(format), words(format)))
        ) {
            for y in 0..HEIGHT {
                assert_equal_the_processor(&words, &format, y);
            }
        }
    }
}
