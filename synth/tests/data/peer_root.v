// A stand-in for the design of another project: restoring square root, one digit per clock, a pipeline.
module peer_root_row #(parameter WIDTH = 8) (
    input  wire                 clk,
    input  wire [2*WIDTH-1:0]   pairs,
    input  wire [WIDTH+1:0]     remainder,
    input  wire [WIDTH-1:0]     root,
    output reg  [2*WIDTH-1:0]   next_pairs,
    output reg  [WIDTH+1:0]     next_remainder,
    output reg  [WIDTH-1:0]     next_root
);
    wire [WIDTH+1:0] next = {remainder[WIDTH-1:0], pairs[2*WIDTH-1:2*WIDTH-2]};
    wire [WIDTH+1:0] divisor = {root, 2'b01};
    wire digit = next >= divisor;

    always @(posedge clk) begin
        next_pairs <= pairs << 2;
        next_remainder <= digit ? next - divisor : next;
        next_root <= {root[WIDTH-2:0], digit};
    end
endmodule

module peer_root #(parameter WIDTH = 8) (
    input  wire                clk,
    input  wire [2*WIDTH-1:0]  x,
    output wire [WIDTH-1:0]    root
);
    wire [2*WIDTH-1:0] pairs [0:WIDTH];
    wire [WIDTH+1:0] remainders [0:WIDTH];
    wire [WIDTH-1:0] roots [0:WIDTH];
    assign pairs[0] = x;
    assign remainders[0] = 0;
    assign roots[0] = 0;
    assign root = roots[WIDTH];

    genvar i;
    generate
        for (i = 0; i < WIDTH; i = i + 1) begin : rows
            peer_root_row #(.WIDTH(WIDTH)) row (
                .clk(clk), .pairs(pairs[i]), .remainder(remainders[i]), .root(roots[i]),
                .next_pairs(pairs[i+1]), .next_remainder(remainders[i+1]), .next_root(roots[i+1])
            );
        end
    endgenerate
endmodule
