//! Machines: object processors of any words and slots, and everything between them and the picture.

use super::words::{check_slots, check_words, lines, slots_line};
use super::{Emitted, Heading, check_prefix, emitted};
use imogene_circuits::arith::Network;
use imogene_circuits::machine::{
    BeamMachine, Load, Objects, Volumes, Zone, ZoneCore, ZoneMachine, beam,
};
use imogene_circuits::machines;
use imogene_circuits::object::Widths;
pub use imogene_circuits::shade::Tables;
use imogene_circuits::shade::{Lights, Shading};
pub use imogene_circuits::video::Output;
pub use imogene_contract::MachineWords;
use imogene_contract::object::ProductSlots;
use imogene_contract::request::in_range;
use imogene_contract::slots::FittedSlot;
use imogene_contract::words::{MOST_LAYERS, MOST_LIGHTS, MOST_MEMBERS, MOST_OBJECTS, MOST_PLANES};
use imogene_contract::{DeciderForm, RequestError, Unit};
use imogene_hdl::Design;

/// Bits of the address of a pixel in a zone, at most.
const ZONE_BITS: u32 = 14;
/// Bits of the address of a word that waits for the next frame, at most.
const LOADER_BITS: u32 = 16;

/// What a zone machine has beside its processors.
#[derive(Clone, Copy, Debug)]
pub struct ZoneShape {
    /// Bits of the address of a pixel in a zone.
    pub zone_bits: usize,
    /// Samples of a pixel along each side: 1, 2 or 4.
    pub samples: usize,
}

/// Which machine.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// The deciding part of a beam machine: visible surfaces, not shaded.
    Beam,
    /// The deciding part of a zone machine: visible surfaces, not shaded.
    ZoneCore(ZoneShape),
    /// A zone machine: shaded pixels over AXI4-Stream.
    ZoneMachine(ZoneShape),
    /// A zone machine with its screen.
    ZoneDisplay(ZoneShape, Output),
    /// A beam machine with its screen: bits of the address of a word that waits for the vertical blanking, screen.
    BeamDisplay(usize, Output),
    /// A beam machine that streams its picture: the same bits, pixels of a line, lines.
    BeamStream(usize, usize, usize),
}

/// A machine.
#[derive(Clone, Debug)]
pub struct MachineRequest {
    /// Which machine.
    pub kind: Kind,
    /// The words of its processors.
    pub words: MachineWords,
    /// Rows of the root networks between registers.
    pub rows_per_stage: usize,
    /// Object processors, in a beam machine one for each object.
    pub slots: Vec<FittedSlot>,
    /// Products of solids, whose slots are the last, product by product.
    pub products: Vec<ProductSlots>,
    /// How the nearest is chosen.
    pub decider: DeciderForm,
    /// Slots of transparent objects, of a machine that shades alone; their numbers follow those of `slots`.
    pub layers: Vec<FittedSlot>,
    /// Volume processors, in a beam machine one for each volume; may be none. A deciding beam has none.
    pub volumes: usize,
    /// Planes of each.
    pub volume_planes: usize,
    /// Its lights, none of a machine with plain colours, or whose tables have all of them; a deciding part has none.
    pub lights: usize,
    /// Of these, the last ones that are directional alone.
    pub suns: usize,
    /// Lit-sphere shading in the place of a shading processor; lights number the tables of a material.
    pub sphere: Option<Tables>,
    /// Pixels of a line that a beam machine that streams draws at once: 1, 2 or 4.
    pub pixels_per_clock: usize,
    /// Graphics modules of a beam machine that streams, 1, 2 or 4: of n modules each draws every n-th line.
    pub modules: usize,
    /// A frame is a field of two: the lines of a module are as many times two apart.
    pub interlaced: bool,
    /// Before the name of every module; may be empty.
    pub prefix: String,
    /// The command line that makes the same text, for the header.
    pub command: String,
}

impl Kind {
    /// True if it shades what it decides.
    fn is_shaded(&self) -> bool {
        !matches!(self, Self::Beam | Self::ZoneCore(_))
    }

    fn zone(&self) -> Option<&ZoneShape> {
        match self {
            Self::ZoneCore(zone) | Self::ZoneMachine(zone) | Self::ZoneDisplay(zone, _) => {
                Some(zone)
            }
            _ => None,
        }
    }

