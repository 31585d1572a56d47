// root_length: part of square_root_quadratic; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module root_length (
    input  wire [47:0] radicand,
    output wire [5:0] length
);

    localparam [5:0] zero = 6'd0;

    assign length = (radicand[46] | radicand[47]) ? 6'd24 :
        (radicand[44] | radicand[45]) ? 6'd23 :
        (radicand[42] | radicand[43]) ? 6'd22 :
        (radicand[40] | radicand[41]) ? 6'd21 :
        (radicand[38] | radicand[39]) ? 6'd20 :
        (radicand[36] | radicand[37]) ? 6'd19 :
        (radicand[34] | radicand[35]) ? 6'd18 :
        (radicand[32] | radicand[33]) ? 6'd17 :
        (radicand[30] | radicand[31]) ? 6'd16 :
        (radicand[28] | radicand[29]) ? 6'd15 :
        (radicand[26] | radicand[27]) ? 6'd14 :
        (radicand[24] | radicand[25]) ? 6'd13 :
        (radicand[22] | radicand[23]) ? 6'd12 :
        (radicand[20] | radicand[21]) ? 6'd11 :
        (radicand[18] | radicand[19]) ? 6'd10 :
        (radicand[16] | radicand[17]) ? 6'd9 :
        (radicand[14] | radicand[15]) ? 6'd8 :
        (radicand[12] | radicand[13]) ? 6'd7 :
        (radicand[10] | radicand[11]) ? 6'd6 :
        (radicand[8] | radicand[9]) ? 6'd5 :
        (radicand[6] | radicand[7]) ? 6'd4 :
        (radicand[4] | radicand[5]) ? 6'd3 :
        (radicand[2] | radicand[3]) ? 6'd2 :
        (radicand[0] | radicand[1]) ? 6'd1 : zero;

endmodule
