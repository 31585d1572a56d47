use imogene_synth::{CriticalPath, parse_report};

const ECP5: &str = include_str!("../data/raster_control.ecp5.report.json");
const ICE40: &str = include_str!("../data/raster_control.ice40.report.json");
const PACKED: &str = include_str!("../data/raster_control.ice40.pack.json");

#[test]
fn the_clock_and_its_path_are_read() {
    let report = parse_report(ECP5).expect("a recorded report");
    assert_eq!(report.fmax_mhz, Some(124.008));
    let path = CriticalPath {
        from: "unit.kept_x_TRELLIS_FF_Q_7".into(),
        to: "unit.kept_last_TRELLIS_FF_Q".into(),
        logic_ns: 2.761,
        routing_ns: 5.303,
    };
    assert_eq!(report.critical_path, Some(path));
    let report = parse_report(ICE40).expect("a recorded report");
    assert_eq!(report.fmax_mhz, Some(115.58));
}

#[test]
fn the_path_explains_the_clock() {
    for text in [ECP5, ICE40] {
        let report = parse_report(text).expect("a recorded report");
        let path = report.critical_path.expect("a path between registers");
        let period = 1000.0 / report.fmax_mhz.expect("a clock");
        assert!((path.logic_ns + path.routing_ns - period).abs() < 0.01);
    }
}

#[test]
fn packing_alone_has_no_clock() {
    let report = parse_report(PACKED).expect("a recorded report");
    assert_eq!(report.fmax_mhz, None);
    assert_eq!(report.critical_path, None);
    assert_eq!(report.utilisation["ICESTORM_LC"].1, 7680);
}

#[test]
fn too_many_cells_are_an_excess_and_too_many_pins_are_not() {
    let mut report = parse_report(PACKED).expect("a recorded report");
    report.utilisation.insert("SB_IO".into(), (300, 206));
    assert_eq!(report.excess(), None);
    let cells = "ICESTORM_LC".to_owned();
    report.utilisation.insert(cells, (9000, 7680));
    assert_eq!(report.excess().as_deref(), Some("9000 ICESTORM_LC of 7680"));
}

#[test]
fn a_report_that_is_none_is_refused() {
    assert!(parse_report("").is_err());
    assert!(parse_report("{\"fmax\": 1}").is_err());
}
