// coefficient_store: part of beam; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module coefficient_store (
    input  wire clock, write,
    input  wire [7:0] address,
    input  wire [47:0] data,
    output reg  signed [25:0] f1_a = 26'sd0,
    output reg  signed [25:0] f1_b = 26'sd0,
    output reg  signed [25:0] f1_c = 26'sd0,
    output reg  signed [47:0] f2_a2 = 48'sd0,
    output reg  signed [47:0] f2_b2 = 48'sd0,
    output reg  signed [47:0] f2_c = 48'sd0,
    output reg  signed [47:0] f2_i0 = 48'sd0,
    output reg  signed [47:0] f2_p0 = 48'sd0,
    output reg  signed [47:0] f2_f = 48'sd0,
    output reg  signed [23:0] gx_a = 24'sd0,
    output reg  signed [23:0] gx_b = 24'sd0,
    output reg  signed [23:0] gx_c = 24'sd0,
    output reg  signed [23:0] gy_a = 24'sd0,
    output reg  signed [23:0] gy_b = 24'sd0,
    output reg  signed [23:0] gy_c = 24'sd0,
    output reg  signed [23:0] gz_a = 24'sd0,
    output reg  signed [23:0] gz_b = 24'sd0,
    output reg  signed [23:0] gz_c = 24'sd0,
    output reg  signed [15:0] kx = 16'sd0,
    output reg  signed [15:0] ky = 16'sd0,
    output reg  signed [15:0] kz = 16'sd0,
    output wire [11:0] box_x0,
    output reg  [11:0] box_x1 = 12'd0,
    output reg  [11:0] box_y0 = 12'd0,
    output reg  [11:0] box_y1 = 12'd0,
    output reg  [4:0] shift = 5'd0,
    output reg  [1:0] object_class = 2'd0,
    output reg  [1:0] plane_0_kind = 2'd0,
    output reg  signed [35:0] plane_0_a = 36'sd0,
    output reg  signed [35:0] plane_0_b = 36'sd0,
    output reg  signed [35:0] plane_0_c = 36'sd0,
    output reg  signed [15:0] plane_0_nx = 16'sd0,
    output reg  signed [15:0] plane_0_ny = 16'sd0,
    output reg  signed [15:0] plane_0_nz = 16'sd0,
    output reg  [1:0] plane_1_kind = 2'd0,
    output reg  signed [35:0] plane_1_a = 36'sd0,
    output reg  signed [35:0] plane_1_b = 36'sd0,
    output reg  signed [35:0] plane_1_c = 36'sd0,
    output reg  signed [15:0] plane_1_nx = 16'sd0,
    output reg  signed [15:0] plane_1_ny = 16'sd0,
    output reg  signed [15:0] plane_1_nz = 16'sd0,
    output reg  [1:0] plane_2_kind = 2'd0,
    output reg  signed [35:0] plane_2_a = 36'sd0,
    output reg  signed [35:0] plane_2_b = 36'sd0,
    output reg  signed [35:0] plane_2_c = 36'sd0,
    output reg  signed [15:0] plane_2_nx = 16'sd0,
    output reg  signed [15:0] plane_2_ny = 16'sd0,
    output reg  signed [15:0] plane_2_nz = 16'sd0
);

    reg [11:0] inverted_box_x0 = 12'd0;

    assign box_x0 = ~inverted_box_x0;

    always @(posedge clock) begin
        if (write) begin
            if (address == 8'd21) begin inverted_box_x0 <= ~data[11:0]; box_x1 <= data[23:12]; end
            if (address == 8'd0) f1_a <= data[25:0];
            if (address == 8'd1) f1_b <= data[25:0];
            if (address == 8'd2) f1_c <= data[25:0];
            if (address == 8'd3) f2_a2 <= data;
            if (address == 8'd4) f2_b2 <= data;
            if (address == 8'd5) f2_c <= data;
            if (address == 8'd6) f2_i0 <= data;
            if (address == 8'd7) f2_p0 <= data;
            if (address == 8'd8) f2_f <= data;
            if (address == 8'd9) gx_a <= data[23:0];
            if (address == 8'd10) gx_b <= data[23:0];
            if (address == 8'd11) gx_c <= data[23:0];
            if (address == 8'd12) gy_a <= data[23:0];
            if (address == 8'd13) gy_b <= data[23:0];
            if (address == 8'd14) gy_c <= data[23:0];
            if (address == 8'd15) gz_a <= data[23:0];
            if (address == 8'd16) gz_b <= data[23:0];
            if (address == 8'd17) gz_c <= data[23:0];
            if (address == 8'd18) kx <= data[15:0];
            if (address == 8'd19) ky <= data[15:0];
            if (address == 8'd20) kz <= data[15:0];
            if (address == 8'd22) begin box_y0 <= data[11:0]; box_y1 <= data[23:12]; end
            if (address == 8'd23) begin shift <= data[6:2]; object_class <= data[1:0]; end
            if (address == 8'd24) plane_0_kind <= data[1:0];
            if (address == 8'd25) plane_0_a <= data[35:0];
            if (address == 8'd26) plane_0_b <= data[35:0];
            if (address == 8'd27) plane_0_c <= data[35:0];
            if (address == 8'd28) plane_0_nx <= data[15:0];
            if (address == 8'd29) plane_0_ny <= data[15:0];
            if (address == 8'd30) plane_0_nz <= data[15:0];
            if (address == 8'd31) plane_1_kind <= data[1:0];
            if (address == 8'd32) plane_1_a <= data[35:0];
            if (address == 8'd33) plane_1_b <= data[35:0];
            if (address == 8'd34) plane_1_c <= data[35:0];
            if (address == 8'd35) plane_1_nx <= data[15:0];
            if (address == 8'd36) plane_1_ny <= data[15:0];
            if (address == 8'd37) plane_1_nz <= data[15:0];
            if (address == 8'd38) plane_2_kind <= data[1:0];
            if (address == 8'd39) plane_2_a <= data[35:0];
            if (address == 8'd40) plane_2_b <= data[35:0];
            if (address == 8'd41) plane_2_c <= data[35:0];
            if (address == 8'd42) plane_2_nx <= data[15:0];
            if (address == 8'd43) plane_2_ny <= data[15:0];
            if (address == 8'd44) plane_2_nz <= data[15:0];
        end
    end
endmodule
