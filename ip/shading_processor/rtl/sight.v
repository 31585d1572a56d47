// sight: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module sight (
    input  wire clock,
    input  wire [11:0] x,
    input  wire [11:0] y,
    input  wire signed [15:0] nx,
    input  wire signed [15:0] ny,
    input  wire signed [15:0] nz,
    input  wire [12:0] size_x,
    input  wire [12:0] size_y,
    input  wire perspective,
    input  wire [3:0] view_shift,
    input  wire [16:0] distance,
    output wire signed [12:0] place_x,
    output wire signed [12:0] place_y,
    output wire signed [17:0] ray_x,
    output wire signed [17:0] ray_y,
    output wire signed [17:0] ray_z,
    output wire signed [17:0] normal_x,
    output wire signed [17:0] normal_y,
    output wire signed [17:0] normal_z,
    output wire signed [24:0] across,
    output wire signed [24:0] square,
    output wire turned,
    output wire signed [27:0] normal_log,
    output wire signed [27:0] ray_log,
    output wire [5:0] ray_places
);

    localparam [7:0] one = 8'd1;
    localparam [7:0] five = 8'd5;
    localparam [17:0] no_ray = 18'd0;
    localparam signed [37:0] none = 38'sd0;
    wire [12:0] wide_at_x;
    wire [12:0] wide_at_y;
    wire [12:0] twice_x;
    wire [12:0] twice_y;
    wire signed [12:0] signed_place_x;
    wire signed [32:0] long_place_x;
    wire [32:0] long_word_x;
    wire [32:0] raised_x;
    wire [32:0] lowered_x;
    wire signed [12:0] signed_place_y;
    wire signed [32:0] long_place_y;
    wire [32:0] long_word_y;
    wire [32:0] raised_y;
    wire [32:0] lowered_y;
    wire [17:0] wide_distance;
    wire signed [17:0] full_normal_x;
    wire signed [17:0] full_normal_y;
    wire signed [17:0] full_normal_z;
    wire [37:0] normal_word;
    wire [37:0] ray_word;
    wire [22:0] cut_square;
    wire [24:0] wide_square;
    wire signed [17:0] ray_normaliser_shifted_x;
    wire signed [17:0] ray_normaliser_shifted_y;
    wire signed [17:0] ray_normaliser_shifted_z;
    wire [5:0] ray_normaliser_places;
    wire signed [15:0] normal_normaliser_shifted_x;
    wire signed [15:0] normal_normaliser_shifted_y;
    wire signed [15:0] normal_normaliser_shifted_z;
    wire [5:0] unused_normal_normaliser_places;
    wire [5:0] places_delay_late;
    wire signed [15:0] normal_delay_x_late;
    wire signed [15:0] normal_delay_y_late;
    wire signed [15:0] normal_delay_z_late;
    wire signed [37:0] normal_square_product;
    wire signed [37:0] ray_square_product;
    wire signed [37:0] both_product;
    wire [31:0] normal_logarithm_number;
    wire signed [27:0] normal_logarithm_value;
    wire [35:0] ray_logarithm_number;
    wire signed [27:0] ray_logarithm_value;
    reg [12:0] kept_place_x = 13'd0;
    reg [12:0] kept_place_y = 13'd0;
    reg [17:0] kept_ray_x = 18'd0;
    reg [17:0] kept_ray_y = 18'd0;
    reg signed [17:0] kept_full_ray_x = 18'sd0;
    reg signed [17:0] kept_full_ray_y = 18'sd0;
    reg signed [17:0] kept_full_ray_z = 18'sd0;

    vector_normaliser_w18 ray_normaliser (
        .clock(clock),
        .x(kept_ray_x),
        .y(kept_ray_y),
        .z(wide_distance),
        .shifted_x(ray_normaliser_shifted_x),
        .shifted_y(ray_normaliser_shifted_y),
        .shifted_z(ray_normaliser_shifted_z),
        .places(ray_normaliser_places)
    );

    vector_normaliser_w16 normal_normaliser (
        .clock(clock),
        .x(normal_delay_x_late),
        .y(normal_delay_y_late),
        .z(normal_delay_z_late),
        .shifted_x(normal_normaliser_shifted_x),
        .shifted_y(normal_normaliser_shifted_y),
        .shifted_z(normal_normaliser_shifted_z),
        .places(unused_normal_normaliser_places)
    );

    word_delay_w6_x11 places_delay (
        .clock(clock),
        .word(ray_normaliser_places),
        .late(places_delay_late)
    );

    word_delay_w16s_x3 normal_delay_x (
        .clock(clock),
        .word(nx),
        .late(normal_delay_x_late)
    );

    word_delay_w16s_x3 normal_delay_y (
        .clock(clock),
        .word(ny),
        .late(normal_delay_y_late)
    );

    word_delay_w16s_x3 normal_delay_z (
        .clock(clock),
        .word(nz),
        .late(normal_delay_z_late)
    );

    scalar_product normal_square (
        .clock(clock),
        .ax(full_normal_x),
        .ay(full_normal_y),
        .az(full_normal_z),
        .bx(full_normal_x),
        .by(full_normal_y),
        .bz(full_normal_z),
        .product(normal_square_product)
    );

    scalar_product ray_square (
        .clock(clock),
        .ax(kept_full_ray_x),
        .ay(kept_full_ray_y),
        .az(kept_full_ray_z),
        .bx(kept_full_ray_x),
        .by(kept_full_ray_y),
        .bz(kept_full_ray_z),
        .product(ray_square_product)
    );

    scalar_product both (
        .clock(clock),
        .ax(full_normal_x),
        .ay(full_normal_y),
        .az(full_normal_z),
        .bx(kept_full_ray_x),
        .by(kept_full_ray_y),
        .bz(kept_full_ray_z),
        .product(both_product)
    );

    logarithm_w28_v1 normal_logarithm (
        .clock(clock),
        .number(normal_logarithm_number),
        .value(normal_logarithm_value)
    );

    logarithm_w28_v2 ray_logarithm (
        .clock(clock),
        .number(ray_logarithm_number),
        .value(ray_logarithm_value)
    );

    assign wide_at_x = {1'd0, x};
    assign wide_at_y = {1'd0, y};
    assign twice_x = wide_at_x << one;
    assign twice_y = wide_at_y << one;
    assign signed_place_x = kept_place_x;
    assign long_place_x = {{20{signed_place_x[12]}}, signed_place_x};
    assign long_word_x = long_place_x;
    assign raised_x = long_word_x << five;
    assign lowered_x = raised_x >> view_shift;
    assign signed_place_y = kept_place_y;
    assign long_place_y = {{20{signed_place_y[12]}}, signed_place_y};
    assign long_word_y = long_place_y;
    assign raised_y = long_word_y << five;
    assign lowered_y = raised_y >> view_shift;
    assign wide_distance = {1'd0, distance};
    assign full_normal_x = {{2{normal_normaliser_shifted_x[15]}}, normal_normaliser_shifted_x};
    assign full_normal_y = {{2{normal_normaliser_shifted_y[15]}}, normal_normaliser_shifted_y};
    assign full_normal_z = {{2{normal_normaliser_shifted_z[15]}}, normal_normaliser_shifted_z};
    assign normal_word = normal_square_product;
    assign ray_word = ray_square_product;
    assign cut_square = normal_word[31:9];
    assign wide_square = {2'd0, cut_square};
    assign normal_logarithm_number = normal_word[31:0];
    assign ray_logarithm_number = ray_word[35:0];
    assign place_x = signed_place_x;
    assign place_y = signed_place_y;
    assign ray_x = kept_full_ray_x;
    assign ray_y = kept_full_ray_y;
    assign ray_z = kept_full_ray_z;
    assign normal_x = full_normal_x;
    assign normal_y = full_normal_y;
    assign normal_z = full_normal_z;
    assign across = both_product[34:10];
    assign square = wide_square;
    assign turned = both_product > none;
    assign normal_log = normal_logarithm_value;
    assign ray_log = ray_logarithm_value;
    assign ray_places = places_delay_late;

    wire unused_bits = &{1'b0, lowered_x[32:18], lowered_y[32:18], normal_word[37:32], ray_word[37:36]};

    always @(posedge clock) begin
        kept_place_x <= twice_x - size_x;
        if (perspective) begin
            kept_ray_x <= lowered_x[17:0];
        end else begin
            kept_ray_x <= no_ray;
        end
        kept_place_y <= twice_y - size_y;
        if (perspective) begin
            kept_ray_y <= lowered_y[17:0];
        end else begin
            kept_ray_y <= no_ray;
        end
        kept_full_ray_x <= ray_normaliser_shifted_x;
        kept_full_ray_y <= ray_normaliser_shifted_y;
        kept_full_ray_z <= ray_normaliser_shifted_z;
    end

endmodule
