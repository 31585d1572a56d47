//! Throughput, ties and error of every unit.

use imogene_rtl::catalogue::Unit;

/// What a unit states besides its ports and latency.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Statement {
    /// Results per clock.
    pub throughput: &'static str,
    /// What happens at equality.
    pub ties: &'static str,
    /// How far a result is from what is computed.
    pub error: &'static str,
}

const EVERY_CLOCK: &str = "one result per clock";
const PIXELS: &str = "one pixel per clock, no bubble between lines or zones";
const NO_TIES: &str = "none: nothing is compared";
const EXACT: &str = "exact";
const MODULO: &str = "exact modulo the width of the value; whoever makes the coefficients proves that the true value fits";
const SMALLER_ID: &str =
    "at equal depth the smaller id wins, so the result does not depend on the order of the inputs";

/// The statement of a unit.
pub const fn of(unit: Unit) -> Statement {
    Statement {
        throughput: throughput(unit),
        ties: ties(unit),
        error: error(unit),
    }
}

const fn throughput(unit: Unit) -> &'static str {
    match unit {
        Unit::SquareRootIterative => "one result every W clocks",
        Unit::CoefficientStore => "one word written per clock",
        Unit::Pe1
        | Unit::Pe2
        | Unit::QuadricPe
        | Unit::PlaneDepth
        | Unit::NormalUnit
        | Unit::RasterControl => PIXELS,
        Unit::QuadricProcessor | Unit::Beam => {
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
        Unit::VisibilityNode | Unit::Decider => SMALLER_ID,
        Unit::Beam => {
            "at equal depth the smaller slot wins; within an object those of the quadric processor"
        }
        _ => NO_TIES,
    }
}

const fn error(unit: Unit) -> &'static str {
    match unit {
        Unit::Pe1 | Unit::Pe2 => MODULO,
        Unit::SquareRootRows => {
            "below 2^(W-D) of the last place, downwards, for every radicand: small roots are lost"
        }
        Unit::SquareRootLeading => {
            "below 2^(1-D) of the root, downwards, or of one last place if that is more"
        }
        Unit::SquareRootLinear => {
            "6.066, 1.647, 0.473 % of the root after 0, 1, 2 corrections, besides floors; with floors 6.066, 1.681, 0.507 % at W = 24 and radicands not below 2^23; monotone"
        }
        Unit::SquareRootQuadratic => {
            "1.345, 0.532, 0.219 % of the root after 0, 1, 2 corrections, besides floors; with floors 1.364, 0.540, 0.221 % at W = 24 and radicands not below 2^23; not monotone: the root steps down by one at some radicands"
        }
        Unit::QuadricPe => "exact in f1 and f2 modulo their widths; the root is rounded down",
        Unit::PlaneDepth => {
            "exact after clamping; whoever makes the coefficients proves that the plane fits its words"
        }
        Unit::NormalUnit => {
            "exact in its integer words; against a normal in real numbers: the product K r loses the places shifted out and 6 bits, the result the low 8 of 24 bits, each by a floor"
        }
        Unit::QuadricProcessor | Unit::Beam => {
            "exact in its integer words; `imogene check SCENE` bounds what the rounding of a scene to those words costs"
        }
        _ => EXACT,
    }
}
