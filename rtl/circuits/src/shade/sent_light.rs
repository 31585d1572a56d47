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

/// `colour (share diffuse + mirror specular)` for red, green, blue, 21 bits after the point.
///
/// The sum of the products has 33 bits after the point, of which 16 are kept. Latency 3.
pub(super) fn sent_light(at: &str, factors: Factors, material: Material, colour: Colour) -> Colour {
    let inputs = (factors, material, ("colour", colour));
    module("sent_light", at, inputs, |(factors, material, colour)| {
        net! { let mirrored = (factor(material.mirror) * factor(factors.specular)).reg(); }
        let level = |share: Bits, colour: Bits| {
            net! {
                let diffused = (factor(share) * factor(factors.diffuse)).reg();
                let sent = (diffused + mirrored).slice(33, 17).reg();
            }
            (factor(sent) * factor(colour)).reg().bits()
        };
        let (share, [r, g, b]) = (material.share, colour.parts());
        let levels = [level(share.r, r), level(share.g, g), level(share.b, b)];
        ("level", Colour::of(levels))
    })
}
