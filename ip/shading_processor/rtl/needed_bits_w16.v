// needed_bits_w16: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module needed_bits_w16 (
    input  wire [15:0] part,
    output wire [15:0] magnitude
);

    assign magnitude = part[15] ? ~part : part;

endmodule
