//! Meanings and width formulas of the ports of the object processors, and of the elementary processors with a mode or a memory.

use super::shared::*;
use super::width::Width;
use imogene_rtl::catalogue::Unit;

/// The words of a polynomial in the pixel's column and line, one port for each: a prefix, which may hold `#`, their degree, width, meaning.
pub(super) struct Polynomial(pub &'static str, pub Degree, pub Width, pub &'static str);

/// Degree of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Degree {
    First,
    Second,
}

use Degree::{First, Second};

impl Degree {
    /// Words of a polynomial and what they are.
    pub fn words(self) -> &'static [(&'static str, &'static str)] {
        match self {
            First => &[
                ("a", "increment from pixel to pixel"),
                ("b", "increment from line to line"),
                ("c", "value at the first pixel"),
            ],
            Second => &[
                ("a2", "2a of a x^2 + b y^2 + c xy + d x + e y + f"),
                ("b2", "2b"),
                ("c", "c"),
                ("i0", "e + b, the first increment from line to line"),
                ("p0", "d + a, the first increment from pixel to pixel"),
                ("f", "f, the value at the first pixel"),
            ],
        }
    }
}

const PIXEL: &[Text] = &[
    Text(
        "x",
        COORDINATE,
        "column of the pixel, counted from the first of the zone",
    ),
    Text(
        "y",
        COORDINATE,
        "line of the pixel, counted from the first of the zone",
    ),
    Text("out_valid", BIT, "valid, with the results of its pixel"),
];
const DEPTHS: &[Text] = &[
    Text(
        "zf",
        W,
        "depth of the visible face; 2^(W-1) - 1 where the object is absent",
    ),
    Text(
        "zb",
        W,
        "depth of the back; that of the front where there is one face only",
    ),
];
const SURFACE_FACE: &[Text] = &[Text(
    "number",
    FACE,
    "visible face: 0 near root, 1 far root",
)];
const PLANE_FACE: &[Text] = &[Text(
    "number",
    FACE,
    "visible face: 2 + i plane i, 15 near end",
)];
const QUADRIC_FACE: &[Text] = &[Text(
    "number",
    FACE,
    "visible face: 0 near root, 1 far root, 2 front plane, 15 near end",
)];
const FACET_FACE: &[Text] = &[Text("number", FACE, "2; 0 where the facet is absent")];
const CURVED_FACE: &[Text] = &[Text("number", FACE, "0")];
const SPHERE_FACE: &[Text] = &[Text("number", FACE, "visible face: 0 sphere, 15 near end")];
const CYLINDER_FACE: &[Text] = &[Text("number", FACE, "visible part: 0 body, 2 front disc")];
const BACK_FACE: &[Text] = &[
    Text("back_number", FACE, "face at zb: 2 + i plane i, 15 far end"),
    Text("back_nx", NORMAL, "normal x of the face at zb"),
    Text("back_ny", NORMAL, "normal y of the face at zb"),
    Text("back_nz", NORMAL, "normal z of the face at zb"),
];
const BARE: &[Text] = &[Text(
    "surface",
    BIT,
    "the object is a bare surface, not a solid",
)];
const SUM_OF_DEPTHS: &[Text] = &[Text(
    "depth_sum",
    SUM,
    "front depth plus back depth, the same at every pixel",
)];
const LID_NORMAL: &[Text] = &[
    Text("lid_nx", NORMAL, "normal x of the front disc"),
    Text("lid_ny", NORMAL, "normal y of the front disc"),
    Text("lid_nz", NORMAL, "normal z of the front disc"),
];
const POINT: &[Text] = &[
    Text(
        "depth",
        W,
        "visible depth of the pixel, ceil(W / R) + 1 clocks after its flags where the volume has a quadric, with them where not",
    ),
    Text(
        "margin",
        W,
        "counts that a point has to lie behind the beginning of the volume, at most 2^(W-1) - 1",
    ),
    Text(
        "is_inside",
        BIT,
        "the visible point lies in the volume; the background does not",
    ),
];
const UNIT: &[Text] = &[Text(
    "depth_shift",
    FACE,
    "the quadric's depths are in units of 2^depth_shift depth words",
)];
const DECISION: &[Text] = &[
    Text(
        "in_box",
        BIT,
        "the pixel lies in the screen box of the object",
    ),
    Text(
        "plane_#_kind",
        Width::fixed(2),
        "kind of plane #: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0)",
    ),
    Text("plane_#_zp", W, "clamped depth of plane #, beside the sums"),
];
const LANES: &[Text] = &[
    Text(
        "split",
        BIT,
        "four polynomials of first degree; read with start",
    ),
    Text(
        "used",
        Width::fixed(4),
        "bit i: the decision asks lane i; read with start",
    ),
    Text(
        "a2",
        QUADRATIC,
        "2a; split, a of lanes 2 (low half) and 3; read with start",
    ),
    Text(
        "b2",
        QUADRATIC,
        "2b; split, a of lanes 0 (low half) and 1; read with start",
    ),
    Text(
        "c",
        QUADRATIC,
        "c; split, b of lanes 2 and 3; read with start",
    ),
    Text(
        "i0",
        QUADRATIC,
        "e + b; split, b of lanes 0 and 1; read with start",
    ),
    Text(
        "p0",
        QUADRATIC,
        "d + a; split, c of lanes 2 and 3; read with start",
    ),
    Text(
        "f",
        QUADRATIC,
        "f; split, c of lanes 0 and 1; read with start",
    ),
    Text(
        "value",
        QUADRATIC,
        "the polynomial of second degree, modulo its width",
    ),
    Text(
        "lane_0",
        W,
        "split, the polynomial of lane 0, modulo its width",
    ),
    Text(
        "lane_1",
        W,
        "split, the polynomial of lane 1, modulo its width",
    ),
    Text(
        "lane_2",
        W,
        "split, the polynomial of lane 2, modulo its width",
    ),
    Text(
        "lane_3",
        W,
        "split, the polynomial of lane 3, modulo its width",
    ),
    Text(
        "is_inside",
        BIT,
        "no used lane, or not the value, is negative; one clock after the values",
    ),
];
const MEMORY: &[Text] = &[
    Text(
        "load_valid",
        BIT,
        "write a word of the memory; obeyed when ready",
    ),
    Text(
        "load_address",
        Width::fixed(4),
        "0 2A, 1 2B, 2 C, 3 E - B, 4 D - A, 5 F of the polynomial moved by (-1, -1); 6 to 8 the copies of 3 to 5",
    ),
    Text("load_data", QUADRATIC, "the word"),
    Text(
        "field_start",
        BIT,
        "command: restore words 3 to 5 from their copies and begin a field, 6 clocks",
    ),
    Text(
        "odd_field",
        BIT,
        "the field has the lines 1, 3, 5, ..; read with field_start",
    ),
    Text(
        "picture_start",
        BIT,
        "command: begin a progressive picture, 1 clock",
    ),
    Text(
        "line_start",
        BIT,
        "command: step to the next line; 15 clocks, 27 in a field but for the first line of the even one",
    ),
    Text("pixel", BIT, "command: step to the next pixel, 1 clock"),
    Text("ready", BIT, "a command is obeyed on the next clock"),
    Text("value_valid", BIT, "the value is that of a pixel"),
    Text("value", QUADRATIC, "the polynomial, modulo its width"),
];
const FACE_RESULT: &[Text] = &[
    Text(
        "zf",
        W,
        "depth of the visible face; 2^(W-1) - 1 where the object is absent",
    ),
    Text("zb", W, "depth of the other face if both are left, else zf"),
    Text("number", FACE, "visible face: 0 near root, 1 far root"),
];

