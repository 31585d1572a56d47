// Row lemma: with S the square of the root and X the pairs taken so far, `remainder + S = X` and `remainder <= 2 root` pass
// through a row, the new S being the square of the new root: S' = 4S, or 4S + 4 root + 1 = (2 root + 1)^2 with digit 1. The digit
// is 1 exactly when that square is not more than the new X. The new remainder fits its K + 1 bits.

module root_lemma #(parameter K = `K) (
    input wire [2*K-1:0] pairs,
    input wire [K-1:0] root,
    input wire [K:0] remainder,
    input wire [2*K-1:0] square, prefix
);
    wire [2*K-1:0] next_pairs;
    wire [K-1:0] next_root;
    wire [K:0] next_remainder;
    wire fits;
    reference_row #(.K(K)) row (.pairs(pairs), .root(root), .remainder(remainder),
        .next_pairs(next_pairs), .next_root(next_root), .next_remainder(next_remainder), .fits(fits));

    wire digit = next_root[0];
    wire [2*K+2:0] square_of_one = {1'b0, square, 2'b00} + {root, 2'b01};
    wire [2*K+2:0] next_square = digit ? square_of_one : {1'b0, square, 2'b00};
    wire [2*K+2:0] next_prefix = {1'b0, prefix, pairs[2*K-1:2*K-2]};

    always @* begin
        assume (!root[K-1]);
        assume (remainder <= {root, 1'b0});
        assume ({1'b0, prefix} == {1'b0, square} + remainder);
        assert (fits);
        assert (next_root[K-1:1] == root[K-2:0]);
        assert (digit == (square_of_one <= next_prefix));
        assert (next_remainder <= {next_root, 1'b0});
        assert (next_prefix == next_square + next_remainder);
    end
endmodule
