//! The machine around the words: processors, volumes, lights, zones, screen.

use super::FitError;
use super::estimate;
use super::frames::{Drawn, Frame, Frames};
use imogene_contract::object::Kind;
use imogene_contract::slots::{FittedSlot, Products, Slots, one_of_each};
use imogene_contract::video::VideoMode;
use imogene_contract::{DeciderForm, MachineWords, RootForm};
use imogene_golden::format::Format;
use imogene_golden::machine::shader::MOST_LIGHTS;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::slots::{own_kind, required};
use imogene_golden::widths::OwnWidths;
use imogene_plan::description::{
    MachineDescription, MachineKind, Mode, Output, OwnMode, Smoothing, ZoneSize,
};
use imogene_plan::display::DisplayError;
use imogene_plan::needs::{enough, narrowed};
use imogene_plan::zone::clocks::{ZoneTiming, clocks};
use imogene_plan::zone::plan::ZonePlan;
use imogene_prepare::PreparedScene;
use imogene_scene::FramedScene;

const PROCESSORS: [usize; 5] = [1, 2, 4, 8, 16];
const SIDES: [u32; 3] = [16, 32, 64];
/// Blanking of a screen of no published mode: front porch, synchronisation, back porch of a line and of a frame.
const BLANKING: [[u64; 3]; 2] = [[8, 16, 16], [2, 2, 12]];

/// How fast a machine has to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Frames per second.
    pub frames: f64,
    /// Clock in MHz.
    pub mhz: f64,
}

/// A machine, and the clocks of its slowest frame.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// What it is made of.
    pub description: MachineDescription,
    /// Clocks of a frame: of the screen, or of the zones where they are more.
    pub clocks: u64,
}

impl Fitted {
    /// True if its processors should take fewer logic cells than those of another, or as many and fewer clocks.
    pub fn is_smaller(&self, other: &Fitted) -> bool {
        let size = |fitted: &Fitted| (cells(&fitted.description), fitted.clocks);
        size(self) < size(other)
    }
}

/// The smallest machine of these words that shows all frames; `timing` gives the clocks of a zone machine's passes.
/// Fails when none shows them, or none is as fast as asked for.
pub fn machine(
    frames: &Frames,
    drawn: &Drawn,
    rows_per_stage: u32,
    pace: Option<Pace>,
    timing: &dyn Fn(&MachineDescription) -> ZoneTiming,
) -> Result<Fitted, FitError> {
    let size = &frames.all[0].scene;
    let size = (size.width, size.height);
    let mut smallest = smallest(&drawn.widths, &drawn.prepared, rows_per_stage, size);
    if let Some(form) = frames.lit_sphere {
        smallest = smallest.lit_by_tables(form);
    }
    if frames.pixels_per_clock > 1 {
        smallest.pixels_per_clock = frames.pixels_per_clock;
        smallest.output = Output::Stream;
    }
    let scenes = scenes(frames, drawn);
    let refused = |source| frames.all[0].refused(source);
    let found = match frames.kind {
        MachineKind::Beam => {
            let beam = enough(&smallest, &scenes).map_err(refused)?;
            if beam.machine != MachineKind::Beam {
                return Err(FitError::TooManyForBeam);
            }
            let description = narrowed(&beam, &scenes).map_err(refused)?;
            let clocks = screen_clocks(&description);
            if let Some(pace) = pace {
                pace.check(clocks, &frames.all[0], Some(&description))?;
            }
            Fitted {
                description,
                clocks,
            }
        }
        MachineKind::Zone => {
            let found = of_zones(&smallest, frames, drawn, pace, timing)?.description;
            let description = narrowed(&found, &scenes).map_err(refused)?;
            let side = description.zone.map_or(SIDES[0], |zone| zone.width);
            let plans = plans(&description, side, frames, drawn)?;
            in_zones(description, &[(side, plans)], timing)
        }
    };
    found.description.check("the fitted machine")?;
    Ok(found)
}

/// The machine of the base format for the same frames: processors that are all alike.
pub fn base(fitted: &MachineDescription) -> MachineDescription {
    MachineDescription {
        depth_word: Format::BASE.depth,
        widths: OwnWidths::default(),
        root_form: RootForm::default(),
        rows_per_stage: 1,
        slots: None,
        ..fitted.clone()
    }
}

