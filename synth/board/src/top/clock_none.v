// No PLL: the clock that comes is the fast one, and every fifth of its edges is one of the pixels.
module board_clock (
    input  wire clock,
    output wire pixel_clock, fast_clock
);

    reg [2:0] place = 3'd0;
    reg slow = 1'b0;

    always @(posedge clock) begin
        place <= place == 3'd4 ? 3'd0 : place + 3'd1;
        slow <= place < 3'd2;
    end

    assign fast_clock = clock;
    assign pixel_clock = slow;
endmodule
