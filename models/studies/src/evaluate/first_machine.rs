//! The machine of 1991 and the processors of both sources: parts, lines, channels (source: Chaillou, IV; Nyiri, 4.1, 5.2.1).

use super::row::{Group, Row};
use super::silicon::Resources;
use super::storage::fair_ball;
use super::{EvaluateError, Hardware, Parts};
use imogene_golden::unit::interlaced::MemoryPe2;
use imogene_golden::unit::pe2::Quadratic;

/// What a source counts in a processor: unit, parameters, its name there, section, PE1, PE2, roots, multipliers, and why ours has others.
struct Processor(
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    [usize; 4],
    &'static str,
);

const PROCESSORS: [Processor; 11] = [
    Processor(
        "first_generation_processor",
        "",
        "quadric, first generation",
        "4.1.2",
        [8, 6, 4, 0],
        "one normal unit of three multipliers stands for three radicands of second degree, each with its root",
    ),
    Processor(
        "quadric_processor",
        "2 planes",
        "quadric, two planes",
        "2.4.2",
        [6, 1, 1, 3],
        "",
    ),
    Processor(
        "patch_processor",
        "4 planes",
        "patch, four planes",
        "5.2.1",
        [8, 1, 1, 3],
        "",
    ),
    Processor(
        "polyhedron_processor",
        "6 planes",
        "polyhedron of six faces",
        "annex A",
        [6, 0, 0, 0],
        "",
    ),
    Processor(
        "quadric_volume",
        "4 planes",
        "shadow of a quadric",
        "4.1.3",
        [5, 1, 1, 0],
        "",
    ),
    Processor(
        "facet_processor",
        "3 sides",
        "facet of three sides",
        "Chaillou, IV.2.2",
        [7, 0, 0, 0],
        "",
    ),
    Processor(
        "facet_processor",
        "4 sides",
        "facet of four sides",
        "Chaillou, IV.2.2",
        [8, 0, 0, 0],
        "",
    ),
    Processor(
        "curved_facet_processor",
        "3 sides",
        "non-planar facet",
        "Chaillou, IV.2.6.1",
        [0, 7, 0, 0],
        "",
    ),
    Processor(
        "sphere_processor",
        "",
        "sphere with its back",
        "Chaillou, IV.2.4",
        [2, 4, 0, 0],
        "front and back depth have a constant sum, so a subtraction gives the back",
    ),
    Processor(
        "cylinder_processor",
        "",
        "cylinder",
        "Chaillou, IV.2.5",
        [5, 6, 0, 0],
        "",
    ),
    Processor(
        "polyhedral_volume",
        "4 planes",
        "shadow of a polyhedron, four planes",
        "4.1.3",
        [4, 0, 0, 0],
        "",
    ),
];

/// Additions of the elementary processors at a pixel: one of a PE1, two of a PE2.
fn additions([pe1, pe2, ..]: [usize; 4]) -> f64 {
    (pe1 + 2 * pe2) as f64
}

fn rows_of(source: &Processor, parts: &Parts) -> Vec<Row> {
    let Processor(_, _, name, section, printed, why) = source;
    let ours = [parts.pe1, parts.pe2, parts.roots, parts.multipliers];
    let why = |same: bool| match (same, why) {
        (false, why) => (*why).to_owned(),
        (true, _) => "counted in the emitted hierarchy".to_owned(),
    };
    let kinds = ["PE1", "PE2", "roots", "multipliers"];
    let counts = printed.iter().zip(ours).zip(kinds);
    let counts = counts.filter(|((there, here), _)| **there > 0 || *here > 0);
    let mut rows: Vec<Row> = counts
        .map(|((&there, here), kind)| {
            Row::new(
                format!("{name}: {kind}"),
                section,
                there as f64,
                here as f64,
                "units",
            )
            .why(why(there == here))
        })
        .collect();
    let sums = [additions(*printed), additions(ours)];
    let row = Row::new(
        format!("{name}: additions of its expressions"),
        section,
        "nothing",
        sums[1],
        "a pixel",
    );
    rows.push(row.corrected(sums[0]).why(why(sums[0] == sums[1])));
    rows
}

