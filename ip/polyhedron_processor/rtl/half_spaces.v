// half_spaces: part of polyhedron_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module half_spaces (
    input  wire clock,
    input  wire [1:0] plane_0_kind,
    input  wire [1:0] plane_1_kind,
    input  wire [1:0] plane_2_kind,
    input  wire [1:0] plane_3_kind,
    input  wire [1:0] plane_4_kind,
    input  wire [1:0] plane_5_kind,
    input  wire signed [23:0] plane_0_zp,
    input  wire signed [23:0] plane_1_zp,
    input  wire signed [23:0] plane_2_zp,
    input  wire signed [23:0] plane_3_zp,
    input  wire signed [23:0] plane_4_zp,
    input  wire signed [23:0] plane_5_zp,
    input  wire is_there,
    output wire signed [23:0] zf,
    output wire [3:0] nf,
    output wire signed [23:0] zb,
    output wire [3:0] nb
);

    localparam [1:0] front_kind = 2'd1;
    localparam [1:0] back_kind = 2'd2;
    localparam [1:0] perpendicular = 2'd3;
    localparam signed [23:0] lowest = 24'sh800000;
    localparam signed [23:0] low = -24'sd8388607;
    localparam signed [23:0] far_limit = 24'sd8388607;
    localparam [3:0] cap = 4'd15;
    localparam [3:0] no_face = 4'd0;
    wire signed [23:0] branch_0_front;
    wire signed [23:0] branch_1_front;
    wire signed [23:0] branch_2_front;
    wire signed [23:0] branch_3_front;
    wire signed [23:0] branch_4_front;
    wire signed [23:0] branch_5_front;
    wire signed [23:0] branch_0_back;
    wire signed [23:0] branch_1_back;
    wire signed [23:0] branch_2_back;
    wire signed [23:0] branch_3_back;
    wire signed [23:0] branch_4_back;
    wire signed [23:0] branch_5_back;
    wire branch_0_removed;
    wire branch_1_removed;
    wire branch_2_removed;
    wire branch_3_removed;
    wire branch_4_removed;
    wire branch_5_removed;
    wire signed [23:0] front_depth;
    wire signed [23:0] back_depth;
    wire [3:0] front_face;
    wire [3:0] back_face;
    wire is_front_face;
    wire is_back_face;
    wire present;
    wire signed [23:0] nodes_0_front;
    wire [3:0] nodes_0_front_number;
    wire signed [23:0] nodes_0_back;
    wire [3:0] nodes_0_back_number;
    wire nodes_0_removed;
    wire signed [23:0] nodes_1_front;
    wire [3:0] nodes_1_front_number;
    wire signed [23:0] nodes_1_back;
    wire [3:0] nodes_1_back_number;
    wire nodes_1_removed;
    wire signed [23:0] nodes_2_front;
    wire [3:0] nodes_2_front_number;
    wire signed [23:0] nodes_2_back;
    wire [3:0] nodes_2_back_number;
    wire nodes_2_removed;
    wire signed [23:0] nodes_3_front;
    wire [3:0] nodes_3_front_number;
    wire signed [23:0] nodes_3_back;
    wire [3:0] nodes_3_back_number;
    wire nodes_3_removed;
    wire signed [23:0] nodes_4_front;
    wire [3:0] nodes_4_front_number;
    wire signed [23:0] nodes_4_back;
    wire [3:0] nodes_4_back_number;
    wire nodes_4_removed;
    wire signed [23:0] registers_0_front;
    wire [3:0] registers_0_front_number;
    wire signed [23:0] registers_0_back;
    wire [3:0] registers_0_back_number;
    wire registers_0_removed;
    reg signed [23:0] kept_zf = 24'sd0;
    reg signed [23:0] kept_zb = 24'sd0;
    reg [3:0] kept_nf = 4'd0;
    reg [3:0] kept_nb = 4'd0;

    half_space_node nodes_0 (
        .clock(clock),
        .a_front(branch_0_front),
        .a_front_number(4'd2),
        .a_back(branch_0_back),
        .a_back_number(4'd2),
        .a_removed(branch_0_removed),
        .b_front(branch_1_front),
        .b_front_number(4'd3),
        .b_back(branch_1_back),
        .b_back_number(4'd3),
        .b_removed(branch_1_removed),
        .front(nodes_0_front),
        .front_number(nodes_0_front_number),
        .back(nodes_0_back),
        .back_number(nodes_0_back_number),
        .removed(nodes_0_removed)
    );

    half_space_node nodes_1 (
        .clock(clock),
        .a_front(branch_2_front),
        .a_front_number(4'd4),
        .a_back(branch_2_back),
        .a_back_number(4'd4),
        .a_removed(branch_2_removed),
        .b_front(branch_3_front),
        .b_front_number(4'd5),
        .b_back(branch_3_back),
        .b_back_number(4'd5),
        .b_removed(branch_3_removed),
        .front(nodes_1_front),
        .front_number(nodes_1_front_number),
        .back(nodes_1_back),
        .back_number(nodes_1_back_number),
        .removed(nodes_1_removed)
    );

    half_space_node nodes_2 (
        .clock(clock),
        .a_front(branch_4_front),
        .a_front_number(4'd6),
        .a_back(branch_4_back),
        .a_back_number(4'd6),
        .a_removed(branch_4_removed),
        .b_front(branch_5_front),
        .b_front_number(4'd7),
        .b_back(branch_5_back),
        .b_back_number(4'd7),
        .b_removed(branch_5_removed),
        .front(nodes_2_front),
        .front_number(nodes_2_front_number),
        .back(nodes_2_back),
        .back_number(nodes_2_back_number),
        .removed(nodes_2_removed)
    );

    half_space_node nodes_3 (
        .clock(clock),
        .a_front(nodes_0_front),
        .a_front_number(nodes_0_front_number),
        .a_back(nodes_0_back),
        .a_back_number(nodes_0_back_number),
        .a_removed(nodes_0_removed),
        .b_front(nodes_1_front),
        .b_front_number(nodes_1_front_number),
        .b_back(nodes_1_back),
        .b_back_number(nodes_1_back_number),
        .b_removed(nodes_1_removed),
        .front(nodes_3_front),
        .front_number(nodes_3_front_number),
        .back(nodes_3_back),
        .back_number(nodes_3_back_number),
        .removed(nodes_3_removed)
    );

    half_space_node nodes_4 (
        .clock(clock),
        .a_front(nodes_3_front),
        .a_front_number(nodes_3_front_number),
        .a_back(nodes_3_back),
        .a_back_number(nodes_3_back_number),
        .a_removed(nodes_3_removed),
        .b_front(registers_0_front),
        .b_front_number(registers_0_front_number),
        .b_back(registers_0_back),
        .b_back_number(registers_0_back_number),
        .b_removed(registers_0_removed),
        .front(nodes_4_front),
        .front_number(nodes_4_front_number),
        .back(nodes_4_back),
        .back_number(nodes_4_back_number),
        .removed(nodes_4_removed)
    );

    half_space_register registers_0 (
        .clock(clock),
        .a_front(nodes_2_front),
        .a_front_number(nodes_2_front_number),
        .a_back(nodes_2_back),
        .a_back_number(nodes_2_back_number),
        .a_removed(nodes_2_removed),
        .front(registers_0_front),
        .front_number(registers_0_front_number),
        .back(registers_0_back),
        .back_number(registers_0_back_number),
        .removed(registers_0_removed)
    );

    assign branch_0_front = (plane_0_kind == front_kind) ? plane_0_zp : lowest;
    assign branch_1_front = (plane_1_kind == front_kind) ? plane_1_zp : lowest;
    assign branch_2_front = (plane_2_kind == front_kind) ? plane_2_zp : lowest;
    assign branch_3_front = (plane_3_kind == front_kind) ? plane_3_zp : lowest;
    assign branch_4_front = (plane_4_kind == front_kind) ? plane_4_zp : lowest;
    assign branch_5_front = (plane_5_kind == front_kind) ? plane_5_zp : lowest;
    assign branch_0_back = (plane_0_kind == back_kind) ? plane_0_zp : far_limit;
    assign branch_1_back = (plane_1_kind == back_kind) ? plane_1_zp : far_limit;
    assign branch_2_back = (plane_2_kind == back_kind) ? plane_2_zp : far_limit;
    assign branch_3_back = (plane_3_kind == back_kind) ? plane_3_zp : far_limit;
    assign branch_4_back = (plane_4_kind == back_kind) ? plane_4_zp : far_limit;
    assign branch_5_back = (plane_5_kind == back_kind) ? plane_5_zp : far_limit;
    assign branch_0_removed = (plane_0_kind == perpendicular) & plane_0_zp[23];
    assign branch_1_removed = (plane_1_kind == perpendicular) & plane_1_zp[23];
    assign branch_2_removed = (plane_2_kind == perpendicular) & plane_2_zp[23];
    assign branch_3_removed = (plane_3_kind == perpendicular) & plane_3_zp[23];
    assign branch_4_removed = (plane_4_kind == perpendicular) & plane_4_zp[23];
    assign branch_5_removed = (plane_5_kind == perpendicular) & plane_5_zp[23];
    assign front_depth = is_front_face ? nodes_4_front : low;
    assign back_depth = is_back_face ? nodes_4_back : far_limit;
    assign front_face = is_front_face ? nodes_4_front_number : cap;
    assign back_face = is_back_face ? nodes_4_back_number : cap;
    assign is_front_face = low < nodes_4_front;
    assign is_back_face = nodes_4_back < far_limit;
    assign present = ((is_there & ~nodes_4_removed) & (front_depth <= back_depth)) & (front_depth < far_limit);
    assign zf = kept_zf;
    assign nf = kept_nf;
    assign zb = kept_zb;
    assign nb = kept_nb;

    always @(posedge clock) begin
        kept_zf <= far_limit;
        kept_nf <= no_face;
        kept_zb <= far_limit;
        kept_nb <= no_face;
        if (present) begin
            kept_zf <= front_depth;
            kept_nf <= front_face;
            kept_zb <= back_depth;
            kept_nb <= back_face;
        end
    end

endmodule
