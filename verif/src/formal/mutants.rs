//! Edits of designs that break what a property states: a proof that does not refute them proves nothing.

use super::FormalError;

/// A search and replace on the text of a design.
#[derive(Clone, Copy, Debug)]
pub struct Mutant {
    /// What is wrong in the mutant.
    pub name: &'static str,
    /// Job that must refute it.
    pub job: &'static str,
    /// Clocks from the initial state within which it shows.
    pub clocks: usize,
    from: &'static str,
    to: &'static str,
}

impl Mutant {
    /// The design with the edit.
    /// Fails when the text searched for is not there exactly once: the mutant would not be the one its name says.
    pub fn apply(&self, design: &str) -> Result<String, FormalError> {
        match design.matches(self.from).count() {
            1 => Ok(design.replacen(self.from, self.to, 1)),
            count => {
                let mutant = format!("{}, mutant `{}`", self.job, self.name);
                let from = self.from;
                let problem = format!("`{from}` is in the design {count} times instead of once");
                Err(FormalError::Text(mutant, problem))
            }
        }
    }
}

/// The mutants of a job.
pub fn of(job: &str) -> impl Iterator<Item = Mutant> + '_ {
    let all = MUTANTS.iter().copied();
    all.filter(move |mutant| mutant.job == job)
}

/// Names of the jobs that have mutants.
pub fn jobs() -> Vec<&'static str> {
    let mut names: Vec<_> = MUTANTS.iter().map(|mutant| mutant.job).collect();
    names.dedup();
    names
}

const fn mutant(
    job: &'static str,
    clocks: usize,
    name: &'static str,
    from: &'static str,
    to: &'static str,
) -> Mutant {
    Mutant {
        name,
        job,
        clocks,
        from,
        to,
    }
}

