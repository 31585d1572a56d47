// flag_delay_x3: part of quadric_volume; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module flag_delay_x3 (
    input  wire clock,
    input  wire valid,
    input  wire start,
    input  wire line,
    output wire late_valid,
    output wire late_start,
    output wire late_line
);

    reg valid_at_0 = 1'd0;
    reg start_at_0 = 1'd0;
    reg line_at_0 = 1'd0;

    assign late_valid = valid_at_0;
    assign late_start = start_at_0;
    assign late_line = line_at_0;

    always @(posedge clock) begin
        valid_at_0 <= valid;
        start_at_0 <= start;
        line_at_0 <= line;
    end

endmodule
