//! The quadric object processor.

use super::Description;
use super::normal::normal_words;
use super::patch::plane_kind;
use super::zone::{Timing, golden, held};
use crate::signal::Signal;
use crate::stimulus::word;
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::{
    PlaneWords, QuadricProcessor as Golden, QuadricWords, ScreenBox, latency,
};
use imogene_golden::unit::interval::Class;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use proptest::prelude::*;

/// Where the ports begin, in their order.
pub(super) mod port {
    pub const F1: usize = 5;
    pub const F2: usize = 8;
    pub const NORMAL: usize = 14;
    pub const BOX: usize = 26;
    pub const SHIFT: usize = 30;
    pub const CLASS: usize = 31;
    pub const PLANES: usize = 32;
    /// Ports of one plane: kind, a, b, c, nx, ny, nz.
    pub const PLANE: usize = 7;
}

pub(super) fn quadric_processor(
    format: Format,
    planes: usize,
    rows_per_stage: usize,
) -> Description {
    let timing = Timing::of(latency(&format, planes, rows_per_stage as u32));
    Description {
        golden: golden(timing, 6, move |i| {
            Box::new(Golden::zone_start(&words_of(i, planes), &format))
        }),
        stimulus: zones,
    }
}

/// The golden model's words from the port values.
pub(super) fn words_of(i: &[i64], planes: usize) -> QuadricWords {
    let w = |k: usize| i128::from(i[k]);
    let (a, b) = (w(port::F2) / 2, w(port::F2 + 1) / 2);
    let plane = |p: usize| {
        let at = port::PLANES + port::PLANE * p;
        PlaneWords {
            kind: plane_kind(i[at]),
            depth: Linear::new(w(at + 1), w(at + 2), w(at + 3)),
            normal: [4, 5, 6].map(|k| i[at + k] as i16),
        }
    };
    QuadricWords {
        class: [Class::Side, Class::Front, Class::Patch, Class::Prism][i[port::CLASS] as usize],
        screen_box: ScreenBox {
            x0: i[port::BOX],
            x1: i[port::BOX + 1],
            y0: i[port::BOX + 2],
            y1: i[port::BOX + 3],
        },
        f1: Linear::new(w(port::F1), w(port::F1 + 1), w(port::F1 + 2)),
        f2: Quadratic {
            a,
            b,
            c: w(port::F2 + 2),
            d: w(port::F2 + 4) - a,
            e: w(port::F2 + 3) - b,
            f: w(port::F2 + 5),
        },
        normal: normal_words(&i[port::NORMAL..], i[port::SHIFT]),
        planes: (0..planes).map(plane).collect(),
    }
}

/// One zone of random size with one set of words: full-range words, or a plausible object whose depths, silhouette and planes meet on
/// the zone, so that every branch is reached.
fn zones(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let any_words: Vec<_> = subject.inputs[port::F1..].iter().map(word).collect();
    let inputs = subject.inputs.clone();
    let words = prop_oneof![
        1 => any_words.prop_map(even_differences),
        4 => plausible(&inputs[port::F1..]).prop_map(even_differences),
    ];
    held(words.boxed(), clocks)
}

pub(super) fn even_differences(mut words: Vec<i64>) -> Vec<i64> {
    words[port::F2 - port::F1] &= !1;
    words[port::F2 - port::F1 + 1] &= !1;
    words
}

/// Words of an object about the middle of a small zone: depths of a few thousand units, planes through them.
pub(super) fn plausible(ports: &[Signal]) -> BoxedStrategy<Vec<i64>> {
    let one = |signal: &Signal| -> BoxedStrategy<i64> {
        let spread = |range: i64| (-range..=range).boxed();
        match signal.name.as_str() {
            "f1_a" | "f1_b" => spread(300),
            "f1_c" => spread(20_000),
            "f2_a2" | "f2_b2" => spread(1 << 18),
            "f2_c" => spread(1 << 16),
            "f2_i0" | "f2_p0" => spread(1 << 22),
            "f2_f" => spread(1 << 26),
            "box_x0" | "box_y0" => (0i64..4).boxed(),
            "box_x1" | "box_y1" => (4i64..30).boxed(),
            "shift" => (0i64..3).boxed(),
            name if name.ends_with("_a") || name.ends_with("_b") => spread(2_000),
            name if name.starts_with("plane_") && name.ends_with("_c") => spread(20_000),
            _ => word(signal),
        }
    };
    ports.iter().map(one).collect::<Vec<_>>().boxed()
}
