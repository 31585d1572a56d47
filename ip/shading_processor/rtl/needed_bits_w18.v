// needed_bits_w18: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module needed_bits_w18 (
    input  wire [17:0] part,
    output wire [17:0] magnitude
);

    assign magnitude = part[17] ? ~part : part;

endmodule
