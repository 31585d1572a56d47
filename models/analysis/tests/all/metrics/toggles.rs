use imogene_analysis::metrics::toggles::{
    Part, count, first_degree, root_stages, sample, second_degree,
};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::normal::NormalWords;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;

#[test]
fn the_sample_is_spread_over_the_screen() {
    assert_eq!(sample(3), [0, 1, 2]);
    assert_eq!(sample(240), [15, 45, 75, 105, 135, 165, 195, 225]);
    assert!(sample(9).iter().all(|line| *line < 9));
}

/// 0, 1, 2, 3: one bit, two bits, one bit.
#[test]
fn a_counter_toggles_as_counters_do() {
    assert_eq!(first_degree(&Linear::new(1, 0, 0), 8, 4), 4);
    // All eight bits from -1 to 0.
    assert_eq!(first_degree(&Linear::new(1, 0, -1), 8, 2), 8);
}

/// Values 0, 1, 4 and increments 1, 3, 5: bits 1 and 2 of the values, 1 and 2 of the increments.
#[test]
fn squares_toggle_in_value_and_increment() {
    let square = Quadratic {
        a: 1,
        ..Default::default()
    };
    assert_eq!(second_degree(&square, 8, 3), (1 + 2) + (1 + 2));
}

/// 13 = 0b1101 in two rows of one digit: after the first, digit 1, remainder 3 - 1, rest 0b01; the root is 3.
#[test]
fn the_root_holds_digits_remainder_and_rest() {
    let format = Format {
        quadratic: 4,
        root: 2,
        ..Format::BASE
    };
    assert_eq!(root_stages(13, 3, &format, 1), [1, 2, 1]);
    assert_eq!(root_stages(13, 3, &format, 2), [0u128; 0]);
}

#[test]
fn words_that_never_change_toggle_nothing() {
    let still = Linear::new(0, 0, 77);
    let words = QuadricWords {
        class: Class::Patch,
        screen_box: ScreenBox::EMPTY,
        f1: still,
        f2: Quadratic {
            f: 1 << 20,
            ..Default::default()
        },
        normal: NormalWords {
            g: [still; 3],
            ..Default::default()
        },
        planes: vec![],
    };
    let counted = |slots: Vec<QuadricWords>, width, height| {
        let whole = Part {
            slots,
            window: ScreenBox::of_screen(width as u32, height as u32),
        };
        count(&[whole], &Format::BASE, 1, height as u32)
    };
    let toggles = counted(vec![words.clone()], 16, 12);
    assert_eq!(toggles.total, 0.0);
    let moving = QuadricWords {
        f1: Linear::new(1, 0, 0),
        ..words
    };
    let toggles = counted(vec![moving.clone(), moving], 3, 1);
    // Two slots of 0, 1, 2: three changes of bits in two clocks each; the sums are the same less and more 1024.
    assert_eq!((toggles.pe1, toggles.pe2, toggles.root), (3.0, 0.0, 0.0));
    assert_eq!(toggles.depth, toggles.total - 3.0);
}
