// half_space_test: part of quadric_volume; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module half_space_test (
    input  wire clock,
    input  wire [1:0] kind,
    input  wire signed [35:0] zp,
    input  wire signed [23:0] z,
    input  wire signed [25:0] entered,
    output wire holds
);

    localparam [1:0] front = 2'd1;
    localparam [1:0] back = 2'd2;
    localparam [1:0] perpendicular = 2'd3;
    wire signed [35:0] leaving;
    wire signed [35:0] entering;
    wire removed;
    reg kept = 1'd0;

    assign leaving = {{12{z[23]}}, z};
    assign entering = {{10{entered[25]}}, entered};
    assign removed = (((kind == front) & (entering < zp)) | ((kind == back) & (zp < leaving))) | ((kind == perpendicular) & zp[35]);
    assign holds = kept;

    always @(posedge clock) begin
        kept <= ~removed;
    end

endmodule
