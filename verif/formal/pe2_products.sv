// Second-degree elementary processor against its polynomial with true multipliers, for the first clocks and narrow words.
// The ports are driven with the preconditioned words of arbitrary a to f; it checks the ghost sums of pe2.sv, which are an
// argument, against the definition.

module pe2_products #(parameter N = 8) (
    input wire clock, valid, start, line,
    input wire [N-1:0] a2, b2, c, p0, i0, f, value
);
    (* anyconst *) wire [N-1:0] poly_a;
    (* anyconst *) wire [N-1:0] poly_b;
    (* anyconst *) wire [N-1:0] poly_c;
    (* anyconst *) wire [N-1:0] poly_d;
    (* anyconst *) wire [N-1:0] poly_e;
    (* anyconst *) wire [N-1:0] poly_f;
    reg started = 0;
    reg [N-1:0] x, y;

    always @* begin
        assume (a2 == poly_a + poly_a);
        assume (b2 == poly_b + poly_b);
        assume (c == poly_c);
        assume (p0 == poly_d + poly_a);
        assume (i0 == poly_e + poly_b);
        assume (f == poly_f);
    end

    always @(posedge clock) begin
        if (valid) begin
            if (start) begin
                started <= 1;
                x <= 0;
                y <= 0;
            end else if (line) begin
                x <= 0;
                y <= y + 1;
            end else begin
                x <= x + 1;
            end
        end
    end

    always @* begin
        if (started)
            assert (value == poly_a * x * x + poly_b * y * y + poly_c * x * y + poly_d * x + poly_e * y + poly_f);
    end
endmodule

bind pe2 pe2_products #(.N(`N)) properties (
    .clock(clock), .valid(valid), .start(start), .line(line),
    .a2(a2), .b2(b2), .c(c), .p0(p0), .i0(i0), .f(f), .value(value)
);
