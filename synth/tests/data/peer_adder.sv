// A stand-in for the design of another project in SystemVerilog: an adder with registers behind it.
`include "peer_width.svh"

module peer_adder #(
    parameter int WIDTH = 8
) (
    input  logic             core_clk,
    input  logic             rst_n,
    input  logic [WIDTH-1:0] a,
    input  logic [WIDTH-1:0] b,
    output logic [WIDTH-1:0] sum
);
    logic [WIDTH-1:0] stages[`PEER_STAGES];

    always_ff @(posedge core_clk or negedge rst_n) begin
        if (!rst_n) begin
            for (int i = 0; i < `PEER_STAGES; i++) stages[i] <= '0;
        end else begin
            stages[0] <= a + b;
            for (int i = 1; i < `PEER_STAGES; i++) stages[i] <= stages[i-1];
        end
    end

    assign sum = stages[`PEER_STAGES-1];
endmodule
