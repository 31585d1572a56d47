//! Checks of pictures.
//!
//! [`trace`] draws a scene file by rays in scene coordinates, with intervals that know when they cannot tell and
//! exact arithmetic where they cannot; [`compare`] holds the golden picture against it. No algorithm of the
//! preparation, the golden model or the exact reference is used for the traced picture. [`crack`] looks for cracks in
//! a picture without any reference, and [`inject`] makes some to see whether it finds them. [`repair`] solves the
//! pixels exactly that short words leave open. [`ordinary`] writes scenes at random, and [`survey`] counts what
//! becomes of them.

pub mod body;
pub mod bounds;
pub mod camera;
pub mod compare;
pub mod crack;
mod decide;
pub mod facet;
pub mod inject;
pub mod interval;
pub mod ordinary;
pub mod paint;
pub mod plot;
pub mod repair;
pub mod root;
pub mod run;
mod solve;
pub mod survey;
pub mod table;
pub mod trace;
pub mod transform;
pub mod verdict;
