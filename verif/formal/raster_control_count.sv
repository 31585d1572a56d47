// Raster control with zones of at most 3 x 3 pixels: the count of `valid` clocks at `last` against the true product.

module raster_control_count (
    input wire clock, go,
    input wire [11:0] width, height,
    input wire valid, start, last
);
    reg [3:0] zone_pixels = 0, count = 0;
    wire [3:0] counted = start ? 4'd1 : count + 4'd1;

    always @(posedge clock) begin
        if (go && (!valid || last)) zone_pixels <= width[1:0] * height[1:0];
        if (valid) count <= counted;
    end

    always @* begin
        assume (width >= 1 && width <= 3 && height >= 1 && height <= 3);
        if (valid) assert (last == (counted == zone_pixels));
    end
endmodule

bind raster_control raster_control_count properties (
    .clock(clock), .go(go), .width(width), .height(height), .valid(valid), .start(start), .last(last)
);
