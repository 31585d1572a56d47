// sent_light: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module sent_light (
    input  wire clock,
    input  wire [16:0] diffuse,
    input  wire [16:0] specular,
    input  wire [15:0] mirror,
    input  wire [15:0] share_r,
    input  wire [15:0] share_g,
    input  wire [15:0] share_b,
    input  wire [16:0] colour_r,
    input  wire [16:0] colour_g,
    input  wire [16:0] colour_b,
    output wire [37:0] level_r,
    output wire [37:0] level_g,
    output wire [37:0] level_b
);

    wire [17:0] wide_diffuse;
    wire [17:0] wide_specular;
    wire [17:0] wide_mirror;
    wire signed [17:0] factor_diffuse;
    wire signed [17:0] factor_specular;
    wire signed [17:0] factor_mirror;
    wire [35:0] mirrored;
    wire [17:0] wide_share_r;
    wire signed [17:0] factor_share_r;
    wire [35:0] diffused_r;
    wire [35:0] both_r;
    wire [17:0] wide_sent_r;
    wire signed [17:0] factor_sent_r;
    wire [17:0] wide_colour_r;
    wire signed [17:0] factor_colour_r;
    wire [35:0] level_word_r;
    wire [17:0] wide_share_g;
    wire signed [17:0] factor_share_g;
    wire [35:0] diffused_g;
    wire [35:0] both_g;
    wire [17:0] wide_sent_g;
    wire signed [17:0] factor_sent_g;
    wire [17:0] wide_colour_g;
    wire signed [17:0] factor_colour_g;
    wire [35:0] level_word_g;
    wire [17:0] wide_share_b;
    wire signed [17:0] factor_share_b;
    wire [35:0] diffused_b;
    wire [35:0] both_b;
    wire [17:0] wide_sent_b;
    wire signed [17:0] factor_sent_b;
    wire [17:0] wide_colour_b;
    wire signed [17:0] factor_colour_b;
    wire [35:0] level_word_b;
    reg signed [35:0] kept_mirrored = 36'sd0;
    reg signed [35:0] kept_diffused_r = 36'sd0;
    reg [16:0] kept_sent_r = 17'd0;
    reg signed [35:0] kept_level_r = 36'sd0;
    reg signed [35:0] kept_diffused_g = 36'sd0;
    reg [16:0] kept_sent_g = 17'd0;
    reg signed [35:0] kept_level_g = 36'sd0;
    reg signed [35:0] kept_diffused_b = 36'sd0;
    reg [16:0] kept_sent_b = 17'd0;
    reg signed [35:0] kept_level_b = 36'sd0;

    assign wide_diffuse = {1'd0, diffuse};
    assign wide_specular = {1'd0, specular};
    assign wide_mirror = {2'd0, mirror};
    assign factor_diffuse = wide_diffuse;
    assign factor_specular = wide_specular;
    assign factor_mirror = wide_mirror;
    assign mirrored = kept_mirrored;
    assign wide_share_r = {2'd0, share_r};
    assign factor_share_r = wide_share_r;
    assign diffused_r = kept_diffused_r;
    assign both_r = diffused_r + mirrored;
    assign wide_sent_r = {1'd0, kept_sent_r};
    assign factor_sent_r = wide_sent_r;
    assign wide_colour_r = {1'd0, colour_r};
    assign factor_colour_r = wide_colour_r;
    assign level_word_r = kept_level_r;
    assign wide_share_g = {2'd0, share_g};
    assign factor_share_g = wide_share_g;
    assign diffused_g = kept_diffused_g;
    assign both_g = diffused_g + mirrored;
    assign wide_sent_g = {1'd0, kept_sent_g};
    assign factor_sent_g = wide_sent_g;
    assign wide_colour_g = {1'd0, colour_g};
    assign factor_colour_g = wide_colour_g;
    assign level_word_g = kept_level_g;
    assign wide_share_b = {2'd0, share_b};
    assign factor_share_b = wide_share_b;
    assign diffused_b = kept_diffused_b;
    assign both_b = diffused_b + mirrored;
    assign wide_sent_b = {1'd0, kept_sent_b};
    assign factor_sent_b = wide_sent_b;
    assign wide_colour_b = {1'd0, colour_b};
    assign factor_colour_b = wide_colour_b;
    assign level_word_b = kept_level_b;
    assign level_r = {2'd0, level_word_r};
    assign level_g = {2'd0, level_word_g};
    assign level_b = {2'd0, level_word_b};

    wire unused_bits = &{1'b0, both_r[35:34], both_r[16:0], both_g[35:34], both_g[16:0], both_b[35:34], both_b[16:0]};

    always @(posedge clock) begin
        kept_mirrored <= factor_mirror * factor_specular;
        kept_diffused_r <= factor_share_r * factor_diffuse;
        kept_sent_r <= both_r[33:17];
        kept_level_r <= factor_sent_r * factor_colour_r;
        kept_diffused_g <= factor_share_g * factor_diffuse;
        kept_sent_g <= both_g[33:17];
        kept_level_g <= factor_sent_g * factor_colour_g;
        kept_diffused_b <= factor_share_b * factor_diffuse;
        kept_sent_b <= both_b[33:17];
        kept_level_b <= factor_sent_b * factor_colour_b;
    end

endmodule
