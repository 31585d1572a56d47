//! The units: names, parameters, latencies, sources, errors.

mod accuracy;

use crate::emit::EmitError;
use crate::format::{
    MOST_CARDS, MOST_CORRECTIONS, MOST_LAYERS, MOST_LIGHTS, MOST_LITERALS, MOST_MODE, MOST_OBJECTS,
    MOST_PLANES, MOST_PRODUCTS, MOST_SIDES,
};

/// A unit that can be emitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Unit {
    /// First-degree elementary processor, at the width of a depth sum.
    Pe1,
    /// Second-degree elementary processor, at the width of a quadratic.
    Pe2,
    /// One processor of second degree, or four of first degree.
    ProgrammablePe,
    /// Second-degree elementary processor with a coefficient memory and a microprogram.
    MemoryPe2,
    /// Square root network, restoring.
    SquareRoot,
    /// Square root network, non-restoring.
    SquareRootNonRestoring,
    /// Square root by one row, digit after digit.
    SquareRootIterative,
    /// First rows of the square root network.
    SquareRootRows,
    /// Leading significant digits of the square root.
    SquareRootLeading,
    /// Piecewise linear square root with corrections.
    SquareRootLinear,
    /// Piecewise quadratic square root with corrections.
    SquareRootQuadratic,
    /// Two depths of a quadric.
    QuadricPe,
    /// Depth of a cut plane.
    PlaneDepth,
    /// Cut of a depth interval by a plane.
    CutPlane,
    /// Depth interval of a quadric.
    DepthInterval,
    /// Choice between two halves of an interval.
    TwoVolumeMerge,
    /// Normal of the visible face.
    NormalUnit,
    /// Decision of a patch.
    PatchDecider,
    /// Quadric object processor.
    QuadricProcessor,
    /// Patch object processor.
    PatchProcessor,
    /// Quadric object processor, first generation.
    FirstGenerationProcessor,
    /// Convex polyhedron processor.
    PolyhedronProcessor,
    /// Flat facet processor.
    FacetProcessor,
    /// Non-planar facet processor.
    CurvedFacetProcessor,
    /// Sphere processor.
    SphereProcessor,
    /// Cylinder processor.
    CylinderProcessor,
    /// Shadow or light volume of a quadric.
    QuadricVolume,
    /// Shadow or light volume of planes.
    PolyhedralVolume,
    /// Raster control.
    RasterControl,
    /// Node of the decider.
    VisibilityNode,
    /// Nearest of many objects.
    Decider,
    /// Nearest of many objects, past their processors.
    VisibilityChain,
    /// Nearest of the objects of many cards.
    CardDecider,
    /// Flags of the light sources.
    ShadowStage,
    /// One transparent object before the visible surface.
    TransparencyStage,
    /// Transparent objects before the visible surface.
    TransparencyPipeline,
    /// Solids of union, intersection and difference.
    CsgDecider,
    /// Coefficient words of one object.
    CoefficientStore,
    /// Beam machine.
    Beam,
    /// Raster of a screen.
    VideoTiming,
    /// Queue behind a pipeline.
    PixelFifo,
    /// Two frames.
    FrameStore,
    /// Smoothing filter.
    PostFilter,
    /// Plane of one bit per pixel.
    Overlay,
    /// Mean of several passes.
    Accumulator,
    /// Shading processor.
    ShadingProcessor,
}

/// A parameter of a unit, besides the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Option of the command line.
    pub option: &'static str,
    /// Least legal value.
    pub least: usize,
    /// Greatest legal value; none where it is the depth word.
    pub most: Option<usize>,
}

const PLANES: Parameter = Parameter {
    option: "planes",
    least: 0,
    most: Some(MOST_PLANES),
};
const ROWS: Parameter = Parameter {
    option: "rows-per-stage",
    least: 1,
    most: None,
};
const OBJECTS: Parameter = Parameter {
    option: "objects",
    least: 1,
    most: Some(MOST_OBJECTS),
};

const HALF_SPACES: Parameter = Parameter { least: 1, ..PLANES };
const SIDES: Parameter = Parameter {
    option: "sides",
    least: 3,
    most: Some(MOST_SIDES),
};
const CURVED_SIDES: Parameter = Parameter { least: 1, ..SIDES };

const CARDS: Parameter = Parameter {
    option: "cards",
    least: 1,
    most: Some(MOST_CARDS),
};

