//! Object processors and their parts.

use super::{EVERY_CLOCK, EXACT, HELD_WORDS, INTEGERS, NO_TIES, PIXELS, WORDS};
use crate::parameters::{CURVED_SIDES, FACES, FOUR_PLANES, PLANES, ROWS, SIDES};
use crate::unit::Record;

pub(crate) const QUADRIC_PE: Record = Record {
    name: "quadric_pe",
    computes: "the two depths f1 - r and f1 + r of a quadric, with r = floor(sqrt(f2))",
    source: "Nyiri 1994, 2.4.2",
    parameters: &[ROWS],
    latency: "ceil(W / R) + 2",
    throughput: PIXELS,
    ties: "f2 = 0 counts as inside, with both depths f1",
    error: "exact in f1 and f2 modulo their widths; the root is rounded down",
};

pub(crate) const PLANE_DEPTH: Record = Record {
    name: "plane_depth",
    computes: "the depth of a plane, clamped to the depth word",
    source: "Nyiri 1994, 2.4.2",
    parameters: &[],
    latency: "2",
    throughput: PIXELS,
    ties: "a value at a bound of the clamp is that bound",
    error: "exact after clamping; whoever makes the coefficients proves that the plane fits its words",
};

pub(crate) const CUT_PLANE: Record = Record {
    name: "cut_plane",
    computes: "one half of a depth interval cut by one plane",
    source: "Nyiri 1994, 2.4.2",
    parameters: &[],
    latency: "1",
    throughput: EVERY_CLOCK,
    ties: "a front plane at zf and a back plane at zb change nothing; a front plane at zb and a back plane at zf keep a sheet; zp = 0 passes a perpendicular plane",
    error: EXACT,
};

pub(crate) const DEPTH_INTERVAL: Record = Record {
    name: "depth_interval",
    computes: "the two halves of the depth interval of a quadric object",
    source: "Nyiri 1994, 2.4.2",
    parameters: &[],
    latency: "1",
    throughput: EVERY_CLOCK,
    ties: "f2 = 0 counts as inside; a near depth at 2^(W-1) - 1 or beyond is absent for a side object; a depth exactly at the near end is kept and gets no cap",
    error: EXACT,
};

pub(crate) const TWO_VOLUME_MERGE: Record = Record {
    name: "two_volume_merge",
    computes: "the half of a depth interval that lies in front",
    source: "Nyiri 1994, 2.4.2",
    parameters: &[],
    latency: "1",
    throughput: EVERY_CLOCK,
    ties: "half A wins at equal front depth",
    error: EXACT,
};

pub(crate) const NORMAL_UNIT: Record = Record {
    name: "normal_unit",
    computes: "the normal of the visible face of a quadric object",
    source: "Nyiri 1994, 2.4.2",
    parameters: &[PLANES],
    latency: "3",
    throughput: PIXELS,
    ties: NO_TIES,
    error: "exact in its integer words; against a normal in real numbers: the product K r loses the places shifted out and 6 bits, the result the low 8 of 24 bits, each by a floor",
};

pub(crate) const PATCH_DECIDER: Record = Record {
    name: "patch_decider",
    computes: "the first face of a bare surface that every plane keeps, all planes at once",
    source: "Nyiri 1994, 2.4.3",
    parameters: &[FOUR_PLANES],
    latency: "2",
    throughput: EVERY_CLOCK,
    ties: "a plane keeps a face that lies in it; the near face wins where both are left; f2 = 0 is inside",
    error: EXACT,
};

pub(crate) const QUADRIC_PROCESSOR: Record = Record {
    name: "quadric_processor",
    computes: "depth, face and normal of the visible front of one quadric object cut by planes",
    source: "Nyiri 1994, 2.4.2",
    parameters: &[PLANES, ROWS],
    latency: "ceil(W / R) + N + 7",
    throughput: HELD_WORDS,
    ties: "those of its parts: f2 = 0 is inside, planes at a face keep it, half A wins at equal front depth; box bounds are inclusive",
    error: WORDS,
};

