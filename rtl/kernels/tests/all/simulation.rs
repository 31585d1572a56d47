//! The kernels in rust-hdl's own simulation against the circuits in ours: equal words on every clock.

use crate::support::{Kernel, difference};
use imogene_circuits::arith::square_root;
use imogene_circuits::machine::{self, decider, visibility_node};
use imogene_circuits::object::{Cut, Interval, cut_plane};
use imogene_circuits::raster::{Flags, Linear, Quadratic, pe1, pe2};
use imogene_hdl::{Bits, Design, Value, module};
use imogene_kernels::*;

kernel!(Pe1<W>, clock, [valid, start, line, a, b, c], [value]);
kernel!(
    Pe2<W>,
    clock,
    [valid, start, line, a2, b2, c, i0, p0, f],
    [value]
);
kernel!(
    SquareRootRow<X, K, R, T>,
    ,
    [pairs, root, remainder, live],
    [next_pairs, next_root, next_remainder]
);
kernel!(
    SquareRootStage<X, K, R, T>,
    clock,
    [pairs, root, remainder, live],
    [next_pairs, next_root, next_remainder]
);
kernel!(SquareRoot<X, K, R, T>, clock, [radicand], [root, remainder]);
kernel!(
    CutPlane<W>,
    clock,
    [kind, surface, number, zp, zf, nf, zb, nb],
    [cut_zf, cut_nf, cut_zb, cut_nb]
);
kernel!(
    VisibilityNode<D, N>,
    clock,
    [
        a.depth, a.id, a.number, a.nx, a.ny, a.nz, b.depth, b.id, b.number, b.nx, b.ny, b.nz
    ],
    [nearest.depth, nearest.id, nearest.number, nearest.nx, nearest.ny, nearest.nz]
);
kernel!(
    Decider<D, N>,
    clock,
    [
        input_0.depth, input_0.id, input_0.number, input_0.nx, input_0.ny, input_0.nz,
        input_1.depth, input_1.id, input_1.number, input_1.nx, input_1.ny, input_1.nz,
        input_2.depth, input_2.id, input_2.number, input_2.nx, input_2.ny, input_2.nz,
        input_3.depth, input_3.id, input_3.number, input_3.nx, input_3.ny, input_3.nz
    ],
    [nearest.depth, nearest.id, nearest.number, nearest.nx, nearest.ny, nearest.nz]
);

const CLOCKS: usize = 2000;

fn assert_same<K: Kernel, T>(circuit: impl FnOnce() -> T) {
    assert_same_as::<K>(&Design::of(circuit));
}

fn assert_same_as<K: Kernel>(circuit: &Design) {
    let found = difference::<K>(circuit, CLOCKS);
    assert_eq!(found, None, "{}", std::any::type_name::<K>());
}

/// A module of the network of so many digits.
fn part(name: &str, digits: u32) -> Design {
    let network = Design::of(|| square_root("top", Bits::input(2 * digits), 1));
    let modules = network.top.all().into_iter();
    let top = modules.filter(|module| module.name == name).last();
    Design {
        top: top.expect("a module of the network"),
    }
}

fn candidates(count: usize, depth: u32) -> Vec<machine::Candidate> {
    (0..count)
        .map(|_| machine::Candidate::input(depth, 16, 8))
        .collect()
}

#[test]
fn pe1_is_the_circuit() {
    let circuit = |width: u32| move || pe1("top", Flags::input(), Linear::input(width));
    assert_same::<Pe1<8>, _>(circuit(8));
    assert_same::<Pe1<16>, _>(circuit(16));
    assert_same::<Pe1<24>, _>(circuit(24));
}

#[test]
fn pe2_is_the_circuit() {
    let circuit = |width: u32| move || pe2("top", Flags::input(), Quadratic::input(width));
    assert_same::<Pe2<8>, _>(circuit(8));
    assert_same::<Pe2<16>, _>(circuit(16));
    assert_same::<Pe2<24>, _>(circuit(24));
    // Above 32 bits rust-hdl counts otherwise; so long is the word of the 24-bit format.
    assert_same::<Pe2<48>, _>(circuit(48));
}

#[test]
fn a_square_root_row_is_the_circuit() {
    assert_same_as::<SquareRootRow<16, 8, 9, 10>>(&part("square_root_row", 8));
    assert_same_as::<SquareRootRow<32, 16, 17, 18>>(&part("square_root_row", 16));
    assert_same_as::<SquareRootRow<48, 24, 25, 26>>(&part("square_root_row", 24));
}

#[test]
fn a_square_root_stage_is_the_circuit() {
    assert_same_as::<SquareRootStage<16, 8, 9, 10>>(&part("square_root_stage", 8));
    assert_same_as::<SquareRootStage<32, 16, 17, 18>>(&part("square_root_stage", 16));
    assert_same_as::<SquareRootStage<48, 24, 25, 26>>(&part("square_root_stage", 24));
}

#[test]
fn the_square_root_is_the_circuit() {
    assert_same_as::<SquareRoot<16, 8, 9, 10>>(&part("square_root", 8));
    assert_same_as::<SquareRoot<32, 16, 17, 18>>(&part("square_root", 16));
    assert_same_as::<SquareRoot<48, 24, 25, 26>>(&part("square_root", 24));
}

#[test]
fn the_cut_plane_is_the_circuit() {
    let circuit = |width: u32| move || cut_plane("top", Cut::input(width), Interval::input(width));
    assert_same::<CutPlane<8>, _>(circuit(8));
    assert_same::<CutPlane<16>, _>(circuit(16));
    assert_same::<CutPlane<24>, _>(circuit(24));
}

#[test]
fn the_visibility_node_is_the_circuit() {
    let circuit = |depth: u32| {
        move || {
            let both = candidates(2, depth);
            visibility_node("top", both[0], both[1])
        }
    };
    assert_same::<VisibilityNode<8, 16>, _>(circuit(8));
    assert_same::<VisibilityNode<16, 16>, _>(circuit(16));
    assert_same::<VisibilityNode<24, 16>, _>(circuit(24));
}

#[test]
fn the_decider_is_the_circuit() {
    let circuit = |depth: u32| move || decider("top", candidates(4, depth));
    assert_same::<Decider<8, 16>, _>(circuit(8));
    assert_same::<Decider<16, 16>, _>(circuit(16));
    assert_same::<Decider<24, 16>, _>(circuit(24));
}

/// The comparison finds a circuit that exchanges the increments.
#[test]
fn another_circuit_is_found() {
    let ports = || (Flags::input(), Linear::input(16));
    let exchanged = Design::of(|| {
        module("pe1", "top", ports(), |(flags, Linear { a, b, c })| {
            ("value", pe1("inner", flags, Linear { a: b, b: a, c }))
        })
    });
    let found = difference::<Pe1<16>>(&exchanged, CLOCKS);
    assert!(found.is_some_and(|text| text.starts_with("clock ")));
}
