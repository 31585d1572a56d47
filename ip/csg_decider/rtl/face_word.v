// face_word: part of csg_decider; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module face_word (
    input  wire [7:0] id,
    input  wire [3:0] number,
    input  wire is_back,
    output wire [12:0] face
);

    localparam [12:0] back_flag = 13'd4096;
    localparam [7:0] by_number = 8'd4;
    wire [12:0] wide_id;
    wire [12:0] wide_number;
    wire [12:0] name;

    assign wide_id = {5'd0, id};
    assign wide_number = {9'd0, number};
    assign name = (wide_id << by_number) | wide_number;
    assign face = is_back ? name | back_flag : name;

endmodule
