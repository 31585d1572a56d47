//! Machines with everything between the object processors and the picture.

use super::words::{check_ranges, check_slots, check_words, lines, slots_line};
use super::{Emitted, Heading, circuit, names};
use crate::format::{MOST_LIGHTS, MOST_OBJECTS, MOST_PLANES};
pub use imogene_circuits::machine::Slot;
use imogene_circuits::machine::{BeamMachine, SHOW_CLOCKS, ZoneCore, ZoneMachine};
pub use imogene_circuits::machines::MachineWords;
use imogene_circuits::machines::{self, objects, volumes};
use imogene_circuits::video::Output;
use imogene_contract::RequestError;
use imogene_contract::video::VideoMode;
use imogene_hdl::Design;

/// Bits of the address of a pixel in a zone, at most.
pub const ZONE_BITS: usize = 14;
/// Bits of the address of a word that waits for the next frame, at most.
pub const LOADER_BITS: usize = 16;

/// The processors of a machine.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Processors {
    /// Their words.
    pub words: MachineWords,
    /// Rows of the root networks between registers.
    pub rows_per_stage: usize,
    /// Object processors, in a beam machine one for each object.
    pub slots: Vec<Slot>,
    /// Volume processors, in a beam machine one for each volume; may be none.
    pub volumes: usize,
    /// Planes of each.
    pub volume_planes: usize,
}

/// What a zone machine has beside its processors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ZoneShape {
    /// Bits of the address of a pixel in a zone.
    pub zone_bits: usize,
    /// Samples of a pixel along each side: 1, 2 or 4.
    pub samples: usize,
}

/// What stands between the pixels of a machine and its pins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct OutputShape {
    /// Video mode.
    pub mode: VideoMode,
    /// Smoothing: 0 none, 1 box of 2 x 2, 2 binomial of 3 x 3.
    pub kernel: usize,
    /// An overlay plane over the picture.
    pub has_overlay: bool,
}

impl OutputShape {
    /// Pixels of a line.
    pub fn width(&self) -> usize {
        self.mode.line.active as usize
    }

    /// Lines.
    pub fn height(&self) -> usize {
        self.mode.frame.active as usize
    }

    fn output(&self) -> Output {
        Output {
            mode: self.mode,
            kernel: self.kernel as u64,
            has_overlay: self.has_overlay,
        }
    }
}

/// Which machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DisplayKind {
    /// The deciding part of a zone machine: visible surfaces, not shaded.
    ZoneCore(ZoneShape),
    /// A zone machine: shaded pixels over AXI4-Stream.
    ZoneMachine(ZoneShape),
    /// A zone machine with its screen.
    ZoneDisplay(ZoneShape, OutputShape),
    /// A beam machine with its screen: bits of the address of a word that waits for the vertical blanking, screen.
    BeamDisplay(usize, OutputShape),
    /// A beam machine that streams its picture: the same bits, pixels of a line, lines.
    BeamStream(usize, usize, usize),
}

/// A machine.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct DisplayRequest {
    /// Which machine.
    pub kind: DisplayKind,
    /// Its processors.
    pub processors: Processors,
    /// Its lights; the deciding part has none.
    pub lights: usize,
    /// Before the name of every module; may be empty.
    pub prefix: String,
    /// The command line that makes the same text, for the header.
    pub command: String,
}

impl DisplayKind {
    fn zone(&self) -> Option<&ZoneShape> {
        match self {
            Self::ZoneCore(zone) | Self::ZoneMachine(zone) | Self::ZoneDisplay(zone, _) => {
                Some(zone)
            }
            Self::BeamDisplay(..) | Self::BeamStream(..) => None,
        }
    }

    fn output(&self) -> Option<&OutputShape> {
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
                "the picture of a scene, frame after frame over AXI4-Stream, one pixel per clock"
            }
        }
    }
}

impl DisplayRequest {
    fn check(&self) -> Result<(), RequestError> {
        let own = &self.processors;
        check_words(&own.words, own.rows_per_stage)?;
        check_slots(&own.slots)?;
        check_ranges(&[
            ("volumes", own.volumes, 0, MOST_OBJECTS),
            ("volume planes", own.volume_planes, 0, MOST_PLANES),
            ("lights", self.lights, 1, MOST_LIGHTS),
        ])?;
        if let Some(bits) = self.kind.loader_bits() {
            check_ranges(&[("loader bits", bits, 1, LOADER_BITS)])?;
        }
        if let Some(zone) = self.kind.zone() {
            // 3 is the only number between the least and the greatest that is none.
            let most = if zone.samples == 3 { 2 } else { 4 };
            check_ranges(&[
                ("zone bits", zone.zone_bits, 1, ZONE_BITS),
                ("samples", zone.samples, 1, most),
            ])?;
        }
        names::check_optional(&self.prefix)
    }

