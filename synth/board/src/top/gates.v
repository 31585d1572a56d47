`timescale 1ns/10ps
// Ticks a board of gates with delays and writes its pins before each rising edge.
module board_gates;
    reg clock = 1'b0;
    wire [31:0] pins;
    integer file;

    board_bench bench (.clock(clock), .pins(pins));

    initial begin
        file = $fopen("pins.bin", "wb");
        repeat ({{ clocks }}) begin
            #{{ half }} clock = 1'b1;
            #{{ half }} clock = 1'b0;
            $fwrite(file, "%u", pins);
        end
        $fclose(file);
        $finish;
    end
endmodule
