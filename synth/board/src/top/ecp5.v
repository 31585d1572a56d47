// Stated models of the cells of a routed ECP5. Inputs that the router leaves open come with the level that they have in
// the part.

// A table of four inputs; of a chain of carries the exclusive or with the carry, which goes on where the table is 1.
module TRELLIS_COMB #(
    parameter MODE = "LOGIC", CCU2_INJECT1 = "NO",
    parameter [15:0] INITVAL = 16'd0
) (
    input  wire A, B, C, D, M, FCI, F1, FXA, FXB, WD, WAD0, WAD1, WAD2, WAD3, WRE, WCK, DI0, DI1,
    output wire F, FCO, OFX
);
    wire table_4 = INITVAL[{D, C, B, A}];
    wire table_2 = INITVAL[{2'b00, B, A}];
    wire carried = MODE == "CCU2" && CCU2_INJECT1 == "NO";

    assign F = table_4 ^ (carried & FCI);
    assign FCO = table_4 ? FCI : carried & table_2;
    assign OFX = M ? F1 : F;
endmodule

module TRELLIS_FF #(
    parameter CLKMUX = "CLK", CEMUX = "CE", LSRMUX = "LSR", REGSET = "RESET", SD = "1"
) (
    input  wire CLK, CE, LSR, DI, M,
    output reg  Q
);
    localparam FIRST = REGSET == "SET" ? 1'b1 : 1'b0;
    wire enable = CEMUX == "1" ? 1'b1 : CEMUX == "INV" ? !CE : CE;
    wire set = LSRMUX == "INV" ? !LSR : LSR;
    wire next = SD == "1" ? DI : M;

    initial Q = FIRST;

    generate
        if (CLKMUX == "INV") begin : falling
            always @(negedge CLK) if (set) Q <= FIRST; else if (enable) Q <= next;
        end else begin : rising
            always @(posedge CLK) if (set) Q <= FIRST; else if (enable) Q <= next;
        end
    endgenerate
endmodule

// Groups of nine bits. Port A writes and both ports read, the old word while it is written; words of 36 bits are written
// at the address of port A and read at that of port B, their lower half through the data of port A.
module DP16KD #(
    parameter integer DATA_WIDTH_A = 18, DATA_WIDTH_B = 18,
    parameter REGMODE_A = "NOREG", REGMODE_B = "NOREG",
    parameter [319:0] {% for name in slices %}INITVAL_{{ name }} = 320'd0{{ ", " if not loop.last }}{% endfor %}
) (
{%- for port in ["A", "B"] %}
    input  wire CLK{{ port }}, CE{{ port }}, OCE{{ port }}, WE{{ port }}, RST{{ port }},
    input  wire CS{{ port }}0, CS{{ port }}1, CS{{ port }}2,
    input  wire {% for bit in range(14) %}AD{{ port }}{{ bit }}, {% endfor %}
    input  wire {% for bit in range(18) %}DI{{ port }}{{ bit }}, {% endfor %}
    output wire {% for bit in range(18) %}DO{{ port }}{{ bit }}{{ ", " if not (loop.last and port == "B") }}{% endfor %}
{%- endfor %}
);
    wire [20479:0] at_first = { {%- for name in slices | reverse %}INITVAL_{{ name }}{{ ", " if not loop.last }}{% endfor -%} };
    reg [8:0] groups [0:2047];
    integer group;
    initial for (group = 0; group < 2048; group = group + 1)
        groups[group] = at_first[group / 2 * 20 + group % 2 * 9 +: 9];
{% for port in ["A", "B"] %}
    wire [13:0] address_{{ port }} = { {%- for bit in range(13, -1, -1) %}AD{{ port }}{{ bit }}{{ ", " if not loop.last }}{% endfor -%} };
    wire [17:0] data_{{ port }} = { {%- for bit in range(17, -1, -1) %}DI{{ port }}{{ bit }}{{ ", " if not loop.last }}{% endfor -%} };
    wire chosen_{{ port }} = CE{{ port }} & !(CS{{ port }}0 | CS{{ port }}1 | CS{{ port }}2);
    wire [8:0] narrow_{{ port }} = groups[address_{{ port }}[13:3]];
    wire [17:0] pair_{{ port }} = {groups[{address_{{ port }}[13:4], 1'b1}], groups[{address_{{ port }}[13:4], 1'b0}]};
    wire [35:0] wide_{{ port }} = {
        groups[{address_{{ port }}[13:5], 2'd3}], groups[{address_{{ port }}[13:5], 2'd2}],
        groups[{address_{{ port }}[13:5], 2'd1}], groups[{address_{{ port }}[13:5], 2'd0}]
    };
    reg [17:0] word_{{ port }} = 18'd0, late_{{ port }} = 18'd0;
    wire [17:0] out_{{ port }} = REGMODE_{{ port }} == "OUTREG" ? late_{{ port }} : word_{{ port }};
    assign { {%- for bit in range(17, -1, -1) %}DO{{ port }}{{ bit }}{{ ", " if not loop.last }}{% endfor -%} } = out_{{ port }};

    always @(posedge CLK{{ port }}) if (OCE{{ port }}) late_{{ port }} <= word_{{ port }};
{% endfor %}
    always @(posedge CLKB)
        if (chosen_B) case (DATA_WIDTH_B)
            36: word_B <= wide_B[35:18];
            18: word_B <= pair_B;
            9: word_B <= {9'd0, narrow_B};
            4: word_B <= {14'd0, narrow_B[address_B[2] * 4 +: 4]};
            2: word_B <= {16'd0, narrow_B[address_B[2:1] * 2 +: 2]};
            default: word_B <= {17'd0, narrow_B[address_B[2:0]]};
        endcase

    generate
        if (DATA_WIDTH_B == 36) begin : lower_half
            always @(posedge CLKB) if (chosen_B) word_A <= wide_B[17:0];
        end else begin : own_word
            always @(posedge CLKA)
                if (chosen_A) case (DATA_WIDTH_A)
                    18: word_A <= pair_A;
                    9: word_A <= {9'd0, narrow_A};
                    4: word_A <= {14'd0, narrow_A[address_A[2] * 4 +: 4]};
                    2: word_A <= {16'd0, narrow_A[address_A[2:1] * 2 +: 2]};
                    default: word_A <= {17'd0, narrow_A[address_A[2:0]]};
                endcase
        end
    endgenerate

    always @(posedge CLKA)
        if (chosen_A & WEA) case (DATA_WIDTH_A)
            36: begin
                if (ADA0) groups[{address_A[13:5], 2'd0}] <= data_A[8:0];
                if (ADA1) groups[{address_A[13:5], 2'd1}] <= data_A[17:9];
                if (ADA2) groups[{address_A[13:5], 2'd2}] <= data_B[8:0];
                if (ADA3) groups[{address_A[13:5], 2'd3}] <= data_B[17:9];
            end
            18: begin
                if (ADA0) groups[{address_A[13:4], 1'b0}] <= data_A[8:0];
                if (ADA1) groups[{address_A[13:4], 1'b1}] <= data_A[17:9];
            end
            9: groups[address_A[13:3]] <= data_A[8:0];
            4: groups[address_A[13:3]][address_A[2] * 4 +: 4] <= data_A[3:0];
            2: groups[address_A[13:3]][address_A[2:1] * 2 +: 2] <= data_A[1:0];
            default: groups[address_A[13:3]][address_A[2:0]] <= data_A[0];
        endcase
endmodule

module MULT18X18D #(
    parameter REG_INPUTA_CLK = "NONE", REG_INPUTB_CLK = "NONE", REG_OUTPUT_CLK = "NONE"
) (
{%- for name in ["A", "B", "C", "SRIA", "SRIB"] %}
    input  wire {% for bit in range(18) %}{{ name }}{{ bit }}, {% endfor %}
{%- endfor %}
{%- for name in ["SROA", "SROB", "ROA", "ROB", "ROC"] %}
    output wire {% for bit in range(18) %}{{ name }}{{ bit }}, {% endfor %}
{%- endfor %}
    input  wire SIGNEDA, SIGNEDB, SOURCEA, SOURCEB,
    input  wire CLK0, CLK1, CLK2, CLK3, CE0, CE1, CE2, CE3, RST0, RST1, RST2, RST3,
    output wire {% for bit in range(36) %}P{{ bit }}, {% endfor %}
    output wire SIGNEDP
);
{%- for name in ["A", "B"] %}
    wire [17:0] now_{{ name }} = { {%- for bit in range(17, -1, -1) %}{{ name }}{{ bit }}{{ ", " if not loop.last }}{% endfor -%} };
    reg [17:0] late_{{ name }} = 18'd0;
    wire [17:0] used_{{ name }} = REG_INPUT{{ name }}_CLK == "CLK0" ? late_{{ name }} : now_{{ name }};
    wire signed [18:0] factor_{{ name }} = {SIGNED{{ name }} & used_{{ name }}[17], used_{{ name }}};
    always @(posedge CLK0) if (CE0) late_{{ name }} <= now_{{ name }};
{%- endfor %}
    wire signed [37:0] product = factor_A * factor_B;
    reg [35:0] late = 36'd0;
    wire [35:0] out = REG_OUTPUT_CLK == "CLK0" ? late : product[35:0];
    assign { {%- for bit in range(35, -1, -1) %}P{{ bit }}{{ ", " if not loop.last }}{% endfor -%} } = out;

    always @(posedge CLK0) if (CE0) late <= product[35:0];
endmodule

// An output of pairs; what else it can do is not used.
module SIOLOGIC (
    input  wire TXDATA0, TXDATA1, TSDATA0, CLK, LSR, CE, PADDI, IOLDOI, DI, DIRECTION, MOVE, LOADN,
    output wire IOLDO, IOLDOD, IOLTO, INDD, INFF, RXDATA0, RXDATA1, CFLAG
);
    ODDRX1F pair (.SCLK(CLK), .RST(LSR), .D0(TXDATA0), .D1(TXDATA1), .Q(IOLDO));
endmodule

module DCCA (
    input  wire CLKI, CE,
    output wire CLKO
);
    assign CLKO = CLKI & CE;
endmodule

module TRELLIS_INPUT #(
    parameter DATAMUX_ODDR = "PADDO"
) (
    input  wire B, I, T, IOLDO, IOLTO,
    output wire O
);
    assign O = B;
endmodule

module TRELLIS_OUTPUT #(
    parameter DATAMUX_ODDR = "PADDO"
) (
    input  wire I, T, IOLDO, IOLTO,
    output wire B, O
);
    assign B = DATAMUX_ODDR == "IOLDO" ? IOLDO : I;
endmodule
