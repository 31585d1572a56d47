//! Which words of objects change along the lines.

use super::{
    Bounds, Cylinder, Facet, FirstGeneration, Gradients, HalfSpace, Patch, Plane, Polyhedron,
    Quadric, Quotient, Sphere, VolumeWords, Words,
};
use crate::raster::laned;

laned! {
    Gradients { gx gy gz }
    Quadric { f1 f2 gradients }
    HalfSpace { linear }
    Plane { half_space }
    Words { quadric planes }
    Patch { quadric planes }
    FirstGeneration { quadric depths conics polars }
    Polyhedron { planes }
    Quotient { numerator denominator gradients planes }
    Facet<P> { sides depth normal }
    Sphere { outline front nx ny nz }
    Cylinder { sides discs body nx ny nz lid }
    Bounds { planes }
    VolumeWords { f1 f2 bounds }
}
