// TMDS encoder: a receiver finds every level and every pair of control bits again, the words have few transitions, and
// ones and zeros stay balanced.
//
// The receiver is figure 3-6 of DVI 1.0. `sent` counts ones less zeros of all words since the last word of control, as
// they leave; the encoder keeps half of it.

module tmds_encoder_properties #(parameter LATENCY = 3) (
    input wire clock, de,
    input wire [7:0] level,
    input wire [1:0] control,
    input wire [9:0] word,
    input wire signed [3:0] disparity
);
    // The ports so many clocks ago as the latency is.
    reg [2:0] started = 0;
    reg [2:0] de_late = 0;
    reg [23:0] level_late;
    reg [5:0] control_late;

    always @(posedge clock) begin
        started <= {started[1:0], 1'b1};
        de_late <= {de_late[1:0], de};
        level_late <= {level_late[15:0], level};
        control_late <= {control_late[3:0], control};
    end

    wire de_before = de_late[2];
    wire [7:0] level_before = level_late[23:16];
    wire [1:0] control_before = control_late[5:4];

    wire [7:0] body = word[9] ? ~word[7:0] : word[7:0];
    wire [7:0] differs = body ^ {body[6:0], 1'b0};
    wire [7:0] decoded = {word[8] ? differs[7:1] : ~differs[7:1], body[0]};

    wire [8:0] turns = word[9:1] ^ word[8:0];
    wire [3:0] transitions = turns[0] + turns[1] + turns[2] + turns[3] + turns[4] + turns[5] + turns[6] + turns[7]
        + turns[8];
    wire [3:0] ones = word[0] + word[1] + word[2] + word[3] + word[4] + word[5] + word[6] + word[7] + word[8]
        + word[9];
    wire signed [6:0] balance = $signed({2'b00, ones, 1'b0}) - 7'sd10;

    reg signed [6:0] before = 0;
    wire signed [6:0] sent = de_before ? before + balance : 7'sd0;
    always @(posedge clock) before <= sent;

    wire is_control = word == 10'h354 || word == 10'h0ab || word == 10'h154 || word == 10'h2ab;

    always @* begin
        assert (sent == 2 * disparity);
        assert (disparity >= -4 && disparity <= 4);
        if (started[2]) begin
            if (de_before) begin
                assert (decoded == level_before);
                assert (transitions <= 5);
                assert (!is_control);
            end else begin
                assert (transitions >= 7);
                assert (word == (control_before[1] ? control_before[0] ? 10'h2ab : 10'h154
                    : control_before[0] ? 10'h0ab : 10'h354));
            end
        end
    end
endmodule

bind tmds_encoder tmds_encoder_properties #(.LATENCY(`LATENCY)) properties (
    .clock(clock), .de(de), .level(level), .control(control), .word(word), .disparity(disparity)
);
