// view_store: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module view_store (
    input  wire clock,
    input  wire load_valid,
    input  wire [15:0] load_address,
    input  wire [31:0] load_data,
    output wire [12:0] size_x,
    output wire [12:0] size_y,
    output wire perspective,
    output wire is_attenuated,
    output wire [3:0] view_shift,
    output wire [16:0] distance,
    output wire signed [29:0] offset,
    output wire [7:0] background_r,
    output wire [7:0] background_g,
    output wire [7:0] background_b
);

    reg [12:0] kept_size_x = 13'd0;
    reg [12:0] kept_size_y = 13'd0;
    reg kept_perspective = 1'd0;
    reg kept_is_attenuated = 1'd0;
    reg [3:0] kept_view_shift = 4'd0;
    reg [16:0] kept_distance = 17'd0;
    reg signed [29:0] kept_offset = 30'sd0;
    reg [7:0] kept_background_r = 8'd0;
    reg [7:0] kept_background_g = 8'd0;
    reg [7:0] kept_background_b = 8'd0;

    assign size_x = kept_size_x;
    assign size_y = kept_size_y;
    assign perspective = kept_perspective;
    assign is_attenuated = kept_is_attenuated;
    assign view_shift = kept_view_shift;
    assign distance = kept_distance;
    assign offset = kept_offset;
    assign background_r = kept_background_r;
    assign background_g = kept_background_g;
    assign background_b = kept_background_b;

    wire unused_bits = &{1'b0, load_data[31:30]};

    always @(posedge clock) begin
        if (load_valid) begin
            if (load_address == 16'd0) begin
                kept_size_x <= load_data[12:0];
            end
            if (load_address == 16'd0) begin
                kept_size_y <= load_data[28:16];
            end
            if (load_address == 16'd1) begin
                kept_perspective <= load_data[0];
            end
            if (load_address == 16'd1) begin
                kept_is_attenuated <= load_data[1];
            end
            if (load_address == 16'd1) begin
                kept_view_shift <= load_data[7:4];
            end
            if (load_address == 16'd2) begin
                kept_distance <= load_data[16:0];
            end
            if (load_address == 16'd3) begin
                kept_offset <= load_data[29:0];
            end
            if (load_address == 16'd4) begin
                kept_background_r <= load_data[7:0];
            end
            if (load_address == 16'd4) begin
                kept_background_g <= load_data[15:8];
            end
            if (load_address == 16'd4) begin
                kept_background_b <= load_data[23:16];
            end
        end
    end

endmodule
