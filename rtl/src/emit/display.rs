//! Machines with everything between the object processors and the picture.

use super::collect::{Scope, collect};
use super::{EmitError, Emitted, Heading, Task, merge, module_texts, names, ports};
use crate::for_format;
use crate::format::{MOST_LIGHTS, MOST_OBJECTS, MOST_PLANES};
use crate::kernel::Ports;
use crate::machine::beam_core::{BeamCore, BeamShape};
use crate::machine::beam_display::BeamDisplay;
use crate::machine::beam_stream::BeamStream;
use crate::machine::frame_loader::LOADER_BITS;
use crate::machine::video_output::{OutputShape, VideoOutput};
use crate::machine::zone_core::{ZONE_BITS, ZoneCore, ZoneShape};
use crate::machine::zone_display::ZoneDisplay;
use crate::machine::zone_machine::ZoneMachine;
use crate::step::Clocked;
use rust_hdl::core::prelude::Block;

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
        for_format!(self.depth_word, clocks_of_format(self))
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

fn clocks_of_format<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
>(
    request: &DisplayRequest,
) -> Result<MachineClocks, EmitError> {
    let zone = |shape: &ZoneShape| {
        let draw = ZoneCore::<W, W1, S, F, P>::draw_clocks(shape);
        let light = ZoneCore::<W, W1, S, F, P>::light_clocks(shape);
        MachineClocks {
            draw,
            light,
            show: ZoneCore::<W, W1, S, F, P>::SHOW_CLOCKS,
            settle: ZoneCore::<W, W1, S, F, P>::settle_clocks(shape),
            ..MachineClocks::default()
        }
    };
    Ok(match &request.kind {
        DisplayKind::ZoneCore(shape) | DisplayKind::ZoneMachine(shape, _) => zone(shape),
        DisplayKind::ZoneDisplay(shape, _, output) => MachineClocks {
            output: VideoOutput::latency(output),
            ..zone(shape)
        },
        DisplayKind::BeamStream(shape, ..) => MachineClocks {
            pixel: BeamCore::<W, W1, S, F, P>::latency(shape),
            ..MachineClocks::default()
        },
        DisplayKind::BeamDisplay(shape, _, output) => MachineClocks {
            pixel: BeamCore::<W, W1, S, F, P>::latency(shape),
            output: VideoOutput::latency(output),
            ..MachineClocks::default()
        },
    })
}

/// Builds the block of a machine and runs a task on it.
pub(crate) fn with_machine<T: Task>(
    request: &DisplayRequest,
    task: T,
) -> Result<T::Outcome, EmitError> {
    request.check()?;
    for_format!(request.depth_word, machine_of_format[T](request, task))
}

fn machine_of_format<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
    T: Task,
>(
    request: &DisplayRequest,
    task: T,
) -> Result<T::Outcome, EmitError> {
    match &request.kind {
        DisplayKind::ZoneCore(shape) => task.run(ZoneCore::<W, W1, S, F, P>::new(shape, 0)),
        DisplayKind::ZoneMachine(shape, lights) => {
            task.run(ZoneMachine::<W, W1, S, F, P>::new(shape, *lights))
        }
        DisplayKind::ZoneDisplay(shape, lights, output) => {
            task.run(ZoneDisplay::<W, W1, S, F, P>::new(shape, *lights, output))
        }
        DisplayKind::BeamDisplay(shape, lights, output) => {
            task.run(BeamDisplay::<W, W1, S, F, P>::new(shape, *lights, output))
        }
        DisplayKind::BeamStream(shape, lights, width, height) => {
            task.run(BeamStream::<W, W1, S, F, P>::new(
                shape, *lights, *width, *height,
            ))
        }
    }
}

struct Collect;

impl Task for Collect {
    type Outcome = Scope;

    fn run<B: Block + Clocked + Ports + Send + 'static>(
        self,
        block: B,
    ) -> Result<Scope, EmitError> {
        collect(block)
    }
}

/// The Verilog of a machine.
///
/// # Errors
///
/// When a number is out of its range, or a prefix begins no identifier.
pub fn emit_display(request: &DisplayRequest) -> Result<Emitted, EmitError> {
    let scope = with_machine(request, Collect)?;
    let clocks = request.clocks()?;
    let ports = ports(&scope);
    let top = format!("{}{}", request.prefix, scope.unit().unwrap_or_default());
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
        modules: module_texts(merge::modules(&scope, &request.prefix)?),
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
    use crate::machine::video_mode::VideoMode;

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
            assert!(text.contains("words [0:255];"), "{top}");
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
