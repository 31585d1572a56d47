//! Machines with everything between the object processors and the picture.

use super::{EmitError, Emitted, Heading, circuit, names};
use crate::format::{DEPTH_WORDS, MOST_LIGHTS, MOST_OBJECTS, MOST_PLANES};
use imogene_circuits::machine::{BeamMachine, SHOW_CLOCKS, ZoneCore, ZoneMachine};
use imogene_circuits::machines;
use imogene_circuits::video::Output;
use imogene_contract::video::VideoMode;
use imogene_hdl::Design;

/// Bits of the address of a pixel in a zone, at most.
pub const ZONE_BITS: usize = 14;
/// Bits of the address of a word that waits for the next frame, at most.
pub const LOADER_BITS: usize = 16;

/// How many processors of what kind a zone machine has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ZoneShape {
    /// Object processors.
    pub objects: usize,
    /// Cut planes of each.
    pub planes: usize,
    /// Volume processors; may be none.
    pub volumes: usize,
    /// Planes of each.
    pub volume_planes: usize,
    /// Rows of the root networks between registers.
    pub rows_per_stage: usize,
    /// Bits of the address of a pixel in a zone.
    pub zone_bits: usize,
    /// Samples of a pixel along each side: 1, 2 or 4.
    pub samples: usize,
}

/// How many processors of what kind a beam machine has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BeamShape {
    /// Object processors, one for each object.
    pub objects: usize,
    /// Cut planes of each.
    pub planes: usize,
    /// Volume processors, one for each shadow or light volume; may be none.
    pub volumes: usize,
    /// Planes of each.
    pub volume_planes: usize,
    /// Rows of the root networks between registers.
    pub rows_per_stage: usize,
    /// Bits of the address of a word that waits for the vertical blanking.
    pub loader_bits: usize,
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

impl ZoneShape {
    fn core(&self, depth_word: usize) -> ZoneCore {
        let (word, rows) = (depth_word as u32, self.rows_per_stage as u32);
        let [objects, planes] = [self.objects, self.planes].map(|count| count as u32);
        let [volumes, volume_planes] = [self.volumes, self.volume_planes].map(|count| count as u32);
        ZoneCore {
            objects: machines::objects(word, rows, objects, planes),
            volumes: machines::volumes(word, rows, volumes, volume_planes),
            places: self.zone_bits as u32,
        }
    }

    fn machine(&self, depth_word: usize, lights: usize) -> ZoneMachine {
        ZoneMachine {
            core: self.core(depth_word),
            samples: self.samples as u32,
            lights: lights as u64,
        }
    }
}

impl BeamShape {
    fn machine(&self, depth_word: usize, lights: usize) -> BeamMachine {
        let (word, rows) = (depth_word as u32, self.rows_per_stage as u32);
        let [objects, planes] = [self.objects, self.planes].map(|count| count as u32);
        let [volumes, volume_planes] = [self.volumes, self.volume_planes].map(|count| count as u32);
        BeamMachine {
            objects: machines::objects(word, rows, objects, planes),
            volumes: machines::volumes(word, rows, volumes, volume_planes),
            lights: lights as u64,
            loader_places: self.loader_bits as u32,
        }
    }
}

/// Which machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DisplayKind {
    /// The deciding part of a zone machine: visible surfaces, not shaded.
    ZoneCore(ZoneShape),
    /// A zone machine: shaded pixels over AXI4-Stream.
    ZoneMachine(ZoneShape, usize),
    /// A zone machine with its screen: shape, lights, screen.
    ZoneDisplay(ZoneShape, usize, OutputShape),
    /// A beam machine with its screen: shape, lights, screen.
    BeamDisplay(BeamShape, usize, OutputShape),
    /// A beam machine that streams its picture: shape, lights, pixels of a line, lines.
    BeamStream(BeamShape, usize, usize, usize),
}

/// A machine.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct DisplayRequest {
    /// Which machine.
    pub kind: DisplayKind,
    /// Depth word `W`, of the catalogue.
    pub depth_word: usize,
    /// Before the name of every module; may be empty.
    pub prefix: String,
    /// The command line that makes the same text, for the header.
    pub command: String,
}

fn range(
    parameter: &'static str,
    value: usize,
    least: usize,
    most: usize,
) -> Result<(), EmitError> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(EmitError::Range {
        parameter,
        value,
        least,
        most,
    })
}

