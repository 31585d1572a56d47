// The frame that the chip has around every project.
module {{ top }} (
    input  wire [7:0] ui_in,
    output wire [7:0] uo_out,
    input  wire [7:0] uio_in,
    output wire [7:0] uio_out,
    output wire [7:0] uio_oe,
    input  wire ena, clk, rst_n
);

    wire {{ names | join(", ") }};
    reg reset;
    wire unused = &{ena, ui_in, uio_in};

    always @(posedge clk) reset <= ~rst_n;

    {{ prefix }}tile tile (
        .clock(clk), .reset(reset), .hsync(hsync), .vsync(vsync),
        .red({red_1, red_0}), .green({green_1, green_0}), .blue({blue_1, blue_0})
    );
{% for pin in pins %}
    assign {{ pin[1] }} = {{ pin[0] }};
{%- endfor %}
    assign uio_out = 8'd0;
    assign uio_oe = 8'd0;
endmodule
