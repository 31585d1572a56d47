//! Diffuse and specular factor of one light.

use super::attenuation::LOSS_BITS;
use super::clocks::{FACTORS, HIGHLIGHT, LOGARITHMS, LOSS, PRODUCTS};
use super::sent_light::Factors;
use super::sight::Sight;
use crate::arith::{
    PRODUCT, Vector, logarithm, logarithm_of_square, power_of_two, product, scalar_product,
};
use imogene_hdl::{Bits, Int, Value, module, net, ports};

/// Bits of a sum of logarithms.
const SUM: u32 = 32;
/// Bits of a loss times an exponent.
const POWER: u32 = 36;
/// Bits of a component of the vector to a light.
pub(super) const COMPONENT: u32 = 30;

/// The cosine between normal and light, and the power of the cosine between mirrored light and viewer, with
/// attenuation; 0 where the light does not reach.
///
/// By the [clocks](super::clocks) the flags come with the pixel, the vector to the light with the others, the exponent
/// with the loss of the highlight, and the attenuation with all loss. Latency [`FACTORS`]. Section 8.3 of the
/// architecture.
pub(super) fn light_factors(
    at: &str,
    (source, vector): (Bits, Vector),
    sight: Sight,
    flags: Bits,
    (exponent, attenuation): (Bits, Bits),
) -> Factors {
    let late = ports!(exponent, attenuation);
    let inputs = (ports!(source, vector), sight, ("flags", flags), late);
    module("light_factors", at, inputs, |(own, sight, flags, late)| {
        let ((source, full), (exponent, attenuation)) = (own, late);
        let reach = flags.right_by(source).bit(0);
        let reach = reach.delayed_as("reach", PRODUCTS + 2);
        let high = full.map(|part| part.slice(COMPONENT - 1, 12).int());
        let low = full.map(|part| part.slice(11, 0).extend(18).int());
        let normal_high = scalar_product("normal_high", sight.normal, high);
        let normal_low = scalar_product("normal_low", sight.normal, low);
        let light_square = scalar_product("light_square", high, high);
        let ray_light = scalar_product("ray_light", sight.ray, high);
        let is_positive = |number: Int| Int::new(0, number.width()).less(number);
        net! {
            // The sign of the whole product: what the low parts leave behind the point counts.
            let kept_exact = (normal_high + normal_low.slice(37, 12).int().extend(38)).reg();
            let kept_rest = (!normal_low.slice(11, 0).is(0)).reg();
            let kept_turned = sight.turned.reg();
            let is_before = is_positive(kept_exact) | (kept_exact.is(0) & kept_rest);
            let kept_lit = kept_turned.select(kept_exact.is_negative(), is_before).reg();
            let along = normal_high.slice(34, 10).int();
            let kept_unturned = along.reg();
            let opposite = Int::new(0, 25) - kept_unturned;
            let kept_along = kept_turned.select(opposite, kept_unturned).reg();
            let kept_magnitude = kept_along.slice(23, 0).reg();
            let kept_is_along = is_positive(kept_along).reg();
            let back = ray_light.slice(36, 12).int();
            let turn = product("turn", sight.across, along);
            let straight = product("straight", sight.square, back);
            let kept_difference = (straight - turn).reg();
            let cosine = kept_difference.slice(49, 20).int();
            let gate = kept_lit & reach;
        }
        let diffuse_gate = gate.delayed_as("gate_along", 1) & kept_is_along;
        let diffuse_gate = diffuse_gate.delayed_as("diffuse_gate", FACTORS - 1 - PRODUCTS - 3);
        let specular_gate = gate.delayed_as("gate_late", PRODUCT - 1) & is_positive(cosine);
        let specular_gate =
            specular_gate.delayed_as("specular_gate", FACTORS - 2 - PRODUCTS - PRODUCT);
        let wide = |number: Int| number.extend(SUM);
        let light_log = wide(logarithm_of_square(
            "light_logarithm",
            light_square.slice(35, 0),
        ));
        let along_log = wide(logarithm("along_logarithm", kept_magnitude));
        let cosine_log = wide(logarithm("cosine_logarithm", cosine.bits()));
        let (normal_log, ray_log) = (wide(sight.normal_log), wide(sight.ray_log));
        let most = Bits::new((1 << LOSS_BITS) - 1, LOSS_BITS);
        net! {
            let pair = normal_log + light_log;
            let kept_pair = pair.reg();
            let kept_other = (normal_log + ray_log).reg();
            let kept_four = (kept_pair + kept_other).reg();
            let kept_pair_cut = (kept_pair - Int::new(20 << 20, SUM)).delay(2);
            let kept_four_cut = (kept_four - Int::new(82 << 20, SUM)).delay(PRODUCT - 1);
            let kept_diffuse = (kept_pair_cut - (along_log + along_log)).reg();
            let kept_specular = (kept_four_cut - (cosine_log + cosine_log)).reg();
            let is_less = kept_specular.slice(SUM - 1, LOSS_BITS).is(0);
            let specular_loss = is_less.select(kept_specular.slice(LOSS_BITS - 1, 0), most);
        }
        let loss = |sum: Int, loss: Bits| {
            let none = Bits::new(0, loss.width());
            sum.is_negative().select(none, loss).reg()
        };
        let diffuse_loss = loss(kept_diffuse, kept_diffuse.bits());
        let diffuse_loss = diffuse_loss.delayed_as("diffuse_loss", LOSS - LOGARITHMS - 5);
        net! {
            let kept_specular_loss = loss(kept_specular, specular_loss);
            let whole_power = product("power_product", signed(kept_specular_loss), signed(exponent));
        }
        let power = whole_power.slice(POWER - 1, 0);
        let power = power.delayed_as("power", LOSS - HIGHLIGHT - (PRODUCT - 1));
        let loss = |loss: Bits| (loss.extend(POWER) + attenuation.extend(POWER)).reg();
        let diffuse = power_of_two("diffuse_power", loss(diffuse_loss));
        let specular = power_of_two("specular_power", loss(power));
        let nothing = Bits::new(0, 17);
        Factors {
            diffuse: diffuse_gate.select(diffuse, nothing).reg(),
            specular: specular_gate.select(specular, nothing).reg(),
        }
    })
}

/// A word that is not negative as a number.
fn signed(word: Bits) -> Int {
    word.extend(word.width() + 1).int()
}
