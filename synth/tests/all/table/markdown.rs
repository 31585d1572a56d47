use super::invented;
use imogene_synth::CriticalPath;

#[test]
fn a_path_names_registers() {
    for (cell, name) in [
        ("unit.f2.first_step_TRELLIS_FF_Q_4", "f2.first_step"),
        (
            "unit.f2.line_value_SB_DFFE_Q_44_D_SB_LUT4_O_LC",
            "f2.line_value",
        ),
        ("inputs_SB_DFFE_Q_DFFLC", "inputs"),
        ("plain", "plain"),
    ] {
        let mut table = invented();
        table.rows[0].slowest_path = Some(CriticalPath {
            from: cell.into(),
            to: "results".into(),
            logic_ns: 1.5,
            routing_ns: 2.0,
        });
        let shown = format!("| `{name}` to `results`, 1.5 ns in cells, 2.0 ns in wires |");
        assert!(table.markdown().contains(&shown), "{shown}");
    }
}
