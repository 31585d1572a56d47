// shading_processor: the colour of every pixel by Phong shading under several lights
//
// parameters: format 24
//             lights 1
// latency:    38 clocks
// error:      within one level of 8 bits of the formula in real numbers on the same integer words (docs/shading.md)
// source:     Chaillou 1991, III.1.2; Nyiri 1994, 1.2.4
// ports:
//   in  clock           1 unsigned
//   in  valid           1 unsigned
//   in  x              12 unsigned
//   in  y              12 unsigned
//   in  depth          24 two's complement
//   in  material        8 unsigned
//   in  nx             16 two's complement
//   in  ny             16 two's complement
//   in  nz             16 two's complement
//   in  flags          16 unsigned
//   in  load_valid      1 unsigned
//   in  load_address   16 unsigned
//   in  load_data      32 unsigned
//   out out_valid       1 unsigned
//   out red             8 unsigned
//   out green           8 unsigned
//   out blue            8 unsigned
//
// Made by: imogene emit shading_processor --format 24 --lights 1 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module shading_processor (
    input  wire clock,
    input  wire valid,
    input  wire [11:0] x,
    input  wire [11:0] y,
    input  wire signed [23:0] depth,
    input  wire [7:0] material,
    input  wire signed [15:0] nx,
    input  wire signed [15:0] ny,
    input  wire signed [15:0] nz,
    input  wire [15:0] flags,
    input  wire load_valid,
    input  wire [15:0] load_address,
    input  wire [31:0] load_data,
    output wire out_valid,
    output wire [7:0] red,
    output wire [7:0] green,
    output wire [7:0] blue
);

    localparam [7:0] missing = 8'd8;
    localparam [31:0] sign_bit = 32'd2147483648;
    localparam [31:0] depth_mask = 32'd4294967040;
    localparam signed [23:0] far_end = 24'sd8388607;
    localparam [5:0] material_page = 6'd4;
    localparam [37:0] no_level = 38'd0;
    localparam [37:0] half = 38'd1048576;
    localparam [7:0] ambient_point = 8'd13;
    localparam [8:0] no_excess = 9'd0;
    localparam [7:0] brightest = 8'd255;
    wire [23:0] depth_word;
    wire [31:0] wide_depth;
    wire [31:0] left_depth;
    wire [31:0] inverted;
    wire [31:0] turned_sign;
    wire [5:0] page;
    wire [1:0] memory_number;
    wire is_material;
    wire [7:0] exponent;
    wire [15:0] early_share;
    wire [15:0] mirror;
    wire [15:0] share_r;
    wire [15:0] ambient_r;
    wire [15:0] share_g;
    wire [15:0] ambient_g;
    wire [15:0] ambient_b;
    wire [37:0] wide_ambient_r;
    wire [37:0] ambient_level_r;
    wire [37:0] first_r;
    wire [37:0] second_r;
    wire [8:0] excess_r;
    wire [37:0] wide_ambient_g;
    wire [37:0] ambient_level_g;
    wire [37:0] first_g;
    wire [37:0] second_g;
    wire [8:0] excess_g;
    wire [37:0] wide_ambient_b;
    wire [37:0] ambient_level_b;
    wire [37:0] first_b;
    wire [37:0] second_b;
    wire [8:0] excess_b;
    wire [12:0] view_store_size_x;
    wire [12:0] view_store_size_y;
    wire view_store_perspective;
    wire view_store_is_attenuated;
    wire [3:0] view_store_view_shift;
    wire [16:0] view_store_distance;
    wire signed [29:0] view_store_offset;
    wire [7:0] view_store_background_r;
    wire [7:0] view_store_background_g;
    wire [7:0] view_store_background_b;
    wire [27:0] light_stores_0_load_data;
    wire [3:0] light_stores_0_source;
    wire light_stores_0_point;
    wire [3:0] light_stores_0_shift;
    wire signed [27:0] light_stores_0_base_x;
    wire signed [27:0] light_stores_0_base_y;
    wire signed [27:0] light_stores_0_base_z;
    wire signed [27:0] light_stores_0_slope_x;
    wire signed [27:0] light_stores_0_slope_y;
    wire signed [27:0] light_stores_0_slope_z;
    wire [16:0] light_stores_0_colour_r;
    wire [16:0] light_stores_0_colour_g;
    wire [16:0] light_stores_0_colour_b;
    wire signed [12:0] sight_place_x;
    wire signed [12:0] sight_place_y;
    wire signed [17:0] sight_ray_x;
    wire signed [17:0] sight_ray_y;
    wire signed [17:0] sight_ray_z;
    wire signed [17:0] sight_normal_x;
    wire signed [17:0] sight_normal_y;
    wire signed [17:0] sight_normal_z;
    wire signed [24:0] sight_across;
    wire signed [24:0] sight_square;
    wire sight_turned;
    wire signed [27:0] sight_normal_log;
    wire signed [27:0] sight_ray_log;
    wire [5:0] sight_ray_places;
    wire [25:0] attenuation_loss;
    wire [16:0] factors_0_diffuse;
    wire [16:0] factors_0_specular;
    wire [37:0] sent_0_level_r;
    wire [37:0] sent_0_level_g;
    wire [37:0] sent_0_level_b;
    wire valid_delay_late;
    wire is_far_word;
    wire is_far_late;
    wire [7:0] material_delay_late;
    wire [7:0] late_material_late;
    wire materials_0_write;
    wire [7:0] materials_0_write_address;
    wire [31:0] materials_0_read_data;
    wire materials_1_write;
    wire [7:0] materials_1_write_address;
    wire [31:0] materials_1_read_data;
    wire materials_2_write;
    wire [7:0] materials_2_write_address;
    wire [31:0] materials_2_read_data;
    wire materials_3_write;
    wire [7:0] materials_3_write_address;
    wire [31:0] materials_3_read_data;
    wire [15:0] share_delay_late;
    wire [15:0] ambient_delay_r_late;
    wire [15:0] ambient_delay_g_late;
    wire [15:0] ambient_delay_b_late;
    reg [31:0] kept_depth = 32'd0;
    reg [31:0] kept_far = 32'd0;
    reg [37:0] kept_low_r = 38'd0;
    reg [37:0] kept_high_r = 38'd0;
    reg [37:0] kept_sum_r = 38'd0;
    reg [7:0] kept_red = 8'd0;
    reg [37:0] kept_low_g = 38'd0;
    reg [37:0] kept_high_g = 38'd0;
    reg [37:0] kept_sum_g = 38'd0;
    reg [7:0] kept_green = 8'd0;
    reg [37:0] kept_low_b = 38'd0;
    reg [37:0] kept_high_b = 38'd0;
    reg [37:0] kept_sum_b = 38'd0;
    reg [7:0] kept_blue = 8'd0;

    view_store view_store (
        .clock(clock),
        .load_valid(load_valid),
        .load_address(load_address),
        .load_data(load_data),
        .size_x(view_store_size_x),
        .size_y(view_store_size_y),
        .perspective(view_store_perspective),
        .is_attenuated(view_store_is_attenuated),
        .view_shift(view_store_view_shift),
        .distance(view_store_distance),
        .offset(view_store_offset),
        .background_r(view_store_background_r),
        .background_g(view_store_background_g),
        .background_b(view_store_background_b)
    );

    light_store light_stores_0 (
        .clock(clock),
        .load_valid(load_valid),
        .load_address(load_address),
        .load_data(light_stores_0_load_data),
        .source(light_stores_0_source),
        .point(light_stores_0_point),
        .shift(light_stores_0_shift),
        .base_x(light_stores_0_base_x),
        .base_y(light_stores_0_base_y),
        .base_z(light_stores_0_base_z),
        .slope_x(light_stores_0_slope_x),
        .slope_y(light_stores_0_slope_y),
        .slope_z(light_stores_0_slope_z),
        .colour_r(light_stores_0_colour_r),
        .colour_g(light_stores_0_colour_g),
        .colour_b(light_stores_0_colour_b)
    );

    sight sight (
        .clock(clock),
        .x(x),
        .y(y),
        .nx(nx),
        .ny(ny),
        .nz(nz),
        .size_x(view_store_size_x),
        .size_y(view_store_size_y),
        .perspective(view_store_perspective),
        .view_shift(view_store_view_shift),
        .distance(view_store_distance),
        .place_x(sight_place_x),
        .place_y(sight_place_y),
        .ray_x(sight_ray_x),
        .ray_y(sight_ray_y),
        .ray_z(sight_ray_z),
        .normal_x(sight_normal_x),
        .normal_y(sight_normal_y),
        .normal_z(sight_normal_z),
        .across(sight_across),
        .square(sight_square),
        .turned(sight_turned),
        .normal_log(sight_normal_log),
        .ray_log(sight_ray_log),
        .ray_places(sight_ray_places)
    );

    attenuation attenuation (
        .clock(clock),
        .is_on(view_store_is_attenuated),
        .offset(view_store_offset),
        .far(kept_far),
        .ray_log(sight_ray_log),
        .ray_places(sight_ray_places),
        .loss(attenuation_loss)
    );

    light_factors factors_0 (
        .clock(clock),
        .flags(flags),
        .place_x(sight_place_x),
        .place_y(sight_place_y),
        .depth(kept_depth),
        .ray_x(sight_ray_x),
        .ray_y(sight_ray_y),
        .ray_z(sight_ray_z),
        .normal_x(sight_normal_x),
        .normal_y(sight_normal_y),
        .normal_z(sight_normal_z),
        .across(sight_across),
        .square(sight_square),
        .turned(sight_turned),
        .normal_log(sight_normal_log),
        .ray_log(sight_ray_log),
        .exponent(exponent),
        .attenuation(attenuation_loss),
        .source(light_stores_0_source),
        .point(light_stores_0_point),
        .shift(light_stores_0_shift),
        .base_x(light_stores_0_base_x),
        .base_y(light_stores_0_base_y),
        .base_z(light_stores_0_base_z),
        .slope_x(light_stores_0_slope_x),
        .slope_y(light_stores_0_slope_y),
        .slope_z(light_stores_0_slope_z),
        .diffuse(factors_0_diffuse),
        .specular(factors_0_specular)
    );

    sent_light sent_0 (
        .clock(clock),
        .diffuse(factors_0_diffuse),
        .specular(factors_0_specular),
        .mirror(mirror),
        .share_r(share_r),
        .share_g(share_g),
        .share_b(share_delay_late),
        .colour_r(light_stores_0_colour_r),
        .colour_g(light_stores_0_colour_g),
        .colour_b(light_stores_0_colour_b),
        .level_r(sent_0_level_r),
        .level_g(sent_0_level_g),
        .level_b(sent_0_level_b)
    );

    word_delay_w1_x38 valid_delay (
        .clock(clock),
        .word(valid),
        .late(valid_delay_late)
    );

    word_delay_w1_x37 is_far (
        .clock(clock),
        .word(is_far_word),
        .late(is_far_late)
    );

    word_delay_w8_x18 material_delay (
        .clock(clock),
        .word(material),
        .late(material_delay_late)
    );

    word_delay_w8_x13 late_material (
        .clock(clock),
        .word(material_delay_late),
        .late(late_material_late)
    );

    block_memory materials_0 (
        .clock(clock),
        .write(materials_0_write),
        .write_address(materials_0_write_address),
        .write_data(load_data),
        .read_address(late_material_late),
        .read_data(materials_0_read_data)
    );

    block_memory materials_1 (
        .clock(clock),
        .write(materials_1_write),
        .write_address(materials_1_write_address),
        .write_data(load_data),
        .read_address(late_material_late),
        .read_data(materials_1_read_data)
    );

    block_memory materials_2 (
        .clock(clock),
        .write(materials_2_write),
        .write_address(materials_2_write_address),
        .write_data(load_data),
        .read_address(late_material_late),
        .read_data(materials_2_read_data)
    );

    block_memory materials_3 (
        .clock(clock),
        .write(materials_3_write),
        .write_address(materials_3_write_address),
        .write_data(load_data),
        .read_address(material_delay_late),
        .read_data(materials_3_read_data)
    );

    word_delay_w16_x13 share_delay (
        .clock(clock),
        .word(early_share),
        .late(share_delay_late)
    );

    word_delay_w16_x3 ambient_delay_r (
        .clock(clock),
        .word(ambient_r),
        .late(ambient_delay_r_late)
    );

    word_delay_w16_x3 ambient_delay_g (
        .clock(clock),
        .word(ambient_g),
        .late(ambient_delay_g_late)
    );

    word_delay_w16_x3 ambient_delay_b (
        .clock(clock),
        .word(ambient_b),
        .late(ambient_delay_b_late)
    );

    assign depth_word = depth;
    assign wide_depth = {8'd0, depth_word};
    assign left_depth = wide_depth << missing;
    assign inverted = ~left_depth;
    assign turned_sign = inverted ^ sign_bit;
    assign page = load_address[15:10];
    assign memory_number = load_address[1:0];
    assign is_material = load_valid & (page == material_page);
    assign exponent = materials_3_read_data[23:16];
    assign early_share = materials_3_read_data[15:0];
    assign mirror = materials_1_read_data[31:16];
    assign share_r = materials_2_read_data[15:0];
    assign ambient_r = materials_0_read_data[15:0];
    assign share_g = materials_2_read_data[31:16];
    assign ambient_g = materials_0_read_data[31:16];
    assign ambient_b = materials_1_read_data[15:0];
    assign wide_ambient_r = {22'd0, ambient_delay_r_late};
    assign ambient_level_r = wide_ambient_r << ambient_point;
    assign first_r = sent_0_level_r + no_level;
    assign second_r = ambient_level_r + half;
    assign excess_r = kept_sum_r[37:29];
    assign wide_ambient_g = {22'd0, ambient_delay_g_late};
    assign ambient_level_g = wide_ambient_g << ambient_point;
    assign first_g = sent_0_level_g + no_level;
    assign second_g = ambient_level_g + half;
    assign excess_g = kept_sum_g[37:29];
    assign wide_ambient_b = {22'd0, ambient_delay_b_late};
    assign ambient_level_b = wide_ambient_b << ambient_point;
    assign first_b = sent_0_level_b + no_level;
    assign second_b = ambient_level_b + half;
    assign excess_b = kept_sum_b[37:29];
    assign light_stores_0_load_data = load_data[27:0];
    assign is_far_word = depth == far_end;
    assign materials_0_write = is_material & (memory_number == 2'd0);
    assign materials_0_write_address = load_address[9:2];
    assign materials_1_write = is_material & (memory_number == 2'd1);
    assign materials_1_write_address = load_address[9:2];
    assign materials_2_write = is_material & (memory_number == 2'd2);
    assign materials_2_write_address = load_address[9:2];
    assign materials_3_write = is_material & (memory_number == 2'd3);
    assign materials_3_write_address = load_address[9:2];
    assign out_valid = valid_delay_late;
    assign red = kept_red;
    assign green = kept_green;
    assign blue = kept_blue;

    wire unused_bits = &{1'b0, materials_3_read_data[31:24], kept_sum_r[20:0], kept_sum_g[20:0], kept_sum_b[20:0]};

    always @(posedge clock) begin
        kept_depth <= left_depth;
        kept_far <= turned_sign & depth_mask;
        kept_low_r <= first_r + second_r;
        kept_high_r <= no_level + no_level;
        kept_sum_r <= kept_low_r + kept_high_r;
        if (is_far_late) begin
            kept_red <= view_store_background_r;
        end else if (excess_r == no_excess) begin
            kept_red <= kept_sum_r[28:21];
        end else begin
            kept_red <= brightest;
        end
        kept_low_g <= first_g + second_g;
        kept_high_g <= no_level + no_level;
        kept_sum_g <= kept_low_g + kept_high_g;
        if (is_far_late) begin
            kept_green <= view_store_background_g;
        end else if (excess_g == no_excess) begin
            kept_green <= kept_sum_g[28:21];
        end else begin
            kept_green <= brightest;
        end
        kept_low_b <= first_b + second_b;
        kept_high_b <= no_level + no_level;
        kept_sum_b <= kept_low_b + kept_high_b;
        if (is_far_late) begin
            kept_blue <= view_store_background_b;
        end else if (excess_b == no_excess) begin
            kept_blue <= kept_sum_b[28:21];
        end else begin
            kept_blue <= brightest;
        end
    end

endmodule
