//! What the source prints and nothing here counts, with the reason.

use super::row::Omitted;

/// All of it, in the order of the source.
pub const OMITTED: [Omitted; 10] = [
    Omitted {
        name: "van Kleij's times, exact and with 12 to 24 facets",
        section: "Table 5.9",
        printed: "36.51 s exact by subdivision, 26.02 to 47.33 s with facets",
        why: "another author's program on a computer of its time; neither is at hand. What it is quoted for, that an exact quadric costs as much as 16 to 20 facets, is counted under software and cells",
    },
    Omitted {
        name: "logic of the planes",
        section: "Table 5.10",
        printed: "1 022 transistors",
        why: "the comparators stand among the 13 adders there, and with the decision in one unit here (patch_decider), of which the table of resources has cells and no transistors",
    },
    Omitted {
        name: "registers of synchronisation",
        section: "Table 5.10",
        printed: "13 104 transistors, 21 words of 24 bits",
        why: "here elementary processors start late in place of most of them, and the rest cannot be told apart from other registers in the synthesised unit",
    },
    Omitted {
        name: "13 adders with registers",
        section: "Table 5.10",
        printed: "19 344 transistors",
        why: "the parts are counted down to elementary processors, roots and multipliers, not to adders; three of them are in the row of the multipliers, two in that of both depths",
    },
    Omitted {
        name: "sum of the patch processor",
        section: "Table 5.10",
        printed: "225 732 transistors",
        why: "the table of resources has transistors of single units only; shares and ratios are counted in logic cells",
    },
    Omitted {
        name: "three-dimensional box of a quadric",
        section: "chapter 5",
        printed: "24 reals",
        why: "there is none here",
    },
    Omitted {
        name: "gates of the PE2 chip",
        section: "Chaillou, IV.1.9",
        printed: "2 990 gates, 48 of 68 pins, 13 packages of a wired adder",
        why: "gates of another library, and packages that this project does not have",
    },
    Omitted {
        name: "shadow volumes of the robot",
        section: "annex D",
        printed: "161",
        why: "the scene is not at hand; a robot of our own has other cuts and sources",
    },
    Omitted {
        name: "machines of other authors",
        section: "Chaillou, II",
        printed: "polygons and spheres a second",
        why: "not counted by the source either",
    },
    Omitted {
        name: "size of the processor with full custom design",
        section: "Chaillou, IV.1.9",
        printed: "more than ten elementary processors a chip",
        why: "a plan",
    },
];
