//! The way from PE1 to the beam machine stays short enough to be read in one sitting.

use imogene_contract::{Request, Unit};
use imogene_rtl::emit::emit;
use std::path::Path;

/// The circuits on the way, from the smallest to the machine.
const FILES: [&str; 12] = [
    "raster/mod.rs",
    "raster/pe1.rs",
    "raster/pe2.rs",
    "arith/root_rows.rs",
    "arith/square_root.rs",
    "object/quadric_pe.rs",
    "object/quadric_cut.rs",
    "object/visible.rs",
    "object/quadric_processor.rs",
    "machine/decider.rs",
    "machine/object_array.rs",
    "machine/beam.rs",
];

#[test]
fn circuits_take_at_most_1000_lines_with_their_docs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("circuits/src");
    let lines = FILES.map(|file| {
        let text = std::fs::read_to_string(folder.join(file)).expect("a file of the way");
        text.lines().count()
    });
    let sum: usize = lines.iter().sum();
    println!("{sum} lines: {lines:?}");
    assert!(sum <= 1_000, "{sum} lines: {lines:?}");
}

#[test]
fn verilog_of_a_small_beam_takes_at_most_950_lines() {
    let request = Request::given("beam", 24, &[("objects", Some(2)), ("planes", Some(2))]);
    let request = request.expect("a legal machine");
    assert_eq!(request.unit, Unit::Beam);
    let emitted = emit(&request).expect("a legal request");
    let texts = emitted.modules.iter();
    let lines: Vec<(&str, usize)> = texts
        .map(|(name, text)| (name.as_str(), text.lines().count()))
        .collect();
    let sum: usize = lines.iter().map(|(_, lines)| lines).sum();
    println!("{sum} lines: {lines:?}");
    assert!(sum <= 950, "{sum} lines: {lines:?}");
}
