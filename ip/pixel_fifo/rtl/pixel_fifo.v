// pixel_fifo: a queue from a pipeline that cannot stall to an AXI4-Stream receiver that can
//
// parameters: format 24
// latency:    2 clocks
// error:      exact
// source:     architecture, 8
// ports:
//   in  clock           1 unsigned
//   in  started         1 unsigned
//   in  push            1 unsigned
//   in  data           24 unsigned
//   in  last            1 unsigned
//   in  m_tready        1 unsigned
//   out room            1 unsigned
//   out m_tvalid        1 unsigned
//   out m_tdata        24 unsigned
//   out m_tlast         1 unsigned
//
// Made by: imogene emit pixel_fifo --format 24 --out DIR
// SPDX-License-Identifier: MIT OR Apache-2.0

module pixel_fifo (
    input  wire clock,
    input  wire started,
    input  wire push,
    input  wire [23:0] data,
    input  wire last,
    input  wire m_tready,
    output wire room,
    output wire m_tvalid,
    output wire [23:0] m_tdata,
    output wire m_tlast
);

    localparam [24:0] last_bit = 25'd16777216;
    localparam [6:0] one = 7'd1;
    wire [24:0] joined;
    wire [24:0] plain;
    wire taken;
    wire [6:0] next_read;
    wire [5:0] store_write_address;
    wire [5:0] store_read_address;
    wire [24:0] store_read_data;
    reg [6:0] read = 7'd0;
    reg [6:0] written = 7'd0;
    reg [6:0] promised = 7'd0;
    reg is_there = 1'd0;

    block_memory store (
        .clock(clock),
        .write(push),
        .write_address(store_write_address),
        .write_data(joined),
        .read_address(store_read_address),
        .read_data(store_read_data)
    );

    assign joined = last ? plain | last_bit : plain;
    assign plain = {1'd0, data};
    assign taken = is_there & m_tready;
    assign next_read = taken ? read + one : read;
    assign store_write_address = written[5:0];
    assign store_read_address = next_read[5:0];
    assign room = ~promised[6];
    assign m_tvalid = is_there;
    assign m_tdata = store_read_data[23:0];
    assign m_tlast = store_read_data[24];

    always @(posedge clock) begin
        read <= next_read;
        is_there <= next_read != written;
        if (push) begin
            written <= written + one;
        end
        if (started & ~taken) begin
            promised <= promised + one;
        end
        if (taken & ~started) begin
            promised <= promised - one;
        end
    end

endmodule
