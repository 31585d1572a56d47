// Beam machine: its `valid` is that of its raster control, LATENCY clocks later; none is lost and none is made. The words on the
// other ports are free in every clock.

module beam_valid_properties #(parameter LATENCY = 36) (
    input wire clock, raster_valid, valid
);
    reg [LATENCY-1:0] past = 0;
    always @(posedge clock) past <= {past, raster_valid};

    always @* assert (valid == past[LATENCY-1]);
endmodule

bind beam beam_valid_properties #(.LATENCY(`LATENCY)) properties (
    .clock(clock), .raster_valid(raster_valid), .valid(valid)
);

// The machine without its outputs, so that only what `valid` depends on is looked at.
module beam_valid (
    input wire clock
);
    beam machine (.clock(clock));
endmodule
