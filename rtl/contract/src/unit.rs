//! Units: the name of each, and its record.

use crate::parameters::Parameter;
use crate::records::{arith, machine, object, raster, shade, video};
use crate::request::RequestError;
use crate::words::LEAST_DEPTH;

/// What is stated of a unit besides its ports, which its circuit declares.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// Name of the unit, its file and its Verilog module.
    pub name: &'static str,
    /// What it computes, in one sentence.
    pub computes: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// Its parameters besides the format.
    pub parameters: &'static [Parameter],
    /// Clocks from an input to its result: a formula in the symbols of its parameters, `W` the depth word.
    pub latency: &'static str,
    /// Results per clock.
    pub throughput: &'static str,
    /// What happens at equality.
    pub ties: &'static str,
    /// How far results are from what it computes: exact, a bound, or a measured maximum. `{W - D}` stands for the value
    /// of a formula, `{C: 6, 1}` for the first or second of the list as `C` is 0 or 1.
    pub error: &'static str,
}

macro_rules! units {
    ($($unit:ident: $record:path;)*) => {
        /// A unit that is a design by itself, from the smallest to the machine.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[allow(missing_docs, reason = "each record says what its unit is")]
        pub enum Unit {
            $($unit,)*
        }

        impl Unit {
            /// All units.
            pub const ALL: [Unit; [$(Unit::$unit),*].len()] = [$(Unit::$unit),*];

            /// What is stated of it.
            pub const fn record(self) -> &'static Record {
                match self {
                    $(Unit::$unit => &$record,)*
                }
            }
        }
    };
}

units! {
    Pe1: raster::PE1;
    Pe2: raster::PE2;
    ProgrammablePe: raster::PROGRAMMABLE_PE;
    MemoryPe2: raster::MEMORY_PE2;
    SquareRoot: arith::SQUARE_ROOT;
    SquareRootNonRestoring: arith::SQUARE_ROOT_NON_RESTORING;
    SquareRootIterative: arith::SQUARE_ROOT_ITERATIVE;
    SquareRootRows: arith::SQUARE_ROOT_ROWS;
    SquareRootLeading: arith::SQUARE_ROOT_LEADING;
    SquareRootLinear: arith::SQUARE_ROOT_LINEAR;
    SquareRootQuadratic: arith::SQUARE_ROOT_QUADRATIC;
    QuadricPe: object::QUADRIC_PE;
    PlaneDepth: object::PLANE_DEPTH;
    CutPlane: object::CUT_PLANE;
    DepthInterval: object::DEPTH_INTERVAL;
    TwoVolumeMerge: object::TWO_VOLUME_MERGE;
    NormalUnit: object::NORMAL_UNIT;
    PatchDecider: object::PATCH_DECIDER;
    QuadricProcessor: object::QUADRIC_PROCESSOR;
    PatchProcessor: object::PATCH_PROCESSOR;
    FirstGenerationProcessor: object::FIRST_GENERATION_PROCESSOR;
    PolyhedronProcessor: object::POLYHEDRON_PROCESSOR;
    FacetProcessor: object::FACET_PROCESSOR;
    CurvedFacetProcessor: object::CURVED_FACET_PROCESSOR;
    SphereProcessor: object::SPHERE_PROCESSOR;
    CylinderProcessor: object::CYLINDER_PROCESSOR;
    QuadricVolume: object::QUADRIC_VOLUME;
    PolyhedralVolume: object::POLYHEDRAL_VOLUME;
    RasterControl: machine::RASTER_CONTROL;
    VisibilityNode: machine::VISIBILITY_NODE;
    Decider: machine::DECIDER;
    VisibilityChain: machine::VISIBILITY_CHAIN;
    CardDecider: machine::CARD_DECIDER;
    ShadowStage: machine::SHADOW_STAGE;
    TransparencyStage: shade::TRANSPARENCY_STAGE;
    TransparencyPipeline: shade::TRANSPARENCY_PIPELINE;
    CsgDecider: machine::CSG_DECIDER;
    CoefficientStore: machine::COEFFICIENT_STORE;
    Beam: machine::BEAM;
    VideoTiming: video::VIDEO_TIMING;
    PixelFifo: video::PIXEL_FIFO;
    FrameStore: video::FRAME_STORE;
    PostFilter: video::POST_FILTER;
    Overlay: video::OVERLAY;
    Accumulator: video::ACCUMULATOR;
    ShadingProcessor: shade::SHADING_PROCESSOR;
}

impl Unit {
    /// Name of the unit, its file and its Verilog module.
    pub const fn name(self) -> &'static str {
        self.record().name
    }

    /// The unit of a name.
    ///
    /// # Errors
    ///
    /// When there is none; the error lists the names.
    pub fn from_name(name: &str) -> Result<Unit, RequestError> {
        let found = Unit::ALL.into_iter().find(|unit| unit.name() == name);
        found.ok_or_else(|| RequestError::Unit {
            name: name.to_owned(),
        })
    }

    /// The least depth word that it is built for.
    pub const fn least_word(self) -> u32 {
        match self {
            // Its parabolas read a bit of the square by its place.
            Unit::SquareRootQuadratic => 12,
            _ => LEAST_DEPTH as u32,
        }
    }

    /// Has it a parameter of this option?
    pub fn has(self, option: &str) -> bool {
        let mut parameters = self.record().parameters.iter();
        parameters.any(|parameter| parameter.option == option)
    }
}
