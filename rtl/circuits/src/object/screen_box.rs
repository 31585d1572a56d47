//! Where on the screen an object may be.

use crate::raster::Pixel;
use imogene_hdl::{Bits, Value, bundle, net};

bundle! {
    /// Screen box of an object; empty where a first exceeds its last.
    ScreenBox() {
        box_x0: Bits(12), "first column of the screen box; empty if beyond the last";
        box_x1: Bits(12), "last column of the screen box";
        box_y0: Bits(12), "first line of the screen box; empty if beyond the last";
        box_y1: Bits(12), "last line of the screen box";
    }
}

impl ScreenBox {
    /// 1 where a pixel lies in the box.
    pub fn contains(self, pixel: Pixel) -> Bits {
        let not_before = |value: Bits, first: Bits| !value.less(first);
        net! {
            let in_box = not_before(pixel.x, self.box_x0)
                & not_before(self.box_x1, pixel.x)
                & not_before(pixel.y, self.box_y0)
                & not_before(self.box_y1, pixel.y);
        }
        in_box
    }
}
