// Decider: after its latency, the smallest {depth, id} of its inputs with the words that came with it.
//
// `one` is any one input: the result is not behind it. The result is one of the inputs, whole.

module decider_properties #(parameter W = 24, parameter M = 4, parameter LATENCY = 2) (
    input wire clock,
    input wire [M*W-1:0] depths,
    input wire [M*8-1:0] ids,
    input wire [M*52-1:0] rests,
    input wire [W-1:0] depth,
    input wire [7:0] id,
    input wire [51:0] rest
);
    localparam SIZE = W + 60;

    // The inputs of the last LATENCY clocks, newest first; depth with its sign turned over, so that {depth, id} is one unsigned number.
    reg [M*SIZE-1:0] past [0:LATENCY-1];
    reg [LATENCY-1:0] started = 0;
    wire [M*SIZE-1:0] given;
    wire [SIZE-1:0] result = {~depth[W-1], depth[W-2:0], id, rest};
    wire [M-1:0] not_behind, equal;

    genvar i;
    generate
        for (i = 0; i < M; i = i + 1) begin : inputs
            wire [W-1:0] z = depths[i*W +: W];
            wire [SIZE-1:0] old = past[LATENCY-1][i*SIZE +: SIZE];
            assign given[i*SIZE +: SIZE] = {~z[W-1], z[W-2:0], ids[i*8 +: 8], rests[i*52 +: 52]};
            assign not_behind[i] = result[SIZE-1:52] <= old[SIZE-1:52];
            assign equal[i] = result == old;
        end
        for (i = 0; i < LATENCY; i = i + 1) begin : clocks
            if (i == 0) begin
                always @(posedge clock) past[0] <= given;
                always @(posedge clock) started[0] <= 1;
            end else begin
                always @(posedge clock) past[i] <= past[i-1];
                always @(posedge clock) started[i] <= started[i-1];
            end
        end
    endgenerate

    always @* begin
        if (started[LATENCY-1]) begin
            assert (&not_behind);
            assert (|equal);
        end
    end
endmodule

bind decider decider_properties #(.W(`W), .M(`M), .LATENCY(`LATENCY)) properties (
    .clock(clock), .depths(`DEPTHS), .ids(`IDS), .rests(`RESTS),
    .depth(depth), .id(id), .rest({number, nx, ny, nz})
);