/// The groups of ports of a unit of this page besides the clock and the words of polynomials; none for any other unit.
pub(super) fn groups(unit: Unit) -> &'static [&'static [Text]] {
    match unit {
        Unit::ProgrammablePe => &[FLAGS, LANES],
        Unit::MemoryPe2 => &[MEMORY],
        Unit::PatchDecider => &[SUMS, DECISION, FACE_RESULT],
        Unit::PatchProcessor => &[
            FLAGS,
            PIXEL,
            F1,
            F2,
            NORMAL_WORDS,
            BOX,
            PLANES,
            DEPTHS,
            SURFACE_FACE,
            NORMAL_RESULT,
        ],
        Unit::FirstGenerationProcessor => &[
            FLAGS,
            PIXEL,
            F1,
            F2,
            NORMAL_WORDS,
            BOX,
            BARE,
            PLANE_NORMALS,
            DEPTHS,
            QUADRIC_FACE,
            NORMAL_RESULT,
        ],
        Unit::PolyhedronProcessor => &[
            FLAGS,
            PIXEL,
            BOX,
            PLANES,
            PLANE_NORMALS,
            DEPTHS,
            PLANE_FACE,
            NORMAL_RESULT,
            BACK_FACE,
        ],
        Unit::FacetProcessor => &[FLAGS, PIXEL, BOX, DEPTHS, FACET_FACE, NORMAL_RESULT],
        Unit::CurvedFacetProcessor => &[FLAGS, PIXEL, BOX, DEPTHS, CURVED_FACE, NORMAL_RESULT],
        Unit::SphereProcessor => &[
            FLAGS,
            PIXEL,
            BOX,
            SUM_OF_DEPTHS,
            DEPTHS,
            SPHERE_FACE,
            NORMAL_RESULT,
        ],
        Unit::CylinderProcessor => &[
            FLAGS,
            PIXEL,
            BOX,
            LID_NORMAL,
            DEPTHS,
            CYLINDER_FACE,
            NORMAL_RESULT,
        ],
        Unit::QuadricVolume => &[FLAGS, PIXEL, POINT, UNIT, F1, F2, BOX, CLASS, PLANES],
        Unit::PolyhedralVolume => &[FLAGS, PIXEL, POINT, BOX, PLANES],
        _ => &[],
    }
}

