//! What rust-hdl prints of the plain kernels against the emitted text of the circuits, by Yosys and ABC. Needs the
//! package 'yosys' and fails without it. The longest words under `IMOGENE_FULL=1` alone.

use super::is_full_run;
use imogene_circuits::arith::square_root;
use imogene_circuits::machine::{Candidate, decider, visibility_node};
use imogene_circuits::object::{Cut, Interval, cut_plane};
use imogene_circuits::raster::{Flags, Linear, Quadratic, pe1, pe2};
use imogene_hdl::{Bits, Design, Value, verilog};
use imogene_kernels::*;
use imogene_verif::equivalence::{Text, Verdict, compare};
use rust_hdl::core::prelude::Block;

/// What rust-hdl prints of a kernel.
fn printed<K: Block + Default>() -> String {
    verilog(&mut K::default())
}

/// The module of this name of the network of so many digits, a row for each stage.
fn part(name: &str, digits: u32) -> Design {
    let network = Design::of(|| square_root("top", Bits::input(2 * digits), 1));
    let modules = network.top.all().into_iter();
    let top = modules.filter(|module| module.name == name).last();
    Design {
        top: top.expect("a module of the network"),
    }
}

fn verdict(kernel: &str, circuit: &Design) -> Verdict {
    let modules = circuit.top.all().into_iter();
    let emitted: String = modules.map(|module| verilog::write(&module, "")).collect();
    let texts = [("top", kernel), (&circuit.top.name, &emitted)];
    let [kernel, circuit] = texts.map(|(top, verilog)| Text { top, verilog });
    compare(kernel, circuit).unwrap_or_else(|error| panic!("{error}"))
}

fn assert_same<K: Block + Default, T>(circuit: impl FnOnce() -> T) {
    assert_same_as::<K>(&Design::of(circuit));
}

fn assert_same_as<K: Block + Default>(circuit: &Design) {
    let found = verdict(&printed::<K>(), circuit);
    assert_eq!(found, Verdict::Equal, "{}", std::any::type_name::<K>());
}

/// The kernels of words of a width.
fn assert_words_are_same<const W: usize>() {
    let width = W as u32;
    let candidates = |count: u32| (0..count).map(move |_| Candidate::input(width, 16, 8));
    assert_same::<Pe1<W>, _>(|| pe1("top", Flags::input(), Linear::input(width)));
    assert_same::<Pe2<W>, _>(|| pe2("top", Flags::input(), Quadratic::input(width)));
    assert_same::<CutPlane<W>, _>(|| cut_plane("top", Cut::input(width), Interval::input(width)));
    assert_same::<Decider<W, 16>, _>(|| decider("top", candidates(4).collect()));
    assert_same::<VisibilityNode<W, 16>, _>(|| {
        let [a, b] = [(); 2].map(|()| Candidate::input(width, 16, 8));
        visibility_node("top", a, b)
    });
}

/// The kernels of a root of `K` digits.
fn assert_roots_are_same<const X: usize, const K: usize, const R: usize, const T: usize>() {
    let part = |name| part(name, K as u32);
    assert_same_as::<SquareRootRow<X, K, R, T>>(&part("square_root_row"));
    assert_same_as::<SquareRootStage<X, K, R, T>>(&part("square_root_stage"));
    assert_same_as::<SquareRoot<X, K, R, T>>(&part("square_root"));
}

#[test]
fn kernels_are_the_circuits_at_any_width() {
    assert_words_are_same::<8>();
    assert_words_are_same::<16>();
    if is_full_run() {
        assert_words_are_same::<24>();
    }
}

#[test]
fn kernels_of_the_root_are_the_circuits_at_any_width() {
    assert_roots_are_same::<16, 8, 9, 10>();
    assert_roots_are_same::<32, 16, 17, 18>();
    if is_full_run() {
        assert_roots_are_same::<48, 24, 25, 26>();
    }
}

/// Each text with one fault.
#[test]
fn a_faulty_kernel_is_found() {
    let assert_found = |text: &str, circuit: &Design, faults: &[(&str, &str)]| {
        for (from, to) in faults {
            assert!(text.contains(from), "{from} is not in\n{text}");
            let found = verdict(&text.replacen(from, to, 1), circuit);
            assert!(matches!(found, Verdict::Differs(_)), "{to}: {found:?}");
        }
    };
    let sum = Design::of(|| pe1("top", Flags::input(), Linear::input(16)));
    assert_found(
        &printed::<Pe1<16>>(),
        &sum,
        &[
            ("line_begin + b", "line_begin - b"),
            ("start | line", "start & line"),
            ("q = 16'h0", "q = 16'h1"),
        ],
    );
    let cut = Design::of(|| cut_plane("top", Cut::input(16), Interval::input(16)));
    assert_found(
        &printed::<CutPlane<16>>(),
        &cut,
        &[
            ("zp > zf", "zp >= zf"),
            ("reg signed [15:0] zero", "reg [15:0] zero"),
            ("absent = 16'h7fff", "absent = 16'h8000"),
        ],
    );
    let root = part("square_root", 8);
    assert_found(
        &printed::<SquareRoot<16, 8, 9, 10>>(),
        &root,
        &[
            ("dividend - divisor", "dividend + divisor"),
            ("live_0 = 10'b11", "live_0 = 10'b1"),
        ],
    );
}
