//! Meanings and width formulas of the ports of every unit.

use super::processors::{self, Polynomial};
use super::shared::*;
use super::video;
use super::width::Width;
use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::EmitRequest;

/// A port as this module describes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Described {
    /// Name in the Verilog.
    pub name: String,
    /// Width.
    pub width: Width,
    /// Meaning.
    pub meaning: String,
}

/// The groups of ports of a unit, and those that it has alone.
fn groups(unit: Unit) -> Vec<&'static [Text]> {
    let mut list = vec![CLOCK];
    let more: &[&'static [Text]] = match unit {
        Unit::Pe1 => &[
            FLAGS,
            &[
                Text("a", SUM, "increment from pixel to pixel; read with start"),
                Text("b", SUM, "increment from line to line; read with start"),
                Text("c", SUM, "value at the first pixel; read with start"),
                Text("value", SUM, "a x + b y + c, modulo its width"),
            ],
        ],
        Unit::Pe2 => &[
            FLAGS,
            &[
                Text("a2", QUADRATIC, "2a; read with start"),
                Text("b2", QUADRATIC, "2b; read with start"),
                Text("c", QUADRATIC, "c; read with start"),
                Text(
                    "p0",
                    QUADRATIC,
                    "d + a, the first increment from pixel to pixel; read with start",
                ),
                Text(
                    "i0",
                    QUADRATIC,
                    "e + b, the first increment from line to line; read with start",
                ),
                Text(
                    "f",
                    QUADRATIC,
                    "f, the value at the first pixel; read with start",
                ),
                Text(
                    "value",
                    QUADRATIC,
                    "a x^2 + b y^2 + c xy + d x + e y + f, modulo its width",
                ),
            ],
        ],
        Unit::SquareRoot | Unit::SquareRootNonRestoring => &[RADICAND, ROOT, REMAINDER],
        Unit::SquareRootIterative => &[
            RADICAND,
            ROOT,
            REMAINDER,
            &[
                Text(
                    "start",
                    BIT,
                    "take the radicand; obeyed when not busy, ignored otherwise",
                ),
                Text("busy", BIT, "digits are being found"),
                Text(
                    "done",
                    BIT,
                    "root and remainder are complete; high for one clock",
                ),
            ],
        ],
        Unit::SquareRootRows | Unit::SquareRootLeading => &[RADICAND, SHORT_ROOT],
        Unit::SquareRootLinear | Unit::SquareRootQuadratic => &[RADICAND, APPROXIMATE],
        Unit::QuadricPe => &[
            FLAGS,
            F1,
            F2,
            SUMS,
            &[
                Text("root", W, "r = floor(sqrt(f2)), with the sums"),
                Text(
                    "late_valid",
                    BIT,
                    "valid, ceil(W / R) clocks later: for a PE1 that is to meet the sums",
                ),
                Text("late_start", BIT, "start, likewise"),
                Text("late_line", BIT, "line, likewise"),
            ],
        ],
        Unit::PlaneDepth => &[
            FLAGS,
            &[
                Text("a", PLANE, "increment from pixel to pixel; read with start"),
                Text("b", PLANE, "increment from line to line; read with start"),
                Text("c", PLANE, "value at the first pixel; read with start"),
                Text(
                    "depth",
                    W,
                    "a x + b y + c modulo the width of its words, clamped to [-2^(W-1), 2^(W-1) - 1]",
                ),
            ],
        ],
        Unit::CutPlane => &[CUT],
        Unit::DepthInterval => &[
            SUMS,
            CLASS,
            HALVES,
            &[Text(
                "in_box",
                BIT,
                "the pixel lies in the screen box of the object",
            )],
        ],
        Unit::TwoVolumeMerge => &[
            HALVES,
            &[
                Text("zf", W, "front depth of the half in front"),
                Text("nf", FACE, "its face number at the front"),
                Text("zb", W, "its back depth"),
                Text("nb", FACE, "its face number at the back"),
            ],
        ],
        Unit::NormalUnit => &[
            FLAGS,
            NORMAL_WORDS,
            PLANE_NORMALS,
            NORMAL_RESULT,
            &[
                Text(
                    "number",
                    FACE,
                    "visible face: 0 near root, 1 far root, 2 + i plane i, 15 near end; with the flags of its pixel",
                ),
                Text(
                    "absent",
                    BIT,
                    "nothing is seen at the pixel: the normal is zero",
                ),
                Text("root", W, "r = floor(sqrt(f2)) of the pixel"),
            ],
        ],
        Unit::QuadricProcessor => &[
            FLAGS,
            F1,
            F2,
            NORMAL_WORDS,
            BOX,
            CLASS,
            PLANES,
            PLANE_NORMALS,
            NORMAL_RESULT,
            &[
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
                Text(
                    "zf",
                    W,
                    "depth of the visible face; 2^(W-1) - 1 where the object is absent",
                ),
                Text("zb", W, "depth of the back of the interval"),
                Text(
                    "number",
                    FACE,
                    "visible face: 0 near root, 1 far root, 2 + i plane i, 15 near end",
                ),
            ],
        ],
        Unit::RasterControl => &[
            FLAGS_OUT,
            ZONE,
            &[
                Text("x", COORDINATE, "column of the pixel"),
                Text("y", COORDINATE, "line of the pixel"),
                Text("last", BIT, "last pixel of the zone"),
            ],
        ],
        Unit::VideoTiming => video::TIMING,
        Unit::PixelFifo => video::FIFO,
        Unit::FrameStore => video::STORE,
        Unit::PostFilter => video::FILTER,
        Unit::Overlay => video::OVERLAY,
        Unit::Accumulator => video::ACCUMULATOR,
        Unit::ShadingProcessor => &[SHADED],
        Unit::VisibilityNode => &[
            VISIBLE,
            NORMAL_RESULT,
            &[
                Text("a_depth", W, "depth of object a"),
                Text("a_id", ID, "number of object a"),
                Text("a_number", FACE, "face of object a"),
                Text("a_nx", NORMAL, "normal x of object a"),
                Text("a_ny", NORMAL, "normal y of object a"),
                Text("a_nz", NORMAL, "normal z of object a"),
                Text("b_depth", W, "depth of object b"),
                Text("b_id", ID, "number of object b"),
                Text("b_number", FACE, "face of object b"),
                Text("b_nx", NORMAL, "normal x of object b"),
                Text("b_ny", NORMAL, "normal y of object b"),
                Text("b_nz", NORMAL, "normal z of object b"),
            ],
        ],
        Unit::Decider => &[
            VISIBLE,
            NORMAL_RESULT,
            DECIDED,
            &[Text("input_#_depth", W, "depth of input #")],
        ],
        Unit::VisibilityChain => &[
            VISIBLE,
            NORMAL_RESULT,
            DECIDED,
            &[Text(
                "input_#_depth",
                W,
                "depth of input #; all of input # comes # clocks after input 0",
            )],
        ],
        Unit::CardDecider => &[
            VISIBLE,
            NORMAL_RESULT,
            DECIDED,
            &[Text(
                "input_#_depth",
                W,
                "depth of input #; all of input M k + p, place p of card k, comes p clocks after input 0",
            )],
        ],
        Unit::ShadowStage => &[&[
            Text(
                "flags_in",
                FLAG_WORD,
                "flags before these volumes: bit s is set where source s reaches the point; all ones in a first pass",
            ),
            Text(
                "volume_#_inside",
                BIT,
                "the visible point is inside volume #",
            ),
            Text(
                "volume_#_kind",
                BIT,
                "kind of volume #: 0 shadow, dark inside, 1 light, dark outside; held",
            ),
            Text(
                "volume_#_source",
                FACE,
                "source that volume # belongs to; held",
            ),
            Text(
                "volume_#_enabled",
                BIT,
                "volume # counts; without it it takes nothing away; held",
            ),
            Text("flags", FLAG_WORD, "flags after these volumes"),
        ]],
        Unit::TransparencyStage => &[
            BLEND,
            &[
                Text(
                    "layer_depth",
                    W,
                    "depth of the transparent object; 2^(W-1) - 1 where it is absent",
                ),
                Text("layer_red", COLOUR, "its red"),
                Text("layer_green", COLOUR, "its green"),
                Text("layer_blue", COLOUR, "its blue"),
                Text(
                    "layer_weight",
                    COLOUR,
                    "its part of what is seen, in 255ths; 255 is opaque",
                ),
            ],
        ],
        Unit::TransparencyPipeline => &[
            BLEND,
            &[
                Text(
                    "layer_#_depth",
                    W,
                    "depth of layer #, 2 # clocks after the pixel; 2^(W-1) - 1 where it is absent",
                ),
                Text("layer_#_red", COLOUR, "red of layer #"),
                Text("layer_#_green", COLOUR, "green of layer #"),
                Text("layer_#_blue", COLOUR, "blue of layer #"),
                Text(
                    "layer_#_weight",
                    COLOUR,
                    "part of layer # in what is seen, in 255ths; 255 is opaque",
                ),
            ],
        ],
        Unit::CsgDecider => &[&[
            Text(
                "intersected_#_zf",
                W,
                "front depth of intersected object #, product by product; 2^(W-1) - 1 where it is absent",
            ),
            Text("intersected_#_zb", W, "back depth of intersected object #"),
            Text("intersected_#_id", ID, "number of intersected object #"),
            Text(
                "intersected_#_number",
                FACE,
                "face at the front of intersected object #",
            ),
            Text(
                "subtracted_#_zf",
                W,
                "front depth of object # taken away, product by product, ceil(log2 I) clocks after the intersected; 2^(W-1) - 1 where it is absent",
            ),
            Text("subtracted_#_zb", W, "back depth of object # taken away"),
            Text("subtracted_#_id", ID, "number of object # taken away"),
            Text(
                "subtracted_#_number",
                FACE,
                "face at the back of object # taken away",
            ),
            Text(
                "depth",
                W,
                "depth that is seen; 2^(W-1) - 1 where nothing is",
            ),
            Text(
                "id",
                ID,
                "number of the object whose face is seen; 0 where nothing is",
            ),
            Text("number", FACE, "face that is seen; 0 where nothing is"),
            Text(
                "is_back",
                BIT,
                "it is the back of an object taken away: its normal is to be turned",
            ),
        ]],
        Unit::CoefficientStore => &[
            F1,
            F2,
            NORMAL_WORDS,
            BOX,
            CLASS,
            PLANES,
            PLANE_NORMALS,
            &[
                Text("write", BIT, "write data to address"),
                Text(
                    "address",
                    ID,
                    "address of the word (table of the load bus); others are ignored",
                ),
                Text(
                    "data",
                    QUADRATIC,
                    "the word; a narrower one sits in the low bits",
                ),
            ],
        ],
        Unit::Beam => &[
            ZONE,
            VISIBLE,
            NORMAL_RESULT,
            &[
                Text("valid", BIT, "this clock carries a pixel"),
                Text("load_valid", BIT, "write a coefficient word"),
                Text("load_object", ID, "slot of the word"),
                Text(
                    "load_address",
                    ID,
                    "address of the word within its slot (table of the load bus)",
                ),
                Text(
                    "load_data",
                    QUADRATIC,
                    "the word; a narrower one sits in the low bits",
                ),
            ],
        ],
        _ => processors::groups(unit),
    };
    list.extend(more);
    list
}

