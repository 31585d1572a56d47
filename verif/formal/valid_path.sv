// Quadric processor: `out_valid` is `valid`, LATENCY clocks later; none is lost and none is made. The words on the other ports are
// free in every clock.

module valid_path #(parameter LATENCY = `LATENCY) (
    input wire clock, valid
);
    wire out_valid;
    quadric_processor processor (.clock(clock), .valid(valid), .out_valid(out_valid));

    reg [LATENCY-1:0] past = 0;
    always @(posedge clock) past <= {past, valid};

    always @* assert (out_valid == past[LATENCY-1]);
endmodule
