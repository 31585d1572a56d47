//! Machines: raster, stores, deciders, solids, shadows.

use super::{EVERY_CLOCK, EXACT, HELD_WORDS, NO_TIES, PIXELS, SMALLER_ID, WORDS};
use crate::parameters::{CARDS, INTERSECTED, OBJECTS, PLANES, PRODUCTS, ROWS, SUBTRACTED};
use crate::unit::Record;

pub(crate) const RASTER_CONTROL: Record = Record {
    name: "raster_control",
    computes: "the raster flags of a zone, one pixel per clock, without a bubble",
    source: "architecture, 2",
    parameters: &[],
    latency: "1",
    throughput: PIXELS,
    ties: NO_TIES,
    error: EXACT,
};

pub(crate) const VISIBILITY_NODE: Record = Record {
    name: "visibility_node",
    computes: "the nearer of two objects",
    source: "architecture, 6",
    parameters: &[],
    latency: "1",
    throughput: EVERY_CLOCK,
    ties: SMALLER_ID,
    error: EXACT,
};

pub(crate) const DECIDER: Record = Record {
    name: "decider",
    computes: "the nearest of many objects",
    source: "architecture, 6",
    parameters: &[OBJECTS],
    latency: "ceil(log2 M)",
    throughput: EVERY_CLOCK,
    ties: SMALLER_ID,
    error: EXACT,
};

pub(crate) const VISIBILITY_CHAIN: Record = Record {
    name: "visibility_chain",
    computes: "the nearest of many objects, compared on the way past their processors",
    source: "Chaillou 1991, IV.3.2",
    parameters: &[OBJECTS],
    latency: "M",
    throughput: EVERY_CLOCK,
    ties: SMALLER_ID,
    error: EXACT,
};

pub(crate) const CARD_DECIDER: Record = Record {
    name: "card_decider",
    computes: "the nearest of the objects of many cards: a chain on each card, a tree between the cards",
    source: "Chaillou 1991, IV.3.6",
    parameters: &[OBJECTS, CARDS],
    latency: "M + ceil(log2 K)",
    throughput: EVERY_CLOCK,
    ties: SMALLER_ID,
    error: EXACT,
};

pub(crate) const SHADOW_STAGE: Record = Record {
    name: "shadow_stage",
    computes: "which light sources reach the visible point, from the answers of the shadow and light volumes",
    source: "Chaillou 1991, IV.3.4; Nyiri 1994, 4.1.3",
    parameters: &[OBJECTS],
    latency: "max(1, ceil(log8 M))",
    throughput: EVERY_CLOCK,
    ties: "none: what is on the boundary of a volume its processor decides",
    error: EXACT,
};

pub(crate) const CSG_DECIDER: Record = Record {
    name: "csg_decider",
    computes: "the visible face of a union of products: convex objects intersected, others taken away",
    source: "Chaillou 1991, III.1.1.4 and IV.3.5",
    parameters: &[PRODUCTS, INTERSECTED, SUBTRACTED],
    latency: "ceil(log2 I) + 1 + ceil(log2(G (J + 1)))",
    throughput: EVERY_CLOCK,
    ties: "at equal depth a front goes before the back of an object taken away, then the smaller id, then the smaller face; what ends where a solid begins takes nothing of it away",
    error: EXACT,
};

pub(crate) const COEFFICIENT_STORE: Record = Record {
    name: "coefficient_store",
    computes: "the coefficient words of one object, loaded over a bus",
    source: "architecture, 7",
    parameters: &[PLANES],
    latency: "1",
    throughput: "one word written per clock",
    ties: NO_TIES,
    error: EXACT,
};

pub(crate) const BEAM: Record = Record {
    name: "beam",
    computes: "the visible surface of many quadric objects, pixel by pixel",
    source: "architecture, 7",
    parameters: &[PLANES, ROWS, OBJECTS],
    latency: "1 + (ceil(W / R) + N + 7) + ceil(log2 M)",
    throughput: HELD_WORDS,
    ties: "at equal depth the smaller slot wins; within an object those of the quadric processor",
    error: WORDS,
};