const LAYERS: Parameter = Parameter {
    option: "layers",
    least: 1,
    most: Some(MOST_LAYERS),
};

const PRODUCTS: Parameter = Parameter {
    option: "products",
    least: 1,
    most: Some(MOST_PRODUCTS),
};
const INTERSECTED: Parameter = Parameter {
    option: "intersected",
    least: 1,
    most: Some(MOST_LITERALS),
};
const SUBTRACTED: Parameter = Parameter {
    option: "subtracted",
    least: 0,
    most: Some(MOST_LITERALS),
};
const LIGHTS: Parameter = Parameter {
    option: "lights",
    least: 1,
    most: Some(MOST_LIGHTS),
};

const DIGITS: Parameter = Parameter {
    option: "digits",
    least: 1,
    most: None,
};
const CORRECTIONS: Parameter = Parameter {
    option: "corrections",
    least: 0,
    most: Some(MOST_CORRECTIONS),
};

/// Number of a video mode.
const MODE: Parameter = Parameter {
    option: "mode",
    least: 0,
    most: Some(MOST_MODE),
};

impl Unit {
    /// All units, from the smallest to the machine.
    pub const ALL: [Self; 46] = [
        Self::Pe1,
        Self::Pe2,
        Self::ProgrammablePe,
        Self::MemoryPe2,
        Self::SquareRoot,
        Self::SquareRootNonRestoring,
        Self::SquareRootIterative,
        Self::SquareRootRows,
        Self::SquareRootLeading,
        Self::SquareRootLinear,
        Self::SquareRootQuadratic,
        Self::QuadricPe,
        Self::PlaneDepth,
        Self::CutPlane,
        Self::DepthInterval,
        Self::TwoVolumeMerge,
        Self::NormalUnit,
        Self::PatchDecider,
        Self::QuadricProcessor,
        Self::PatchProcessor,
        Self::FirstGenerationProcessor,
        Self::PolyhedronProcessor,
        Self::FacetProcessor,
        Self::CurvedFacetProcessor,
        Self::SphereProcessor,
        Self::CylinderProcessor,
        Self::QuadricVolume,
        Self::PolyhedralVolume,
        Self::RasterControl,
        Self::VisibilityNode,
        Self::Decider,
        Self::VisibilityChain,
        Self::CardDecider,
        Self::ShadowStage,
        Self::TransparencyStage,
        Self::TransparencyPipeline,
        Self::CsgDecider,
        Self::CoefficientStore,
        Self::Beam,
        Self::VideoTiming,
        Self::PixelFifo,
        Self::FrameStore,
        Self::PostFilter,
        Self::Overlay,
        Self::Accumulator,
        Self::ShadingProcessor,
    ];