/// Processors of both sources.
///
/// # Errors
///
/// When a processor is not among those handed in.
pub fn processors(hardware: &Hardware) -> Result<Group, EvaluateError> {
    let mut rows = vec![];
    for source in &PROCESSORS {
        let found = hardware
            .processors
            .iter()
            .find(|p| p.unit == source.0 && p.parameters == source.1);
        let parts = found.ok_or_else(|| EvaluateError::Missing {
            unit: source.0.into(),
            target: source.1.into(),
            figure: "parts",
        })?;
        rows.extend(rows_of(source, parts));
    }
    Ok(Group {
        name: "processors",
        title: "Parts of the processors",
        about: "Ours are counted in the hierarchy of the Verilog that is emitted, as `imogene processors` does. Additions at a pixel are one for a PE1 and two for a PE2.".into(),
        rows,
    })
}

/// Clocks from the last pixel of a line to the first of the next, and words of memory, of the memory-based PE2.
fn memory_pe2(interlaced: bool) -> [f64; 2] {
    let expression = Quadratic::default();
    let mut pe = if interlaced {
        let mut pe = MemoryPe2::interlaced(&expression, 48);
        pe.field_start(0);
        pe.line_start();
        pe
    } else {
        let mut pe = MemoryPe2::progressive(&expression, 48);
        pe.line_start();
        pe
    };
    let before = pe.clocks();
    pe.line_start();
    [(pe.clocks() - before) as f64, pe.memory_words() as f64]
}

/// The machine of 1991.
///
/// # Errors
///
/// When a figure is not in the table: a defect.
pub fn machine(resources: &Resources) -> Result<Group, EvaluateError> {
    let [progressive, words] = memory_pe2(false);
    let [interlaced, words_interlaced] = memory_pe2(true);
    let [sides, seen] = fair_ball()?;
    let pixel_clock = resources.fmax("quadric_processor")?;
    let node = resources.flip_flops("visibility_node")?;
    let source =
        |name: &str, section: &'static str, printed: f64, ours: f64, unit: &'static str| {
            Row::new(name, section, printed, ours, unit)
        };
    let spheres = 200.0 * 50.0;
    Ok(Group {
        name: "machine",
        title: "The machine of 1991, and facets that a quadric stands for",
        about: "Clocks are counted by running the golden model of the memory-based PE2. Facets are those of a mesh whose outline is nowhere more than half a pixel inside that of a ball in a box of 80 x 80 pixels, the source's example."
            .into(),
        rows: vec![
            source("PE2 with memory, words", "Chaillou, IV.1.5", 6.0, words, "words").why("the same"),
            source("PE2 with memory, words, interlaced", "Chaillou, IV.1.5", 12.0, words_interlaced, "words")
                .why("three second differences never change, so they need no second copy"),
            Row::new("PE2 with memory, clocks between lines", "Chaillou, IV.1.5", "7 us at 16 MHz", progressive, "clocks")
                .why("7 us of retrace are 112 clocks there; its algorithm with one memory port takes this"),
            Row::new("the same, interlaced", "Chaillou, IV.1.5", "7 us at 16 MHz", interlaced, "clocks").why("two line steps"),
            source("PE2 chip, clock", "Chaillou, IV.1.9", 10.0, resources.fmax("memory_pe2")?, "MHz")
                .why("CMOS of 2 um and 32 bits there, an FPGA and 48 bits here"),
            source("PE2 chip, transistors", "Chaillou, IV.1.9", 25_000.0, resources.transistors("pe2")?, "transistors")
                .why("48 bits and registers here, 32 bits, two memories and a controller there"),
            source("channel from a processor to the decider", "Chaillou, IV.3.6", 50.0, node, "bits")
                .why("flip-flops of a node of the decider: a depth of 24, an id of 12, a normal of 3 x 16"),
            source("facets that a sphere replaces", "Chaillou, IV.4.8", 100.0, seen, "facets")
                .why(format!("assumed there; here, for a ball of this size, the facets turned to the viewer of a mesh with {sides} sides and {} bands", sides / 2.0)),
            source("facets around, equal to a quadric for the eye", "4.1.2", 20.0, sides, "facets")
                .why("a judgement there; here the sides for half a pixel at a radius of 40"),
            source("facet equivalents of 200 processors at 50 images", "Chaillou, IV.4.8", 1_000_000.0, spheres * seen, "a second")
                .why("200 processors, 50 images, one object for each processor, and facets as counted above: another size of the ball gives another number"),
            source("pixel clock of 512 x 512, not interlaced", "Chaillou, Table 1.1", 16.6, pixel_clock, "MHz").why("the quadric processor; the PE2 chip reaches 10 there"),
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sphere_adds_eight_times_at_a_pixel() {
        // Three PE2 and two PE1 without the back (Chaillou, IV.2.4).
        assert_eq!(additions([2, 3, 0, 0]), 8.0);
    }
}