    fn output(&self) -> Option<&Output> {
        match self {
            Self::ZoneDisplay(_, output) | Self::BeamDisplay(_, output) => Some(output),
            _ => None,
        }
    }

    fn loader_bits(&self) -> Option<usize> {
        match *self {
            Self::BeamDisplay(bits, _) | Self::BeamStream(bits, ..) => Some(bits),
            _ => None,
        }
    }

    fn contract(&self) -> &'static str {
        match self {
            Self::Beam => {
                "the visible surface of the objects of a scene, in the words and slots that the scene requires"
            }
            Self::ZoneCore(_) => {
                "visible surfaces of a scene of any number of objects, zone by zone"
            }
            Self::ZoneMachine(_) => {
                "shaded pixels of a scene of any number of objects, zone by zone"
            }
            Self::ZoneDisplay(..) => {
                "the picture of a scene of any number of objects, drawn zone by zone, on the pins of a screen"
            }
            Self::BeamDisplay(..) => {
                "the picture of a scene, every pixel drawn when the screen wants it, on the pins of a screen"
            }
            Self::BeamStream(..) => {
                "the picture of a scene, frame after frame over AXI4-Stream, at the pace that it is built for"
            }
        }
    }
}

impl MachineRequest {
    /// The deciding part of a beam machine, fitted to a scene.
    pub fn fitted(
        words: MachineWords,
        rows_per_stage: usize,
        slots: Vec<FittedSlot>,
    ) -> MachineRequest {
        MachineRequest {
            kind: Kind::Beam,
            words,
            rows_per_stage,
            slots,
            products: vec![],
            decider: DeciderForm::Tree,
            layers: vec![],
            volumes: 0,
            volume_planes: 0,
            lights: 1,
            suns: 0,
            sphere: None,
            pixels_per_clock: 1,
            modules: 1,
            interlaced: false,
            prefix: String::new(),
            command: String::new(),
        }
    }

    fn check(&self) -> Result<(), RequestError> {
        check_words(&self.words, self.rows_per_stage)?;
        check_slots(&self.slots, &self.words)?;
        self.check_products()?;
        let most_layers = MOST_LAYERS * u32::from(self.kind.is_shaded());
        in_range("layers", self.layers.len(), 0, most_layers)?;
        in_range("volumes", self.volumes, 0, MOST_OBJECTS)?;
        in_range("volume planes", self.volume_planes, 0, MOST_PLANES)?;
        in_range("lights", self.lights, 0, MOST_LIGHTS)?;
        in_range("suns", self.suns, 0, self.lights as u32)?;
        if let Some(bits) = self.kind.loader_bits() {
            in_range("loader bits", bits, 1, LOADER_BITS)?;
        }
        if let Some(zone) = self.kind.zone() {
            in_range("zone bits", zone.zone_bits, 1, ZONE_BITS)?;
            // 3 is the only number between the least and the greatest that is none.
            let most = if zone.samples == 3 { 2 } else { 4 };
            in_range("samples", zone.samples, 1, most)?;
        }
        self.check_lanes()?;
        if self.words.clocks_per_pixel() > 1 && !self.is_serial() {
            return Err(RequestError::Serial);
        }
        match self.prefix.as_str() {
            "" => Ok(()),
            prefix => check_prefix(prefix),
        }
    }

    /// True if it can wait between pixels.
    fn is_serial(&self) -> bool {
        matches!(self.kind, Kind::BeamStream(..)) && self.pixels_per_clock == 1
    }

    fn check_lanes(&self) -> Result<(), RequestError> {
        let lanes = self.pixels_per_clock;
        let Kind::BeamStream(bits, width, height) = self.kind else {
            in_range("graphics modules", self.modules, 1, 1)?;
            return in_range("pixels per clock", lanes, 1, 1);
        };
        // 3 is the only number between the least and the greatest that is none.
        in_range("pixels per clock", lanes, 1, if lanes == 3 { 2 } else { 4 })?;
        let rest = width % lanes;
        in_range("pixels of a line beyond the last whole clock", rest, 0, 0)?;
        let modules = self.modules;
        in_range(
            "graphics modules",
            modules,
            1,
            if modules == 3 { 2 } else { 4 },
        )?;
        in_range(
            "lines beyond the last of all modules",
            height % modules,
            0,
            0,
        )?;
        if modules > 1 {
            let rest = width % (lanes * modules);
            in_range("pixels of a line beyond the last that leave", rest, 0, 0)?;
            in_range(
                "clocks in which a line leaves",
                width / (lanes * modules),
                2,
                u32::MAX,
            )?;
        }
        let least = self.beam(bits).least_line();
        in_range("clocks of a line", width / lanes, least, u32::MAX)
    }

