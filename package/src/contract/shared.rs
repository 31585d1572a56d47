//! Ports that several units have, and the widths of all.

use super::width::Width;

/// A port, or with `#` in its name one port for each plane or object: width and meaning.
pub(super) struct Text(pub &'static str, pub Width, pub &'static str);

pub(super) const BIT: Width = Width::fixed(1);
pub(super) const W: Width = Width::word(0);
pub(super) const ROUNDED: Width = Width::word(1);
pub(super) const SUM: Width = Width::word(2);
pub(super) const QUADRATIC: Width = Width::double();
pub(super) const PLANE: Width = Width::word(12);
pub(super) const COORDINATE: Width = Width::fixed(12);
pub(super) const FACE: Width = Width::fixed(4);
pub(super) const PART: Width = Width::fixed(24);
pub(super) const NORMAL: Width = Width::fixed(16);
pub(super) const FLAG_WORD: Width = Width::fixed(16);
pub(super) const COLOUR: Width = Width::fixed(8);
pub(super) const ID: Width = Width::fixed(8);

/// What a stage for transparent objects takes and hands on besides them.
pub(super) const BLEND: &[Text] = &[
    Text("pixel_depth", W, "depth of the opaque surface"),
    Text("pixel_red", COLOUR, "red seen so far"),
    Text("pixel_green", COLOUR, "green seen so far"),
    Text("pixel_blue", COLOUR, "blue seen so far"),
    Text("depth", W, "depth of the opaque surface"),
    Text("red", COLOUR, "red that is seen"),
    Text("green", COLOUR, "green that is seen"),
    Text("blue", COLOUR, "blue that is seen"),
];
/// What a decider takes of each object besides its depth.
pub(super) const DECIDED: &[Text] = &[
    Text("input_#_id", ID, "number of the object on input #"),
    Text("input_#_number", FACE, "face of the object on input #"),
    Text("input_#_nx", NORMAL, "normal x of the object on input #"),
    Text("input_#_ny", NORMAL, "normal y of the object on input #"),
    Text("input_#_nz", NORMAL, "normal z of the object on input #"),
];
pub(super) const CLOCK: &[Text] = &[Text("clock", BIT, "rising edge")];
pub(super) const FLAGS: &[Text] = &[
    Text(
        "valid",
        BIT,
        "this clock carries a pixel; without it no state of the elementary processors changes",
    ),
    Text("start", BIT, "first pixel of the zone; counts under valid"),
    Text(
        "line",
        BIT,
        "first pixel of any other line; counts under valid",
    ),
];
pub(super) const F1: &[Text] = &[
    Text(
        "f1_a",
        SUM,
        "linear part of the depth: increment from pixel to pixel",
    ),
    Text(
        "f1_b",
        SUM,
        "linear part of the depth: increment from line to line",
    ),
    Text(
        "f1_c",
        SUM,
        "linear part of the depth: value at the first pixel",
    ),
];
pub(super) const F2: &[Text] = &[
    Text(
        "f2_a2",
        QUADRATIC,
        "quadratic f2 = a x^2 + b y^2 + c xy + d x + e y + f: 2a",
    ),
    Text("f2_b2", QUADRATIC, "quadratic: 2b"),
    Text("f2_c", QUADRATIC, "quadratic: c"),
    Text(
        "f2_p0",
        QUADRATIC,
        "quadratic: d + a, the first increment from pixel to pixel",
    ),
    Text(
        "f2_i0",
        QUADRATIC,
        "quadratic: e + b, the first increment from line to line",
    ),
    Text(
        "f2_f",
        QUADRATIC,
        "quadratic: f, its value at the first pixel",
    ),
];
pub(super) const NORMAL_WORDS: &[Text] = &[
    Text(
        "gx_a",
        PART,
        "linear part of normal x: increment from pixel to pixel",
    ),
    Text(
        "gx_b",
        PART,
        "linear part of normal x: increment from line to line",
    ),
    Text(
        "gx_c",
        PART,
        "linear part of normal x: value at the first pixel",
    ),
    Text(
        "gy_a",
        PART,
        "linear part of normal y: increment from pixel to pixel",
    ),
    Text(
        "gy_b",
        PART,
        "linear part of normal y: increment from line to line",
    ),
    Text(
        "gy_c",
        PART,
        "linear part of normal y: value at the first pixel",
    ),
    Text(
        "gz_a",
        PART,
        "linear part of normal z: increment from pixel to pixel",
    ),
    Text(
        "gz_b",
        PART,
        "linear part of normal z: increment from line to line",
    ),
    Text(
        "gz_c",
        PART,
        "linear part of normal z: value at the first pixel",
    ),
    Text("kx", NORMAL, "factor of the root in normal x"),
    Text("ky", NORMAL, "factor of the root in normal y"),
    Text("kz", NORMAL, "factor of the root in normal z"),
    Text(
        "shift",
        Width::fixed(5),
        "places the root is shifted right for the normal",
    ),
];
pub(super) const PLANE_NORMALS: &[Text] = &[
    Text("plane_#_nx", NORMAL, "normal x of plane #"),
    Text("plane_#_ny", NORMAL, "normal y of plane #"),
    Text("plane_#_nz", NORMAL, "normal z of plane #"),
];
pub(super) const PLANES: &[Text] = &[
    Text(
        "plane_#_kind",
        Width::fixed(2),
        "kind of plane #: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0)",
    ),
    Text(
        "plane_#_a",
        PLANE,
        "depth zp of plane #: increment from pixel to pixel",
    ),
    Text(
        "plane_#_b",
        PLANE,
        "depth zp of plane #: increment from line to line",
    ),
    Text(
        "plane_#_c",
        PLANE,
        "depth zp of plane #: value at the first pixel",
    ),
];
pub(super) const BOX: &[Text] = &[
    Text(
        "box_x0",
        COORDINATE,
        "first column of the screen box; empty if beyond the last",
    ),
    Text("box_x1", COORDINATE, "last column of the screen box"),
    Text("box_y0", COORDINATE, "first line of the screen box"),
    Text("box_y1", COORDINATE, "last line of the screen box"),
];
pub(super) const CLASS: &[Text] = &[Text(
    "object_class",
    Width::fixed(2),
    "class of the object: 0 side, 1 front, 2 patch, 3 prism",
)];
pub(super) const HALVES: &[Text] = &[
    Text("zf_a", W, "front depth of half A"),
    Text("nf_a", FACE, "face number at the front of half A"),
    Text("zb_a", W, "back depth of half A"),
    Text("nb_a", FACE, "face number at the back of half A"),
    Text("zf_b", W, "front depth of half B"),
    Text("nf_b", FACE, "face number at the front of half B"),
    Text("zb_b", W, "back depth of half B"),
    Text("nb_b", FACE, "face number at the back of half B"),
];
pub(super) const SUMS: &[Text] = &[
    Text("near_sum", SUM, "f1 - r, modulo its width"),
    Text("far_sum", SUM, "f1 + r, modulo its width"),
    Text(
        "is_inside",
        BIT,
        "f2 >= 0; where it is low the depths and the root mean nothing",
    ),
];
pub(super) const NORMAL_RESULT: &[Text] = &[
    Text("nx", NORMAL, "normal x of the visible face"),
    Text("ny", NORMAL, "normal y of the visible face"),
    Text("nz", NORMAL, "normal z of the visible face"),
];
pub(super) const VISIBLE: &[Text] = &[
    Text(
        "depth",
        W,
        "depth of the nearest; 2^(W-1) - 1 is the far end, that is nothing there",
    ),
    Text("id", ID, "number of the nearest object"),
    Text("number", FACE, "number of its visible face"),
];
pub(super) const SHADED: &[Text] = &[
    Text("valid", BIT, "this clock carries a pixel"),
    Text("x", COORDINATE, "column of the pixel on the screen"),
    Text("y", COORDINATE, "line of the pixel on the screen"),
    Text("depth", W, "depth; 2^(W-1) - 1 is the background"),
    Text("material", ID, "number of the material"),
    Text("nx", NORMAL, "normal x, of any length"),
    Text("ny", NORMAL, "normal y"),
    Text("nz", NORMAL, "normal z"),
    Text("flags", NORMAL, "bit i: source i reaches the point"),
    Text(
        "load_valid",
        BIT,
        "write a word; only while no pixel is inside",
    ),
    Text(
        "load_address",
        NORMAL,
        "address of the word, section 8 of the architecture",
    ),
    Text("load_data", Width::fixed(32), "the word, in the low bits"),
    Text("out_valid", BIT, "valid, with the colour of its pixel"),
    Text("red", ID, "red, 0 to 255"),
    Text("green", ID, "green, 0 to 255"),
    Text("blue", ID, "blue, 0 to 255"),
];
pub(super) const RADICAND: &[Text] = &[Text("radicand", QUADRATIC, "number to take the root of")];
pub(super) const ROOT: &[Text] = &[Text("root", W, "floor(sqrt(radicand))")];
pub(super) const REMAINDER: &[Text] = &[Text("remainder", ROUNDED, "radicand - root^2")];
pub(super) const APPROXIMATE: &[Text] = &[Text("root", ROUNDED, "approximate root, at most 2^W")];
pub(super) const SHORT_ROOT: &[Text] = &[Text(
    "root",
    W,
    "root whose D digits are kept, the lower ones zero",
)];
pub(super) const ZONE: &[Text] = &[
    Text(
        "go",
        BIT,
        "begin a zone; obeyed when idle or with the last pixel of a zone, ignored otherwise",
    ),
    Text(
        "width",
        COORDINATE,
        "pixels of a line, at least 1; read with an obeyed go",
    ),
    Text(
        "height",
        COORDINATE,
        "lines of the zone, at least 1; read with an obeyed go",
    ),
];

pub(super) const CUT: &[Text] = &[
    Text(
        "kind",
        Width::fixed(2),
        "kind of the plane: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0)",
    ),
    Text(
        "surface",
        BIT,
        "the object is a bare surface (class patch), not a solid",
    ),
    Text("number", FACE, "face number of the plane"),
    Text("zp", W, "clamped depth of the plane"),
    Text("zf", W, "front depth"),
    Text("nf", FACE, "face number at the front"),
    Text("zb", W, "back depth"),
    Text("nb", FACE, "face number at the back"),
    Text("cut_zf", W, "front depth after the cut"),
    Text("cut_nf", FACE, "face number at the front after the cut"),
    Text("cut_zb", W, "back depth after the cut"),
    Text("cut_nb", FACE, "face number at the back after the cut"),
];

pub(super) const FLAGS_OUT: &[Text] = &[
    Text("valid", BIT, "this clock carries a pixel"),
    Text("start", BIT, "first pixel of the zone"),
    Text("line", BIT, "first pixel of any other line"),
];