/// Every port that a unit with its parameters is described to have, in no order.
pub fn described(request: &EmitRequest) -> Vec<Described> {
    let groups = groups(request.unit);
    let texts = groups.into_iter().flatten();
    let ports = texts.flat_map(|Text(name, width, meaning)| {
        repeated(name, *width, meaning.to_string(), request)
    });
    let polynomials = processors::polynomials(request.unit).iter();
    // Of a single input the decider is a wire.
    let is_wire = request.unit == Unit::Decider && request.objects == 1;
    ports
        .chain(polynomials.flat_map(|polynomial| words(polynomial, request)))
        .filter(|port| !is_wire || port.name != "clock")
        .collect()
}

/// The ports of a polynomial's words.
fn words(
    Polynomial(prefix, degree, width, meaning): &Polynomial,
    request: &EmitRequest,
) -> Vec<Described> {
    let ports = degree.words().iter();
    ports
        .flat_map(|(part, what)| {
            let text = format!("{meaning}: {what}");
            repeated(&format!("{prefix}_{part}"), *width, text, request)
        })
        .collect()
}

fn repeated(name: &str, width: Width, meaning: String, request: &EmitRequest) -> Vec<Described> {
    let count = match (name.contains('#'), request.unit) {
        (false, _) => 1,
        (true, Unit::Decider | Unit::VisibilityChain | Unit::ShadowStage) => request.objects,
        (true, Unit::TransparencyPipeline) => request.layers(),
        (true, Unit::CsgDecider) if name.starts_with("intersected") => {
            request.products() * request.intersected()
        }
        (true, Unit::CsgDecider) => request.products() * request.subtracted(),
        (true, Unit::CardDecider) => request.objects * request.cards(),
        (true, Unit::FacetProcessor | Unit::CurvedFacetProcessor) => request.sides(),
        (true, Unit::FirstGenerationProcessor) => 2,
        (true, _) => request.planes,
    };
    let one = |index: usize| Described {
        name: name.replace('#', &index.to_string()),
        width,
        meaning: meaning.replace('#', &index.to_string()),
    };
    (0..count).map(one).collect()
}