/// A beam machine with nothing but words, empty slots for the frames, and a screen.
pub fn smallest(
    widths: &MachineWords,
    frames: &[PreparedScene],
    rows_per_stage: u32,
    size: (u32, u32),
) -> MachineDescription {
    MachineDescription {
        machine: MachineKind::Beam,
        depth_word: widths.depth,
        widths: OwnWidths::of(widths),
        root_form: widths.root_form,
        rows_per_stage,
        objects: 0,
        planes: 0,
        slots: Some(Slots(kinds(frames))),
        products: Products::default(),
        decider: DeciderForm::Tree,
        layers: 0,
        volumes: 0,
        volume_planes: 0,
        lights: 1,
        lit_sphere: None,
        // As many as the lights of the scene leave.
        suns: MOST_LIGHTS,
        zone: None,
        loader_words: None,
        mode: mode(size),
        output: Output::Pins,
        pixels_per_clock: 1,
        modules: 1,
        interlaced: false,
        supersampling: 1,
        smoothing: Smoothing::None,
        overlay: false,
    }
}

/// For each part of the frames in no solid an empty slot of the smallest processor that draws it in all.
fn kinds(frames: &[PreparedScene]) -> Vec<FittedSlot> {
    let mut kinds: Vec<FittedSlot> = vec![];
    for frame in frames {
        for (place, slot) in frame.slots_alone().iter().enumerate() {
            let own = smallest_kind(&slot.words);
            match kinds.get_mut(place) {
                None => kinds.push(own),
                Some(kind) if kind.kind != own.kind => *kind = FittedSlot::NONE,
                Some(kind) => *kind = kind.or(&own),
            }
        }
    }
    kinds
}

/// What a part needs of the smallest processor that draws it: a surface of a patch processor.
fn smallest_kind(words: &ProcessorWords) -> FittedSlot {
    required(&own_kind(words.clone())).unwrap_or(FittedSlot::NONE)
}

/// The published mode of a size, or one with a short blanking.
fn mode((width, height): (u32, u32)) -> Mode {
    let (width, height) = (u64::from(width), u64::from(height));
    let is_of_size = |mode: &VideoMode| (mode.line.active, mode.frame.active) == (width, height);
    if VideoMode::ALL.iter().any(is_of_size) {
        return Mode::Named(format!("{width}x{height}"));
    }
    let span = |active: u64, [front, sync, back]: [u64; 3]| [active, front, sync, back];
    Mode::Own(OwnMode {
        columns: span(width, BLANKING[0]),
        lines: span(height, BLANKING[1]),
        hsync_high: false,
        vsync_high: false,
    })
}

fn scenes<'a>(frames: &'a Frames, drawn: &'a Drawn) -> Vec<(&'a FramedScene, &'a PreparedScene)> {
    let scenes = frames.all.iter().map(|frame| &frame.scene);
    scenes.zip(&drawn.prepared).collect()
}

impl Pace {
    /// Refuses what is too slow; of a beam machine with the pixels per clock that would do.
    fn check(
        self,
        clocks: u64,
        frame: &Frame,
        beam: Option<&MachineDescription>,
    ) -> Result<(), FitError> {
        let fastest = self.mhz * 1e6 / clocks as f64;
        if fastest >= self.frames {
            return Ok(());
        }
        let more = beam.and_then(|beam| self.lanes(fastest, beam));
        Err(FitError::Slow {
            scene: frame.name.clone(),
            wanted: self.frames,
            mhz: self.mhz,
            fastest,
            remedy: more.map_or(String::new(), |more| {
                format!("; --pixels-per-clock {more} would do")
            }),
        })
    }

    /// Pixels per clock with which a beam machine would be fast enough.
    fn lanes(self, fastest: f64, beam: &MachineDescription) -> Option<u32> {
        let of_one = fastest / f64::from(beam.pixels_per_clock);
        [2, 4].into_iter().find(|&pixels_per_clock| {
            let machine = MachineDescription {
                pixels_per_clock,
                output: Output::Stream,
                ..beam.clone()
            };
            of_one * f64::from(pixels_per_clock) >= self.frames && machine.check("").is_ok()
        })
    }
}

/// Clocks of a frame; those of several pixels at once are fewer.
fn screen_clocks(description: &MachineDescription) -> u64 {
    let clocks = description.video_mode().map_or(0, |mode| mode.clocks());
    clocks / u64::from(description.pixels_per_clock)
}

