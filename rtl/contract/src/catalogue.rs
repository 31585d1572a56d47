//! The units: the name of each, and its record.

use crate::parameters::{
    CARDS, CORRECTIONS, CURVED_SIDES, DIGITS, FACES, FOUR_PLANES, INTERSECTED, LAYERS, LIGHTS,
    MODE, OBJECTS, PLANES, ROWS, SIDES, SUBTRACTED, SUNS, TABLE_PLACES, TABLES, TWO_CORRECTIONS,
};
use crate::record::Record;

// What several records state.
const EVERY_CLOCK: &str = "one result per clock";
const PIXELS: &str = "one pixel per clock, no bubble between lines or zones";
const ZONE_WORDS: &str = "one pixel per clock, no bubble between lines or zones; coefficients change only with the start of a zone";
const HELD_WORDS: &str = "one pixel per clock, no bubble between lines; coefficients change only when the pipeline has drained";

const NO_TIES: &str = "none: nothing is compared";
const SMALLER_ID: &str =
    "at equal depth the smaller id wins, so the result does not depend on the order of the inputs";

const EXACT: &str = "exact";
const MODULO: &str = "exact modulo the width of the value; whoever makes the coefficients proves that the true value fits";
const WORDS: &str = "exact in its integer words; imogene check SCENE bounds what the rounding of a scene to those words costs";
const INTEGERS: &str =
    "exact in its integer words; against real numbers: the rounding of the words, each once";

macro_rules! units {
    ($($unit:ident $name:literal $parameters:tt $latency:literal, $throughput:expr, $source:literal;
        computes $computes:literal;
        ties $ties:expr;
        error $error:expr;)*) => {
        /// A unit that is a design by itself, from the smallest to the machine.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Unit {
            $(#[doc = $computes] $unit,)*
        }

        impl Unit {
            /// All units.
            pub const ALL: [Unit; [$(Unit::$unit),*].len()] = [$(Unit::$unit),*];

            /// What is stated of it.
            pub const fn record(self) -> &'static Record {
                match self {
                    $(Unit::$unit => &Record {
                        name: $name,
                        computes: $computes,
                        source: $source,
                        parameters: &$parameters,
                        latency: $latency,
                        throughput: $throughput,
                        ties: $ties,
                        error: $error,
                    },)*
                }
            }
        }
    };
}

