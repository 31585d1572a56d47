// light_store: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module light_store (
    input  wire clock,
    input  wire load_valid,
    input  wire [15:0] load_address,
    input  wire [27:0] load_data,
    output wire [3:0] source,
    output wire point,
    output wire [3:0] shift,
    output wire signed [27:0] base_x,
    output wire signed [27:0] base_y,
    output wire signed [27:0] base_z,
    output wire signed [27:0] slope_x,
    output wire signed [27:0] slope_y,
    output wire signed [27:0] slope_z,
    output wire [16:0] colour_r,
    output wire [16:0] colour_g,
    output wire [16:0] colour_b
);

    reg [3:0] kept_source = 4'd0;
    reg kept_point = 1'd0;
    reg [3:0] kept_shift = 4'd0;
    reg signed [27:0] kept_base_x = 28'sd0;
    reg signed [27:0] kept_base_y = 28'sd0;
    reg signed [27:0] kept_base_z = 28'sd0;
    reg signed [27:0] kept_slope_x = 28'sd0;
    reg signed [27:0] kept_slope_y = 28'sd0;
    reg signed [27:0] kept_slope_z = 28'sd0;
    reg [16:0] kept_colour_r = 17'd0;
    reg [16:0] kept_colour_g = 17'd0;
    reg [16:0] kept_colour_b = 17'd0;

    assign source = kept_source;
    assign point = kept_point;
    assign shift = kept_shift;
    assign base_x = kept_base_x;
    assign base_y = kept_base_y;
    assign base_z = kept_base_z;
    assign slope_x = kept_slope_x;
    assign slope_y = kept_slope_y;
    assign slope_z = kept_slope_z;
    assign colour_r = kept_colour_r;
    assign colour_g = kept_colour_g;
    assign colour_b = kept_colour_b;

    always @(posedge clock) begin
        if (load_valid) begin
            if (load_address == 16'd16) begin
                kept_point <= load_data[0];
                kept_source <= load_data[7:4];
                kept_shift <= load_data[11:8];
            end
            if (load_address == 16'd17) begin
                kept_base_x <= load_data;
            end
            if (load_address == 16'd18) begin
                kept_base_y <= load_data;
            end
            if (load_address == 16'd19) begin
                kept_base_z <= load_data;
            end
            if (load_address == 16'd20) begin
                kept_slope_x <= load_data;
            end
            if (load_address == 16'd21) begin
                kept_slope_y <= load_data;
            end
            if (load_address == 16'd22) begin
                kept_slope_z <= load_data;
            end
            if (load_address == 16'd23) begin
                kept_colour_r <= load_data[16:0];
            end
            if (load_address == 16'd24) begin
                kept_colour_g <= load_data[16:0];
            end
            if (load_address == 16'd25) begin
                kept_colour_b <= load_data[16:0];
            end
        end
    end

endmodule