    fn core(&self, zone: &ZoneShape) -> ZoneCore {
        let beam = self.beam(0);
        ZoneCore {
            objects: beam.objects,
            volumes: beam.volumes,
            places: zone.zone_bits as u32,
        }
    }

    fn zone(&self, zone: &ZoneShape) -> ZoneMachine {
        ZoneMachine {
            core: self.core(zone),
            samples: zone.samples as u32,
            lights: self.lights as u64,
        }
    }

    fn beam(&self, loader_bits: usize) -> BeamMachine {
        let own = &self.processors;
        let (words, rows) = (&own.words, own.rows_per_stage as u32);
        BeamMachine {
            objects: objects(words, rows, own.slots.clone()),
            volumes: volumes(words, rows, own.volumes, own.volume_planes as u64),
            lights: self.lights as u64,
            loader_places: loader_bits as u32,
        }
    }

    /// Clocks of what is fixed in the machine.
    ///
    /// # Errors
    ///
    /// When a number is out of its range.
    pub fn clocks(&self) -> Result<MachineClocks, RequestError> {
        self.check()?;
        let output = self.kind.output();
        let behind = MachineClocks {
            output: output.map_or(0, |output| output.output().latency() as usize),
            ..MachineClocks::default()
        };
        let Some(zone) = self.kind.zone() else {
            return Ok(MachineClocks {
                pixel: self.beam(0).latency() as usize,
                ..behind
            });
        };
        let core = self.core(zone);
        Ok(MachineClocks {
            draw: core.draw_clocks() as usize,
            light: core.light_clocks() as usize,
            show: SHOW_CLOCKS as usize,
            settle: core.settle_clocks() as usize,
            ..behind
        })
    }

    /// The circuit of the machine.
    ///
    /// # Errors
    ///
    /// When a number is out of its range.
    pub fn design(&self) -> Result<Design, RequestError> {
        self.check()?;
        Ok(match &self.kind {
            DisplayKind::ZoneCore(zone) => machines::zone_core(&self.core(zone)),
            DisplayKind::ZoneMachine(zone) => machines::zone_machine(&self.zone(zone)),
            DisplayKind::ZoneDisplay(zone, output) => {
                machines::zone_display(&self.zone(zone), &output.output())
            }
            DisplayKind::BeamDisplay(bits, output) => {
                machines::beam_display(&self.beam(*bits), &output.output())
            }
            DisplayKind::BeamStream(bits, width, height) => {
                machines::beam_stream(&self.beam(*bits), (*width as u64, *height as u64))
            }
        })
    }

    fn parameters(&self) -> Vec<String> {
        let own = &self.processors;
        let mut lines = lines(&own.words, own.rows_per_stage);
        lines.extend([
            slots_line(&own.slots),
            format!(
                "{} volume processors of {} planes",
                own.volumes, own.volume_planes
            ),
        ]);
        if let Some(zone) = self.kind.zone() {
            lines.push(format!(
                "zones of up to {} pixels",
                1usize << zone.zone_bits
            ));
            if zone.samples > 1 {
                lines.push(format!("{0} x {0} samples of a pixel", zone.samples));
            }
        }
        let loader = self.kind.loader_bits();
        lines.extend(loader.map(|bits| format!("{} words of the next frame", 1usize << bits)));
        if !matches!(self.kind, DisplayKind::ZoneCore(_)) {
            lines.push(format!("{} lights", self.lights));
        }
        if let Some(output) = self.kind.output() {
            let smoothing = ["none", "2 x 2", "3 x 3"][output.kernel.min(2)];
            let overlay = if output.has_overlay { "yes" } else { "no" };
            lines.push(format!(
                "screen of {} x {} pixels",
                output.width(),
                output.height()
            ));
            lines.push(format!("smoothing {smoothing}, overlay {overlay}"));
        }
        if let DisplayKind::BeamStream(_, width, height) = self.kind {
            lines.push(format!("pictures of {width} x {height} pixels"));
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
pub fn emit_display(request: &DisplayRequest) -> Result<Emitted, RequestError> {
    let design = request.design()?;
    let clocks = request.clocks()?;
    let ports = circuit::ports(&design);
    let top = format!("{}{}", request.prefix, design.top.name);
    let heading = Heading {
        top: &top,
        contract: request.kind.contract(),
        parameters: request.parameters(),
        latency: clocks.pixel,
        error: "exact in its integer words; imogene check SCENE bounds what the rounding of a scene to those words costs",
        source: "machines",
        ports: &ports,
        command: &request.command,
    };
    let header = heading.text();
    Ok(Emitted {
        header,
        modules: circuit::modules(&design, &request.prefix),
        top,
        ports,
        latency: clocks.pixel,
    })
}

#[cfg(test)]
mod tests;
