//! The square root and what stands in for it.

use super::{EVERY_CLOCK, EXACT, NO_TIES};
use crate::parameters::{CORRECTIONS, DIGITS, ROWS, TWO_CORRECTIONS};
use crate::unit::Record;

pub(crate) const SQUARE_ROOT: Record = Record {
    name: "square_root",
    computes: "root = floor(sqrt(radicand)) and remainder = radicand - root^2, one result per clock",
    source: "Nyiri 1994, 2.3.3",
    parameters: &[ROWS],
    latency: "ceil(W / R)",
    throughput: EVERY_CLOCK,
    ties: "where four times the remainder and the next pair equal 4 root + 1 the digit is 1, so the root of a square is exact and leaves remainder 0",
    error: EXACT,
};

pub(crate) const SQUARE_ROOT_NON_RESTORING: Record = Record {
    name: "square_root_non_restoring",
    computes: "root = floor(sqrt(radicand)) and remainder = radicand - root^2, one result per clock",
    source: "Nyiri 1994, 2.3.3",
    parameters: &[ROWS],
    latency: "ceil(W / R)",
    throughput: EVERY_CLOCK,
    ties: "a remainder of zero counts as not negative and gives digit 1, so the root of a square is exact and leaves remainder 0",
    error: EXACT,
};

pub(crate) const SQUARE_ROOT_ITERATIVE: Record = Record {
    name: "square_root_iterative",
    computes: "root = floor(sqrt(radicand)) and remainder = radicand - root^2, one digit per clock",
    source: "Nyiri 1994, 2.3.3",
    parameters: &[],
    latency: "W",
    throughput: "one result every W clocks",
    ties: "where four times the remainder and the next pair equal 4 root + 1 the digit is 1, so the root of a square is exact and leaves remainder 0",
    error: EXACT,
};

pub(crate) const SQUARE_ROOT_ROWS: Record = Record {
    name: "square_root_rows",
    computes: "the upper digits of floor(sqrt(radicand)), the lower ones zero",
    source: "Nyiri 1994, 2.3.3",
    parameters: &[DIGITS, ROWS],
    latency: "ceil(D / R)",
    throughput: EVERY_CLOCK,
    ties: "digits are those of the rounded-down root; the lower ones are cut off, never rounded up",
    error: "bound: below 2^{W - D} of the last place, downwards, for every radicand: small roots are lost",
};

pub(crate) const SQUARE_ROOT_LEADING: Record = Record {
    name: "square_root_leading",
    computes: "the leading significant digits of floor(sqrt(radicand)), the lower ones zero",
    source: "Nyiri 1994, B.10",
    parameters: &[DIGITS, ROWS],
    latency: "ceil(D / R) + 2",
    throughput: EVERY_CLOCK,
    ties: "digits are those of the rounded-down root; the lower ones are cut off, never rounded up",
    error: "bound: below 2^{1 - D} of the root, downwards, or of one last place if that is more",
};

pub(crate) const SQUARE_ROOT_LINEAR: Record = Record {
    name: "square_root_linear",
    computes: "an approximate square root by straight lines and corrections, monotone",
    source: "Nyiri 1994, 2.3.3",
    parameters: &[TWO_CORRECTIONS],
    latency: "1 + 2 C",
    throughput: EVERY_CLOCK,
    ties: NO_TIES,
    error: "bound: {C: 6.066, 1.647, 0.473} % of the root besides floors; measured maximum with floors: {C: 6.066, 1.681, 0.507} % at W = 24 and radicands not below 2^23; monotone",
};

pub(crate) const SQUARE_ROOT_QUADRATIC: Record = Record {
    name: "square_root_quadratic",
    computes: "an approximate square root by parabolas and corrections",
    source: "Nyiri 1994, 2.3.3",
    parameters: &[CORRECTIONS],
    latency: "3 + 2 C",
    throughput: EVERY_CLOCK,
    ties: NO_TIES,
    error: "bound: {C: 1.345, 0.532, 0.219} % of the root besides floors; measured maximum with floors: {C: 1.364, 0.540, 0.221} % at W = 24 and radicands not below 2^23; not monotone: the root steps down by one at some radicands",
};
