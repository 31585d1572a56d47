//! One point: the scene prepared for it, drawn, and compared with the truth.

use super::design::{Accuracy, Design, Zones};
use super::view::Views;
use crate::fit::machine::{smallest, with_side};
use crate::kit::words::{drawn, narrowest};
use imogene_analysis::metrics::toggles::{Part, Toggles, count};
use imogene_analysis::metrics::{Metrics, measure as compare};
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::words::Words;
use imogene_golden::unit::lattice::Lattice;
use imogene_plan::description::{MachineDescription, MachineKind, Output};
use imogene_plan::display::mean_of_samples;
use imogene_plan::needs::{enough, narrowed};
use imogene_plan::pace::{Timing, clocks_per_frame};
use imogene_plan::zone::plan::ZonePlan;
use imogene_prepare::{PreparedScene, prepare_for_roots};
use imogene_scene::FramedScene;

/// What is known of all points of the same pixels.
pub struct Measured<'a> {
    /// Every width.
    pub widths: MachineWords,
    /// How far what is drawn is from the truth, sample by sample.
    pub metrics: Metrics,
    /// Root mean square of the differences of all channels from the ideal picture, in percent of the whole scale.
    pub picture_error: f64,
    /// The picture.
    pub rgb: Vec<u8>,
    /// The map of its errors.
    pub map: Vec<u8>,
    scene: &'a FramedScene,
    prepared: PreparedScene,
}

/// Draws and compares; the error says why the scene cannot be prepared.
pub fn measure<'a>(views: &'a Views, accuracy: &Accuracy) -> Result<Measured<'a>, String> {
    let scene = views.drawn(accuracy)?;
    let (widths, prepared) = prepared(scene, accuracy)?;
    let mut drawing = drawn(scene, &prepared, accuracy.tables()).map_err(|e| e.to_string())?;
    if accuracy.undersampling > 1 {
        drawing = drawing.enlarged(accuracy.undersampling as usize);
    }
    if accuracy.interlaced {
        drawing = drawing.of_even_lines();
    }
    let (metrics, map) = compare(views.truth(accuracy), &drawing);
    let (columns, samples) = (drawing.frame.width, accuracy.supersampling as usize);
    let rgb = mean_of_samples(&drawing.rgb, columns, samples);
    Ok(Measured {
        widths,
        metrics,
        picture_error: views.ideal().error(&rgb),
        rgb,
        map: first_samples(&map, columns, samples),
        scene,
        prepared,
    })
}

/// Of every pixel the first sample.
fn first_samples(rgb: &[u8], columns: usize, samples: usize) -> Vec<u8> {
    let lines = rgb.chunks(3 * columns).step_by(samples);
    let pixels = lines.flat_map(|line| line.chunks(3).step_by(samples));
    pixels.flatten().copied().collect()
}

impl Measured<'_> {
    /// The smallest machine of these words and of the form of a point that shows the scene; or why there is none.
    pub fn machine(&self, design: &Design) -> Result<MachineDescription, String> {
        let samples = design.accuracy.supersampling;
        let size = (self.scene.width / samples, self.scene.height / samples);
        let frames = std::slice::from_ref(&self.prepared);
        let beam = MachineDescription {
            output: Output::Stream,
            pixels_per_clock: design.pixels_per_clock,
            interlaced: design.accuracy.interlaced,
            ..smallest(&self.widths, frames, design.rows_per_stage, size)
        };
        let beam = match design.accuracy.tables() {
            None => beam,
            Some(form) => beam.lit_by_tables(form),
        };
        let asked = match design.zones {
            Some(Zones { processors, side }) => MachineDescription {
                machine: MachineKind::Zone,
                objects: processors,
                slots: None,
                supersampling: samples,
                ..with_side(&beam, side)
            },
            None if design.accuracy.catalogue => MachineDescription {
                slots: None,
                ..beam
            },
            None => beam,
        };
        let scenes = [(self.scene, &self.prepared)];
        let found = enough(&asked, &scenes).map_err(|e| e.to_string())?;
        if found.machine != asked.machine {
            return Err("more objects or volumes than a beam machine has processors".into());
        }
        let found = match design.accuracy.catalogue {
            true => found,
            false => narrowed(&found, &scenes).map_err(|e| e.to_string())?,
        };
        found.check("its machine").map_err(|e| e.to_string())?;
        Ok(found)
    }

    /// Clocks from frame to frame, every frame with new words.
    pub fn clocks(&self, machine: &MachineDescription, timing: &Timing) -> Result<u64, String> {
        clocks_per_frame(machine, self.scene, &self.prepared, timing).map_err(|e| e.to_string())
    }

    /// Bits that change from clock to clock while objects are drawn.
    pub fn toggles(&self, machine: &MachineDescription) -> Result<Toggles, String> {
        let (format, rows) = (&self.prepared.format, machine.rows_per_stage);
        let fields = machine.fields();
        let height = self.prepared.height / fields.len() as u32;
        if machine.machine == MachineKind::Beam {
            let step = machine.pixels_per_clock;
            let lane = |first: u32| {
                let mut pixels = Lattice::columns(step.into(), first.into());
                pixels.dy = fields[0].dy;
                let slots = self.prepared.quadrics();
                Part {
                    slots: slots.map(|(_, object)| object.words.on(&pixels)).collect(),
                    window: ScreenBox::of_screen(self.prepared.width / step, height),
                }
            };
            let lanes: Vec<Part> = (0..step).map(lane).collect();
            return Ok(count(&lanes, format, rows, height));
        }
        let plan = ZonePlan::of(&self.prepared, machine.zone_machine());
        let plan = plan.map_err(|e| e.to_string())?;
        let zones = plan.zones.iter().map(|zone| {
            let parts = zone.all_parts();
            let words = parts.filter_map(|part| plan.parts[part as usize].quadric());
            Part {
                slots: words.map(|words| words.on(&zone.sample.pixels())).collect(),
                window: zone.window,
            }
        });
        let zones: Vec<Part> = zones.collect();
        Ok(count(&zones, format, rows, height / machine.supersampling))
    }
}

fn prepared(
    scene: &FramedScene,
    accuracy: &Accuracy,
) -> Result<(MachineWords, PreparedScene), String> {
    if accuracy.catalogue {
        let format = Format::new(accuracy.depth).map_err(|e| e.to_string())?;
        let words = format.widths();
        return Ok((words, in_format(scene, &words)?));
    }
    let wide = accuracy.widest();
    let in_widths = |widths: &MachineWords| match in_format(scene, widths) {
        Err(problem) if *widths == wide => Err(problem),
        prepared => Ok(prepared.ok().map(|prepared| vec![prepared])),
    };
    let found = narrowest(&wide, in_widths)?;
    let (widths, mut scenes) = found.expect("a refusal of the widest words is an error");
    Ok((widths, scenes.remove(0)))
}

fn in_format(scene: &FramedScene, widths: &MachineWords) -> Result<PreparedScene, String> {
    let format = Format::fitted(widths).map_err(|e| e.to_string())?;
    prepare_for_roots(scene, format).map_err(|e| e.to_string())
}
