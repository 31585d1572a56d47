//! The transparent objects before the visible surface, farthest first.

use super::transparency_stage::TransparencyStage;
use crate::format::MOST_LAYERS;
use crate::kernel::*;

/// Blends `T` transparent objects over a pixel: a [`TransparencyStage`] for each, layer 0 first.
///
/// Layer i is taken `2 i` clocks after the pixel: its processor starts later. The host sorts: on no pixel may a layer be farther than one of a
/// smaller index, unless it is absent or hidden there.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `pixel_depth` | in | `W` bits, depth of the opaque surface |
/// | `pixel_red`, `pixel_green`, `pixel_blue` | in | 8 bits, its colour |
/// | `layer_i_depth` | in | `W` bits, `2 i` clocks after the pixel; `ZMAX` where the object is absent |
/// | `layer_i_red`, `layer_i_green`, `layer_i_blue` | in | 8 bits |
/// | `layer_i_weight` | in | 8 bits, in 255ths |
/// | `depth` | out | `pixel_depth` |
/// | `red`, `green`, `blue` | out | 8 bits |
///
/// Latency `2 T`.
pub struct TransparencyPipeline<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Depth of the opaque surface.
    pub pixel_depth: Signal<In, Int<W>>,
    /// Its red.
    pub pixel_red: Signal<In, Word<8>>,
    /// Its green.
    pub pixel_green: Signal<In, Word<8>>,
    /// Its blue.
    pub pixel_blue: Signal<In, Word<8>>,
    /// Depth of each transparent object.
    pub layer_depth: Vec<Signal<In, Int<W>>>,
    /// Red of each.
    pub layer_red: Vec<Signal<In, Word<8>>>,
    /// Green of each.
    pub layer_green: Vec<Signal<In, Word<8>>>,
    /// Blue of each.
    pub layer_blue: Vec<Signal<In, Word<8>>>,
    /// Part of each.
    pub layer_weight: Vec<Signal<In, Word<8>>>,
    /// Depth of the opaque surface.
    pub depth: Signal<Out, Int<W>>,
    /// Red seen.
    pub red: Signal<Out, Word<8>>,
    /// Green seen.
    pub green: Signal<Out, Word<8>>,
    /// Blue seen.
    pub blue: Signal<Out, Word<8>>,
    stages: Vec<TransparencyStage<W>>,
    _layers: usize,
    _asleep: bool,
}

block! {
    [const W: usize] TransparencyPipeline [W]
    inputs { clock, pixel_depth, pixel_red, pixel_green, pixel_blue, layer_depth, layer_red,
        layer_green, layer_blue, layer_weight }
    parts { depth, red, green, blue, stages }
    data { _layers }
}

impl<const W: usize> TransparencyPipeline<W> {
    /// A pipeline for `layers` transparent objects.
    ///
    /// # Panics
    ///
    /// When `layers` is not in `1..=8`.
    pub fn new(layers: usize) -> Self {
        assert!(
            (1..=MOST_LAYERS).contains(&layers),
            "a transparency pipeline has 1 to {MOST_LAYERS} layers"
        );
        fields! {
            [clock, pixel_depth, pixel_red, pixel_green, pixel_blue, depth, red, green, blue]
            layer_depth: repeat(layers, Default::default),
            layer_red: repeat(layers, Default::default),
            layer_green: repeat(layers, Default::default),
            layer_blue: repeat(layers, Default::default),
            layer_weight: repeat(layers, Default::default),
            stages: repeat(layers, TransparencyStage::default),
            _layers: layers,
        }
    }

    /// Clocks from the pixel to what is seen.
    pub const fn latency(layers: usize) -> usize {
        layers * TransparencyStage::<W>::latency()
    }
}

impl<const W: usize> Logic for TransparencyPipeline<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("transparency_pipeline");
        self.stages[0].pixel_depth.next = self.pixel_depth.val();
        self.stages[0].pixel_red.next = self.pixel_red.val();
        self.stages[0].pixel_green.next = self.pixel_green.val();
        self.stages[0].pixel_blue.next = self.pixel_blue.val();
        for i in 1..self._layers {
            self.stages[i].pixel_depth.next = self.stages[i - 1].depth.val();
            self.stages[i].pixel_red.next = self.stages[i - 1].red.val();
            self.stages[i].pixel_green.next = self.stages[i - 1].green.val();
            self.stages[i].pixel_blue.next = self.stages[i - 1].blue.val();
        }
        for i in 0..self._layers {
            self.stages[i].clock.next = self.clock.val();
            self.stages[i].layer_depth.next = self.layer_depth[i].val();
            self.stages[i].layer_red.next = self.layer_red[i].val();
            self.stages[i].layer_green.next = self.layer_green[i].val();
            self.stages[i].layer_blue.next = self.layer_blue[i].val();
            self.stages[i].layer_weight.next = self.layer_weight[i].val();
            self.depth.next = self.stages[i].depth.val();
            self.red.next = self.stages[i].red.val();
            self.green.next = self.stages[i].green.val();
            self.blue.next = self.stages[i].blue.val();
        }
    }
}

clocked!(TransparencyPipeline<const W: usize>);
