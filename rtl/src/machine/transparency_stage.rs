//! One transparent object before the visible surface.

use super::colour_blend::ColourBlend;
use crate::kernel::*;

/// Blends the colour of a transparent object with that of the pixel, if the object is nearer than the opaque surface.
///
/// The depth handed on is that of the opaque surface: of transparent objects that come farthest first each is nearer than the last one blended, so
/// only the opaque surface can hide it. An object at the depth of the surface is hidden, as is an absent one, whose depth is `ZMAX`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `pixel_depth` | in | `W` bits, depth of the opaque surface |
/// | `pixel_red`, `pixel_green`, `pixel_blue` | in | 8 bits, what is seen so far |
/// | `layer_depth` | in | `W` bits, `ZMAX` where the transparent object is absent |
/// | `layer_red`, `layer_green`, `layer_blue` | in | 8 bits |
/// | `layer_weight` | in | 8 bits, t: the part of the transparent object in 255ths; 255 is opaque |
/// | `depth` | out | `pixel_depth` |
/// | `red`, `green`, `blue` | out | 8 bits |
///
/// Latency 2.
#[derive(Default)]
pub struct TransparencyStage<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Depth of the opaque surface.
    pub pixel_depth: Signal<In, Int<W>>,
    /// Red so far.
    pub pixel_red: Signal<In, Word<8>>,
    /// Green so far.
    pub pixel_green: Signal<In, Word<8>>,
    /// Blue so far.
    pub pixel_blue: Signal<In, Word<8>>,
    /// Depth of the transparent object.
    pub layer_depth: Signal<In, Int<W>>,
    /// Its red.
    pub layer_red: Signal<In, Word<8>>,
    /// Its green.
    pub layer_green: Signal<In, Word<8>>,
    /// Its blue.
    pub layer_blue: Signal<In, Word<8>>,
    /// Its part in 255ths.
    pub layer_weight: Signal<In, Word<8>>,
    /// Depth of the opaque surface.
    pub depth: Signal<Out, Int<W>>,
    /// Red seen.
    pub red: Signal<Out, Word<8>>,
    /// Green seen.
    pub green: Signal<Out, Word<8>>,
    /// Blue seen.
    pub blue: Signal<Out, Word<8>>,
    is_nearer: Signal<Local, Bit>,
    kept_depth: DFF<Int<W>>,
    late_depth: DFF<Int<W>>,
    blend_red: ColourBlend,
    blend_green: ColourBlend,
    blend_blue: ColourBlend,
    _asleep: bool,
}

block! {
    [const W: usize] TransparencyStage [W]
    inputs { clock, pixel_depth, pixel_red, pixel_green, pixel_blue, layer_depth, layer_red,
        layer_green, layer_blue, layer_weight }
    parts { depth, red, green, blue, is_nearer, kept_depth, late_depth, blend_red, blend_green,
        blend_blue }
    data { }
}

impl<const W: usize> TransparencyStage<W> {
    /// Clocks from the pixel to what is seen.
    pub const fn latency() -> usize {
        ColourBlend::latency()
    }
}

impl<const W: usize> Logic for TransparencyStage<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("transparency_stage");
        clock!(
            self,
            clock,
            kept_depth,
            late_depth,
            blend_red,
            blend_green,
            blend_blue
        );
        self.is_nearer.next = self.layer_depth.val() < self.pixel_depth.val();
        self.kept_depth.d.next = self.pixel_depth.val();
        self.late_depth.d.next = self.kept_depth.q.val();
        self.blend_red.front.next = self.layer_red.val();
        self.blend_red.behind.next = self.pixel_red.val();
        self.blend_red.weight.next = self.layer_weight.val();
        self.blend_red.is_seen.next = self.is_nearer.val();
        self.blend_green.front.next = self.layer_green.val();
        self.blend_green.behind.next = self.pixel_green.val();
        self.blend_green.weight.next = self.layer_weight.val();
        self.blend_green.is_seen.next = self.is_nearer.val();
        self.blend_blue.front.next = self.layer_blue.val();
        self.blend_blue.behind.next = self.pixel_blue.val();
        self.blend_blue.weight.next = self.layer_weight.val();
        self.blend_blue.is_seen.next = self.is_nearer.val();
        self.depth.next = self.late_depth.q.val();
        self.red.next = self.blend_red.blend.val();
        self.green.next = self.blend_green.blend.val();
        self.blue.next = self.blend_blue.blend.val();
    }
}

clocked!(TransparencyStage<const W: usize>);
