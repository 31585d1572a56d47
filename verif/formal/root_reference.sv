// One row of the restoring root network, written from the digit recurrence for any width: K bits of root, 2K bits of radicand.

module reference_row #(parameter K = 24) (
    input wire [2*K-1:0] pairs,
    input wire [K-1:0] root,
    input wire [K:0] remainder,
    output wire [2*K-1:0] next_pairs,
    output wire [K-1:0] next_root,
    output wire [K:0] next_remainder,
    output wire fits
);
    wire [K+2:0] dividend = {remainder, pairs[2*K-1:2*K-2]};
    wire [K+2:0] divisor = {1'b0, root, 2'b01};
    wire digit = dividend >= divisor;
    wire [K+2:0] rest = digit ? dividend - divisor : dividend;

    assign next_pairs = {pairs[2*K-3:0], 2'b00};
    assign next_root = {root[K-2:0], digit};
    assign next_remainder = rest[K:0];
    assign fits = rest[K+2:K+1] == 0;
endmodule