/// The zone machine of the fewest cells that is fast enough, with the side of its zones at which it is fastest: objects
/// go to processors of quadrics wherever these draw them, or each to the smallest that draws it.
fn of_zones(
    smallest: &MachineDescription,
    frames: &Frames,
    drawn: &Drawn,
    pace: Option<Pace>,
    timing: &dyn Fn(&MachineDescription) -> ZoneTiming,
) -> Result<Fitted, FitError> {
    let mut tried: Vec<(MachineDescription, Vec<InZones>)> = vec![];
    let parts = drawn.prepared.iter().flat_map(PreparedScene::slots_alone);
    let own = one_of_each(parts.map(|part| smallest_kind(&part.words)));
    let has_others = own.iter().any(|slot| slot.kind != Kind::Quadric);
    let mut kinds = vec![None];
    kinds.extend(has_others.then_some(Some(Slots(own))));
    for slots in kinds {
        let one = MachineDescription {
            machine: MachineKind::Zone,
            objects: 1,
            slots,
            ..with_side(smallest, SIDES[0])
        };
        let refused = |source| frames.all[0].refused(source);
        let base = enough(&one, &scenes(frames, drawn)).map_err(refused)?;
        // Words that do not follow from the depth word are for quadrics and patches alone.
        if !tried.is_empty() && base.check("").is_err() {
            continue;
        }
        let in_zones = |side| Ok((side, plans(&base, side, frames, drawn)?));
        let plans: Result<_, FitError> = SIDES.into_iter().map(in_zones).collect();
        tried.push((base, plans?));
    }
    let mut machines = vec![];
    for (base, plans) in &tried {
        for objects in PROCESSORS {
            // Beside the processors of products.
            let machine = base.zone_machine().with_processors(objects);
            let slots = [machine.slots, machine.layers].concat();
            let machine = MachineDescription {
                objects: slots.len(),
                slots: base.slots.is_some().then_some(Slots(slots)),
                ..base.clone()
            };
            for volumes in PROCESSORS {
                if base.volumes > 0 || volumes == 1 {
                    let mut machine = machine.clone();
                    machine.volumes = volumes.min(base.volumes * volumes);
                    machines.push((machine, plans));
                }
            }
        }
    }
    machines.sort_by(|(a, _), (b, _)| cells(a).total_cmp(&cells(b)));
    let mut slower: Vec<Fitted> = vec![];
    for (machine, plans) in machines {
        let found = in_zones(machine, plans, timing);
        if pace.is_none_or(|pace| found.clocks as f64 * pace.frames <= pace.mhz * 1e6) {
            return Ok(found);
        }
        slower.push(found);
    }
    let fastest = slower.into_iter().min_by_key(|found| found.clocks);
    let fastest = fastest.expect("a machine was tried");
    let pace = pace.expect("without a pace the first machine does");
    pace.check(fastest.clocks, &frames.all[0], None)?;
    Ok(fastest)
}

pub(crate) fn with_side(machine: &MachineDescription, side: u32) -> MachineDescription {
    let (width, height) = (side, side);
    MachineDescription {
        zone: Some(ZoneSize { width, height }),
        ..machine.clone()
    }
}

fn plans(
    base: &MachineDescription,
    side: u32,
    frames: &Frames,
    drawn: &Drawn,
) -> Result<Vec<ZonePlan>, FitError> {
    let machine = with_side(base, side).zone_machine();
    let plan = |(frame, prepared): (&Frame, &PreparedScene)| {
        let plan = ZonePlan::of(prepared, machine.clone());
        plan.map_err(|source| frame.refused(DisplayError::Plan(source)))
    };
    frames.all.iter().zip(&drawn.prepared).map(plan).collect()
}

/// Side of zones, and the frames in them.
type InZones = (u32, Vec<ZonePlan>);

/// A machine with the side of its zones at which its slowest frame is fastest.
fn in_zones(
    machine: MachineDescription,
    plans: &[InZones],
    timing: &dyn Fn(&MachineDescription) -> ZoneTiming,
) -> Fitted {
    let timing = timing(&machine);
    let slowest = |(side, plans): &InZones| {
        let of_frame = |plan: &ZonePlan| {
            let mut plan = plan.clone();
            plan.machine = with_side(&machine, *side).zone_machine();
            clocks(&plan, &timing).total
        };
        plans.iter().map(of_frame).max().unwrap_or(0)
    };
    let timed = plans.iter().map(|of| (slowest(of), of.0)).min();
    let (clocks, side) = timed.expect("there are sides");
    Fitted {
        clocks: clocks.max(screen_clocks(&machine)),
        description: with_side(&machine, side),
    }
}

/// Logic cells around an object processor at 24 bits: its store of words and its node of the decider.
const AROUND_SLOT: f64 = 210.0;

fn cells(machine: &MachineDescription) -> f64 {
    let of = |slot: &FittedSlot| estimate::of_slot(&machine.words(), slot);
    let around = AROUND_SLOT / 24.0 * f64::from(machine.depth_word);
    let objects: f64 = machine.slots().iter().map(|slot| of(slot) + around).sum();
    let volume = of(&FittedSlot::quadric(machine.volume_planes as u32));
    objects + machine.volumes as f64 * volume
}
