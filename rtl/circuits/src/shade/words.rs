//! Words of the view and of the lights.

use crate::arith::Vector;
use crate::machine::LoadBus;
use crate::video::{Colour, LEVEL};
use imogene_contract::shading::{ATTENUATION, BACKGROUND, DISTANCE, SIZE, VIEW};
use imogene_hdl::{Bits, bundle, bundles, module};

bundle! {
    /// Where the viewer is.
    Eye() {
        size_x: Bits(13), "columns of the picture";
        size_y: Bits(13), "lines of the picture";
        perspective: Bits(1), "lines of sight meet in the eye";
        is_field: Bits(1), "the lines of the picture count by two";
        view_shift: Bits(4), "places that coordinates are shifted to the right";
        distance: Bits(17), "distance of the eye";
    }

    /// Attenuation with the distance.
    Fog() {
        is_on: Bits(1), "there is one";
        offset: Int(30), "`log2(unit / k)`, 22 bits after the point";
    }
}

bundles! {
    /// Words that all lights share.
    View {
        /// Where the viewer is.
        eye: Eye as "";
        fog: Fog as "", "attenuation";
        background: Colour as "background", "colour of the background";
    }

    /// Where a light is.
    LightPlace {
        point: Bits as "point", "it is at a point";
        shift: Bits as "shift", "units of a half pixel, as a power of two";
        base: Vector as "base", "constant part of the vector to it";
        slope: Vector as "slope", "part that goes with depth";
    }
}

/// Keeps the words of the view. A word is written at the clock edge and holds until written again; all are zero at
/// power-up.
pub(super) fn view_store(at: &str, bus: LoadBus) -> View {
    module("view_store", at, ("load", bus), |bus| View {
        eye: Eye {
            size_x: bus.bits(SIZE, 12, 0),
            size_y: bus.bits(SIZE, 28, 16),
            perspective: bus.bits(VIEW, 0, 0),
            is_field: bus.bits(VIEW, 2, 2),
            view_shift: bus.bits(VIEW, 7, 4),
            distance: bus.bits(DISTANCE, 16, 0),
        },
        fog: Fog {
            is_on: bus.bits(VIEW, 1, 1),
            offset: bus.number(ATTENUATION, 30),
        },
        background: Colour::of(
            [0, 1, 2].map(|level| bus.bits(BACKGROUND, (level + 1) * LEVEL - 1, level * LEVEL)),
        ),
    })
}

/// Keeps the ten words of one light: its flag, its place and its colour. All are zero at power-up: a light that adds
/// nothing.
pub(super) fn light_store(at: &str, bus: LoadBus) -> (Bits, LightPlace, Colour) {
    module("light_store", at, ("load", bus), |bus| {
        let place = LightPlace {
            point: bus.bits(0, 0, 0),
            shift: bus.bits(0, 11, 8),
            base: vector(bus, 1),
            slope: vector(bus, 4),
        };
        (source(bus), place, ("colour", colour(bus)))
    })
}

/// Keeps the words of a directional light: its flag, its direction and its colour.
pub(super) fn sun_store(at: &str, bus: LoadBus) -> (Bits, Vector, Colour) {
    module("sun_store", at, ("load", bus), |bus| {
        (source(bus), vector(bus, 1), ("colour", colour(bus)))
    })
}

fn source(bus: LoadBus) -> (&'static str, Bits) {
    ("source", bus.bits(0, 7, 4))
}

fn vector(bus: LoadBus, first: u64) -> Vector {
    Vector::of([0, 1, 2].map(|index| bus.number(first + index, 28)))
}

fn colour(bus: LoadBus) -> Colour {
    Colour::of([7, 8, 9].map(|word| bus.bits(word, 16, 0)))
}
