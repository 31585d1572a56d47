// Every register stage of the emitted non-restoring root network against the rows of the restoring reference. Its remainder `m` is
// the reference's if the last digit is 1, and that less 2 root + 1, which is negative, if it is 0; so the restored remainder, m or
// m + 2 root + 1, goes through the same rows, and the row lemma holds for it. Two's complement of KNOWN + 2 bits after KNOWN rows.
// The registers start at 0, which is no such state: a stage is looked at once a radicand has come to it.

module non_restoring_rows_properties #(parameter K = 24, parameter STAGES = 24, parameter ROWS = 1) (
    input wire clock,
    input wire [2*K-1:0] radicand,
    input wire [STAGES*2*K-1:0] stage_pairs,
    input wire [STAGES*K-1:0] stage_root,
    input wire [STAGES*(K+2)-1:0] stage_remainder,
    input wire [K-1:0] root,
    input wire [K:0] remainder
);
    localparam F = 2 * K;
    reg [STAGES-1:0] filled = 0;
    always @(posedge clock) filled <= {filled, 1'b1};
    wire [STAGES*(K+1)-1:0] restored;

    genvar i, j;
    generate
        for (i = 0; i < STAGES; i = i + 1) begin : stage
            localparam FIRST = i * ROWS;
            localparam COUNT = K - FIRST < ROWS ? K - FIRST : ROWS;
            localparam KNOWN = FIRST + COUNT;
            reg [F-1:0] old_pairs;
            reg [K-1:0] old_root;
            reg [K:0] old_restored;
            always @(posedge clock) begin
                old_pairs <= i == 0 ? radicand : stage_pairs[(i-1)*F +: F];
                old_root <= i == 0 ? 0 : stage_root[(i-1)*K +: K];
                old_restored <= i == 0 ? 0 : restored[(i-1)*(K+1) +: K+1];
            end

            wire [F-1:0] pairs [0:COUNT];
            wire [K-1:0] digits [0:COUNT];
            wire [K:0] rest [0:COUNT];
            assign pairs[0] = old_pairs;
            assign digits[0] = old_root;
            assign rest[0] = old_restored;
            for (j = 0; j < COUNT; j = j + 1) begin : row
                reference_row #(.K(K)) reference (.pairs(pairs[j]), .root(digits[j]), .remainder(rest[j]),
                    .next_pairs(pairs[j+1]), .next_root(digits[j+1]), .next_remainder(rest[j+1]), .fits());
            end

            // The remainder of this stage, restored; and back, to see that its sign is that of the last digit.
            wire [K-1:0] found = stage_root[i*K +: K];
            wire [KNOWN+1:0] m = stage_remainder[i*(K+2) +: KNOWN+2];
            wire [KNOWN+1:0] back = found[0] ? 0 : {found[KNOWN-1:0], 1'b1};
            wire [KNOWN+1:0] whole = m + back;
            assign restored[i*(K+1) +: K+1] = whole[KNOWN:0];

            always @* begin
                if (filled[i]) begin
                    if (i < STAGES - 1) assert (stage_pairs[i*F +: F] == pairs[COUNT]);
                    assert (found == digits[COUNT]);
                    assert (restored[i*(K+1) +: K+1] == rest[COUNT]);
                    assert (!whole[KNOWN+1]);
                    assert ({1'b0, found} >> KNOWN == 0);
                    assert (rest[COUNT] <= {found, 1'b0});
                end
            end
        end
    endgenerate

    always @* begin
        assert (root == stage_root[(STAGES-1)*K +: K]);
        if (filled[STAGES-1]) assert (remainder == restored[(STAGES-1)*(K+1) +: K+1]);
    end
endmodule

bind square_root_non_restoring non_restoring_rows_properties #(.K(`K), .STAGES(`STAGES), .ROWS(`ROWS)) properties (
    .clock(clock), .radicand(radicand), .stage_pairs(`PAIRS), .stage_root(`ROOTS), .stage_remainder(`REMAINDERS),
    .root(root), .remainder(remainder)
);
