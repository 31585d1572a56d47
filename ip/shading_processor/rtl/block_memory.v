// block_memory: part of shading_processor; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module block_memory (
    input  wire clock,
    input  wire write,
    input  wire [7:0] write_address,
    input  wire [31:0] write_data,
    input  wire [7:0] read_address,
    output wire [31:0] read_data
);

    reg [31:0] words [0:255];
    reg [31:0] kept_read_data = 32'd0;
    // Block RAM begins with zeros; synthesis need not work through a loop for it.
`ifndef SYNTHESIS
    integer place;
    initial begin
        for (place = 0; place <= 255; place = place + 1) words[place] = 32'd0;
    end
`endif

    assign read_data = kept_read_data;

    always @(posedge clock) begin
        kept_read_data <= words[read_address];
        if (write) words[write_address] <= write_data;
    end

endmodule