impl DisplayRequest {
    fn check(&self) -> Result<(), EmitError> {
        if !DEPTH_WORDS.contains(&self.depth_word) {
            return Err(EmitError::Format {
                value: self.depth_word,
            });
        }
        let processors = |objects, planes, volumes, volume_planes, rows| {
            range("objects", objects, 1, MOST_OBJECTS)?;
            range("planes", planes, 0, MOST_PLANES)?;
            range("volumes", volumes, 0, MOST_OBJECTS)?;
            range("volume planes", volume_planes, 0, MOST_PLANES)?;
            range("rows per stage", rows, 1, self.depth_word)
        };
        let zone = |s: &ZoneShape| {
            processors(
                s.objects,
                s.planes,
                s.volumes,
                s.volume_planes,
                s.rows_per_stage,
            )?;
            range("zone bits", s.zone_bits, 1, ZONE_BITS)?;
            if [1, 2, 4].contains(&s.samples) {
                return Ok(());
            }
            range("samples", s.samples, 1, 2)
        };
        match &self.kind {
            DisplayKind::ZoneCore(shape) => zone(shape),
            DisplayKind::ZoneMachine(shape, lights)
            | DisplayKind::ZoneDisplay(shape, lights, _) => {
                range("lights", *lights, 1, MOST_LIGHTS)?;
                zone(shape)
            }
            DisplayKind::BeamDisplay(s, lights, _) | DisplayKind::BeamStream(s, lights, ..) => {
                range("lights", *lights, 1, MOST_LIGHTS)?;
                range("loader bits", s.loader_bits, 1, LOADER_BITS)?;
                processors(
                    s.objects,
                    s.planes,
                    s.volumes,
                    s.volume_planes,
                    s.rows_per_stage,
                )
            }
        }?;
        if self.prefix.is_empty() {
            Ok(())
        } else {
            names::check_prefix(&self.prefix)
        }
    }

    /// Clocks of what is fixed in the machine.
    ///
    /// # Errors
    ///
    /// When a number is out of its range.
    pub fn clocks(&self) -> Result<MachineClocks, EmitError> {
        self.check()?;
        let word = self.depth_word;
        let zone = |shape: &ZoneShape| {
            let core = shape.core(word);
            MachineClocks {
                draw: core.draw_clocks() as usize,
                light: core.light_clocks() as usize,
                show: SHOW_CLOCKS as usize,
                settle: core.settle_clocks() as usize,
                ..MachineClocks::default()
            }
        };
        let beam = |shape: &BeamShape, lights: usize| MachineClocks {
            pixel: shape.machine(word, lights).latency() as usize,
            ..MachineClocks::default()
        };
        Ok(match &self.kind {
            DisplayKind::ZoneCore(shape) | DisplayKind::ZoneMachine(shape, _) => zone(shape),
            DisplayKind::ZoneDisplay(shape, _, output) => MachineClocks {
                output: output.output().latency() as usize,
                ..zone(shape)
            },
            DisplayKind::BeamStream(shape, lights, ..) => beam(shape, *lights),
            DisplayKind::BeamDisplay(shape, lights, output) => MachineClocks {
                output: output.output().latency() as usize,
                ..beam(shape, *lights)
            },
        })
    }

