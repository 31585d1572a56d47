//! Loading, and the pipeline of patch processors (source: chapter 5).

use super::costs::{change, facets, quadrics};
use super::duplication::formula;
use super::row::{Group, Row};
use super::scenes::{Moving, OBJECT_SIDE, ZONE_SIDE};
use super::silicon::Resources;
use super::storage::patch_bits;
use super::zones::{Kind, mean, source_mean};
use super::{EvaluateError, Hardware};
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::object::load::load_words;
use imogene_plan::zone::clocks::{FrameClocks, clocks};
use imogene_plan::zone::plan::ZonePlan;
use imogene_plan::zone::stream::beats_of_part;

/// Patches of the frame whose clocks are counted.
const PATCHES: u64 = 1000;
/// Its screen, the source's.
const SCREEN: [u32; 2] = [720, 540];
/// Processors of the greater example.
const PROCESSORS: usize = 100;

/// The source's machine: clock in Hz, clocks to load a patch.
struct Source;

impl Source {
    const CLOCK: f64 = 33e6;
    const LOADING: f64 = 1e-6;

    /// Processors that are kept busy by one link: `L H To / Co`.
    fn processors(side: f64) -> f64 {
        side * side / Source::CLOCK / Source::LOADING
    }

    fn zones(side: f64) -> f64 {
        Source::CLOCK / (side * side)
    }
}

/// Our machine.
struct Ours {
    clock: f64,
    /// Beats of the words of a patch.
    loading: f64,
    drain: f64,
}

impl Ours {
    fn processors(&self, side: f64) -> f64 {
        (self.pass(side) / self.loading).floor()
    }

    fn pass(&self, side: f64) -> f64 {
        side * side + self.drain
    }

    fn zones(&self, side: f64) -> f64 {
        self.clock / self.pass(side)
    }
}

/// The machine with 100 processors, zones of 128 and four planes.
fn machine() -> ZoneMachine {
    ZoneMachine {
        object_processors: PROCESSORS,
        planes: 4,
        volume_processors: 0,
        volume_planes: 0,
        zone_width: ZONE_SIDE,
        zone_height: ZONE_SIDE,
        samples: 1,
    }
}

/// Clocks of a frame of many patches, spread evenly over the screen by the golden ratio and the plastic number.
fn frame(patch: &Moving, hardware: &Hardware) -> Result<FrameClocks, EvaluateError> {
    let room = SCREEN.map(|side| u64::from(side - OBJECT_SIDE + 1));
    // Kronecker's sequence with the powers of one over the plastic number, in whole numbers.
    let place = |k: u64| {
        let along = |step: u64, room: u64| ((k * step % 1_000_000) * room / 1_000_000) as i64;
        [along(754_878, room[0]), along(569_840, room[1])]
    };
    let places: Vec<[i64; 2]> = (1..=PATCHES).map(place).collect();
    let plan = ZonePlan::of(&patch.at(&places, SCREEN), machine())?;
    Ok(clocks(&plan, &hardware.zone_timing))
}

