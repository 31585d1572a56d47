// Stated models of cells that have no delays here.
//
// A PLL is locked from the first clock on. Its input ticks at the rate of its fast output, and every fifth of these edges
// is one of the pixels: the dividers themselves are arithmetic, not simulated.
// Nothing here has delays, so that most pins count nothing.
/* verilator lint_off UNUSEDSIGNAL */
module EHXPLLL #(
    parameter PLLRST_ENA = "", INTFB_WAKE = "", STDBY_ENABLE = "", DPHASE_SOURCE = "", FEEDBK_PATH = "",
    parameter OUTDIVIDER_MUXA = "", OUTDIVIDER_MUXB = "", OUTDIVIDER_MUXC = "", OUTDIVIDER_MUXD = "",
    parameter CLKOP_ENABLE = "", CLKOS_ENABLE = "", CLKOS2_ENABLE = "",
    parameter CLKI_DIV = 1, CLKFB_DIV = 1, CLKOP_DIV = 1, CLKOS_DIV = 5, CLKOS2_DIV = 1,
    parameter CLKOP_CPHASE = 0, CLKOS_CPHASE = 0, CLKOS2_CPHASE = 0,
    parameter CLKOP_FPHASE = 0, CLKOS_FPHASE = 0, CLKOS2_FPHASE = 0
) (
    input  wire CLKI, CLKFB, RST, STDBY, PHASESEL0, PHASESEL1, PHASEDIR, PHASESTEP, PHASELOADREG, PLLWAKESYNC, ENCLKOP,
    output wire CLKOP, CLKOS, CLKOS2, CLKINTFB, LOCK
);
    CLKDIV fifth (.HCLKIN(CLKI), .RESETN(1'b1), .CALIB(1'b0), .CLKOUT(CLKOS));

    assign CLKOP = CLKI;
    assign CLKOS2 = 1'b0;
    assign CLKINTFB = 1'b0;
    assign LOCK = 1'b1;
endmodule

module SB_PLL40_CORE #(
    parameter FEEDBACK_PATH = "", PLLOUT_SELECT = "", DELAY_ADJUSTMENT_MODE_FEEDBACK = "",
    parameter DELAY_ADJUSTMENT_MODE_RELATIVE = "",
    parameter SHIFTREG_DIV_MODE = 0, FDA_FEEDBACK = 0, FDA_RELATIVE = 0, DIVR = 0, DIVF = 0, DIVQ = 0,
    parameter FILTER_RANGE = 0, ENABLE_ICEGATE = 0, TEST_MODE = 0
) (
    input  wire REFERENCECLK, EXTFEEDBACK, RESETB, BYPASS, LATCHINPUTVALUE, SDI, SCLK,
    input  wire [7:0] DYNAMICDELAY,
    output wire PLLOUTCORE, PLLOUTGLOBAL, LOCK, SDO
);
    assign PLLOUTCORE = REFERENCECLK;
    assign PLLOUTGLOBAL = REFERENCECLK;
    assign LOCK = 1'b1;
    assign SDO = 1'b0;
endmodule

module SB_PLL40_PAD #(
    parameter FEEDBACK_PATH = "", PLLOUT_SELECT = "", DELAY_ADJUSTMENT_MODE_FEEDBACK = "",
    parameter DELAY_ADJUSTMENT_MODE_RELATIVE = "",
    parameter SHIFTREG_DIV_MODE = 0, FDA_FEEDBACK = 0, FDA_RELATIVE = 0, DIVR = 0, DIVF = 0, DIVQ = 0,
    parameter FILTER_RANGE = 0, ENABLE_ICEGATE = 0, TEST_MODE = 0
) (
    input  wire PACKAGEPIN, EXTFEEDBACK, RESETB, BYPASS, LATCHINPUTVALUE, SDI, SCLK,
    input  wire [7:0] DYNAMICDELAY,
    output wire PLLOUTCORE, PLLOUTGLOBAL, LOCK, SDO
);
    SB_PLL40_CORE pll (
        .REFERENCECLK(PACKAGEPIN), .EXTFEEDBACK(EXTFEEDBACK), .RESETB(RESETB), .BYPASS(BYPASS),
        .LATCHINPUTVALUE(LATCHINPUTVALUE), .SDI(SDI), .SCLK(SCLK), .DYNAMICDELAY(DYNAMICDELAY),
        .PLLOUTCORE(PLLOUTCORE), .PLLOUTGLOBAL(PLLOUTGLOBAL), .LOCK(LOCK), .SDO(SDO)
    );
