use crate::common::*;
use imogene_contract::{MachineWords, RootForm};
use imogene_golden::object::line::{Instructions, for_each_present_by};
use imogene_golden::unit::root::fast_root;

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
            let mut widths = widths;
            widths.root_form = root_form;
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
    let slope = move || prop_oneof![3 => number(width.saturating_sub(6).max(2)), 1 => number(64)];
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
        let with = |class| [middle, -middle, end, -end].map(|f1| (class, f1));
        for (class, f1) in Class::ALL.into_iter().flat_map(with) {
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