/// The polynomials of a unit whose words are ports.
pub(super) fn polynomials(unit: Unit) -> &'static [Polynomial] {
    const FINE_PLANE: &str = "in units of 2^-10 depth words";
    match unit {
        Unit::FirstGenerationProcessor => &[
            Polynomial("depth_0", First, PLANE, "depth of the front plane"),
            Polynomial("depth_1", First, PLANE, "depth of the back plane"),
            Polynomial(
                "conic_0",
                Second,
                QUADRATIC,
                "not negative where the front plane is inside the quadric",
            ),
            Polynomial(
                "conic_1",
                Second,
                QUADRATIC,
                "not negative where the back plane is inside the quadric",
            ),
            Polynomial(
                "polar_0",
                First,
                PLANE,
                "negative where the front plane has the middle of the quadric on its removed side",
            ),
            Polynomial(
                "polar_1",
                First,
                PLANE,
                "negative where the back plane has the middle of the quadric on its removed side",
            ),
        ],
        Unit::FacetProcessor => &[
            Polynomial("side_#", First, PLANE, "not negative inside side #"),
            Polynomial("depth", First, PLANE, FINE_PLANE),
            Polynomial("nx", First, PART, "normal x in units of 2^-8"),
            Polynomial("ny", First, PART, "normal y in units of 2^-8"),
            Polynomial("nz", First, PART, "normal z in units of 2^-8"),
        ],
        Unit::CurvedFacetProcessor => &[
            Polynomial("side_#", Second, QUADRATIC, "not negative inside side #"),
            Polynomial(
                "depth",
                Second,
                QUADRATIC,
                "depth in units of 2^-(W-2) depth words",
            ),
            Polynomial("nx", Second, QUADRATIC, "normal x in units of 2^-(2W-16)"),
            Polynomial("ny", Second, QUADRATIC, "normal y in units of 2^-(2W-16)"),
            Polynomial("nz", Second, QUADRATIC, "normal z in units of 2^-(2W-16)"),
        ],
        Unit::SphereProcessor => &[
            Polynomial(
                "outline",
                Second,
                QUADRATIC,
                "not negative inside the outline",
            ),
            Polynomial(
                "front",
                Second,
                QUADRATIC,
                "front depth in units of 2^-(W-2) depth words",
            ),
            Polynomial("nx", First, PART, "normal x in units of 2^-8"),
            Polynomial("ny", First, PART, "normal y in units of 2^-8"),
            Polynomial("nz", Second, QUADRATIC, "normal z in units of 2^-(2W-16)"),
        ],
        Unit::CylinderProcessor => &[
            Polynomial(
                "side_0",
                First,
                PLANE,
                "not negative inside side 0 of the rectangle between the discs",
            ),
            Polynomial(
                "side_1",
                First,
                PLANE,
                "not negative inside side 1 of the rectangle between the discs",
            ),
            Polynomial(
                "side_2",
                First,
                PLANE,
                "not negative inside side 2 of the rectangle between the discs",
            ),
            Polynomial(
                "side_3",
                First,
                PLANE,
                "not negative inside side 3 of the rectangle between the discs",
            ),
            Polynomial(
                "disc_0",
                Second,
                QUADRATIC,
                "not negative in the front disc",
            ),
            Polynomial("disc_1", Second, QUADRATIC, "not negative in the back disc"),
            Polynomial(
                "body",
                Second,
                QUADRATIC,
                "depth of the body in units of 2^-(W-2) depth words",
            ),
            Polynomial(
                "nx",
                Second,
                QUADRATIC,
                "normal x of the body in units of 2^-(2W-16)",
            ),
            Polynomial(
                "ny",
                Second,
                QUADRATIC,
                "normal y of the body in units of 2^-(2W-16)",
            ),
            Polynomial(
                "nz",
                Second,
                QUADRATIC,
                "normal z of the body in units of 2^-(2W-16)",
            ),
            Polynomial(
                "lid",
                First,
                PLANE,
                "depth of the front disc in units of 2^-10 depth words",
            ),
        ],
        _ => &[],
    }
}
