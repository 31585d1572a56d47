//! Work for each zone: which zones an object touches, and its words there (source: Table 5.8).

use super::costs::zoning;
use super::duplication::{Edges, touched};
use super::row::{Group, Row};

/// Kinds of objects that the source sorts into zones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Seven expressions of first degree.
    Facet,
    /// Eight, and one of second degree.
    Patch,
    /// Seven, and one of second degree.
    Quadric,
}

/// What the source prints for a kind.
struct Source {
    presort: f64,
    set_up: f64,
    corner: f64,
    shift: f64,
}

impl Kind {
    fn source(self) -> Source {
        let [presort, set_up, corner, shift] = match self {
            Kind::Facet => [48.0, 0.0, 15.0, 14.0],
            Kind::Patch => [60.0, 90.0, 20.0, 26.0],
            Kind::Quadric => [340.0, 420.0, 30.0, 24.0],
        };
        Source {
            presort,
            set_up,
            corner,
            shift,
        }
    }

    /// The same steps as we count them.
    fn ours(self) -> Source {
        let shift = |lines: f64, conics: f64| {
            lines * zoning::moved_line_by_shifts() + conics * zoning::moved_conic_by_shifts()
        };
        let [presort, set_up, corner, shift] = match self {
            Kind::Facet => [
                zoning::facet(),
                0.0,
                zoning::facet_corner(),
                shift(7.0, 0.0),
            ],
            Kind::Patch => [
                zoning::patch(),
                zoning::patch_outline(),
                zoning::patch_corner(),
                shift(8.0, 1.0),
            ],
            Kind::Quadric => [
                zoning::quadric_by_corners(),
                zoning::quadric_outline(),
                zoning::quadric_corner(),
                shift(7.0, 1.0),
            ],
        };
        Source {
            presort,
            set_up,
            corner,
            shift,
        }
    }
}

impl Source {
    /// Pre-sort, refinement at the corners of all zones that are touched, and a shift for every zone but the first, for a box of 20 in 32; `corners` of four zones.
    fn mean(&self, corners: f64) -> f64 {
        let share = touched(20, 32, Edges::Anywhere);
        let corners = 4.0 * share.one + 6.0 * share.two + corners * share.four;
        self.presort + self.set_up + self.corner * corners + self.shift * (share.mean - 1.0)
    }

    /// Pre-sort and refinement of n x n zones.
    fn refined(&self, n: f64) -> f64 {
        self.set_up + self.corner * (n + 1.0) * (n + 1.0)
    }
}

/// Our mean operations of a kind for its zones.
pub fn mean(kind: Kind) -> f64 {
    kind.ours().mean(9.0)
}

/// The source's mean, with nine corners of four zones.
pub fn source_mean(kind: Kind) -> f64 {
    kind.source().mean(9.0)
}

/// The rows.
pub fn group() -> Group {
    let row = |name: &str, printed: f64, ours: f64| {
        Row::new(name, "Table 5.8", printed, ours, "operations")
    };
    let [facet, patch, quadric] = [Kind::Facet, Kind::Patch, Kind::Quadric].map(Kind::ours);
    let mean_row = |name: &str, kind: Kind, printed: f64| {
        row(name, printed, mean(kind))
            .corrected(source_mean(kind))
            .why("four zones have nine corners, the print takes eight; ours with our steps")
    };
    let by_shifts =
        "additions alone: the side of a zone is a power of two, so the products are shifts";
    let corners = "a value with two products for each side, and a test";
    Group {
        name: "zones",
        title: "Zones: pre-sort, refinement, shift",
        about: "Pre-sort finds the zones of an object's box, refinement asks whether the outline meets each of them, shift moves the expressions to a zone."
            .into(),
        rows: vec![
            row("pre-sort, facet", 48.0, facet.presort)
                .why("least and greatest column and line, and the zones of four numbers; the source's figures are 12 for each corner and 12 besides"),
            row("pre-sort, quadric by the corners of a box in space", 340.0, quadric.presort)
                .corrected(340.0 + 88.0)
                .why("the print leaves out the division of the eight points; here the box of eight points is cheaper"),
            row("pre-sort, quadric by its outline", 340.0, zoning::quadric_by_outline())
                .corrected(340.0 + 88.0)
                .why("the tangents of the outline f2 = 0 along the axes, from coefficients that are there: no box in space is needed, and the screen box is exact"),
            row("pre-sort, patch", 60.0, patch.presort).why("as for the facet"),
            row("refinement, facet, each corner", 15.0, facet.corner).why(corners),
            row("refinement, quadric, set-up", 420.0, quadric.set_up)
                .why("12 edges of the box, each a line and the sides of the other six corners: 12 x 35; ours stops where two corners differ"),
            row("refinement, quadric, each corner", 30.0, quadric.corner).why(corners),
            row("refinement, patch, set-up", 90.0, patch.set_up)
                .why("6 edges, each a line and the sides of the other two corners: the same"),
            row("refinement, patch, each corner", 20.0, patch.corner).why(corners),
            row("refinement, patch, 5 x 5 zones", 810.0, patch.refined(5.0)).why("36 corners"),
            row("refinement, patch, 2 x 2 zones", 270.0, patch.refined(2.0)).why("nine corners, here too in the source"),
            row("refinement, quadric, 5 x 5 zones", 1500.0, quadric.refined(5.0)).why("36 corners"),
            row("refinement, quadric, 2 x 2 zones", 690.0, quadric.refined(2.0)).why("nine corners"),
            row("shift, facet", 14.0, facet.shift).why(by_shifts),
            row("shift, quadric", 24.0, quadric.shift).corrected(26.0).why(format!(
                "seven expressions of first degree at 2 and one of second degree at {}, where the print's formula drops 128 d from the constant, and the parts of its sum are 14 + 12; {by_shifts}",
                zoning::moved_conic_by_shifts()
            )),
            row("shift, patch", 26.0, patch.shift).corrected(28.0).why("eight expressions of first degree; the print has the two exchanged"),
            row("shift, facet, with products", 14.0, 7.0 * zoning::moved_line()).why("a zone of any size"),
            row("shift, patch, with products", 26.0, 8.0 * zoning::moved_line() + zoning::moved_conic())
                .corrected(28.0)
                .why("a zone of any size"),
            mean_row("facet of 20 x 20 in zones of 32, mean", Kind::Facet, 169.0),
            mean_row("patch of 20 x 20 in zones of 32, mean", Kind::Patch, 323.0),
            mean_row("quadric of 20 x 20 in zones of 32, mean", Kind::Quadric, 995.0),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The formula with the source's parts and eight corners gives the printed means, to their last digit.
    #[test]
    fn printed_means_follow_from_printed_parts() {
        for (kind, printed, corrected) in [
            (Kind::Facet, 169.0, 174.0),
            (Kind::Patch, 323.0, 330.0),
            (Kind::Quadric, 995.0, 1006.0),
        ] {
            let source = kind.source();
            assert!((source.mean(8.0) - printed).abs() <= 1.0, "{kind:?}");
            assert!((source.mean(9.0) - corrected).abs() <= 1.0, "{kind:?}");
        }
        let [patch, quadric] = [Kind::Patch, Kind::Quadric].map(Kind::source);
        assert_eq!([patch.refined(5.0), patch.refined(2.0)], [810.0, 270.0]);
        assert_eq!(
            [quadric.refined(5.0), quadric.refined(2.0)],
            [1500.0, 690.0]
        );
    }
}
