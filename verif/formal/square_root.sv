// The emitted root network, whole: after STAGES clocks, `square + remainder = radicand` and `remainder <= 2 root`, where `square`
// follows the recurrence of the square of the root (root.smt2). One invariant per register stage, all proved together by
// induction: the pairs left, the square and the remainder of stage i are those of the radicand of i + 1 clocks ago.

module square_root_properties #(parameter K = 24, parameter STAGES = 24, parameter ROWS = 1) (
    input wire clock,
    input wire [2*K-1:0] radicand,
    input wire [STAGES*2*K-1:0] stage_pairs,
    input wire [STAGES*K-1:0] stage_root,
    input wire [STAGES*(K+1)-1:0] stage_remainder,
    input wire [K-1:0] root,
    input wire [K:0] remainder
);
    localparam F = 2 * K;
    wire [STAGES*F-1:0] radicands, squares;

    genvar i, j;
    generate
        for (i = 0; i < STAGES; i = i + 1) begin : stage
            localparam FIRST = i * ROWS;
            localparam COUNT = K - FIRST < ROWS ? K - FIRST : ROWS;
            localparam KNOWN = FIRST + COUNT;
            // A root of KNOWN digits has a square of 2 KNOWN bits.
            localparam Q = 2 * KNOWN;

            // The radicand of i + 1 clocks ago, and what the stage before held one clock ago.
            reg [F-1:0] old_radicand = 0;
            reg [Q-1:0] old_square = 0;
            reg [K-1:0] old_root = 0;
            always @(posedge clock) begin
                old_radicand <= i == 0 ? radicand : radicands[(i-1)*F +: F];
                old_square <= i == 0 ? 0 : squares[(i-1)*F +: Q];
                old_root <= i == 0 ? 0 : stage_root[(i-1)*K +: K];
            end

            wire [F-1:0] pairs = stage_pairs[i*F +: F];
            wire [K-1:0] digits = stage_root[i*K +: K];
            wire [K:0] rest = stage_remainder[i*(K+1) +: K+1];
            wire [Q-1:0] prefix = old_radicand[F-1:F-Q];

            // The square grows with each digit that this stage found.
            wire [Q-1:0] square [0:COUNT];
            assign square[0] = old_square;
            for (j = 0; j < COUNT; j = j + 1) begin : row
                wire [K-1:0] before = digits >> COUNT - j;
                wire digit = digits[COUNT-1-j];
                assign square[j+1] = digit ? {square[j], 2'b00} + {before, 2'b01} : {square[j], 2'b00};
            end
            assign radicands[i*F +: F] = old_radicand;
            assign squares[i*F +: F] = square[COUNT];

            always @* begin
                if (i < STAGES - 1) assert (pairs == old_radicand << Q);
                assert (digits >> COUNT == old_root);
                assert ({1'b0, digits} >> KNOWN == 0);
                assert (rest <= {digits, 1'b0});
                assert (square[COUNT] + rest == {1'b0, prefix});
            end
        end
    endgenerate

    always @* begin
        assert (root == stage_root[(STAGES-1)*K +: K]);
        assert (remainder == stage_remainder[(STAGES-1)*(K+1) +: K+1]);
    end
endmodule

bind square_root square_root_properties #(.K(`K), .STAGES(`STAGES), .ROWS(`ROWS)) properties (
    .clock(clock), .radicand(radicand), .stage_pairs(`PAIRS), .stage_root(`ROOTS), .stage_remainder(`REMAINDERS),
    .root(root), .remainder(remainder)
);
