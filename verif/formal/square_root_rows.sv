// Every register stage of the emitted root network is its rows of the reference, of what the stage before it held one clock
// earlier. Rows trimmed to their live bits are right in reachable states only, so the state is asserted as well: as many digits as
// rows so far, and remainder <= 2 root. The first stage starts from an empty root and the radicand.

module square_root_rows_properties #(parameter K = 24, parameter STAGES = 24, parameter ROWS = 1) (
    input wire clock,
    input wire [2*K-1:0] radicand,
    input wire [STAGES*2*K-1:0] stage_pairs,
    input wire [STAGES*K-1:0] stage_root,
    input wire [STAGES*(K+1)-1:0] stage_remainder,
    input wire [K-1:0] root,
    input wire [K:0] remainder
);
    localparam F = 2 * K;

    genvar i, j;
    generate
        for (i = 0; i < STAGES; i = i + 1) begin : stage
            localparam FIRST = i * ROWS;
            localparam COUNT = K - FIRST < ROWS ? K - FIRST : ROWS;
            reg [F-1:0] old_pairs = 0;
            reg [K-1:0] old_root = 0;
            reg [K:0] old_remainder = 0;
            always @(posedge clock) begin
                old_pairs <= i == 0 ? radicand : stage_pairs[(i-1)*F +: F];
                old_root <= i == 0 ? 0 : stage_root[(i-1)*K +: K];
                old_remainder <= i == 0 ? 0 : stage_remainder[(i-1)*(K+1) +: K+1];
            end

            wire [F-1:0] pairs [0:COUNT];
            wire [K-1:0] digits [0:COUNT];
            wire [K:0] rest [0:COUNT];
            assign pairs[0] = old_pairs;
            assign digits[0] = old_root;
            assign rest[0] = old_remainder;
            for (j = 0; j < COUNT; j = j + 1) begin : row
                reference_row #(.K(K)) reference (.pairs(pairs[j]), .root(digits[j]), .remainder(rest[j]),
                    .next_pairs(pairs[j+1]), .next_root(digits[j+1]), .next_remainder(rest[j+1]), .fits());
            end

            always @* begin
                if (old_root >> FIRST == 0 && old_remainder <= {old_root, 1'b0}) begin
                    if (i < STAGES - 1) assert (stage_pairs[i*F +: F] == pairs[COUNT]);
                    assert (stage_root[i*K +: K] == digits[COUNT]);
                    assert (stage_remainder[i*(K+1) +: K+1] == rest[COUNT]);
                end
                assert ({1'b0, stage_root[i*K +: K]} >> FIRST + COUNT == 0);
                assert (stage_remainder[i*(K+1) +: K+1] <= {stage_root[i*K +: K], 1'b0});
            end
        end
    endgenerate

    always @* begin
        assert (root == stage_root[(STAGES-1)*K +: K]);
        assert (remainder == stage_remainder[(STAGES-1)*(K+1) +: K+1]);
    end
endmodule

bind square_root square_root_rows_properties #(.K(`K), .STAGES(`STAGES), .ROWS(`ROWS)) properties (
    .clock(clock), .radicand(radicand), .stage_pairs(`PAIRS), .stage_root(`ROOTS), .stage_remainder(`REMAINDERS),
    .root(root), .remainder(remainder)
);
