//! What a surface sends back of one light.

use super::factor;
use crate::video::Colour;
use imogene_hdl::{Bits, Value, bundle, bundles, module, net};

bundle! {
    /// Factors of one light at a pixel.
    Factors() {
        diffuse: Bits(17), "diffuse factor";
        specular: Bits(17), "specular factor";
    }
}

bundles! {
    /// What a material sends back.
    #[derive(Copy)]
    Material {
        mirror: Bits as "mirror", "mirrored share";
        share: Colour as "share", "diffused share";
    }
}

/// Latency of what is sent back: a product, a sum, a product, with a register before each product and, for the wires
/// to what adds it, two behind.
pub(super) const SENT_LIGHT: u32 = 7;

/// `colour (share diffuse + mirror specular)` for red, green, blue, 21 bits after the point.
///
/// The sum of the products has 33 bits after the point, of which 16 are kept. Latency [`SENT_LIGHT`].
pub(super) fn sent_light(at: &str, factors: Factors, material: Material, colour: Colour) -> Colour {
    let inputs = (factors, material, ("colour", colour));
    module("sent_light", at, inputs, |(factors, material, colour)| {
        let product =
            |one: Bits, other: Bits| (factor(one).reg() * factor(other).reg()).reg().reg();
        net! { let mirrored = product(material.mirror, factors.specular); }
        let level = |share: Bits, colour: Bits| {
            net! {
                let diffused = product(share, factors.diffuse);
                let sent = (diffused + mirrored).slice(33, 17).reg();
            }
            product(sent, colour).bits()
        };
        let (share, [r, g, b]) = (material.share, colour.parts());
        let levels = [level(share.r, r), level(share.g, g), level(share.b, b)];
        ("level", Colour::of(levels))
    })
}
