//! The source's algorithms, each as one would write it, in numbers that count.

pub mod facet;
pub mod lighting;
pub mod pixel;
pub mod quadric;
pub mod transform;
pub mod zones;
