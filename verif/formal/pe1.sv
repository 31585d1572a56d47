// First-degree elementary processor: value = a x + b y + c modulo 2^N, whatever the sequence of flags.
//
// The products are written as sums that grow by one word at a time, so that the solver sees additions only:
//   sum_ax = a x   because it is 0 at the first pixel of a line and grows by a with every further pixel,
//   sum_by = b y   because it is 0 at the start and grows by b with every further line.
// These two sentences are proved over the integers in pe1.smt2; reduction modulo 2^N commutes with addition. The words on the
// ports are those of the start until the next one.

module pe1_properties #(parameter N = 26) (
    input wire clock, valid, start, line,
    input wire [N-1:0] a, b, c, next_line, value
);
    // The words on the ports at the last start, and the sums of the position since then.
    reg started = 0;
    reg [N-1:0] word_a, word_b, word_c, sum_ax, sum_by;
    wire [N-1:0] line_value = word_c + sum_by;

    always @(posedge clock) begin
        if (valid) begin
            if (start) begin
                started <= 1;
                word_a <= a;
                word_b <= b;
                word_c <= c;
                sum_ax <= 0;
                sum_by <= 0;
            end else if (line) begin
                sum_ax <= 0;
                sum_by <= sum_by + word_b;
            end else begin
                sum_ax <= sum_ax + word_a;
            end
        end
    end

    always @* begin
        if (started) begin
            if (!(valid && start)) assume (a == word_a && b == word_b);
            assert (next_line == line_value + word_b);
            assert (value == line_value + sum_ax);
        end
    end
endmodule

bind pe1 pe1_properties #(.N(`N)) properties (
    .clock(clock), .valid(valid), .start(start), .line(line), .a(a), .b(b), .c(c),
    .next_line(next_line), .value(value)
);