pub(crate) const PATCH_PROCESSOR: Record = Record {
    name: "patch_processor",
    computes: "depth, face and normal of the visible face of a bare quadric surface cut by planes",
    source: "Nyiri 1994, 2.4.3 and 5.2.1",
    parameters: &[FOUR_PLANES, ROWS],
    latency: "ceil(W / R) + 7",
    throughput: HELD_WORDS,
    ties: "a plane keeps a face that lies in it; the near face wins where both are left; f2 = 0 is inside",
    error: WORDS,
};

pub(crate) const FIRST_GENERATION_PROCESSOR: Record = Record {
    name: "first_generation_processor",
    computes: "depth, face and normal of a quadric between two parallel planes, found by contours on the screen",
    source: "Nyiri 1994, 2.4.1",
    parameters: &[ROWS],
    latency: "ceil(W / R) + 6",
    throughput: HELD_WORDS,
    ties: "a plane exactly at a root of a solid is its face; of a surface it has removed that root; f2 = 0 is inside",
    error: INTEGERS,
};

pub(crate) const POLYHEDRON_PROCESSOR: Record = Record {
    name: "polyhedron_processor",
    computes: "front and back depth, faces and normals of a convex solid of planes",
    source: "Nyiri 1994, annex A; Chaillou 1991, IV.2.3",
    parameters: &[FACES],
    latency: "ceil(log2 N) + 4",
    throughput: HELD_WORDS,
    ties: "of planes at equal depth the smallest index wins; an interval of no thickness is there; a plane at the near end is not a face, the end is",
    error: INTEGERS,
};

pub(crate) const FACET_PROCESSOR: Record = Record {
    name: "facet_processor",
    computes: "depth and interpolated normal of a flat facet of three or four sides",
    source: "Chaillou 1991, IV.2.2",
    parameters: &[SIDES],
    latency: "2",
    throughput: PIXELS,
    ties: "zero is inside",
    error: INTEGERS,
};

pub(crate) const CURVED_FACET_PROCESSOR: Record = Record {
    name: "curved_facet_processor",
    computes: "depth and normal of a facet with sides, depth and normal of second degree",
    source: "Chaillou 1991, IV.2.6.1",
    parameters: &[CURVED_SIDES],
    latency: "2",
    throughput: PIXELS,
    ties: "zero is inside",
    error: INTEGERS,
};

pub(crate) const SPHERE_PROCESSOR: Record = Record {
    name: "sphere_processor",
    computes: "depth and normal of a sphere with exact outline and a paraboloid for the depth",
    source: "Chaillou 1991, IV.2.4",
    parameters: &[],
    latency: "4",
    throughput: HELD_WORDS,
    ties: "zero is inside",
    error: "exact in its integer words; against a sphere of radius R: outline exact, depth +29.5 % of R at the outline, -4.5 % at most inside, 5.1 % RMS",
};

pub(crate) const CYLINDER_PROCESSOR: Record = Record {
    name: "cylinder_processor",
    computes: "depth and normal of a cylinder with exact outline and a parabolic body",
    source: "Chaillou 1991, IV.2.5",
    parameters: &[],
    latency: "3",
    throughput: HELD_WORDS,
    ties: "zero is inside; the front disc goes before the body",
    error: "exact in its integer words; against a cylinder: outline and front disc exact, depth of the body that of the sphere processor over the part of the axis in the screen plane",
};

pub(crate) const QUADRIC_VOLUME: Record = Record {
    name: "quadric_volume",
    computes: "is the visible point in a shadow or light volume of a quadric and planes",
    source: "Nyiri 1994, 3.2.1 and 4.1.3",
    parameters: &[FOUR_PLANES, ROWS],
    latency: "ceil(W / R) + 4",
    throughput: HELD_WORDS,
    ties: "with margin 0 a point on the boundary is inside; with more the beginning is open by the margin, the end stays closed",
    error: INTEGERS,
};

pub(crate) const POLYHEDRAL_VOLUME: Record = Record {
    name: "polyhedral_volume",
    computes: "is the visible point in a shadow or light volume of planes",
    source: "Nyiri 1994, 3.2.1 and 4.1.3",
    parameters: &[FOUR_PLANES],
    latency: "3",
    throughput: HELD_WORDS,
    ties: "with margin 0 a point on the boundary is inside; with more the beginning is open by the margin, the end stays closed",
    error: INTEGERS,
};
