//! Scalar product of two vectors.

use crate::kernel::*;

/// Gives `product = a . b` of vectors of 18 bits a component, which multipliers of 18 x 18 bits take.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `ax`, `ay`, `az`, `bx`, `by`, `bz` | in | 18 bits, two's complement |
/// | `product` | out | 38 bits, two's complement |
///
/// Latency 2: the products, then their sum.
#[derive(Default)]
pub struct ScalarProduct {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// One vector.
    pub ax: Signal<In, Int<18>>,
    /// One vector.
    pub ay: Signal<In, Int<18>>,
    /// One vector.
    pub az: Signal<In, Int<18>>,
    /// The other vector.
    pub bx: Signal<In, Int<18>>,
    /// The other vector.
    pub by: Signal<In, Int<18>>,
    /// The other vector.
    pub bz: Signal<In, Int<18>>,
    /// The scalar product.
    pub product: Signal<Out, Int<38>>,
    product_x: DFF<Doubled<18>>,
    product_y: DFF<Doubled<18>>,
    product_z: DFF<Doubled<18>>,
    cut_x: Signal<Local, Int<36>>,
    cut_y: Signal<Local, Int<36>>,
    cut_z: Signal<Local, Int<36>>,
    wide_x: Signal<Local, Int<38>>,
    wide_y: Signal<Local, Int<38>>,
    wide_z: Signal<Local, Int<38>>,
    first_sum: Signal<Local, Int<38>>,
    kept_sum: DFF<Int<38>>,
    _asleep: bool,
}

block! {
    [] ScalarProduct []
    inputs { clock, ax, ay, az, bx, by, bz }
    parts { product, product_x, product_y, product_z, cut_x, cut_y, cut_z, wide_x, wide_y, wide_z, first_sum, kept_sum }
    data { }
}

impl Logic for ScalarProduct {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("scalar_product");
        clock!(self, clock, product_x, product_y, product_z, kept_sum);
        self.product_x.d.next = self.ax.val() * self.bx.val();
        self.product_y.d.next = self.ay.val() * self.by.val();
        self.product_z.d.next = self.az.val() * self.bz.val();
        self.cut_x.next = self.product_x.q.val().get_bits::<36>(0);
        self.cut_y.next = self.product_y.q.val().get_bits::<36>(0);
        self.cut_z.next = self.product_z.q.val().get_bits::<36>(0);
        self.wide_x.next = signed_bit_cast::<38, 36>(self.cut_x.val());
        self.wide_y.next = signed_bit_cast::<38, 36>(self.cut_y.val());
        self.wide_z.next = signed_bit_cast::<38, 36>(self.cut_z.val());
        self.first_sum.next = self.wide_x.val() + self.wide_y.val();
        self.kept_sum.d.next = self.first_sum.val() + self.wide_z.val();
        self.product.next = self.kept_sum.q.val();
    }
}

clocked!(ScalarProduct);
