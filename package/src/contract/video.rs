//! Ports of the units between the pixels and the screen.

use super::shared::{BIT, COORDINATE, ID, PART, Text};
use super::width::Width;

const KERNEL: Width = Width::fixed(2);
const PLANE_ADDRESS: Width = Width::fixed(10);
const PLANE_WORD: Width = Width::fixed(32);

const COLOUR_IN: &[Text] = &[
    Text("r", ID, "red of the pixel"),
    Text("g", ID, "green of the pixel"),
    Text("b", ID, "blue of the pixel"),
];
const COLOUR_OUT: &[Text] = &[
    Text("out_r", ID, "red of the result"),
    Text("out_g", ID, "green of the result"),
    Text("out_b", ID, "blue of the result"),
];

pub(super) const TIMING: &[&[Text]] = &[&[
    Text("enable", BIT, "go on; all outputs hold without it"),
    Text("de", BIT, "a pixel is shown"),
    Text("start", BIT, "first pixel of the frame"),
    Text("line", BIT, "first pixel of any other line"),
    Text("x", COORDINATE, "column of the pixel; 0 in the blanking"),
    Text("y", COORDINATE, "line of the pixel; 0 in the blanking"),
    Text(
        "hsync",
        BIT,
        "synchronisation of the line, with the polarity of the mode",
    ),
    Text(
        "vsync",
        BIT,
        "synchronisation of the frame, with the polarity of the mode",
    ),
    Text("frame_start", BIT, "first clock of the vertical blanking"),
    Text("need", BIT, "de of lead clocks later"),
    Text("go", BIT, "start of lead clocks later"),
    Text("need_line", BIT, "line of lead clocks later"),
    Text("need_x", COORDINATE, "x of lead clocks later"),
    Text("need_y", COORDINATE, "y of lead clocks later"),
]];

pub(super) const FIFO: &[&[Text]] = &[&[
    Text(
        "started",
        BIT,
        "a pixel goes into the pipeline; only with room",
    ),
    Text("push", BIT, "a pixel leaves the pipeline"),
    Text("data", PART, "the pixel that leaves the pipeline"),
    Text(
        "last",
        BIT,
        "the pixel that leaves the pipeline ends its packet",
    ),
    Text("room", BIT, "a pixel that is started now finds a place"),
    Text(
        "m_tvalid",
        BIT,
        "a pixel is there; it stays until it is taken",
    ),
    Text("m_tdata", PART, "the oldest pixel"),
    Text("m_tlast", BIT, "the oldest pixel ends its packet"),
    Text("m_tready", BIT, "the receiver takes the oldest pixel"),
]];

pub(super) const STORE: &[&[Text]] = &[&[
    Text("width", COORDINATE, "pixels of a line"),
    Text("s_tvalid", BIT, "a pixel comes in"),
    Text(
        "s_tready",
        BIT,
        "it is taken; low from the last pixel of a frame until the frames change places",
    ),
    Text(
        "s_tdata",
        PART,
        "its colour: red in bits 23..16, green in 15..8, blue in 7..0",
    ),
    Text(
        "s_tuser",
        PART,
        "its place: line in bits 23..12, column in 11..0",
    ),
    Text("s_tlast", BIT, "last pixel of the frame"),
    Text(
        "retrace",
        BIT,
        "first clock of the vertical blanking: a whole frame takes its place on the screen",
    ),
    Text("need", BIT, "a pixel to show"),
    Text("x", COORDINATE, "its column"),
    Text("y", COORDINATE, "its line"),
    Text("valid", BIT, "need, with the colour of its pixel"),
    Text("r", ID, "red of the pixel to show"),
    Text("g", ID, "green of the pixel to show"),
    Text("b", ID, "blue of the pixel to show"),
    Text("swapped", BIT, "another frame is shown from now on"),
]];

pub(super) const FILTER: &[&[Text]] = &[
    COLOUR_IN,
    COLOUR_OUT,
    &[
        Text(
            "kernel",
            KERNEL,
            "0 pass, 1 box of 2 x 2, 2 and 3 binomial of 3 x 3; read with the first pixel of a picture",
        ),
        Text("valid", BIT, "this clock carries a pixel"),
        Text("x", COORDINATE, "column of the pixel, below 2048"),
        Text("y", COORDINATE, "line of the pixel"),
        Text("line_end", BIT, "last pixel of its line"),
        Text("last", BIT, "last pixel of the picture"),
        Text("out_valid", BIT, "a smooth pixel is there"),
        Text("out_x", COORDINATE, "its column"),
        Text("out_y", COORDINATE, "its line"),
        Text("out_line_end", BIT, "it is the last of its line"),
        Text("out_last", BIT, "it is the last of the picture"),
    ],
];

pub(super) const OVERLAY: &[&[Text]] = &[
    COLOUR_IN,
    COLOUR_OUT,
    &[
        Text("write", BIT, "the host writes 32 pixels"),
        Text(
            "write_address",
            PLANE_ADDRESS,
            "which word: that of the pixels 32 times the address and on",
        ),
        Text(
            "write_data",
            PLANE_WORD,
            "the word, its first pixel in bit 0",
        ),
        Text(
            "enable",
            BIT,
            "the plane is shown; read 3 clocks after the pixel",
        ),
        Text(
            "colour",
            PART,
            "colour of the set pixels: red in bits 23..16, green in 15..8, blue in 7..0; read 3 clocks after the pixel",
        ),
        Text("width", COORDINATE, "pixels of a line"),
        Text("valid", BIT, "this clock carries a pixel"),
        Text("x", COORDINATE, "column of the pixel"),
        Text("y", COORDINATE, "line of the pixel"),
        Text("out_valid", BIT, "valid, with the colour of its pixel"),
    ],
];

pub(super) const ACCUMULATOR: &[&[Text]] = &[
    COLOUR_IN,
    COLOUR_OUT,
    &[
        Text(
            "fine",
            BIT,
            "16 passes, not 4; read with the pixels of the last pass",
        ),
        Text("valid", BIT, "this clock carries a pixel"),
        Text(
            "address",
            COORDINATE,
            "which pixel; not the same in two clocks in a row",
        ),
        Text("first_pass", BIT, "the pixel is of the first pass"),
        Text("last_pass", BIT, "the pixel is of the last pass"),
        Text("out_valid", BIT, "a pixel of the last pass leaves"),
        Text("out_address", COORDINATE, "which pixel"),
    ],
];
