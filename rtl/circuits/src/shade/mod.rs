//! Colours of pixels.

mod attenuation;
mod clocks;
mod flat_shading;
mod form;
mod light_factors;
mod light_vector;
mod lit_sphere;
mod sent_light;
mod shading_processor;
mod sight;
mod transparency;
mod words;

pub use flat_shading::{FlatPoint, flat_shading};
pub use form::Shading;
pub use lit_sphere::{SpherePoint, Tables, lit_sphere, lit_sphere_nearest};
pub use shading_processor::{Lights, Point, Shaded, ShadingLoad, shading_processor};
pub use transparency::{BLEND_LATENCY, Layer, Surface, transparency_pipeline, transparency_stage};

use crate::video::LEVEL;
use imogene_hdl::{Bits, Int, Value};
use words::{Eye, Fog};

/// A word as a factor of the multipliers, which take 18 bits with a sign.
fn factor(word: Bits) -> Int {
    word.extend(18).int()
}
