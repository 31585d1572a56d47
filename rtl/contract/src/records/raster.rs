//! Elementary processors.

use super::{MODULO, NO_TIES, PIXELS};
use crate::unit::Record;

pub(crate) const PE1: Record = Record {
    name: "pe1",
    computes: "value(x, y) = a x + b y + c by additions alone, one pixel per clock",
    source: "Nyiri 1994, 2.3.2 and B.2.1",
    parameters: &[],
    latency: "1",
    throughput: PIXELS,
    ties: NO_TIES,
    error: MODULO,
};

pub(crate) const PE2: Record = Record {
    name: "pe2",
    computes: "value(x, y) = a x^2 + b y^2 + c xy + d x + e y + f by additions alone, one pixel per clock",
    source: "Nyiri 1994, 2.3.2 and B.2.1",
    parameters: &[],
    latency: "1",
    throughput: PIXELS,
    ties: NO_TIES,
    error: MODULO,
};

pub(crate) const PROGRAMMABLE_PE: Record = Record {
    name: "programmable_pe",
    computes: "value(x, y) of second degree, or four of first degree with the decision on their signs, by additions alone",
    source: "Chaillou 1991, IV.1.7",
    parameters: &[],
    latency: "1",
    throughput: PIXELS,
    ties: "zero is inside",
    error: MODULO,
};

pub(crate) const MEMORY_PE2: Record = Record {
    name: "memory_pe2",
    computes: "value(x, y) of second degree by two adders, three registers and a memory of one port, field by field",
    source: "Chaillou 1991, IV.1.5",
    parameters: &[],
    latency: "1",
    throughput: "one pixel per clock within a line; 15 clocks between lines, 27 in a field",
    ties: NO_TIES,
    error: MODULO,
};