endmodule

module MMCME2_BASE #(
    parameter real CLKIN1_PERIOD = 0.0, CLKFBOUT_MULT_F = 1.0, CLKOUT0_DIVIDE_F = 1.0,
    parameter DIVCLK_DIVIDE = 1
) (
    input  wire CLKIN1, CLKFBIN, RST, PWRDWN,
    output wire CLKFBOUT, CLKOUT0, LOCKED
);
    assign CLKFBOUT = 1'b0;
    assign CLKOUT0 = CLKIN1;
    assign LOCKED = 1'b1;
endmodule

module BUFG (
    input  wire I,
    output wire O
);
    assign O = I;
endmodule

// Both bits are taken with the rising edge; D0 is sent while the clock is high, D1 while it is low.
module ODDRX1F (
    input  wire SCLK, RST, D0, D1,
    output wire Q
);
    reg first = 1'b0, second = 1'b0;

    always @(posedge SCLK) begin
        first <= D0;
        second <= D1;
    end

    assign Q = SCLK ? first : second;
endmodule

module rPLL #(
    parameter FCLKIN = "", DEVICE = "", IDIV_SEL = 0, FBDIV_SEL = 0, ODIV_SEL = 8,
    parameter DYN_IDIV_SEL = "", DYN_FBDIV_SEL = "", DYN_ODIV_SEL = "", DYN_DA_EN = "", DYN_SDIV_SEL = 2,
    parameter PSDA_SEL = "", DUTYDA_SEL = "", CLKFB_SEL = "", CLKOUT_BYPASS = "", CLKOUTP_BYPASS = "",
    parameter CLKOUTD_BYPASS = "", CLKOUTD_SRC = "", CLKOUTD3_SRC = "", CLKOUT_FT_DIR = 0, CLKOUTP_FT_DIR = 0,
    parameter CLKOUT_DLY_STEP = 0, CLKOUTP_DLY_STEP = 0
) (
    input  wire CLKIN, CLKFB, RESET, RESET_P,
    input  wire [5:0] FBDSEL, IDSEL, ODSEL,
    input  wire [3:0] PSDA, DUTYDA, FDLY,
    output wire CLKOUT, CLKOUTP, CLKOUTD, CLKOUTD3, LOCK
);
    assign CLKOUT = CLKIN;
    assign {CLKOUTP, CLKOUTD, CLKOUTD3} = 3'd0;
    assign LOCK = 1'b1;
endmodule

module CLKDIV #(
    parameter DIV_MODE = "", GSREN = ""
) (
    input  wire HCLKIN, RESETN, CALIB,
    output wire CLKOUT
);
    reg [2:0] place = 3'd0;
    reg slow = 1'b0;

    always @(posedge HCLKIN) begin
        place <= place == 3'd4 ? 3'd0 : place + 3'd1;
        slow <= place < 3'd2;
    end

    assign CLKOUT = slow;
endmodule

// A word is taken with the second edge of the fast clock of its period, and D0 is sent first.
module OSER10 #(
    parameter GSREN = "", LSREN = ""
) (
    input  wire D0, D1, D2, D3, D4, D5, D6, D7, D8, D9, FCLK, PCLK, RESET,
    output wire Q
);
    reg [9:0] word = 10'd0;
    reg was_high = 1'b0;

    always @(posedge FCLK) begin
        was_high <= PCLK;
        word <= PCLK & ~was_high ? {D9, D8, D7, D6, D5, D4, D3, D2, D1, D0} : word >> 2;
    end

    assign Q = FCLK ? word[0] : word[1];
endmodule

module ELVDS_OBUF (
    input  wire I,
    output wire O, OB
);
    assign O = I;
    assign OB = ~I;
endmodule

module TLVDS_OBUF (
    input  wire I,
    output wire O, OB
);
    ELVDS_OBUF pair (.I(I), .O(O), .OB(OB));
endmodule

// A cell of a Gowin part as an adder: its table says where the carry passes, its four lowest entries what else it is.
module GOWIN_ADDER #(
    parameter [15:0] INIT = 16'd0
) (
    input  wire A, B, C, D, CIN,
    output wire SUM, COUT
);
    wire passes = INIT[{D, C, B, A}];

    assign SUM = passes ^ CIN;
    assign COUT = passes ? CIN : INIT[{2'd0, B, A}];
endmodule
