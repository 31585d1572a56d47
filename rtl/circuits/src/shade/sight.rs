//! Line of sight and normal at a pixel.

use super::clocks::{LOGARITHMS, VECTORS};
use super::{Eye, factor};
use crate::arith::{NORMALISED, Vector, logarithm_of_square, scalar_product, vector_normaliser};
use crate::object::Normal;
use crate::raster::Pixel;
use imogene_hdl::{Bits, Bundle, Int, Value, bundle, bundles, join, module, net};

bundle! {
    /// A place on the screen.
    Middle() {
        x: Int(13), "half pixels from the middle";
        y: Int(13), "half pixels from the middle";
    }
}

bundles! {
    /// What all lights share, after the [clocks](super::clocks) of their names.
    #[derive(Copy)]
    Sight {
        place: Middle as "place", "place on the screen, 1 clock after the pixel";
        ray: Vector as "ray", "line of sight, VECTORS";
        normal: Vector as "normal", "normal, VECTORS";
        across: Int as "across", "normal times line of sight, PRODUCTS";
        square: Int as "square", "square of the normal, PRODUCTS";
        turned: Bits as "turned", "the normal looks away from the viewer, PRODUCTS";
        normal_log: Int as "normal_log", "logarithm of the square of the normal, LOGARITHMS";
        ray_log: Int as "ray_log", "logarithm of the square of the line of sight, LOGARITHMS";
    }
}

/// Place on the screen, 1 clock after the pixel, and line of sight, 2 clocks after it.
pub(super) fn line_of_sight(pixel: Pixel, eye: Eye) -> (Middle, Vector) {
    let place = |at: Bits, size: Bits| (join([at, Bits::new(0, 1)]) - size).reg().int();
    net! {
        let line = eye.is_field.select(pixel.y.left(1), pixel.y);
        let place_x = place(pixel.x, eye.size_x);
        let place_y = place(line, eye.size_y);
    }
    let along = |place: Int| {
        net! {
            let raised = place.extend(33).bits().left(5);
            let lowered = raised.right_by(eye.view_shift);
        }
        let none = Bits::new(0, 18);
        eye.perspective.select(lowered.low(18), none).reg().int()
    };
    let place = Middle {
        x: place_x,
        y: place_y,
    };
    let ray = Vector::of([along(place_x), along(place_y), factor(eye.distance)]);
    (place, ray)
}

/// Place on the screen, line of sight and normal in full words, and their products; beside them the places that the
/// line of sight was shifted, with the logarithms. Section 8.2 of the architecture.
pub(super) fn sight(at: &str, pixel: Pixel, normal: Normal, eye: Eye) -> (Sight, Bits) {
    let inputs = (pixel, normal, eye);
    module("sight", at, inputs, |(pixel, normal, eye)| {
        let (place, ray) = line_of_sight(pixel, eye);
        let full = vector_normaliser("ray_normaliser", ray);
        let ray = full.vector.delayed(VECTORS - 2 - NORMALISED);
        let normal = Vector::of(normal.parts()).delayed(VECTORS - NORMALISED);
        let full_normal = vector_normaliser("normal_normaliser", normal).vector;
        let normal = full_normal.map(|part| part.extend(18));
        let normal_square = scalar_product("normal_square", normal, normal).bits();
        let ray_square = scalar_product("ray_square", ray, ray).bits();
        let both = scalar_product("both", normal, ray);
        let sight = Sight {
            place,
            ray,
            normal,
            across: both.slice(34, 10).int(),
            square: normal_square.slice(31, 9).extend(25).int(),
            turned: Int::new(0, 38).less(both),
            normal_log: logarithm_of_square("normal_logarithm", normal_square.low(32)),
            ray_log: logarithm_of_square("ray_logarithm", ray_square.low(36)),
        };
        let places = full
            .places
            .delayed_as("places_late", LOGARITHMS - 2 - NORMALISED);
        (sight, ("ray_places", places))
    })
}
