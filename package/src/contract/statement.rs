//! Throughput and ties of every unit. The error is stated by the catalogue, for the header of the Verilog states it too.

use imogene_rtl::catalogue::Unit;

/// What a unit states besides its ports and latency.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Statement {
    /// Results per clock.
    pub throughput: &'static str,
    /// What happens at equality.
    pub ties: &'static str,
}

const EVERY_CLOCK: &str = "one result per clock";
const PIXELS: &str = "one pixel per clock, no bubble between lines or zones";
const NO_TIES: &str = "none: nothing is compared";
const SMALLER_ID: &str =
    "at equal depth the smaller id wins, so the result does not depend on the order of the inputs";

/// The statement of a unit.
pub const fn of(unit: Unit) -> Statement {
    Statement {
        throughput: throughput(unit),
        ties: ties(unit),
    }
}

const fn throughput(unit: Unit) -> &'static str {
    match unit {
        Unit::SquareRootIterative => "one result every W clocks",
        Unit::CoefficientStore => "one word written per clock",
        Unit::Pe1
        | Unit::Pe2
        | Unit::ProgrammablePe
        | Unit::FacetProcessor
        | Unit::CurvedFacetProcessor
        | Unit::QuadricPe
        | Unit::PlaneDepth
        | Unit::NormalUnit
        | Unit::RasterControl => PIXELS,
        Unit::VideoTiming => "one position of the raster per clock with enable",
        Unit::PixelFifo => {
            "one pixel per clock as long as the receiver does not stall, behind a pipeline of at most 60 clocks"
        }
        Unit::FrameStore => "one pixel per clock out, and one in while a frame is not whole",
        Unit::PostFilter => {
            "one pixel per clock; a clock without a pixel after each line, width + 2 after a picture"
        }
        Unit::Overlay | Unit::Accumulator => "one pixel per clock",
        Unit::MemoryPe2 => {
            "one pixel per clock within a line; 15 clocks between lines, 27 in a field"
        }
        Unit::ShadingProcessor => {
            "one pixel per clock, without a bubble; words change only when the pipeline has drained"
        }
        Unit::QuadricProcessor
        | Unit::PatchProcessor
        | Unit::FirstGenerationProcessor
        | Unit::PolyhedronProcessor
        | Unit::SphereProcessor
        | Unit::CylinderProcessor
        | Unit::QuadricVolume
        | Unit::PolyhedralVolume
        | Unit::Beam => {
            "one pixel per clock, no bubble between lines; coefficients change only when the pipeline has drained"
        }
        _ => EVERY_CLOCK,
    }
}

const fn ties(unit: Unit) -> &'static str {
    match unit {
        Unit::SquareRoot | Unit::SquareRootIterative => {
            "where four times the remainder and the next pair equal 4 root + 1 the digit is 1, so the root of a square is exact and leaves remainder 0"
        }
        Unit::SquareRootNonRestoring => {
            "a remainder of zero counts as not negative and gives digit 1, so the root of a square is exact and leaves remainder 0"
        }
        Unit::SquareRootRows | Unit::SquareRootLeading => {
            "digits are those of the rounded-down root; the lower ones are cut off, never rounded up"
        }
        Unit::QuadricPe => "f2 = 0 counts as inside, with both depths f1",
        Unit::DepthInterval => {
            "f2 = 0 counts as inside; a near depth at 2^(W-1) - 1 or beyond is absent for a side object; a depth exactly at the near end is kept and gets no cap"
        }
        Unit::PlaneDepth => "a value at a bound of the clamp is that bound",
        Unit::CutPlane => {
            "a front plane at zf and a back plane at zb change nothing; a front plane at zb and a back plane at zf keep a sheet; zp = 0 passes a perpendicular plane"
        }
        Unit::TwoVolumeMerge => "half A wins at equal front depth",
        Unit::QuadricProcessor => {
            "those of its parts: f2 = 0 is inside, planes at a face keep it, half A wins at equal front depth; box bounds are inclusive"
        }
        Unit::PatchDecider | Unit::PatchProcessor => {
            "a plane keeps a face that lies in it; the near face wins where both are left; f2 = 0 is inside"
        }
        Unit::FirstGenerationProcessor => {
            "a plane exactly at a root of a solid is its face; of a surface it has removed that root; f2 = 0 is inside"
        }
        Unit::PolyhedronProcessor => {
            "of planes at equal depth the smallest index wins; an interval of no thickness is there; a plane at the near end is not a face, the end is"
        }
        Unit::ProgrammablePe
        | Unit::FacetProcessor
        | Unit::CurvedFacetProcessor
        | Unit::SphereProcessor => "zero is inside",
        Unit::CylinderProcessor => "zero is inside; the front disc goes before the body",
        Unit::ShadingProcessor => {
            "a normal at a right angle to the line of sight is not turned; a light in the plane of the surface adds nothing; half a level is rounded up"
        }
        Unit::QuadricVolume | Unit::PolyhedralVolume => {
            "with margin 0 a point on the boundary is inside; with more the beginning is open by the margin, the end stays closed"
        }
        Unit::FrameStore => {
            "a retrace in the clock of the last pixel of a frame comes too early for it"
        }
        Unit::PostFilter => "halves are rounded up; beyond an edge the nearest pixel stands",
        Unit::Overlay => "a word read in the clock that writes it is the old one",
        Unit::Accumulator => "halves are rounded up",
        Unit::VisibilityNode | Unit::Decider | Unit::VisibilityChain | Unit::CardDecider => {
            SMALLER_ID
        }
        Unit::TransparencyStage | Unit::TransparencyPipeline => {
            "at equal depth the opaque surface hides the layer; 255ths have no halves"
        }
        Unit::CsgDecider => {
            "at equal depth a front goes before the back of an object taken away, then the smaller id, then the smaller face; what ends where a solid begins takes nothing of it away"
        }
        Unit::ShadowStage => "none: what is on the boundary of a volume its processor decides",
        Unit::Beam => {
            "at equal depth the smaller slot wins; within an object those of the quadric processor"
        }
        _ => NO_TIES,
    }
}
