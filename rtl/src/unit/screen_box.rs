//! Test against the screen box of an object.

use crate::kernel::*;

/// Says whether a pixel lies in the screen box of an object.
///
/// | port | direction | format |
/// |---|---|---|
/// | `x`, `y` | in | 12 bits, pixel |
/// | `box_x0`, `box_x1`, `box_y0`, `box_y1` | in | 12 bits, inclusive; empty where the first exceeds the last |
/// | `in_box` | out | the pixel lies in the box |
///
/// Latency 0: a few comparators without register.
#[derive(Default)]
pub struct ScreenBox {
    /// Column.
    pub x: Signal<In, Word<12>>,
    /// Line.
    pub y: Signal<In, Word<12>>,
    /// First column of the screen box.
    pub box_x0: Signal<In, Word<12>>,
    /// Last column of the screen box.
    pub box_x1: Signal<In, Word<12>>,
    /// First line of the screen box.
    pub box_y0: Signal<In, Word<12>>,
    /// Last line of the screen box.
    pub box_y1: Signal<In, Word<12>>,
    /// The pixel lies in the box.
    pub in_box: Signal<Out, Bit>,
    right_of_x0: Signal<Local, Bit>,
    left_of_x1: Signal<Local, Bit>,
    below_y0: Signal<Local, Bit>,
    above_y1: Signal<Local, Bit>,
    _asleep: bool,
}

block! {
    [] ScreenBox []
    inputs { x, y, box_x0, box_x1, box_y0, box_y1 }
    parts { in_box, right_of_x0, left_of_x1, below_y0, above_y1 }
    data { }
}

impl ScreenBox {}

impl Logic for ScreenBox {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("screen_box");
        self.right_of_x0.next = self.x.val() >= self.box_x0.val();
        self.left_of_x1.next = self.x.val() <= self.box_x1.val();
        self.below_y0.next = self.y.val() >= self.box_y0.val();
        self.above_y1.next = self.y.val() <= self.box_y1.val();
        self.in_box.next = self.right_of_x0.val()
            & self.left_of_x1.val()
            & self.below_y0.val()
            & self.above_y1.val();
    }
}