    fn check_products(&self) -> Result<(), RequestError> {
        let members: usize = self.products.iter().map(ProductSlots::count).sum();
        in_range("slots of products", members, 0, self.slots.len() as u32)?;
        self.products.iter().try_for_each(|product| {
            in_range("objects intersected", product.intersected, 1, MOST_MEMBERS)?;
            in_range("objects taken away", product.subtracted, 0, MOST_MEMBERS)
        })
    }

    fn objects(&self) -> Objects {
        Objects {
            words: self.words,
            rows_per_stage: self.rows_per_stage as u32,
            slots: self.slots.clone(),
            products: self.products.clone(),
            decider: self.decider,
            lanes: self.pixels_per_clock as u32,
        }
    }

    fn core(&self, zone: &ZoneShape) -> ZoneCore {
        let beam = self.beam(0);
        ZoneCore {
            ahead: ZoneMachine::ahead(&beam.objects, &self.layers),
            objects: beam.objects,
            volumes: beam.volumes,
            places: zone.zone_bits as u32,
        }
    }

    fn shading(&self) -> Shading {
        Shading {
            lights: Lights {
                count: self.lights as u64,
                suns: self.suns as u64,
            },
            tables: self.sphere.clone(),
        }
    }

    fn zone(&self, zone: &ZoneShape) -> ZoneMachine {
        ZoneMachine {
            core: self.core(zone),
            layers: self.layers.clone(),
            samples: zone.samples as u32,
            shading: self.shading(),
        }
    }

    fn beam(&self, loader_bits: usize) -> BeamMachine {
        BeamMachine {
            objects: self.objects(),
            layers: self.layers.clone(),
            volumes: Volumes {
                widths: Widths::of(&self.words),
                root: Network::of(&self.words, self.rows_per_stage as u32),
                planes: vec![self.volume_planes as u64; self.volumes],
                lanes: self.pixels_per_clock as u32,
            },
            shading: self.shading(),
            loader_places: loader_bits as u32,
            modules: self.modules as u32,
            line_shift: (self.modules << usize::from(self.interlaced))
                .ilog2()
                .saturating_sub(1),
        }
    }

    /// Clocks of what is fixed in the machine.
    ///
    /// # Errors
    ///
    /// When a number is out of its range.
    pub fn clocks(&self) -> Result<MachineClocks, RequestError> {
        self.check()?;
        let mut clocks = MachineClocks {
            output: self.kind.output().map_or(0, Output::latency) as usize,
            ..MachineClocks::default()
        };
        match self.kind.zone() {
            Some(zone) => {
                let core = self.core(zone);
                clocks.draw = core.draw_clocks() as usize;
                clocks.light = core.light_clocks() as usize;
                clocks.show = core.show_clocks() as usize;
                clocks.settle = core.settle_clocks() as usize;
            }
            None if matches!(self.kind, Kind::Beam) => {
                clocks.pixel = self.objects().latency() as usize;
            }
            None => clocks.pixel = self.beam(0).latency() as usize,
        }
        Ok(clocks)
    }

    /// The circuit of the machine.
    ///
    /// # Errors
    ///
    /// When a number is out of its range, or a prefix begins no identifier.
    pub fn design(&self) -> Result<Design, RequestError> {
        self.check()?;
        Ok(match &self.kind {
            Kind::Beam => {
                let objects = self.objects();
                Design::of(|| beam("top", Zone::input(), Load::input(objects.bus()), &objects))
            }
            Kind::ZoneCore(zone) => machines::zone_core(&self.core(zone)),
            Kind::ZoneMachine(zone) => machines::zone_machine(&self.zone(zone)),
            Kind::ZoneDisplay(zone, output) => machines::zone_display(&self.zone(zone), output),
            Kind::BeamDisplay(bits, output) => machines::beam_display(&self.beam(*bits), output),
            Kind::BeamStream(bits, width, height) => {
                machines::beam_stream(&self.beam(*bits), (*width as u64, *height as u64))
            }
        })
    }

