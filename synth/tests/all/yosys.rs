use imogene_synth::{Family, parse_statistics, resources};

const ICE40: &str = include_str!("../data/normal_unit.ice40.stat.json");
const ECP5: &str = include_str!("../data/normal_unit.ecp5.stat.json");
const XILINX: &str = include_str!("../data/normal_unit.xilinx.stat.json");
const GOWIN: &str = include_str!("../data/normal_unit.gowin.stat.json");
const GATES: &str = include_str!("../data/pe1.transistors.stat.json");

fn recorded(family: Family, text: &str) -> [u64; 5] {
    let statistics = parse_statistics(text).expect("a recorded report");
    resources(family, &statistics.cells).counts()
}

#[test]
fn recorded_statistics_are_summed() {
    assert_eq!(recorded(Family::Ice40, ICE40), [3011, 525, 369, 0, 0]);
    assert_eq!(recorded(Family::Ecp5, ECP5), [627, 525, 153, 3, 0]);
    assert_eq!(recorded(Family::Xilinx7, XILINX), [609, 510, 78, 3, 0]);
    assert_eq!(recorded(Family::Gowin, GOWIN), [590, 525, 306, 3, 0]);
    assert_eq!(recorded(Family::Gates, GATES), [0; 5]);
}

#[test]
fn cells_of_memories_and_multipliers_are_told_from_carry_cells() {
    let cells = |names: &[&str]| names.iter().map(|name| ((*name).to_owned(), 1)).collect();
    let several = cells(&["ALU", "ALU54D", "SDPB", "RAM16SDP4"]);
    let gowin = resources(Family::Gowin, &several);
    let counts = (gowin.carry, gowin.dsp, gowin.bram, gowin.lut);
    assert_eq!(counts, (1, 1, 1, 1));
    let ecp5 = resources(Family::Ecp5, &cells(&["DP16KD", "MULT18X18D"]));
    assert_eq!((ecp5.bram, ecp5.dsp), (1, 1));
}

#[test]
fn recorded_transistors_are_read() {
    let statistics = parse_statistics(GATES).expect("a recorded report");
    assert_eq!(statistics.transistors, Some(5066));
    let ecp5 = parse_statistics(ECP5).expect("a recorded report");
    assert_eq!(ecp5.transistors, None);
}

#[test]
fn transistors_that_leave_cells_out_are_refused() {
    let text = GATES.replace("\"5066\"", "\"5066+\"");
    let error = parse_statistics(&text).expect_err("an incomplete count");
    assert!(error.to_string().contains("5066+"), "{error}");
}

#[test]
fn a_report_that_is_none_is_refused() {
    for text in ["", "ERROR: no such module", "{", "{}"] {
        assert!(parse_statistics(text).is_err(), "{text}");
    }
}
