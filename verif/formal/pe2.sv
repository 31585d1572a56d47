// Second-degree elementary processor: value = a x^2 + b y^2 + c x y + d x + e y + f modulo 2^N, loaded with a2 = 2a, b2 = 2b, c,
// p0 = d + a, i0 = e + b and f, whatever the sequence of flags.
//
// Every register is a word plus ghost sums, so that the solver sees additions only; those of the next line are a line ahead:
//   sum_a2x    = a2 x    grows by a2 with every pixel of a line      pixel step = first step + sum_a2x
//   sum_cy     = c y     grows by c with every line                  first step = p0 + sum_cy
//   sum_b2y    = b2 y    grows by b2 with every line                 line step  = i0 + sum_b2y
//   sum_pixels           grows by the pixel step with every pixel    value      = line value + sum_pixels
//   sum_lines            grows by the line step with every line      line value = f + sum_lines
// The closed forms of the sums, and that they add up to the polynomial, are proved over the integers in pe2.smt2; reduction
// modulo 2^N commutes with addition. One sum grows by a register of the unit, which is itself asserted.

module pe2_properties #(parameter N = 48) (
    input wire clock, valid, start, line,
    input wire [N-1:0] a2, b2, c, p0, i0, f, next_line, next_line_step, next_first_step, pixel_step, value
);
    // The words on the ports at the last start, and the sums of the position since then.
    reg started = 0;
    reg [N-1:0] word_a2, word_b2, word_c, word_p0, word_i0, word_f;
    reg [N-1:0] sum_a2x, sum_cy, sum_b2y, sum_pixels, sum_lines;
    wire [N-1:0] first_step = word_p0 + sum_cy;
    wire [N-1:0] line_step = word_i0 + sum_b2y;
    wire [N-1:0] line_value = word_f + sum_lines;

    always @(posedge clock) begin
        if (valid) begin
            if (start) begin
                started <= 1;
                word_a2 <= a2;
                word_b2 <= b2;
                word_c <= c;
                word_p0 <= p0;
                word_i0 <= i0;
                word_f <= f;
                {sum_a2x, sum_cy, sum_b2y, sum_pixels, sum_lines} <= 0;
            end else if (line) begin
                {sum_a2x, sum_pixels} <= 0;
                sum_cy <= sum_cy + word_c;
                sum_b2y <= sum_b2y + word_b2;
                sum_lines <= sum_lines + line_step;
            end else begin
                sum_a2x <= sum_a2x + word_a2;
                sum_pixels <= sum_pixels + pixel_step;
            end
        end
    end

    always @* begin
        if (started) begin
            // The words on the ports are those of the start; the registers are differences of the polynomial.
            if (!(valid && start)) assume (a2 == word_a2 && b2 == word_b2 && c == word_c);
            assert (next_first_step == first_step + word_c);
            assert (pixel_step == first_step + sum_a2x);
            assert (next_line_step == line_step + word_b2);
            assert (next_line == line_value + line_step);
            assert (value == line_value + sum_pixels);
        end
    end
endmodule

bind pe2 pe2_properties #(.N(`N)) properties (
    .clock(clock), .valid(valid), .start(start), .line(line),
    .a2(a2), .b2(b2), .c(c), .p0(p0), .i0(i0), .f(f),
    .next_line(next_line), .next_line_step(next_line_step), .next_first_step(next_first_step),
    .pixel_step(pixel_step), .value(value)
);
