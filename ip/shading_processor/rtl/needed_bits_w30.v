// needed_bits_w30: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module needed_bits_w30 (
    input  wire [29:0] part,
    output wire [29:0] magnitude
);

    assign magnitude = part[29] ? ~part : part;

endmodule
