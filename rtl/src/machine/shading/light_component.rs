//! One component of the vector to a light.
use crate::kernel::*;
/// Gives `base - place - ((slope depth) >> 31)`; the shift rounds down.
///
/// Latency 2: the product and the first difference, then the second. Section 8.2 of the architecture.
pub struct LightComponent {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Depth as a fraction, 31 bits after the point.
    pub depth: Signal<In, Int<32>>,
    /// Place on the screen in units of the light.
    pub place: Signal<In, Int<30>>,
    /// Constant part.
    pub base: Signal<In, Int<28>>,
    /// Part that goes with depth.
    pub slope: Signal<In, Int<28>>,
    /// The component.
    pub result: Signal<Out, Int<30>>,
    factor: Signal<Local, Int<32>>,
    wide_base: Signal<Local, Int<30>>,
    deep: Signal<Local, Int<30>>,
    kept_product: DFF<Doubled<32>>,
    kept_rest: DFF<Int<30>>,
    kept: DFF<Int<30>>,
    point: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [] LightComponent []
    inputs { clock, depth, place, base, slope }
    parts { result, factor, wide_base, deep, kept_product, kept_rest, kept, point }
    data {  }
}

impl LightComponent {
    pub(in crate::machine) fn new() -> Self {
        fields! {
            [clock, depth, place, base, slope, result, factor, wide_base, deep, kept_product, kept_rest, kept]
            point: constant(31),
        }
    }
}

impl Logic for LightComponent {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("light_component");
        clock!(self, clock, kept_product, kept_rest, kept);
        self.factor.next = signed_bit_cast::<32, 28>(self.slope.val());
        self.wide_base.next = signed_bit_cast::<30, 28>(self.base.val());
        self.kept_product.d.next = self.factor.val() * self.depth.val();
        self.kept_rest.d.next = self.wide_base.val() - self.place.val();
        self.deep.next = self
            .kept_product
            .q
            .val()
            .get_bits::<30>(self.point.val().index());
        self.kept.d.next = self.kept_rest.q.val() - self.deep.val();
        self.result.next = self.kept.q.val();
    }
}

clocked!(LightComponent);