    fn parameters(&self) -> Vec<String> {
        let mut lines = lines(&self.words, self.rows_per_stage);
        lines.push(slots_line(&self.slots));
        if !self.layers.is_empty() {
            lines.push(format!("transparent: {}", slots_line(&self.layers)));
        }
        lines.extend(self.products.iter().map(|product| {
            let (all, less) = (product.intersected, product.subtracted);
            format!("a product of {all} objects less {less}, in the last slots")
        }));
        if !self.decider.is_usual() {
            lines.push(format!("decider {}", self.decider));
        }
        if matches!(self.kind, Kind::Beam) {
            return lines;
        }
        let (volumes, planes) = (self.volumes, self.volume_planes);
        lines.push(format!("{volumes} volume processors of {planes} planes"));
        if let Some(ZoneShape { zone_bits, samples }) = self.kind.zone() {
            lines.push(format!("zones of up to {} pixels", 1usize << zone_bits));
            if *samples > 1 {
                lines.push(format!("{samples} x {samples} samples of a pixel"));
            }
        }
        let loader = self.kind.loader_bits();
        lines.extend(loader.map(|bits| format!("{} words of the next frame", 1usize << bits)));
        if !matches!(self.kind, Kind::ZoneCore(_)) {
            lines.push(format!("{} lights", self.lights));
            lines.extend(self.sphere.iter().map(|tables| {
                let (side, count) = (1 << tables.places, tables.count);
                let nearest = if tables.nearest {
                    ", the nearest taken"
                } else {
                    ""
                };
                format!("{count} lit-sphere tables of {side} x {side} entries{nearest}")
            }));
            if self.suns > 0 {
                lines.push(format!("the last {} directional", self.suns));
            }
        }
        if let Some(output) = self.kind.output() {
            let (width, height) = (output.mode.line.active, output.mode.frame.active);
            let smoothing = ["none", "2 x 2", "3 x 3"][output.kernel.min(2) as usize];
            let overlay = if output.has_overlay { "yes" } else { "no" };
            lines.push(format!("screen of {width} x {height} pixels"));
            lines.push(format!("smoothing {smoothing}, overlay {overlay}"));
        }
        if let Kind::BeamStream(_, width, height) = self.kind {
            let lanes = self.pixels_per_clock * self.modules;
            if self.modules > 1 {
                lines.push(format!("{} graphics modules", self.modules));
            }
            let pace = match self.words.clocks_per_pixel() {
                1 => format!("{lanes} per clock"),
                clocks if lanes == 1 => format!("one every {clocks} clocks"),
                clocks => format!("{lanes} every {clocks} clocks"),
            };
            lines.push(format!("pictures of {width} x {height} pixels, {pace}"));
        }
        lines
    }
}

/// Clocks that a machine takes besides those of its pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MachineClocks {
    /// Of a drawing pass of a zone machine.
    pub draw: usize,
    /// Of a lighting pass.
    pub light: usize,
    /// Of a showing pass.
    pub show: usize,
    /// From a drawing or lighting command until words of processors are taken again.
    pub settle: usize,
    /// From a pixel that a beam machine wants to its colour.
    pub pixel: usize,
    /// From the scan of a screen to its pins.
    pub output: usize,
}

/// The Verilog of a machine.
///
/// # Errors
///
/// When a number is out of its range, or a prefix begins no identifier.
pub fn emit_machine(request: &MachineRequest) -> Result<Emitted, RequestError> {
    let design = request.design()?;
    let (error, source) = match request.kind {
        Kind::Beam => (
            "exact in its integer words; the contract beside it states how far they are from the scene",
            "architecture, 7",
        ),
        _ => (Unit::Beam.record().error, "machines"),
    };
    let heading = Heading {
        contract: request.kind.contract(),
        parameters: request.parameters(),
        error,
        source,
        command: &request.command,
    };
    let latency = request.clocks()?.pixel;
    Ok(emitted(&design, &request.prefix, latency, &heading))
}
