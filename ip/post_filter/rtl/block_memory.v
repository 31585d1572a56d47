// block_memory: part of post_filter; see there.
// SPDX-License-Identifier: MIT OR Apache-2.0

module block_memory (
    input  wire clock,
    input  wire write,
    input  wire [10:0] write_address,
    input  wire [47:0] write_data,
    input  wire [10:0] read_address,
    output wire [47:0] read_data
);

    reg [47:0] words [0:2047];
    reg [47:0] kept_read_data = 48'd0;
    // Block RAM begins with zeros; synthesis need not work through a loop for it.
`ifndef SYNTHESIS
    integer place;
    initial begin
        for (place = 0; place <= 2047; place = place + 1) words[place] = 48'd0;
    end
`endif

    assign read_data = kept_read_data;

    always @(posedge clock) begin
        kept_read_data <= words[read_address];
        if (write) words[write_address] <= write_data;
    end

endmodule
