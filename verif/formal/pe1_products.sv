// First-degree elementary processor against its polynomial with true multipliers, for the first clocks and narrow words.
// It checks the ghost sums of pe1.sv, which are an argument, against the definition.

module pe1_products #(parameter N = 8) (
    input wire clock, valid, start, line,
    input wire [N-1:0] a, b, c, value
);
    reg started = 0;
    reg [N-1:0] word_a, word_b, word_c, x, y;

    always @(posedge clock) begin
        if (valid) begin
            if (start) begin
                started <= 1;
                word_a <= a;
                word_b <= b;
                word_c <= c;
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
        if (started && !(valid && start)) assume (a == word_a && b == word_b);
        if (started) assert (value == word_a * x + word_b * y + word_c);
    end
endmodule

bind pe1 pe1_products #(.N(`N)) properties (
    .clock(clock), .valid(valid), .start(start), .line(line), .a(a), .b(b), .c(c), .value(value)
);
