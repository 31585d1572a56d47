//! The exact reference: every pixel solved in big integers, by another route than the machine's.
//!
//! The machine evaluates a depth as `f1 -+ sqrt(f2)` from coefficients that went through perspective. Here the line of
//! sight is put into the camera-frame equation, the polynomial along the ray is solved, and numbers `(p + s sqrt(q)) /
//! d` are compared exactly; where ball arithmetic proves a sign, it stands for the exact one ([`number`]).
//! Only the scene's camera frame is shared with the preparation.

pub(crate) mod back;
pub(crate) mod facet;
pub mod number;
pub mod ray;
pub mod render;
pub mod shadow;
