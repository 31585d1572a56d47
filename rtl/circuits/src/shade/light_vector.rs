//! Vector from the visible point to a light.

use super::light_factors::COMPONENT;
use super::sight::Middle;
use super::words::LightPlace;
use crate::arith::{PRODUCT, Vector, product, product_latency, vector_normaliser};
use imogene_hdl::{Bits, Int, Value, module, net, ports};

/// The vector from a point of the scene to a light, by [`VECTORS`](super::clocks::VECTORS); its place on the screen
/// comes a clock after its depth.
pub(super) fn light_vector(at: &str, light: LightPlace, place: Middle, depth: Int) -> Vector {
    let inputs = (light, ("place", place), ("depth", depth));
    module("light_vector", at, inputs, |(light, place, depth)| {
        let nowhere = Bits::new(0, COMPONENT);
        let shifted = |place: Int| {
            let shifted = place.extend(COMPONENT).bits().left_by(light.shift);
            light.point.select(shifted, nowhere).int()
        };
        let component = |name: &str, place: Int, base: Int, slope: Int| {
            light_component(&format!("component_{name}"), depth, place, (base, slope))
        };
        let (base, slope) = (light.base, light.slope);
        let vector = Vector {
            x: component("x", shifted(place.x), base.x, slope.x),
            y: component("y", shifted(place.y), base.y, slope.y),
            z: component("z", nowhere.int(), base.z, slope.z),
        };
        vector_normaliser("normaliser", vector).vector
    })
}

/// The vector to a directional light, of a direction that fills its words.
pub(super) fn sun_vector(direction: Vector) -> Vector {
    direction.map(|part| {
        let wide = part.extend(COMPONENT).bits();
        wide.left(COMPONENT - part.width()).int()
    })
}

/// `base - place - ((slope depth) >> 31)` with the depth in the high ones of 32 bits; the shift rounds down. Latency
/// [`PRODUCT`] and one; the place comes a clock after the depth.
fn light_component(at: &str, depth: Int, place: Int, (base, slope): (Int, Int)) -> Int {
    let inputs = ports!(depth, place, base, slope);
    module("light_component", at, inputs, |ports| {
        let (depth, place, base, slope) = ports;
        // The slope stays, so a product of a short depth may begin later.
        let depth = depth.delay(PRODUCT - product_latency(depth.width()));
        net! {
            let whole_product = product("deep", slope, depth);
            let kept_place = place.reg();
            let kept_rest = (base.extend(COMPONENT) - kept_place).delay(PRODUCT - 2);
        }
        // What is left of the 31 places when the zeros below the depth are not multiplied.
        let places = depth.width() - 1;
        let deep = whole_product.slice(whole_product.width() - 1, places).int();
        let deep = deep.extend(COMPONENT);
        ("result", (kept_rest - deep).reg())
    })
}
