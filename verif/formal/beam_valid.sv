// Beam machine: its `valid` is that of a raster control with the same `go`, LATENCY clocks later. The words on the other ports are
// free in every clock.

module beam_valid #(parameter LATENCY = `LATENCY) (
    input wire clock,
    input wire go,
    input wire [11:0] width,
    input wire [11:0] height
);
    wire valid, pixel;
    beam machine (.clock(clock), .go(go), .width(width), .height(height), .valid(valid));
    raster_control raster (.clock(clock), .go(go), .width(width), .height(height), .valid(pixel),
        .start(), .line(), .x(), .y(), .last());

    reg [LATENCY-1:0] past = 0;
    always @(posedge clock) past <= {past, pixel};

    always @* assert (valid == past[LATENCY-1]);
endmodule