    /// Name of the unit, its file and its Verilog module.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pe1 => "pe1",
            Self::Pe2 => "pe2",
            Self::SquareRoot => "square_root",
            Self::SquareRootNonRestoring => "square_root_non_restoring",
            Self::SquareRootIterative => "square_root_iterative",
            Self::SquareRootRows => "square_root_rows",
            Self::SquareRootLeading => "square_root_leading",
            Self::SquareRootLinear => "square_root_linear",
            Self::SquareRootQuadratic => "square_root_quadratic",
            Self::QuadricPe => "quadric_pe",
            Self::PlaneDepth => "plane_depth",
            Self::CutPlane => "cut_plane",
            Self::DepthInterval => "depth_interval",
            Self::TwoVolumeMerge => "two_volume_merge",
            Self::NormalUnit => "normal_unit",
            Self::QuadricProcessor => "quadric_processor",
            Self::RasterControl => "raster_control",
            Self::VisibilityNode => "visibility_node",
            Self::Decider => "decider",
            Self::VisibilityChain => "visibility_chain",
            Self::CardDecider => "card_decider",
            Self::ShadowStage => "shadow_stage",
            Self::TransparencyStage => "transparency_stage",
            Self::TransparencyPipeline => "transparency_pipeline",
            Self::CsgDecider => "csg_decider",
            Self::CoefficientStore => "coefficient_store",
            Self::ProgrammablePe => "programmable_pe",
            Self::MemoryPe2 => "memory_pe2",
            Self::PatchDecider => "patch_decider",
            Self::PatchProcessor => "patch_processor",
            Self::FirstGenerationProcessor => "first_generation_processor",
            Self::PolyhedronProcessor => "polyhedron_processor",
            Self::FacetProcessor => "facet_processor",
            Self::CurvedFacetProcessor => "curved_facet_processor",
            Self::SphereProcessor => "sphere_processor",
            Self::CylinderProcessor => "cylinder_processor",
            Self::QuadricVolume => "quadric_volume",
            Self::PolyhedralVolume => "polyhedral_volume",
            Self::Beam => "beam",
            Self::VideoTiming => "video_timing",
            Self::PixelFifo => "pixel_fifo",
            Self::FrameStore => "frame_store",
            Self::PostFilter => "post_filter",
            Self::Overlay => "overlay",
            Self::Accumulator => "accumulator",
            Self::ShadingProcessor => "shading_processor",
        }
    }

    /// The unit of a name.
    ///
    /// # Errors
    ///
    /// When there is none; the error lists the names.
    pub fn from_name(name: &str) -> Result<Self, EmitError> {
        let found = Self::ALL.into_iter().find(|unit| unit.name() == name);
        found.ok_or_else(|| EmitError::Unit {
            name: name.to_owned(),
        })
    }

    /// What the unit does, in one sentence.
    pub const fn contract(self) -> &'static str {
        match self {
            Self::Pe1 => "value(x, y) = a x + b y + c by additions alone, one pixel per clock",
            Self::Pe2 => {
                "value(x, y) = a x^2 + b y^2 + c xy + d x + e y + f by additions alone, one pixel per clock"
            }
            Self::SquareRoot | Self::SquareRootNonRestoring => {
                "root = floor(sqrt(radicand)) and remainder = radicand - root^2, one result per clock"
            }
            Self::SquareRootIterative => {
                "root = floor(sqrt(radicand)) and remainder = radicand - root^2, one digit per clock"
            }
            Self::SquareRootRows => {
                "the upper digits of floor(sqrt(radicand)), the lower ones zero"
            }
            Self::SquareRootLeading => {
                "the leading significant digits of floor(sqrt(radicand)), the lower ones zero"
            }
            Self::SquareRootLinear => {
                "an approximate square root by straight lines and corrections, monotone"
            }
            Self::SquareRootQuadratic => "an approximate square root by parabolas and corrections",
            Self::QuadricPe => {
                "the two depths f1 - r and f1 + r of a quadric, with r = floor(sqrt(f2))"
            }
            Self::PlaneDepth => "the depth of a plane, clamped to the depth word",
            Self::CutPlane => "one half of a depth interval cut by one plane",
            Self::DepthInterval => "the two halves of the depth interval of a quadric object",
            Self::TwoVolumeMerge => "the half of a depth interval that lies in front",
            Self::NormalUnit => "the normal of the visible face of a quadric object",
            Self::QuadricProcessor => {
                "depth, face and normal of the visible front of one quadric object cut by planes"
            }
            Self::RasterControl => {
                "the raster flags of a zone, one pixel per clock, without a bubble"
            }
            Self::VisibilityNode => "the nearer of two objects",
            Self::Decider => "the nearest of many objects",
            Self::VisibilityChain => {
                "the nearest of many objects, compared on the way past their processors"
            }
            Self::CardDecider => {
                "the nearest of the objects of many cards: a chain on each card, a tree between the cards"
            }
            Self::ShadowStage => {
                "which light sources reach the visible point, from the answers of the shadow and light volumes"
            }
            Self::TransparencyStage => {
                "the colour of a transparent object blended over that of a pixel, if it is nearer"
            }
            Self::TransparencyPipeline => {
                "the colours of transparent objects blended over that of a pixel, farthest first"
            }
            Self::CsgDecider => {
                "the visible face of a union of products: convex objects intersected, others taken away"
            }
            Self::CoefficientStore => "the coefficient words of one object, loaded over a bus",
            Self::ProgrammablePe => {
                "value(x, y) of second degree, or four of first degree with the decision on their signs, by additions alone"
            }
            Self::MemoryPe2 => {
                "value(x, y) of second degree by two adders, three registers and a memory of one port, field by field"
            }
            Self::PatchDecider => {
                "the first face of a bare surface that every plane keeps, all planes at once"
            }
            Self::PatchProcessor => {
                "depth, face and normal of the visible face of a bare quadric surface cut by planes"
            }
            Self::FirstGenerationProcessor => {
                "depth, face and normal of a quadric between two parallel planes, found by contours on the screen"
            }
            Self::PolyhedronProcessor => {
                "front and back depth, faces and normals of a convex solid of planes"
            }
            Self::FacetProcessor => {
                "depth and interpolated normal of a flat facet of three or four sides"
            }
            Self::CurvedFacetProcessor => {
                "depth and normal of a facet with sides, depth and normal of second degree"
            }
            Self::SphereProcessor => {
                "depth and normal of a sphere with exact outline and a paraboloid for the depth"
            }
            Self::CylinderProcessor => {
                "depth and normal of a cylinder with exact outline and a parabolic body"
            }
            Self::QuadricVolume => {
                "is the visible point in a shadow or light volume of a quadric and planes"
            }
            Self::PolyhedralVolume => "is the visible point in a shadow or light volume of planes",
            Self::Beam => "the visible surface of many quadric objects, pixel by pixel",
            Self::VideoTiming => {
                "the raster of a screen with its blanking, and the same some clocks ahead"
            }
            Self::PixelFifo => {
                "a queue from a pipeline that cannot stall to an AXI4-Stream receiver that can"
            }
            Self::FrameStore => "the last whole frame that came, while the next one comes",
            Self::PostFilter => "a picture smoothed by a 2 x 2 box or a 3 x 3 binomial",
            Self::Overlay => "a plane of one bit per pixel over a picture",
            Self::Accumulator => "the mean of 4 or 16 passes over a picture",
            Self::ShadingProcessor => {
                "the colour of every pixel by Phong shading under several lights"
            }
        }
    }

    /// Where the unit comes from.
    pub const fn source(self) -> &'static str {
        match self {
            Self::Pe1 | Self::Pe2 => "Nyiri 1994, 2.3.2 and B.2.1",
            Self::SquareRoot
            | Self::SquareRootNonRestoring
            | Self::SquareRootIterative
            | Self::SquareRootRows
            | Self::SquareRootLinear
            | Self::SquareRootQuadratic => "Nyiri 1994, 2.3.3",
            Self::SquareRootLeading => "Nyiri 1994, B.10",
            Self::QuadricPe
            | Self::PlaneDepth
            | Self::CutPlane
            | Self::DepthInterval
            | Self::TwoVolumeMerge
            | Self::NormalUnit
            | Self::QuadricProcessor => "Nyiri 1994, 2.4.2",
            Self::ProgrammablePe => "Chaillou 1991, IV.1.7",
            Self::MemoryPe2 => "Chaillou 1991, IV.1.5",
            Self::PatchDecider => "Nyiri 1994, 2.4.3",
            Self::PatchProcessor => "Nyiri 1994, 2.4.3 and 5.2.1",
            Self::FirstGenerationProcessor => "Nyiri 1994, 2.4.1",
            Self::PolyhedronProcessor => "Nyiri 1994, annex A; Chaillou 1991, IV.2.3",
            Self::FacetProcessor => "Chaillou 1991, IV.2.2",
            Self::CurvedFacetProcessor => "Chaillou 1991, IV.2.6.1",
            Self::SphereProcessor => "Chaillou 1991, IV.2.4",
            Self::CylinderProcessor => "Chaillou 1991, IV.2.5",
            Self::QuadricVolume => "Nyiri 1994, 3.2.1 and 4.1.3",
            Self::PolyhedralVolume => "Nyiri 1994, 3.2.1 and 4.1.3",
            Self::RasterControl => "architecture, 2",
            Self::VisibilityNode | Self::Decider => "architecture, 6",
            Self::VisibilityChain => "Chaillou 1991, IV.3.2",
            Self::CardDecider => "Chaillou 1991, IV.3.6",
            Self::ShadowStage => "Chaillou 1991, IV.3.4; Nyiri 1994, 4.1.3",
            Self::TransparencyStage | Self::TransparencyPipeline => "Chaillou 1991, IV.3.3",
            Self::CsgDecider => "Chaillou 1991, III.1.1.4 and IV.3.5",
            Self::CoefficientStore | Self::Beam => "architecture, 7",
            Self::VideoTiming => "Chaillou 1991, I.2.4.2 and IV.4.4",
            Self::PixelFifo | Self::FrameStore => "architecture, 8",
            Self::PostFilter => "Chaillou 1991, IV.4.3",
            Self::Overlay => "Chaillou 1991, IV.4.7.1",
            Self::Accumulator => "Chaillou 1991, III.1.5 and IV.4.7.2",
            Self::ShadingProcessor => "Chaillou 1991, III.1.2; Nyiri 1994, 1.2.4",
        }
    }

    /// The parameters the unit has besides the format.
    pub const fn parameters(self) -> &'static [Parameter] {
        match self {
            Self::SquareRoot | Self::SquareRootNonRestoring | Self::QuadricPe => &[ROWS],
            Self::SquareRootRows | Self::SquareRootLeading => &[DIGITS, ROWS],
            Self::SquareRootLinear | Self::SquareRootQuadratic => &[CORRECTIONS],
            Self::NormalUnit | Self::CoefficientStore => &[PLANES],
            Self::QuadricProcessor | Self::PatchProcessor | Self::QuadricVolume => &[PLANES, ROWS],
            Self::PatchDecider | Self::PolyhedralVolume => &[PLANES],
            Self::FirstGenerationProcessor => &[ROWS],
            Self::PolyhedronProcessor => &[HALF_SPACES],
            Self::FacetProcessor => &[SIDES],
            Self::CurvedFacetProcessor => &[CURVED_SIDES],
            Self::Decider | Self::VisibilityChain | Self::ShadowStage => &[OBJECTS],
            Self::CardDecider => &[OBJECTS, CARDS],
            Self::TransparencyPipeline => &[LAYERS],
            Self::CsgDecider => &[PRODUCTS, INTERSECTED, SUBTRACTED],
            Self::Beam => &[PLANES, ROWS, OBJECTS],
            Self::VideoTiming => &[MODE],
            Self::ShadingProcessor => &[LIGHTS],
            _ => &[],
        }
    }

    /// Planes of the unit if nobody asks for another number: those of the source, where it has another than 3.
    pub const fn default_planes(self) -> usize {
        match self {
            Self::PolyhedronProcessor => 6,
            Self::PatchDecider
            | Self::PatchProcessor
            | Self::QuadricVolume
            | Self::PolyhedralVolume => 4,
            _ => 3,
        }
    }

    /// Latency as a formula; `W` depth word, `R` rows per stage, `N` planes, `M` objects, `D` digits, `C` corrections, `E` sides, `K` cards, `T` layers, `G` products, `I` objects
    /// intersected and `J` taken away in each.
    /// Latency as a formula; `W` depth word, `R` rows per stage, `N` planes, `M` objects, `D` digits, `C` corrections, `E` sides; `V`, the video mode, is in none.
    pub const fn latency_formula(self) -> &'static str {
        match self {
            Self::SquareRoot | Self::SquareRootNonRestoring => "ceil(W / R)",
            Self::SquareRootIterative => "W",
            Self::SquareRootRows => "ceil(D / R)",
            Self::SquareRootLeading => "ceil(D / R) + 2",
            Self::SquareRootLinear => "1 + 2 C",
            Self::SquareRootQuadratic => "3 + 2 C",
            Self::QuadricPe => "ceil(W / R) + 2",
            Self::PlaneDepth => "2",
            Self::NormalUnit => "3",
            Self::QuadricProcessor => "ceil(W / R) + N + 7",
            Self::PatchProcessor => "ceil(W / R) + 7",
            Self::FirstGenerationProcessor => "ceil(W / R) + 6",
            Self::QuadricVolume => "ceil(W / R) + 4",
            Self::PolyhedralVolume | Self::CylinderProcessor => "3",
            Self::PolyhedronProcessor => "ceil(log2 N) + 4",
            Self::PatchDecider | Self::FacetProcessor | Self::CurvedFacetProcessor => "2",
            Self::SphereProcessor | Self::Overlay => "4",
            Self::PixelFifo => "2",
            Self::Accumulator | Self::FrameStore | Self::PostFilter => "3",
            Self::Decider => "ceil(log2 M)",
            Self::VisibilityChain => "M",
            Self::CardDecider => "M + ceil(log2 K)",
            Self::ShadowStage => "max(1, ceil(log8 M))",
            Self::TransparencyStage => "2",
            Self::TransparencyPipeline => "2 T",
            Self::CsgDecider => "ceil(log2 I) + 1 + ceil(log2(G (J + 1)))",
            Self::Beam => "1 + (ceil(W / R) + N + 7) + ceil(log2 M)",
            Self::ShadingProcessor => "38",
            _ => "1",
        }
    }
}