    /// The circuit of the machine.
    ///
    /// # Errors
    ///
    /// When a number is out of its range.
    pub fn design(&self) -> Result<Design, EmitError> {
        self.check()?;
        let word = self.depth_word;
        Ok(match &self.kind {
            DisplayKind::ZoneCore(shape) => machines::zone_core(&shape.core(word)),
            DisplayKind::ZoneMachine(shape, lights) => {
                machines::zone_machine(&shape.machine(word, *lights))
            }
            DisplayKind::ZoneDisplay(shape, lights, output) => {
                machines::zone_display(&shape.machine(word, *lights), &output.output())
            }
            DisplayKind::BeamDisplay(shape, lights, output) => {
                machines::beam_display(&shape.machine(word, *lights), &output.output())
            }
            DisplayKind::BeamStream(shape, lights, width, height) => {
                let size = (*width as u64, *height as u64);
                machines::beam_stream(&shape.machine(word, *lights), size)
            }
        })
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
pub fn emit_display(request: &DisplayRequest) -> Result<Emitted, EmitError> {
    let design = request.design()?;
    let clocks = request.clocks()?;
    let ports = circuit::ports(&design);
    let top = format!("{}{}", request.prefix, design.top.name);
    let heading = Heading {
        top: &top,
        contract: request.contract(),
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

impl DisplayRequest {
    fn contract(&self) -> &'static str {
        match self.kind {
            DisplayKind::ZoneCore(_) => {
                "visible surfaces of a scene of any number of objects, zone by zone"
            }
            DisplayKind::ZoneMachine(..) => {
                "shaded pixels of a scene of any number of objects, zone by zone"
            }
            DisplayKind::ZoneDisplay(..) => {
                "the picture of a scene of any number of objects, drawn zone by zone, on the pins of a screen"
            }
            DisplayKind::BeamDisplay(..) => {
                "the picture of a scene, every pixel drawn when the screen wants it, on the pins of a screen"
            }
            DisplayKind::BeamStream(..) => {
                "the picture of a scene, frame after frame over AXI4-Stream, one pixel per clock"
            }
        }
    }

    fn parameters(&self) -> Vec<String> {
        let mut lines = vec![format!("format {}", self.depth_word)];
        let mut processors = |objects, planes, volumes, volume_planes, rows| {
            lines.push(format!("{objects} object processors of {planes} planes"));
            lines.push(format!(
                "{volumes} volume processors of {volume_planes} planes"
            ));
            lines.push(format!("rows per stage {rows}"));
        };
        match &self.kind {
            DisplayKind::ZoneCore(s)
            | DisplayKind::ZoneMachine(s, _)
            | DisplayKind::ZoneDisplay(s, ..) => {
                processors(
                    s.objects,
                    s.planes,
                    s.volumes,
                    s.volume_planes,
                    s.rows_per_stage,
                );
                lines.push(format!("zones of up to {} pixels", 1usize << s.zone_bits));
                if s.samples > 1 {
                    lines.push(format!("{0} x {0} samples of a pixel", s.samples));
                }
            }
            DisplayKind::BeamDisplay(s, ..) | DisplayKind::BeamStream(s, ..) => {
                processors(
                    s.objects,
                    s.planes,
                    s.volumes,
                    s.volume_planes,
                    s.rows_per_stage,
                );
                lines.push(format!(
                    "{} words of the next frame",
                    1usize << s.loader_bits
                ));
            }
        }
        match &self.kind {
            DisplayKind::ZoneMachine(_, lights) => lines.push(format!("{lights} lights")),
            DisplayKind::ZoneDisplay(_, lights, o) | DisplayKind::BeamDisplay(_, lights, o) => {
                lines.push(format!("{lights} lights"));
                lines.push(format!("screen of {} x {} pixels", o.width(), o.height()));
                let smoothing = ["none", "2 x 2", "3 x 3"][o.kernel.min(2)];
                lines.push(format!(
                    "smoothing {smoothing}, overlay {}",
                    if o.has_overlay { "yes" } else { "no" }
                ));
            }
            DisplayKind::BeamStream(_, lights, width, height) => {
                lines.push(format!("{lights} lights"));
                lines.push(format!("pictures of {width} x {height} pixels"));
            }
            DisplayKind::ZoneCore(_) => {}
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ZONE: ZoneShape = ZoneShape {
        objects: 2,
        planes: 1,
        volumes: 1,
        volume_planes: 4,
        rows_per_stage: 4,
        zone_bits: 8,
        samples: 1,
    };
    const BEAM: BeamShape = BeamShape {
        objects: 2,
        planes: 1,
        volumes: 1,
        volume_planes: 4,
        rows_per_stage: 4,
        loader_bits: 8,
    };

    fn request(kind: DisplayKind) -> DisplayRequest {
        DisplayRequest {
            kind,
            depth_word: 24,
            prefix: String::new(),
            command: "a command".into(),
        }
    }

    #[test]
    fn machines_are_emitted() {
        let screen = |kernel, has_overlay| OutputShape {
            mode: VideoMode::VGA,
            kernel,
            has_overlay,
        };
        let kinds = [
            (DisplayKind::ZoneCore(ZONE), "zone_core"),
            (DisplayKind::ZoneMachine(ZONE, 2), "zone_machine"),
            (
                DisplayKind::ZoneMachine(ZoneShape { samples: 4, ..ZONE }, 1),
                "zone_machine",
            ),
            (
                DisplayKind::ZoneDisplay(ZONE, 1, screen(0, false)),
                "zone_display",
            ),
            (
                DisplayKind::BeamDisplay(BEAM, 1, screen(2, true)),
                "beam_display",
            ),
            (DisplayKind::BeamStream(BEAM, 1, 64, 48), "beam_stream"),
        ];
        for (kind, top) in kinds {
            let emitted = emit_display(&request(kind)).unwrap();
            assert_eq!(emitted.top, top);
            let text = emitted.bundle();
            assert!(text.contains(" [0:255];"), "{top}");
            if let Ok(folder) = std::env::var("IMOGENE_EMIT") {
                std::fs::write(format!("{folder}/{top}.v"), text).unwrap();
            }
        }
    }

    #[test]
    fn numbers_out_of_range_are_refused() {
        let zone = |change: fn(&mut ZoneShape)| {
            let mut shape = ZONE;
            change(&mut shape);
            emit_display(&request(DisplayKind::ZoneMachine(shape, 1))).is_err()
        };
        assert!(zone(|s| s.objects = 0));
        assert!(zone(|s| s.planes = 13));
        assert!(zone(|s| s.zone_bits = 15));
        assert!(zone(|s| s.rows_per_stage = 25));
        assert!(zone(|s| s.samples = 3));
        assert!(emit_display(&request(DisplayKind::ZoneMachine(ZONE, 5))).is_err());
    }
}
