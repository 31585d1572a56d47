//! What a unit is built for.

/// Every parameter that a unit may have; a circuit reads those that it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// Depth word `W` of the format.
    pub depth_word: u32,
    /// Cut planes of an object.
    pub planes: u32,
    /// Rows of the root network between registers.
    pub rows_per_stage: u32,
    /// Objects of a machine, or inputs of a decider.
    pub objects: u32,
    /// Digits that a shortened square root keeps.
    pub digits: u32,
    /// Corrections behind an approximate square root.
    pub corrections: u32,
    /// Sides of a facet.
    pub sides: u32,
    /// Number of a video mode.
    pub mode: u32,
    /// Cards of processors.
    pub cards: u32,
    /// Transparent objects of a pipeline.
    pub layers: u32,
    /// Products of a solid.
    pub products: u32,
    /// Objects intersected in a product.
    pub intersected: u32,
    /// Objects taken away in a product.
    pub subtracted: u32,
    /// Lights of a shading processor.
    pub lights: u32,
}

impl Parameters {
    /// A format with the parameters that are most often the default.
    pub const fn of(depth_word: u32) -> Parameters {
        Parameters {
            depth_word,
            planes: 3,
            rows_per_stage: 1,
            objects: 4,
            digits: depth_word / 2,
            corrections: 1,
            sides: 3,
            mode: 0,
            cards: 2,
            layers: 2,
            products: 2,
            intersected: 2,
            subtracted: 2,
            lights: 1,
        }
    }
}
