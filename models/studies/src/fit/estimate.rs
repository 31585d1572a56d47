//! A rough count of the logic cells of a machine, to try the cheap ones first. Costs that are reported come from
//! synthesis.

use imogene_contract::MachineWords;
use imogene_contract::object::Kind;
use imogene_contract::slots::FittedSlot;

/// Cells at 24 bits of kinds whose words follow from the depth word: of the processor, and of each plane or side.
const AT_24_BITS: [(Kind, [f64; 2]); 7] = [
    (Kind::Polyhedron, [130.0, 350.0]),
    (Kind::Facet, [470.0, 120.0]),
    (Kind::CurvedFacet, [1680.0, 420.0]),
    (Kind::Sphere, [1550.0, 0.0]),
    (Kind::Cylinder, [3220.0, 0.0]),
    (Kind::FirstGeneration, [3490.0, 0.0]),
    (Kind::Quotient, [3900.0, 300.0]),
];

/// Logic cells of ECP5, from the costs of the units at 24 bits and how they grow with their words: adders and registers
/// in proportion, the root network with the square of its rows.
pub fn of_slot(widths: &MachineWords, slot: &FittedSlot) -> f64 {
    let other = AT_24_BITS.into_iter().find(|(kind, _)| *kind == slot.kind);
    if let Some((_, [own, plane])) = other {
        return f64::from(widths.depth) / 24.0 * (own + plane * f64::from(slot.planes));
    }
    let widths = slot.words(widths);
    let [depth, root, plane, normal] =
        [widths.depth, widths.root, widths.plane, widths.normal].map(f64::from);
    let guards = [widths.guard_linear, widths.guard_quadratic].map(f64::from);
    let rows = root - f64::from(widths.dropped_rows);
    let linear = 5.0 * (depth + 2.0 + guards[0]);
    let quadratic = 11.0 * (2.0 * root + guards[1]);
    let network = 1.4 * rows * rows;
    let interval = 15.0 * depth;
    let planes = f64::from(slot.planes) * (6.0 * plane + 6.0 * depth);
    let normals = 3.0 * (8.0 * (normal + 8.0) + 4.0 * normal);
    linear + quadratic + network + interval + planes + normals
}
