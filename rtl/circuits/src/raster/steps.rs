//! The words of a polynomial that are read after its first pixel.

use super::{Linear, Quadratic};
use imogene_hdl::bundle;

bundle! {
    /// What words of first degree are read for after the start.
    Steps(width) {
        a: Int(width), "increment from pixel to pixel";
        b: Int(width), "increment from line to line";
    }

    /// The same of second degree.
    SecondSteps(width) {
        a2: Int(width), "2a of a x^2 + b y^2 + c xy + d x + e y + f";
        b2: Int(width), "2b";
        c: Int(width), "c";
    }
}

impl Linear {
    /// What is read after the start.
    pub(crate) fn steps(&self) -> Steps {
        let Linear { a, b, .. } = *self;
        Steps { a, b }
    }

    /// The same with these in the place of its own.
    pub(crate) fn with_steps(self, Steps { a, b }: Steps) -> Linear {
        Linear { a, b, ..self }
    }
}

impl Quadratic {
    /// What is read after the start.
    pub(crate) fn steps(&self) -> SecondSteps {
        let Quadratic { a2, b2, c, .. } = *self;
        SecondSteps { a2, b2, c }
    }

    /// The same with these in the place of its own.
    pub(crate) fn with_steps(self, SecondSteps { a2, b2, c }: SecondSteps) -> Quadratic {
        Quadratic { a2, b2, c, ..self }
    }
}
