// light_factors: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module light_factors (
    input  wire clock,
    input  wire [15:0] flags,
    input  wire signed [12:0] place_x,
    input  wire signed [12:0] place_y,
    input  wire signed [31:0] depth,
    input  wire signed [17:0] ray_x,
    input  wire signed [17:0] ray_y,
    input  wire signed [17:0] ray_z,
    input  wire signed [17:0] normal_x,
    input  wire signed [17:0] normal_y,
    input  wire signed [17:0] normal_z,
    input  wire signed [24:0] across,
    input  wire signed [24:0] square,
    input  wire turned,
    input  wire signed [27:0] normal_log,
    input  wire signed [27:0] ray_log,
    input  wire [7:0] exponent,
    input  wire [25:0] attenuation,
    input  wire [3:0] source,
    input  wire point,
    input  wire [3:0] shift,
    input  wire signed [27:0] base_x,
    input  wire signed [27:0] base_y,
    input  wire signed [27:0] base_z,
    input  wire signed [27:0] slope_x,
    input  wire signed [27:0] slope_y,
    input  wire signed [27:0] slope_z,
    output wire [16:0] diffuse,
    output wire [16:0] specular
);

    localparam [29:0] no_place = 30'd0;
    localparam signed [37:0] none = 38'sd0;
    localparam [11:0] no_rest = 12'd0;
    localparam signed [24:0] no_along = 25'sd0;
    localparam signed [29:0] no_cosine = 30'sd0;
    localparam signed [31:0] pair_cut = 32'sd20971520;
    localparam signed [31:0] four_cut = 32'sd85983232;
    localparam [31:0] no_loss = 32'd0;
    localparam [25:0] no_short_loss = 26'd0;
    localparam signed [5:0] no_high = 6'sd0;
    localparam [25:0] most = 26'd67108863;
    localparam [16:0] nothing = 17'd0;
    wire [15:0] shifted_flags;
    wire signed [29:0] long_place_x;
    wire [29:0] long_word_x;
    wire [29:0] shifted_x;
    wire [29:0] light_place_x;
    wire signed [29:0] long_place_y;
    wire [29:0] long_word_y;
    wire [29:0] shifted_y;
    wire [29:0] light_place_y;
    wire signed [17:0] high_x;
    wire [29:0] full_word_x;
    wire [11:0] low_x;
    wire [17:0] wide_low_x;
    wire signed [17:0] high_y;
    wire [29:0] full_word_y;
    wire [11:0] low_y;
    wire [17:0] wide_low_y;
    wire signed [17:0] high_z;
    wire [29:0] full_word_z;
    wire [11:0] low_z;
    wire [17:0] wide_low_z;
    wire signed [25:0] low_carry;
    wire signed [37:0] wide_carry;
    wire [37:0] low_word;
    wire [11:0] low_rest;
    wire is_negative;
    wire is_positive;
    wire signed [24:0] along;
    wire signed [24:0] opposite;
    wire [24:0] along_word;
    wire signed [24:0] back;
    wire signed [29:0] cosine;
    wire is_cosine;
    wire [37:0] light_word;
    wire signed [31:0] wide_normal_log;
    wire signed [31:0] wide_ray_log;
    wire signed [31:0] wide_light_log;
    wire signed [31:0] wide_along_log;
    wire signed [31:0] wide_cosine_log;
    wire signed [31:0] pair;
    wire signed [31:0] normal_ray;
    wire signed [31:0] twice_along;
    wire signed [31:0] twice_cosine;
    wire signed [5:0] specular_high;
    wire [27:0] wide_loss;
    wire signed [27:0] loss_factor;
    wire [27:0] wide_exponent;
    wire signed [27:0] exponent_factor;
    wire [35:0] power_word;
    wire [35:0] wide_attenuation;
    wire [35:0] wide_diffuse;
    wire gate;
    wire reach_word;
    wire reach_late;
    wire signed [29:0] normaliser_shifted_x;
    wire signed [29:0] normaliser_shifted_y;
    wire signed [29:0] normaliser_shifted_z;
    wire [5:0] unused_normaliser_places;
    wire signed [29:0] component_x_result;
    wire signed [29:0] component_y_result;
    wire signed [29:0] component_z_result;
    wire signed [37:0] normal_high_product;
    wire signed [37:0] normal_low_product;
    wire signed [37:0] light_square_product;
    wire signed [37:0] ray_light_product;
    wire [35:0] light_logarithm_number;
    wire signed [27:0] light_logarithm_value;
    wire signed [27:0] along_logarithm_value;
    wire signed [27:0] cosine_logarithm_value;
    wire [35:0] power_delay_late;
    wire [31:0] diffuse_delay_late;
    wire [16:0] diffuse_power_value;
    wire [16:0] specular_power_value;
    wire diffuse_gate_word;
    wire diffuse_gate_late;
    wire specular_gate_word;
    wire specular_gate_late;
    reg signed [37:0] kept_exact = 38'sd0;
    reg kept_rest = 1'd0;
    reg kept_turned = 1'd0;
    reg kept_lit = 1'd0;
    reg signed [24:0] kept_along = 25'sd0;
    reg [23:0] kept_magnitude = 24'd0;
    reg kept_is_along = 1'd0;
    reg signed [49:0] kept_turn = 50'sd0;
    reg signed [49:0] kept_straight = 50'sd0;
    reg signed [49:0] kept_difference = 50'sd0;
    reg signed [31:0] kept_pair = 32'sd0;
    reg signed [31:0] kept_four = 32'sd0;
    reg signed [31:0] kept_pair_cut = 32'sd0;
    reg signed [31:0] kept_four_cut = 32'sd0;
    reg signed [31:0] kept_diffuse = 32'sd0;
    reg signed [31:0] kept_specular = 32'sd0;
    reg [31:0] kept_diffuse_loss = 32'd0;
    reg [25:0] kept_specular_loss = 26'd0;
    reg signed [55:0] kept_power = 56'sd0;
    reg [35:0] kept_diffuse_sum = 36'd0;
    reg [35:0] kept_specular_sum = 36'd0;

    word_delay_w1_x9 reach (
        .clock(clock),
        .word(reach_word),
        .late(reach_late)
    );

    vector_normaliser_w30 normaliser (
        .clock(clock),
        .x(component_x_result),
        .y(component_y_result),
        .z(component_z_result),
        .shifted_x(normaliser_shifted_x),
        .shifted_y(normaliser_shifted_y),
        .shifted_z(normaliser_shifted_z),
        .places(unused_normaliser_places)
    );

    light_component component_x (
        .clock(clock),
        .depth(depth),
        .place(light_place_x),
        .base(base_x),
        .slope(slope_x),
        .result(component_x_result)
    );

    light_component component_y (
        .clock(clock),
        .depth(depth),
        .place(light_place_y),
        .base(base_y),
        .slope(slope_y),
        .result(component_y_result)
    );

    light_component component_z (
        .clock(clock),
        .depth(depth),
        .place(no_place),
        .base(base_z),
        .slope(slope_z),
        .result(component_z_result)
    );

    scalar_product normal_high (
        .clock(clock),
        .ax(normal_x),
        .ay(normal_y),
        .az(normal_z),
        .bx(high_x),
        .by(high_y),
        .bz(high_z),
        .product(normal_high_product)
    );

    scalar_product normal_low (
        .clock(clock),
        .ax(normal_x),
        .ay(normal_y),
        .az(normal_z),
        .bx(wide_low_x),
        .by(wide_low_y),
        .bz(wide_low_z),
        .product(normal_low_product)
    );

    scalar_product light_square (
        .clock(clock),
        .ax(high_x),
        .ay(high_y),
        .az(high_z),
        .bx(high_x),
        .by(high_y),
        .bz(high_z),
        .product(light_square_product)
    );

    scalar_product ray_light (
        .clock(clock),
        .ax(ray_x),
        .ay(ray_y),
        .az(ray_z),
        .bx(high_x),
        .by(high_y),
        .bz(high_z),
        .product(ray_light_product)
    );

    logarithm_w28_v2 light_logarithm (
        .clock(clock),
        .number(light_logarithm_number),
        .value(light_logarithm_value)
    );

    logarithm_w28_v3 along_logarithm (
        .clock(clock),
        .number(kept_magnitude),
        .value(along_logarithm_value)
    );

    logarithm_w28_v4 cosine_logarithm (
        .clock(clock),
        .number(cosine),
        .value(cosine_logarithm_value)
    );

    word_delay_w36_x4 power_delay (
        .clock(clock),
        .word(power_word),
        .late(power_delay_late)
    );

    word_delay_w32_x5 diffuse_delay (
        .clock(clock),
        .word(kept_diffuse_loss),
        .late(diffuse_delay_late)
    );

    power_of_two diffuse_power (
        .clock(clock),
        .loss(kept_diffuse_sum),
        .value(diffuse_power_value)
    );

    power_of_two specular_power (
        .clock(clock),
        .loss(kept_specular_sum),
        .value(specular_power_value)
    );

    word_delay_w1_x23 diffuse_gate (
        .clock(clock),
        .word(diffuse_gate_word),
        .late(diffuse_gate_late)
    );

    word_delay_w1_x23 specular_gate (
        .clock(clock),
        .word(specular_gate_word),
        .late(specular_gate_late)
    );

    assign shifted_flags = flags >> source;
    assign long_place_x = {{17{place_x[12]}}, place_x};
    assign long_word_x = long_place_x;
    assign shifted_x = long_word_x << shift;
    assign light_place_x = point ? shifted_x : no_place;
    assign long_place_y = {{17{place_y[12]}}, place_y};
    assign long_word_y = long_place_y;
    assign shifted_y = long_word_y << shift;
    assign light_place_y = point ? shifted_y : no_place;
    assign high_x = normaliser_shifted_x[29:12];
    assign full_word_x = normaliser_shifted_x;
    assign low_x = full_word_x[11:0];
    assign wide_low_x = {6'd0, low_x};
    assign high_y = normaliser_shifted_y[29:12];
    assign full_word_y = normaliser_shifted_y;
    assign low_y = full_word_y[11:0];
    assign wide_low_y = {6'd0, low_y};
    assign high_z = normaliser_shifted_z[29:12];
    assign full_word_z = normaliser_shifted_z;
    assign low_z = full_word_z[11:0];
    assign wide_low_z = {6'd0, low_z};
    assign low_carry = normal_low_product[37:12];
    assign wide_carry = {{12{low_carry[25]}}, low_carry};
    assign low_word = normal_low_product;
    assign low_rest = low_word[11:0];
    assign is_negative = kept_exact[37];
    assign is_positive = (kept_exact > none) | ((kept_exact == none) & kept_rest);
    assign along = normal_high_product[34:10];
    assign opposite = -along;
    assign along_word = kept_along;
    assign back = ray_light_product[36:12];
    assign cosine = kept_difference[49:20];
    assign is_cosine = cosine > no_cosine;
    assign light_word = light_square_product;
    assign wide_normal_log = {{4{normal_log[27]}}, normal_log};
    assign wide_ray_log = {{4{ray_log[27]}}, ray_log};
    assign wide_light_log = {{4{light_logarithm_value[27]}}, light_logarithm_value};
    assign wide_along_log = {{4{along_logarithm_value[27]}}, along_logarithm_value};
    assign wide_cosine_log = {{4{cosine_logarithm_value[27]}}, cosine_logarithm_value};
    assign pair = wide_normal_log + wide_light_log;
    assign normal_ray = wide_normal_log + wide_ray_log;
    assign twice_along = wide_along_log + wide_along_log;
    assign twice_cosine = wide_cosine_log + wide_cosine_log;
    assign specular_high = kept_specular[31:26];
    assign wide_loss = {2'd0, kept_specular_loss};
    assign loss_factor = wide_loss;
    assign wide_exponent = {20'd0, exponent};
    assign exponent_factor = wide_exponent;
    assign power_word = kept_power[35:0];
    assign wide_attenuation = {10'd0, attenuation};
    assign wide_diffuse = {4'd0, diffuse_delay_late};
    assign gate = kept_lit & reach_late;
    assign reach_word = shifted_flags[0];
    assign light_logarithm_number = light_word[35:0];
    assign diffuse_gate_word = gate & kept_is_along;
    assign specular_gate_word = gate & is_cosine;
    assign diffuse = diffuse_gate_late ? diffuse_power_value : nothing;
    assign specular = specular_gate_late ? specular_power_value : nothing;

    wire unused_bits = &{1'b0, shifted_flags[15:1], full_word_x[29:12], full_word_y[29:12], full_word_z[29:12], low_word[37:12], along_word[24], light_word[37:36], ray_light_product[37], ray_light_product[11:0], kept_difference[19:0], kept_power[55:36]};

    always @(posedge clock) begin
        kept_exact <= normal_high_product + wide_carry;
        kept_rest <= low_rest != no_rest;
        kept_turned <= turned;
        if (kept_turned) begin
            kept_lit <= is_negative;
        end else begin
            kept_lit <= is_positive;
        end
        if (turned) begin
            kept_along <= opposite;
        end else begin
            kept_along <= along;
        end
        kept_magnitude <= along_word[23:0];
        kept_is_along <= kept_along > no_along;
        kept_turn <= along * across;
        kept_straight <= square * back;
        kept_difference <= kept_straight - kept_turn;
        kept_pair <= pair;
        kept_four <= pair + normal_ray;
        kept_pair_cut <= kept_pair - pair_cut;
        kept_four_cut <= kept_four - four_cut;
        kept_diffuse <= kept_pair_cut - twice_along;
        kept_specular <= kept_four_cut - twice_cosine;
        if (kept_diffuse[31]) begin
            kept_diffuse_loss <= no_loss;
        end else begin
            kept_diffuse_loss <= kept_diffuse;
        end
        if (kept_specular[31]) begin
            kept_specular_loss <= no_short_loss;
        end else if (specular_high == no_high) begin
            kept_specular_loss <= kept_specular[25:0];
        end else begin
            kept_specular_loss <= most;
        end
        kept_power <= loss_factor * exponent_factor;
        kept_diffuse_sum <= wide_diffuse + wide_attenuation;
        kept_specular_sum <= power_delay_late + wide_attenuation;
    end

endmodule