/// All mutants.
#[rustfmt::skip]
pub const MUTANTS: &[Mutant] = &[
    mutant("pe1-26", 6, "a pixel adds b", "pixel_value + a", "pixel_value + b"),
    mutant("pe1-26", 6, "a line adds a", "line_begin + b", "line_begin + a"),
    mutant("pe1-26", 6, "a line continues from the last pixel", "first ? line_begin :", "start ? c : line ? pixel_value :"),
    mutant("pe1-26", 6, "line wins over start", "start ? c : next_line", "line ? next_line : c"),
    mutant("pe1-26", 6, "valid is ignored", "if (valid) begin", "if (1'b1) begin"),
    mutant("pe1-26", 6, "the lowest bit is dropped", "assign value = pixel_value;", "assign value = {pixel_value[25:1], 1'b0};"),
    mutant("pe1-products", 6, "a pixel adds b", "pixel_value + a", "pixel_value + b"),
    mutant("pe1-integers", 0, "x grows by 2", "(* a (+ x 1))", "(* a (+ x 2))"),
    mutant("pe2-48", 7, "a pixel adds the step of the next line", "pixel_value + pixel_step", "pixel_value + next_first_step"),
    mutant("pe2-48", 7, "a pixel step adds b2", "pixel_step + a2", "pixel_step + b2"),
    mutant("pe2-48", 7, "a line step loses b2", "line_step + b2", "line_step - b2"),
    mutant("pe2-48", 7, "a first step forgets c", "<= first_step + c", "<= first_step"),
    mutant("pe2-48", 7, "the line step starts from p0", "start ? i0 :", "start ? p0 :"),
    mutant("pe2-48", 7, "a line's first step is not kept", "next_first_step <= first_step + c", "next_first_step <= pixel_step + c"),
    mutant("pe2-48", 7, "a line continues the pixel step", "first ? first_step : next_step", "next_step"),
    mutant("pe2-48", 7, "a line continues from the last pixel", "line_begin + line_step", "pixel_value + line_step"),
    mutant("pe2-48", 7, "valid is ignored", "if (valid) begin", "if (1'b1) begin"),
    mutant("pe2-products", 6, "a line step adds a2", "line_step + b2", "line_step + a2"),
    mutant("pe2-integers", 0, "the first increment forgets a", "(= p0 (+ d a))", "(= p0 d)"),
    mutant("cut_plane-24", 5, "a front plane at zf cuts", "& ~(before_front | at_front)", "& ~before_front"),
    mutant("cut_plane-24", 5, "a front plane at zb removes", "cuts_front & ~(before_back | at_back)", "cuts_front & ~before_back"),
    mutant("cut_plane-24", 5, "a back plane cuts behind zb", "(kind_late_1 == 2'd2) & before_back", "(kind_late_1 == 2'd2) & ~before_back"),
    mutant("cut_plane-24", 5, "a back plane before zf does not remove", "cuts_back & before_front", "cuts_back & at_front"),
    mutant("cut_plane-24", 5, "the sign of zp is the next bit", "& zp_late_1[23]", "& zp_late_1[22]"),
    mutant("cut_plane-24", 5, "a patch is cut like a solid", "surface_late_1 ? zb_late_1 : zp_late_1", "zp_late_1"),
    mutant("cut_plane-24", 5, "a patch keeps its far face behind a back plane", "surface_late_1 ? zf_late_1 : zp_late_1", "surface_late_1 ? zb_late_1 : zp_late_1"),
    mutant("cut_plane-24", 5, "a patch's near face takes the plane's number", "surface_late_1 ? nb_late_1 : number_late_1", "number_late_1"),
    mutant("cut_plane-24", 5, "a solid keeps its front", "surface_late_1 ? zb_late_1 : zp_late_1", "surface_late_1 ? zb_late_1 : zf_late_1"),
    mutant("cut_plane-24", 5, "a removed half keeps its back", "cut_zb <= removed ? 24'sd8388607", "cut_zb <= removed ? zb_late_1"),
    mutant("cut_plane_order-24", 7, "a solid is cut to its back", "surface_late_1 ? zb_late_1 : zp_late_1", "zb_late_1"),
    mutant("quadric_cut-24", 8, "a front plane at the near root cuts", "{near_root_late_1[23], front[22:0]}", "{near_root_late_1[23], front[22:0]} + 24'd1"),
    mutant("quadric_cut-24", 8, "limits at one depth leave nothing", "{front[23], back[22:0]} <", "{front[23], back[22:0]} <="),
    mutant("quadric_cut-24", 8, "what is behind hides what is before", "~((before_2 | order_back_hides_far_late_1)", "~((1'b0 | order_back_hides_far_late_1)"),
    mutant("quadric_cut-24", 8, "a back plane before the far root removes it all", "order_front_hides_far_late_1 | order_back_hides_near_late_1", "order_front_hides_far_late_1 | order_back_hides_far_late_1"),
    mutant("quadric_cut-24", 8, "a patch shows a point behind a back plane", "~(order_front_hides_far_late_1 | order_back_hides_far_late_1)", "~order_front_hides_far_late_1"),
    mutant("quadric_cut-24", 8, "the near end is not behind a front plane", "(from_end & ~order_has_front_late_1)", "from_end"),
    mutant("quadric_cut-24", 8, "a back plane at the least word removes nothing", "| (back == 24'sh800000)", "| 1'b0"),
    mutant("quadric_cut-24", 8, "the screen box is ignored", "in_box_late_1 & is_inside_late_1", "is_inside_late_1"),
    mutant("quadric_cut-24", 8, "the far root carries the near one's number", "4'd15 : 4'd1", "4'd15 : 4'd0"),
    mutant("quadric_cut-24", 8, "the limits come a clock early", "is_plane_late_1 ? front_late_2", "is_plane_late_1 ? front_late_1"),
    mutant("raster_control-12", 8, "go interrupts a zone", "go & ~goes_on", "go"),
    mutant("raster_control-12", 8, "a line is one pixel too long", "column_before <= width - 12'd2", "column_before <= width - 12'd1"),
    mutant("raster_control-12", 8, "the last line is told by the column", "y == line_before", "x == line_before"),
    mutant("raster_control-12", 8, "line is never raised", "line <= goes_on & in_last_column", "line <= 1'd0"),
    mutant("raster_control-12", 8, "a zone of one column is one pixel", "obeyed ? one_line", "obeyed ? (one_line | one_column)"),
    mutant("raster_control-12", 8, "x does not return", "in_last_column ? 12'd0 : (x", "(x"),
    mutant("raster_control-3x3", 12, "a zone has one line more", "line_before <= height - 12'd2", "line_before <= height - 12'd1"),
    mutant("raster_control-3x3", 12, "a zone of one line is one pixel", "obeyed ? one_column", "obeyed ? (one_column | one_line)"),
    mutant("raster_control-integers", 0, "the last line is counted twice", "(= y (- height 1))", "(= y height)"),
    mutant("quadric_processor-n3-r1", 43, "the flags are one clock early", "early_valid = valid_late[22]", "early_valid = valid_late[21]"),
    mutant("quadric_processor-n3-r1", 43, "a valid is lost beside line", "{valid_late[21:0], valid}", "{valid_late[21:0], valid & ~line}"),
    mutant("quadric_processor-n3-r1", 43, "a valid is made by start", "{valid_late[21:0], valid}", "{valid_late[21:0], valid | start}"),
    mutant("beam-m4-n3", 46, "the decider's delay is left out", "assign valid = valid_late[1];", "assign valid = processors_out_valid[0];"),
    mutant("visibility_node-24", 3, "the second input wins at equal depth", "{b_depth, b_id}", "{b_depth, 8'd0}"),
    mutant("visibility_node-24", 3, "the greater id of the second input wins", "{b_depth, b_id}", "{b_depth, ~b_id}"),
    mutant("visibility_node-24", 3, "the first input wins at equal depth", "{b_depth, b_id}", "{b_depth, a_id}"),
    mutant("visibility_node-24", 3, "a normal does not follow", "b_wins ? b_ny : a_ny", "a_ny"),
    mutant("decider-m4", 4, "an input is looked at twice", ".b_depth(input_3_depth)", ".b_depth(input_2_depth)"),
    mutant("decider-m4", 4, "an id comes from another node", ".a_id(nodes_0_id)", ".a_id(nodes_1_id)"),
    mutant("square_root_rows-24-r1", 5, "the digits are turned over", "negative ? next_root_joined : (next_root_joined | 24'd1)", "negative ? (next_root_joined | 24'd1) : next_root_joined"),
    mutant("square_root_rows-24-r1", 5, "the remainder is not restored", "(negative ? dividend : trial)", "trial"),
    mutant("square_root_rows-24-r1", 5, "the divisor is 4 root", "{root, 2'd1}", "{root, 2'd0}"),
    mutant("square_root_rows-24-r1", 5, "half a pair is used", "{pairs[45:0], 2'd0}", "{pairs[46:0], 1'd0}"),
    mutant("square_root_rows-24-r1", 5, "a row has one live bit too few", "dividend : trial) & live", "dividend : trial) & (live >> 1)"),
    mutant("square_root_rows-24-r1", 5, "the pair is one bit low", "pair = pairs[47:46]", "pair = pairs[46:45]"),
    mutant("square_root_rows-24-r1", 9, "a stage takes the root of the one before", ".root(stages_root[k])", ".root(stages_root[k - (k == 6)])"),
    mutant("square_root-16-r1", 5, "the digits are turned over", "negative ? next_root_joined : (next_root_joined | 16'd1)", "negative ? (next_root_joined | 16'd1) : next_root_joined"),
    mutant("square_root-16-r1", 5, "the remainder is not restored", "(negative ? dividend : trial)", "trial"),
    mutant("square_root-16-r1", 5, "the divisor is 4 root", "{root, 2'd1}", "{root, 2'd0}"),
    mutant("square_root-16-r1", 5, "half a pair is used", "{pairs[29:0], 2'd0}", "{pairs[30:0], 1'd0}"),
    mutant("square_root-16-r1", 5, "a row has one live bit too few", "dividend : trial) & live", "dividend : trial) & (live >> 1)"),
    mutant("non_restoring_rows-24-r1", 5, "a negative remainder is subtracted from", "was_negative ? root : ~root", "~root"),
    mutant("non_restoring_rows-24-r1", 5, "the sum adds 4 root + 1", "was_negative ? root : ~root, 2'd3", "was_negative ? root : ~root, was_negative ? 2'd1 : 2'd3"),
    mutant("non_restoring_rows-24-r1", 5, "the digits are turned over", "negative ? next_root_joined : (next_root_joined | 24'd1)", "negative ? (next_root_joined | 24'd1) : next_root_joined"),
    mutant("non_restoring_rows-24-r1", 5, "a row has one live bit too few", "next_live = {live[24:0], 1'd1}", "next_live = {live[24:0], 1'd0}"),
    mutant("root_lemma-24", 1, "an exact square gets digit 0", "dividend >= divisor", "dividend > divisor"),
    mutant("root_lemma-24", 1, "the divisor is 4 root", "{1'b0, root, 2'b01}", "{1'b0, root, 2'b00}"),
    mutant("root_lemma-24", 1, "the digit is not kept", "{root[K-2:0], digit}", "{root[K-2:0], 1'b0}"),
    mutant("root-integers", 0, "the square forgets 1", "(* 4 root) 1)", "(* 4 root))"),
    mutant("tmds_encoder", 7, "five ones are not inverted", "ones > 4'd4", "ones > 4'd5"),
    mutant("tmds_encoder", 9, "the disparity outlives control", "de_2 ? next_disparity : 4'sd0", "de_2 ? next_disparity : disparity"),
    mutant("tmds_encoder", 11, "words are turned the wrong way", "grows = disparity[3] == is_short", "grows = disparity[3] != is_short"),
    mutant("tmds_encoder", 9, "the marks do not count", "(excess + mark) - 4'sd1", "excess"),
    mutant("tmds_encoder", 7, "a word of control is another", "10'd340", "10'd342"),
];