/// Loading and rates.
///
/// # Errors
///
/// When the patches do not fit the machine, or a clock is not in the table: a defect.
pub fn group(
    patch: &Moving,
    hardware: &Hardware,
    resources: &Resources,
) -> Result<Group, EvaluateError> {
    let format = Format::BASE;
    let plan = ZonePlan::of(&patch.at(&[[0, 0]], [OBJECT_SIDE; 2]), machine())?;
    let beats = beats_of_part(plan.parts[0].words.planes.len(), 4) as f64;
    let bits = patch_bits(&load_words(patch.words(), &format, 4));
    let ours = Ours {
        clock: 1e6 * resources.fmax("quadric_processor")?,
        loading: beats,
        drain: f64::from(hardware.zone_timing.draw_drain),
    };
    let (small, great, duplication) = (64.0, 128.0, formula(80.0, 128.0));
    let source_rate = Source::zones(great) * Source::processors(great);
    let our_rate = ours.zones(great) * ours.processors(great);
    let counted = frame(patch, hardware)?;
    let frames = ours.clock / counted.total as f64;
    let hundred = PROCESSORS as f64;
    let mhz = ours.clock / 1e6;
    let clock = format!("{mhz:.1} MHz, the quadric processor on ecp5-45k");
    let rate = |name: &str, printed: f64, corrected: f64, value: f64| {
        Row::new(name, "chapter 5", printed, value, "per second").corrected(corrected)
    };
    Ok(Group {
        name: "pipeline",
        title: "Loading, and the pipeline of patch processors",
        about: format!(
            "The source's figures are done again from its formula L H To / Co, its 33 MHz and its 1 us of loading. Ours take the beats and clocks of the zone machine and {clock}, the slowest unit of that machine that is measured \
             ({:.1} MHz is that of the patch processor). A pass over a zone takes its pixels and {} clocks in which the last ones leave the pipeline.",
            resources.fmax("patch_processor")?,
            ours.drain
        ),
        rows: vec![
            Row::new("loading of a patch", "chapter 5", 20.0, beats, "cycles").corrected(19.5).why(
                "a beat for each word, 24 to 48 bits of its 64, and one for the id; constant normals of four planes are 12 of them, which a patch does not need. Nothing waits: loading is hidden behind the pass before",
            ),
            Row::new("the same, words packed into 64 bits", "chapter 5", 20.0, (bits / 64.0).ceil(), "cycles").corrected((936.0f64 / 64.0).ceil()).why(
                "936 bits would be 15 cycles; ours has more bits, see storage",
            ),
            Row::new("time of loading", "chapter 5", 1.0, 1e6 * beats / ours.clock, "us").why("a beat a clock; the source has 50 ns a cycle"),
            Row::new("processors that one link keeps busy, zones of 128", "chapter 5", 490.0, ours.processors(great), "processors")
                .corrected(Source::processors(great).floor())
                .why("loading takes more cycles, and cycles are those of the pixel clock; the print rounds To to 30 ns"),
            Row::new("the same, zones of 64", "chapter 5", 120.0, ours.processors(small), "processors")
                .corrected(Source::processors(small).floor())
                .why("the same"),
            rate("zones of 128 of one processor", 2000.0, Source::zones(great), ours.zones(great)).why(clock.clone()),
            rate("zones of 64 of one processor", 8000.0, Source::zones(small), ours.zones(small)).why(clock.clone()),
            rate("patches times zones, zones of 128", 980_000.0, source_rate, our_rate)
                .why("as many processors as the link keeps busy: the rate is the clock over the cycles of loading"),
            rate("patches times zones, zones of 64", 960_000.0, Source::zones(small) * Source::processors(small), ours.zones(small) * ours.processors(small))
                .why("the same"),
            rate("patches of 80 x 80, zones of 128", 370_000.0, source_rate / duplication, our_rate / duplication).why("over the duplication factor 2.641"),
            rate("patches of 80 x 80, zones of 64", 192_000.0, Source::zones(small) * Source::processors(small) / formula(80.0, small), ours.zones(small) * ours.processors(small) / formula(80.0, small))
                .why("over the duplication factor 5.06; the print takes 5"),
            rate("facets that stand for them, seven each", 2_590_000.0, 7.0 * source_rate / duplication, 7.0 * our_rate / duplication)
                .why("with the source's seven facets for a patch"),
            rate("patches of 100 processors", 75_750.0, hundred * Source::zones(great) / duplication, hundred * ours.zones(great) / duplication)
                .why("loading of 100 patches is hidden behind a pass"),
            rate("facets that stand for them", 530_000.0, 7.0 * hundred * Source::zones(great) / duplication, 7.0 * hundred * ours.zones(great) / duplication)
                .why("seven each"),
            rate("patches of 100 processors, clocks of a whole frame", 75_750.0, hundred * Source::zones(great) / duplication, frames * PATCHES as f64)
                .why(format!(
                    "{PATCHES} patches in boxes of 80 x 80, spread over 720 x 540 pixels: {} clocks, {frames:.0} frames a second, {} draw passes of which the last of a zone has idle processors, {} zones shown, {} clocks waiting for words",
                    counted.total, counted.draw_passes, counted.zones, counted.waiting
                )),
            Row::new("patches in an image at 25 a second", "chapter 5", "nothing", our_rate / duplication / 25.0, "patches")
                .corrected(source_rate / duplication / 25.0)
                .why("the rate above over 25"),
        ],
    })
}

/// The work that the preparation has to do for the source's rates.
pub fn preparation() -> Group {
    let patch = change::quadric_matrices() + quadrics::patch_in_all() + mean(Kind::Patch);
    let facet = change::product() + facets::phong_by_expressions() + mean(Kind::Facet);
    let (source_patch, source_facet) = (
        1046.0 + source_mean(Kind::Patch),
        449.0 + source_mean(Kind::Facet),
    );
    let (source_rate, hundred) = (370_000.0, 75_750.0);
    let mflops = |name: &str, printed: f64, corrected: f64, ours: f64| {
        Row::new(
            name,
            "chapter 5",
            printed,
            ours / 1e6,
            "million operations a second",
        )
        .corrected(corrected / 1e6)
    };
    let same = "at the source's rate, with our operations";
    Group {
        name: "rates",
        title: "Work of the preparation at the source's rates",
        about: "Operations of one object with its matrices and its zones, times the rates of the source; only the operations are ours.".into(),
        rows: vec![
            Row::new("patch with its zones", "chapter 5", 1369.0, patch, "operations").corrected(source_patch).why("1046 and the mean of the zones there"),
            Row::new("facet with its zones", "chapter 5", 618.0, facet, "operations").corrected(source_facet).why("449 and the mean of the zones there"),
            mflops("370 000 patches a second", 500.0, source_patch * source_rate, patch * source_rate).why(same),
            mflops("seven times as many facets", 1600.0, 7.0 * source_facet * source_rate, 7.0 * facet * source_rate).why(same),
            mflops("a million facets a second", 600.0, source_facet * 1e6, facet * 1e6).why(same),
            mflops("patches of 100 processors", 100.0, source_patch * hundred, patch * hundred).why(same),
            Row::new("seven facets over a patch", "chapter 5", 3.0, 7.0 * facet / patch, "times")
                .corrected(7.0 * source_facet / source_patch)
                .why("operations of seven facets with their zones over those of a patch"),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The formula with the source's parameters gives its results (thesis chapter 5).
    #[test]
    fn the_source_follows_from_its_parameters() {
        assert_eq!(
            [128.0, 64.0].map(|side| Source::processors(side).floor()),
            [496.0, 124.0]
        );
        assert_eq!(
            [128.0, 64.0].map(|side| Source::zones(side).round()),
            [2014.0, 8057.0]
        );
        let rate = Source::zones(128.0) * Source::processors(128.0);
        // The clock cancels: one patch for every 1 us of loading.
        assert!((rate - 1e6).abs() < 1.0);
        assert!((rate / formula(80.0, 128.0) - 370_000.0).abs() / 370_000.0 < 0.03);
    }
}
