// Raster control: after a `go` that is obeyed, exactly width x height clocks with `valid`, in raster order, without a gap.
//
// `count` counts the pixels of a zone, `done` those of its finished lines: done = y width, because it grows by the width with every
// line (raster_control.smt2). At `last` the count is done + width with y = height - 1, that is width x height.

module raster_control_properties (
    input wire clock, go,
    input wire [11:0] width, height,
    input wire valid, start, line,
    input wire [11:0] x, y,
    input wire last,
    input wire [11:0] column_before, line_before,
    input wire is_narrow, in_last_column, in_last_line
);
    reg [11:0] zone_width, zone_height;
    reg [23:0] count, done;
    reg old_obeyed = 0, old_going = 0;
    reg [11:0] old_x, old_y;
    wire obeyed = go && (!valid || last);
    wire [11:0] right_edge = zone_width - 12'd1;
    wire [11:0] bottom_edge = zone_height - 12'd1;

    always @(posedge clock) begin
        old_obeyed <= obeyed;
        old_going <= valid && !last;
        old_x <= x;
        old_y <= y;
        if (obeyed) begin
            zone_width <= width;
            zone_height <= height;
            count <= 1;
            done <= 0;
        end else if (valid) begin
            count <= count + 1;
            if (x == right_edge) done <= done + zone_width;
        end
    end

    always @* begin
        if (go) assume (width != 0 && height != 0);

        // A pixel follows an obeyed `go` and every pixel but the last, and nothing else.
        assert (valid == (old_obeyed || old_going));
        if (!valid) assert (!start && !line && !last);
        if (valid) begin
            assert (zone_width != 0 && zone_height != 0);
            assert (column_before == right_edge - 12'd1 && line_before == bottom_edge - 12'd1);
            assert (is_narrow == (right_edge == 0));
            assert (in_last_column == (x == right_edge) && in_last_line == (y == bottom_edge));
            assert (x <= right_edge && y <= bottom_edge);
            assert (start == (x == 0 && y == 0));
            assert (line == (x == 0 && y != 0));
            assert (last == (x == right_edge && y == bottom_edge));
            assert (count == done + x + 24'd1);
            // Raster order: the first pixel, then the next in the line, then the first of the next line.
            if (old_obeyed) assert (x == 0 && y == 0);
            else if (old_x == right_edge) assert (x == 0 && y == old_y + 12'd1);
            else assert (x == old_x + 12'd1 && y == old_y);
        end
        if (last) assert (count == done + zone_width);
    end
endmodule

bind raster_control raster_control_properties properties (
    .clock(clock), .go(go), .width(width), .height(height), .valid(valid), .start(start), .line(line),
    .x(x), .y(y), .last(last),
    .column_before(column_before), .line_before(line_before), .is_narrow(is_narrow),
    .in_last_column(in_last_column), .in_last_line(in_last_line)
);
