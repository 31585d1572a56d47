//! How far results are from what a unit computes: the one statement that the header of the Verilog and the contract both show.

use super::Unit;
use crate::emit::EmitRequest;

const EXACT: &str = "exact";
const MODULO: &str = "exact modulo the width of the value; whoever makes the coefficients proves that the true value fits";
const WORDS: &str = "exact in its integer words; imogene check SCENE bounds what the rounding of a scene to those words costs";

const INTEGERS: &str =
    "exact in its integer words; against real numbers: the rounding of the words, each once";

/// Greatest errors in percent of the root after 0, 1, 2 corrections: those of the formula, and those measured with floors at `W = 24` and
/// radicands not below `2^23` (docs/root-network.md).
const LINEAR: [[&str; 2]; 3] = [["6.066", "6.066"], ["1.647", "1.681"], ["0.473", "0.507"]];
const QUADRATIC: [[&str; 2]; 3] = [["1.345", "1.364"], ["0.532", "0.540"], ["0.219", "0.221"]];

impl Unit {
    /// How far a result is from what the unit computes, at the parameters of a request: exact, a bound, or a measured maximum.
    pub fn error(self, shape: &EmitRequest) -> String {
        match self {
            Self::Pe1 | Self::Pe2 | Self::ProgrammablePe | Self::MemoryPe2 => MODULO.into(),
            Self::SquareRootRows => format!(
                "bound: below 2^{} of the last place, downwards, for every radicand: small roots are lost",
                shape.depth_word - shape.digits()
            ),
            Self::SquareRootLeading => format!(
                "bound: below 2^{} of the root, downwards, or of one last place if that is more",
                1 - shape.digits() as i64
            ),
            Self::SquareRootLinear => approximate(&LINEAR, shape, "monotone"),
            Self::SquareRootQuadratic => approximate(
                &QUADRATIC,
                shape,
                "not monotone: the root steps down by one at some radicands",
            ),
            Self::QuadricPe => {
                "exact in f1 and f2 modulo their widths; the root is rounded down".into()
            }
            Self::PlaneDepth => {
                "exact after clamping; whoever makes the coefficients proves that the plane fits its words".into()
            }
            Self::NormalUnit => {
                "exact in its integer words; against a normal in real numbers: the product K r loses the places shifted out and 6 bits, the result the low 8 of 24 bits, each by a floor".into()
            }
            Self::QuadricProcessor | Self::PatchProcessor | Self::Beam => WORDS.into(),
            Self::FirstGenerationProcessor
            | Self::PolyhedronProcessor
            | Self::FacetProcessor
            | Self::CurvedFacetProcessor
            | Self::QuadricVolume
            | Self::PolyhedralVolume => INTEGERS.into(),
            Self::SphereProcessor => {
                "exact in its integer words; against a sphere of radius R: outline exact, depth +29.5 % of R at the outline, -4.5 % at most inside, 5.1 % RMS".into()
            }
            Self::CylinderProcessor => {
                "exact in its integer words; against a cylinder: outline and front disc exact, depth of the body that of the sphere processor over the part of the axis in the screen plane".into()
            }
            Self::TransparencyStage => "bound: half a step of a component".into(),
            Self::TransparencyPipeline => format!(
                "bound: half a step of a component for each of {} layers",
                shape.layers()
            ),
            Self::ShadingProcessor => {
                "within one level of 8 bits of the formula in real numbers on the same integer words (docs/shading.md)".into()
            }
            _ => EXACT.into(),
        }
    }
}

/// The statement of an approximate square root.
fn approximate(figures: &[[&str; 2]; 3], shape: &EmitRequest, steps: &str) -> String {
    let [formula, measured] = figures[shape.corrections()];
    format!(
        "bound: {formula} % of the root besides floors; measured maximum with floors: {measured} % at W = 24 and radicands not below 2^23; {steps}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_follow_the_parameters() {
        let short = |unit, digits| EmitRequest {
            digits: Some(digits),
            ..EmitRequest::new(unit)
        };
        let rows = short(Unit::SquareRootRows, 10);
        assert!(rows.unit.error(&rows).contains("below 2^14 of the last"));
        let leading = short(Unit::SquareRootLeading, 10);
        assert!(
            leading
                .unit
                .error(&leading)
                .contains("below 2^-9 of the root")
        );
        let none = EmitRequest {
            corrections: Some(0),
            ..EmitRequest::new(Unit::SquareRootQuadratic)
        };
        assert!(none.unit.error(&none).contains("1.345 %"));
        let two = EmitRequest::new(Unit::SquareRootLinear);
        assert!(two.unit.error(&two).contains("0.473 %"));
    }

    /// The figures are those of the page where they are measured.
    #[test]
    fn figures_are_those_of_the_documentation() {
        let page = include_str!("../../../docs/root-network.md");
        for (figures, measured) in [
            (&LINEAR, "6.066, 1.681, 0.507 %"),
            (&QUADRATIC, "1.364, 0.540, 0.221 %"),
        ] {
            let formula = figures.map(|[formula, _]| formula).join(", ");
            assert_eq!(
                figures.map(|[_, measured]| measured).join(", ") + " %",
                measured
            );
            assert!(page.contains(&format!("{formula} %")) && page.contains(measured));
        }
    }
}
