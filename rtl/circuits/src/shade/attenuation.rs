//! Attenuation with the distance from the viewer.

use super::Fog;
use super::clocks::LOGARITHMS;
use crate::arith::{LOGARITHM, LOGARITHM_OF_SUM, logarithm, logarithm_of_sum};
use imogene_hdl::{Bits, Int, Value, join, module, net, ports};

/// Bits of the sums.
const SUM: u32 = 32;
/// Bits of the loss.
pub(super) const LOSS_BITS: u32 = 26;

/// The loss `log2(1 + d / k)`, 21 bits after the point, at most 32 less one unit; 0 if the attenuation is off.
///
/// With `e = log2(d / k)` the loss is `max(e, 0) + log2(1 + 2^-|e|)`. `far` is what is left of the way to the far
/// end, a clock after the pixel; logarithm and places of the line of sight come with the logarithms, and the loss by
/// [`LOSS`](super::clocks::LOSS). Section 8.3 of the architecture.
pub(super) fn attenuation(
    at: &str,
    fog: Fog,
    far: Bits,
    (ray_log, ray_places): (Int, Bits),
) -> Bits {
    let inputs = (fog, ("far", far), ports!(ray_log, ray_places));
    module("attenuation", at, inputs, |(fog, far, ray)| {
        let (ray_log, ray_places) = ray;
        let wide = |number: Int| number.extend(SUM);
        let zero = Int::new(0, SUM);
        let far_log =
            logarithm("logarithm", far).delayed_as("far_late", LOGARITHMS - 1 - LOGARITHM);
        net! {
            let twice_far = wide(far_log) + wide(far_log);
            let wide_offset = wide(fog.offset.slice(29, 1).int());
            let places = join([ray_places, Bits::new(0, 21)]).extend(SUM).int();
            let kept_near = (wide(ray_log) - places).reg();
            let kept_far = (wide_offset - twice_far).reg();
            let kept_e = (kept_near + kept_far).reg();
            let opposite = zero - kept_e;
            let magnitude = kept_e.is_negative().select(opposite, kept_e).bits().reg();
            let fall = logarithm_of_sum("curve", magnitude);
        }
        let late = kept_e.delayed_as("e_late", LOGARITHM_OF_SUM);
        net! {
            let rise = late.is_negative().select(zero, late).reg();
            let sum = (join([fall, Bits::new(0, 3)]).extend(SUM).int() + rise).reg();
            let is_less = sum.slice(SUM - 1, LOSS_BITS).is(0);
        }
        let most = Bits::new((1 << LOSS_BITS) - 1, LOSS_BITS);
        let loss = is_less.select(sum.slice(LOSS_BITS - 1, 0), most);
        let loss = fog.is_on.select(loss, Bits::new(0, LOSS_BITS)).reg();
        ("loss", loss)
    })
}
