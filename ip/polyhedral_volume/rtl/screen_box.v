// screen_box: part of polyhedral_volume; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module screen_box (
    input  wire [11:0] x,
    input  wire [11:0] y,
    input  wire [11:0] box_x0,
    input  wire [11:0] box_x1,
    input  wire [11:0] box_y0,
    input  wire [11:0] box_y1,
    output wire in_box
);

    wire right_of_x0;
    wire left_of_x1;
    wire below_y0;
    wire above_y1;

    assign right_of_x0 = x >= box_x0;
    assign left_of_x1 = x <= box_x1;
    assign below_y0 = y >= box_y0;
    assign above_y1 = y <= box_y1;
    assign in_box = ((right_of_x0 & left_of_x1) & below_y0) & above_y1;

endmodule
