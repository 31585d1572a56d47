//! Every unit that is a design by itself, under the name that the catalogue gives it.

use crate::arith::square_root;
use crate::machine::{
    Beam, Candidate, Load, LoadBus, Slot, Volume, Zone, beam, card_decider, coefficient_store,
    decider, raster_control, shadow_stage, visibility_chain, visibility_node,
};
use crate::object::{
    Cut, Face, Interval, Network, NormalWords, Roots, Shape, Widths, Words, cut_plane,
    depth_interval, normal_unit, plane_depth, quadric_pe, quadric_processor, two_volume_merge,
};
use crate::raster::{Flags, Linear, Pixel, Quadratic, pe1, pe2};
use imogene_contract::parameters::Parameters;
use imogene_contract::words::{NORMAL, NORMAL_PART, depth_sum, plane, quadratic};
use imogene_hdl::{Bits, Design, Value};

/// A unit: its name, and what builds it.
type Unit = (&'static str, fn(&Parameters));

/// The design of a unit; none if no unit is called so.
///
/// # Panics
///
/// With the reason, where the parameters make no circuit.
pub fn design(name: &str, parameters: &Parameters) -> Option<Design> {
    let (_, build) = UNITS.iter().find(|unit| unit.0 == name)?;
    Some(Design::of(|| build(parameters)))
}

/// Widths of the words of an object in a format.
pub fn widths(depth_word: u32) -> Widths {
    let word = depth_word as usize;
    Widths {
        linear: depth_sum(word) as u32,
        quadratic: quadratic(word) as u32,
        gradient: NORMAL_PART as u32,
        normal: NORMAL as u32,
        plane: plane(word) as u32,
    }
}

fn linear(parameters: &Parameters) -> Linear {
    Linear::input(widths(parameters.depth_word).linear)
}

fn quadric(parameters: &Parameters) -> (Linear, Quadratic) {
    let f2 = Quadratic::input(widths(parameters.depth_word).quadratic);
    (linear(parameters), f2)
}

fn network(parameters: &Parameters) -> Network {
    Network {
        digits: parameters.depth_word,
        rows: parameters.depth_word,
        rows_per_stage: parameters.rows_per_stage,
    }
}

fn words(parameters: &Parameters) -> Words {
    Words::input(widths(parameters.depth_word), parameters.planes as usize)
}

fn candidates(parameters: &Parameters, count: u32) -> Vec<Candidate> {
    let candidate = |_| Candidate::input(parameters.depth_word, NORMAL as u32, 8);
    (0..count).map(candidate).collect()
}

/// The units that are circuits of functions.
pub const UNITS: &[Unit] = &[
    ("pe1", |p| {
        pe1("top", Flags::input(), linear(p));
    }),
    ("pe2", |p| {
        pe2("top", Flags::input(), quadric(p).1);
    }),
    ("square_root", |p| {
        let radicand = Bits::input(widths(p.depth_word).quadratic);
        square_root("top", radicand, p.rows_per_stage);
    }),
    ("quadric_pe", |p| {
        let sum = widths(p.depth_word).linear;
        quadric_pe("top", Flags::input(), quadric(p), sum, network(p));
    }),
    ("plane_depth", |p| {
        let words = Linear::input(widths(p.depth_word).plane);
        plane_depth("top", Flags::input(), words, p.depth_word);
    }),
    ("cut_plane", |p| {
        let word = p.depth_word;
        cut_plane("top", Cut::input(word), Interval::input(word));
    }),
    ("depth_interval", |p| {
        let roots = Roots::input(widths(p.depth_word).linear);
        depth_interval("top", roots, p.depth_word);
    }),
    ("two_volume_merge", |p| {
        let [a, b] = [(); 2].map(|()| Interval::input(p.depth_word));
        two_volume_merge("top", a, b);
    }),
    ("normal_unit", |p| {
        let words = NormalWords::of(&words(p));
        normal_unit("top", Flags::input(), Face::input(p.depth_word), words);
    }),
    ("quadric_processor", |p| {
        let shape = Shape {
            depth: p.depth_word,
            root: network(p),
            two_volumes: true,
        };
        quadric_processor("top", Flags::input(), Pixel::input(), words(p), shape);
    }),
    ("raster_control", |_| {
        raster_control("top", Zone::input());
    }),
    ("visibility_node", |p| {
        let both = candidates(p, 2);
        visibility_node("top", both[0], both[1]);
    }),
    ("decider", |p| {
        decider("top", candidates(p, p.objects));
    }),
    ("visibility_chain", |p| {
        visibility_chain("top", candidates(p, p.objects));
    }),
    ("card_decider", |p| {
        let all = candidates(p, p.cards * p.objects);
        card_decider("top", all, p.objects as usize);
    }),
    ("shadow_stage", |p| {
        let volumes = (0..p.objects).map(|_| Volume::input()).collect();
        shadow_stage("top", Bits::input(16), volumes);
    }),
    ("coefficient_store", |p| {
        let widths = widths(p.depth_word);
        let bus = LoadBus::input(widths.quadratic);
        coefficient_store("top", bus, widths, u64::from(p.planes));
    }),
    ("beam", |p| {
        let slot = Slot {
            planes: p.planes as usize,
            two_volumes: true,
        };
        let machine = Beam {
            depth: p.depth_word,
            widths: widths(p.depth_word),
            root: network(p),
            slots: vec![slot; p.objects as usize],
        };
        let load = Load::input(machine.widths.quadratic);
        beam("top", Zone::input(), load, &machine);
    }),
];