// Unit, name, parameters, latency, throughput, source.
units! {
    // Elementary processors.
    Pe1 "pe1" [] "1", ZONE_WORDS, "Nyiri 1994, 2.3.2 and B.2.1";
        computes "value(x, y) = a x + b y + c by additions alone, one pixel per clock";
        ties NO_TIES;
        error MODULO;
    Pe2 "pe2" [] "1", ZONE_WORDS, "Nyiri 1994, 2.3.2 and B.2.1";
        computes "value(x, y) = a x^2 + b y^2 + c xy + d x + e y + f by additions alone, one pixel per clock";
        ties NO_TIES;
        error MODULO;
    ProgrammablePe "programmable_pe" [] "1", PIXELS, "Chaillou 1991, IV.1.7";
        computes "value(x, y) of second degree, or four of first degree with the decision on their signs, by additions alone";
        ties "zero is inside";
        error MODULO;
    MemoryPe2 "memory_pe2" [] "1", "one pixel per clock within a line; 15 clocks between lines, 27 in a field", "Chaillou 1991, IV.1.5";
        computes "value(x, y) of second degree by two adders, three registers and a memory of one port, field by field";
        ties NO_TIES;
        error MODULO;

    // The square root and what stands in for it.
    SquareRoot "square_root" [ROWS] "ceil(W / R)", EVERY_CLOCK, "Nyiri 1994, 2.3.3";
        computes "root = floor(sqrt(radicand)) and remainder = radicand - root^2, one result per clock";
        ties "where four times the remainder and the next pair equal 4 root + 1 the digit is 1, so the root of a square is exact and leaves remainder 0";
        error EXACT;
    SquareRootNonRestoring "square_root_non_restoring" [ROWS] "ceil(W / R)", EVERY_CLOCK, "Nyiri 1994, 2.3.3";
        computes "root = floor(sqrt(radicand)) and remainder = radicand - root^2, one result per clock";
        ties "a remainder of zero counts as not negative and gives digit 1, so the root of a square is exact and leaves remainder 0";
        error EXACT;
    SquareRootIterative "square_root_iterative" [] "W", "one result every W clocks", "Nyiri 1994, 2.3.3";
        computes "root = floor(sqrt(radicand)) and remainder = radicand - root^2, one digit per clock";
        ties "where four times the remainder and the next pair equal 4 root + 1 the digit is 1, so the root of a square is exact and leaves remainder 0";
        error EXACT;
    SquareRootRows "square_root_rows" [DIGITS, ROWS] "ceil(D / R)", EVERY_CLOCK, "Nyiri 1994, 2.3.3";
        computes "the upper digits of floor(sqrt(radicand)), the lower ones zero";
        ties "digits are those of the rounded-down root; the lower ones are cut off, never rounded up";
        error "bound: below 2^{W - D} of the last place, downwards, for every radicand: small roots are lost";
    SquareRootLeading "square_root_leading" [DIGITS, ROWS] "ceil((D - 1) / R) + 2", EVERY_CLOCK, "Nyiri 1994, B.10";
        computes "the leading significant digits of floor(sqrt(radicand)), the lower ones zero";
        ties "digits are those of the rounded-down root; the lower ones are cut off, never rounded up";
        error "bound: below 2^{1 - D} of the root, downwards, or of one last place if that is more";
    SquareRootLinear "square_root_linear" [TWO_CORRECTIONS] "1 + 2 C", EVERY_CLOCK, "Nyiri 1994, 2.3.3";
        computes "an approximate square root by straight lines and corrections, monotone";
        ties NO_TIES;
        error "bound: {C: 6.066, 1.647, 0.473} % of the root besides floors; measured maximum with floors: {C: 6.066, 1.681, 0.507} % at W = 24 and radicands not below 2^23; monotone";
    SquareRootQuadratic "square_root_quadratic" [CORRECTIONS] "3 + 2 C", EVERY_CLOCK, "Nyiri 1994, 2.3.3";
        computes "an approximate square root by parabolas and corrections";
        ties NO_TIES;
        error "bound: {C: 1.345, 0.532, 0.219} % of the root besides floors; measured maximum with floors: {C: 1.364, 0.540, 0.221} % at W = 24 and radicands not below 2^23; not monotone: the root steps down by one at some radicands";

    // Object processors and their parts.
    QuadricPe "quadric_pe" [ROWS] "ceil(W / R) + 2", HELD_WORDS, "Nyiri 1994, 2.4.2";
        computes "the two depths f1 - r and f1 + r of a quadric, with r = floor(sqrt(f2))";
        ties "f2 = 0 counts as inside, with both depths f1";
        error "exact in f1 and f2 modulo their widths; the root is rounded down";
    PlaneDepth "plane_depth" [] "2", ZONE_WORDS, "Nyiri 1994, 2.4.2";
        computes "the depth of a plane, clamped to the depth word";
        ties "a value at a bound of the clamp is that bound";
        error "exact after clamping; whoever makes the coefficients proves that the plane fits its words";
    CutPlane "cut_plane" [] "2", EVERY_CLOCK, "Nyiri 1994, 2.4.2";
        computes "one half of a depth interval cut by one plane";
        ties "a front plane at zf and a back plane at zb change nothing; a front plane at zb and a back plane at zf keep a sheet; zp = 0 passes a perpendicular plane";
        error EXACT;
    QuadricCut "quadric_cut" [] "5", EVERY_CLOCK, "Nyiri 1994, 2.4.2";
        computes "what is seen of a quadric of which planes leave what lies between two limits; the limits come two clocks after the roots";
        ties "a limit at a face keeps it, and the face its number; limits at one depth keep a sheet; f2 = 0 counts as inside";
        error EXACT;
    NormalUnit "normal_unit" [PLANES] "4", HELD_WORDS, "Nyiri 1994, 2.4.2";
        computes "the normal of the visible face of a quadric object";
        ties NO_TIES;
        error "exact in its integer words; against a normal in real numbers: the product K r loses the places shifted out and 6 bits, the result the low 8 of 24 bits, each by a floor";
    PatchDecider "patch_decider" [FOUR_PLANES] "3", EVERY_CLOCK, "Nyiri 1994, 2.4.3";
        computes "the first face of a bare surface that every plane keeps, all planes at once";
        ties "a plane keeps a face that lies in it; the near face wins where both are left; f2 = 0 is inside";
        error EXACT;
    QuadricProcessor "quadric_processor" [PLANES, ROWS] "ceil(W / R) + 11 + max(0, ceil(log2 N) - 2)", HELD_WORDS, "Nyiri 1994, 2.4.2";
        computes "depth, face and normal of the visible front of one quadric object cut by planes";
        ties "those of its parts: f2 = 0 is inside, planes at a face keep it; box bounds are inclusive";
        error WORDS;
    QuotientProcessor "quotient_processor" [PLANES, ROWS] "13 + max(0, ceil(log2 N) - 2) + ceil(W / R)", HELD_WORDS, "Nyiri 1994, 2.1.1";
        computes "depth, face and normal of the visible front of a quadric whose depth is a quotient, cut by planes";
        ties "a solid ends at the rounded-down quotient or begins there; where the denominator is zero a surface is absent and a solid is everywhere or nowhere; planes at a face keep it; box bounds are inclusive";
        error WORDS;
    PatchProcessor "patch_processor" [FOUR_PLANES, ROWS] "ceil(W / R) + 9", HELD_WORDS, "Nyiri 1994, 2.4.3 and 5.2.1";
        computes "depth, face and normal of the visible face of a bare quadric surface cut by planes";
        ties "a plane keeps a face that lies in it; the near face wins where both are left; f2 = 0 is inside";
        error WORDS;
    FirstGenerationProcessor "first_generation_processor" [ROWS] "ceil(W / R) + 9", HELD_WORDS, "Nyiri 1994, 2.4.1";
        computes "depth, face and normal of a quadric between two parallel planes, found by contours on the screen";
        ties "a plane exactly at a root of a solid is its face; of a surface it has removed that root; f2 = 0 is inside";
        error INTEGERS;
    PolyhedronProcessor "polyhedron_processor" [FACES] "ceil(log2 N) + 6", HELD_WORDS, "Nyiri 1994, annex A; Chaillou 1991, IV.2.3";
        computes "front and back depth, faces and normals of a convex solid of planes";
        ties "of planes at equal depth the smallest index wins; an interval of no thickness is there; a plane at the near end is not a face, the end is";
        error INTEGERS;
    FacetProcessor "facet_processor" [SIDES] "3", HELD_WORDS, "Chaillou 1991, IV.2.2";
        computes "depth and interpolated normal of a flat facet of three or four sides";
        ties "zero is inside";
        error INTEGERS;
    CurvedFacetProcessor "curved_facet_processor" [CURVED_SIDES] "3", HELD_WORDS, "Chaillou 1991, IV.2.6.1";
        computes "depth and normal of a facet with sides, depth and normal of second degree";
        ties "zero is inside";
        error INTEGERS;
    SphereProcessor "sphere_processor" [] "4", HELD_WORDS, "Chaillou 1991, IV.2.4";
        computes "depth and normal of a sphere with exact outline and a paraboloid for the depth";
        ties "zero is inside";
        error "exact in its integer words; against a sphere of radius R: outline exact, depth +29.5 % of R at the outline, -4.5 % at most inside, 5.1 % RMS";
    CylinderProcessor "cylinder_processor" [] "3", HELD_WORDS, "Chaillou 1991, IV.2.5";
        computes "depth and normal of a cylinder with exact outline and a parabolic body";
        ties "zero is inside; the front disc goes before the body";
        error "exact in its integer words; against a cylinder: outline and front disc exact, depth of the body that of the sphere processor over the part of the axis in the screen plane";
    QuadricVolume "quadric_volume" [FOUR_PLANES, ROWS] "ceil(W / R) + 5", HELD_WORDS, "Nyiri 1994, 3.2.1 and 4.1.3";
        computes "is the visible point in a shadow or light volume of a quadric and planes";
        ties "with margin 0 a point on the boundary is inside; with more the beginning is open by the margin, the end stays closed";
        error INTEGERS;
    PolyhedralVolume "polyhedral_volume" [FOUR_PLANES] "4", HELD_WORDS, "Nyiri 1994, 3.2.1 and 4.1.3";
        computes "is the visible point in a shadow or light volume of planes";
        ties "with margin 0 a point on the boundary is inside; with more the beginning is open by the margin, the end stays closed";
        error INTEGERS;

    // Raster, deciders, shadows, transparency, solids, stores.
    RasterControl "raster_control" [] "1", PIXELS, "architecture, 2";
        computes "the raster flags of a zone, one pixel per clock, without a bubble";
        ties NO_TIES;
        error EXACT;
    VisibilityNode "visibility_node" [] "1", EVERY_CLOCK, "architecture, 6";
        computes "the nearer of two objects";
        ties SMALLER_ID;
        error EXACT;
    Decider "decider" [OBJECTS] "ceil(log2 M)", EVERY_CLOCK, "architecture, 6";
        computes "the nearest of many objects";
        ties SMALLER_ID;
        error EXACT;
    VisibilityChain "visibility_chain" [OBJECTS] "M", EVERY_CLOCK, "Chaillou 1991, IV.3.2";
        computes "the nearest of many objects, compared on the way past their processors";
        ties SMALLER_ID;
        error EXACT;
    CardDecider "card_decider" [OBJECTS, CARDS] "M + ceil(log2 K)", EVERY_CLOCK, "Chaillou 1991, IV.3.6";
        computes "the nearest of the objects of many cards: a chain on each card, a tree between the cards";
        ties SMALLER_ID;
        error EXACT;
    ShadowStage "shadow_stage" [OBJECTS] "max(1, ceil(log8 M))", EVERY_CLOCK, "Chaillou 1991, IV.3.4; Nyiri 1994, 4.1.3";
        computes "which light sources reach the visible point, from the answers of the shadow and light volumes";
        ties "none: what is on the boundary of a volume its processor decides";
        error EXACT;
    TransparencyStage "transparency_stage" [] "4", EVERY_CLOCK, "Chaillou 1991, IV.3.3";
        computes "the colour of a transparent object blended over that of a pixel, if it is nearer";
        ties "at equal depth the opaque surface hides the layer; 255ths have no halves";
        error "bound: half a step of a component";
    TransparencyPipeline "transparency_pipeline" [LAYERS] "4 T", EVERY_CLOCK, "Chaillou 1991, IV.3.3";
        computes "the colours of transparent objects blended over that of a pixel, farthest first";
        ties "at equal depth the opaque surface hides the layer; 255ths have no halves";
        error "bound: half a step of a component for each of {T} layers";
    CsgProduct "csg_product" [INTERSECTED, SUBTRACTED] "ceil(log2 I) + 2 + ceil(log2(J + 1))", EVERY_CLOCK, "Chaillou 1991, III.1.1.4 and IV.3.5";
        computes "the visible face of what convex objects have in common, without what others take away";
        ties "at equal depth the earlier input; what ends where a solid begins takes nothing of it away";
        error EXACT;
    CoefficientStore "coefficient_store" [PLANES] "1", "one word written per clock", "architecture, 7";
        computes "the coefficient words of one object, loaded over a bus";
        ties NO_TIES;
        error EXACT;
    Beam "beam" [PLANES, ROWS, OBJECTS] "1 + (ceil(W / R) + 11 + max(0, ceil(log2 N) - 2)) + ceil(log2 M)", HELD_WORDS, "architecture, 7";
        computes "the visible surface of many quadric objects, pixel by pixel";
        ties "at equal depth the smaller slot wins; within an object those of the quadric processor";
        error WORDS;

    // The screen, and what gives a pixel its colour.
    VideoTiming "video_timing" [MODE] "1", "one position of the raster per clock with enable", "Chaillou 1991, I.2.4.2 and IV.4.4";
        computes "the raster of a screen with its blanking, and the same some clocks ahead";
        ties NO_TIES;
        error EXACT;
    PixelFifo "pixel_fifo" [] "3", "one pixel per clock as long as the receiver does not stall, behind a pipeline of at most 59 clocks", "architecture, 8";
        computes "a queue from a pipeline that cannot stall to an AXI4-Stream receiver that can";
        ties NO_TIES;
        error EXACT;
    LineMerger "line_merger" [] "3", "the lines of 4 modules of 16 pixels each in 16 clocks, 4 neighbours per clock", "Nyiri 1994, 2.4.4 and 4.1.3";
        computes "the lines of graphics modules that draw side by side, one after the other";
        ties NO_TIES;
        error EXACT;
    FrameStore "frame_store" [] "5", "one pixel per clock out, and one in while a frame is not whole", "architecture, 8";
        computes "the last whole frame that came, while the next one comes";
        ties "a retrace in the clock of the last pixel of a frame comes too early for it";
        error EXACT;
    PostFilter "post_filter" [] "6", "one pixel per clock; a clock without a pixel after each line, width + 3 after a picture; lines begin 3 clocks apart or more", "Chaillou 1991, IV.4.3";
        computes "a picture smoothed by a 2 x 2 box or a 3 x 3 binomial";
        ties "halves are rounded up; beyond an edge the nearest pixel stands";
        error EXACT;
    Overlay "overlay" [] "6", "one pixel per clock", "Chaillou 1991, IV.4.7.1";
        computes "a plane of one bit per pixel over a picture";
        ties "a word read in the clock that writes it is the old one";
        error EXACT;
    Accumulator "accumulator" [] "4", "one pixel per clock", "Chaillou 1991, III.1.5 and IV.4.7.2";
        computes "the mean of 4 or 16 passes over a picture";
        ties "halves are rounded up";
        error EXACT;
    TmdsEncoder "tmds_encoder" [] "3", "one word per clock", "DVI 1.0, 3.2";
        computes "the word of ten bits that a DVI channel sends for a level, or for two bits of control";
        ties "the chain of fewer transitions, which are never as many; without a disparity, or in a chain of four ones, the bits of the chain are turned over where it is of XNOR";
        error EXACT;
    TmdsSerialiser "tmds_serialiser" [] "6", "two bits per clock, a word every five clocks", "DVI 1.0, 2.2";
        computes "the words of a DVI channel, two bits at a time";
        ties NO_TIES;
        error EXACT;
    SceneSequencer "scene_sequencer" [] "1", "one word every two clocks", "none: it stands in for the host";
        computes "the addresses of the words of images, which it sends over AXI4-Stream one after the other, each as often as it stays";
        ties NO_TIES;
        error EXACT;
    ShadingProcessor "shading_processor" [LIGHTS, SUNS] "66", "one pixel per clock, without a bubble; words change only when the pipeline has drained", "Chaillou 1991, III.1.2; Nyiri 1994, 1.2.4";
        computes "the colour of every pixel by Phong shading under several lights";
        ties "a normal at a right angle to the line of sight is not turned; a light in the plane of the surface adds nothing; half a level is rounded up";
        error "within one level of 8 bits of the formula in real numbers on the same integer words (docs/shading.md)";
    LitSphere "lit_sphere" [TABLE_PLACES, TABLES] "36", "one pixel per clock, without a bubble; words change only when the pipeline has drained", "architecture, 8.4";
        computes "the colour of every pixel from a table of the direction of its normal, one for each material and each way in which lights reach it";
        ties "a normal at a right angle to the line of sight is not turned; half a level is rounded up";
        error "measured in docs/shading.md: lights and viewer count as infinitely far, and between entries colours are of first degree";
    LitSphereNearest "lit_sphere_nearest" [TABLE_PLACES, TABLES] "12 + B", "one pixel per clock, without a bubble; words change only when the pipeline has drained", "architecture, 8.4";
        computes "the colour of every pixel from the nearest entry of a table of the direction of its normal";
        ties "a normal at a right angle to the line of sight is not turned; between two entries stands the later one";
        error "measured in docs/shading.md: lights and viewer count as infinitely far, and an entry has one colour";
}
