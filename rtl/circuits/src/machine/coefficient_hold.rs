//! Words of an object that are used after its first pixel, kept while those of the next object are loaded.

use super::LoadBus;
use crate::object::{Factors, Normal, Plane, ScreenBox, Words};
use crate::raster::{SecondSteps, Steps};
use imogene_contract::object::CONTROL;
use imogene_hdl::{Bits, Bundle, Value, bundles, module, net};

bundles! {
    /// A cut plane without its depth at the first pixel.
    #[derive(Copy)]
    HeldPlane {
        kind: Bits as "kind",
            "kind: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0)";
        steps: Steps as "", "depth zp";
        /// Its normal.
        normal: Normal as "";
    }

    /// Words that are used after the first pixel.
    Held {
        f1: Steps as "f1", "linear part of the depth";
        f2: SecondSteps as "f2", "quadratic under the root";
        gx: Steps as "gx", "linear part of normal x";
        gy: Steps as "gy", "linear part of normal y";
        gz: Steps as "gz", "linear part of normal z";
        /// Factors of the root.
        factors: Factors as "";
        /// Where it may be.
        screen_box: ScreenBox as "";
        object_class: Bits as "object_class", "class of the object: 0 side, 1 front, 2 patch, 3 prism";
        shift: Bits as "shift", "places the root is shifted right for the normal";
        planes: Vec<HeldPlane> as "plane", "plane #";
    }
}

impl Held {
    /// Those of an object.
    pub fn of(words: &Words) -> Held {
        let plane = |plane: &Plane| HeldPlane {
            kind: plane.half_space.kind,
            steps: plane.half_space.linear.steps(),
            normal: plane.normal,
        };
        let (quadric, gradients) = (&words.quadric, &words.quadric.gradients);
        Held {
            f1: quadric.f1.steps(),
            f2: quadric.f2.steps(),
            gx: gradients.gx.steps(),
            gy: gradients.gy.steps(),
            gz: gradients.gz.steps(),
            factors: gradients.factors,
            screen_box: quadric.screen_box,
            object_class: words.object_class,
            shift: quadric.shift,
            planes: words.planes.iter().map(plane).collect(),
        }
    }

    /// The words of an object with these in the place of its own.
    pub fn in_place(self, mut words: Words) -> Words {
        let quadric = &mut words.quadric;
        quadric.f1 = quadric.f1.with_steps(self.f1);
        quadric.f2 = quadric.f2.with_steps(self.f2);
        let gradients = &mut quadric.gradients;
        gradients.gx = gradients.gx.with_steps(self.gx);
        gradients.gy = gradients.gy.with_steps(self.gy);
        gradients.gz = gradients.gz.with_steps(self.gz);
        words.quadric.gradients.factors = self.factors;
        words.quadric.screen_box = self.screen_box;
        words.quadric.shift = self.shift;
        words.object_class = self.object_class;
        for (plane, held) in words.planes.iter_mut().zip(self.planes) {
            plane.half_space.kind = held.kind;
            plane.half_space.linear = plane.half_space.linear.with_steps(held.steps);
            plane.normal = held.normal;
        }
        words
    }
}

/// Takes over words of a coefficient store at the beginning of a pass, and keeps them until the next; with them the id
/// of the object, written to its own address on the bus of the store.
///
/// What an elementary processor begins with it reads at the first pixel alone; the words here are used at others too.
/// So the store may be loaded with the next object as soon as all processors have started. An object whose control
/// word was not written since the last `take` is absent: its screen box is empty.
pub fn coefficient_hold(at: &str, take: Bits, bus: LoadBus, next: Held) -> (Bits, Held) {
    let inputs = (("take", take), bus, ("next", next));
    module("coefficient_hold", at, inputs, |(take, bus, mut next)| {
        net! { let is_present = bus.is_new(CONTROL, take); }
        // Kept inverted: zero, also that of power-up, is an empty box.
        let nowhere = Bits::new(0, next.screen_box.box_x0.width());
        next.screen_box.box_x0 = is_present.select(!next.screen_box.box_x0, nowhere);
        let mut held = next.registered_when(take);
        held.screen_box.box_x0 = !held.screen_box.box_x0.named("inverted_box_x0");
        (("id", bus.held_id(take)), held)
    })
}
