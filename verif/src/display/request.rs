//! The hardware of a machine description.

use imogene_contract::RequestError;
use imogene_contract::video::VideoMode;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_plan::description::{MachineDescription, MachineKind, Output as Picture, Smoothing};
use imogene_plan::pace::Timing;
use imogene_plan::zone::clocks::ZoneTiming;
use imogene_rtl::emit::machine::{Kind, MachineRequest, Output, Tables, ZoneShape};

/// The request for the machine of a description whose tables of lit-sphere shading hold these words; `command` is
/// stated in the header of its Verilog. Panics when the description was not checked.
pub fn request_for(machine: &MachineDescription, tables: &[u64], command: &str) -> MachineRequest {
    let mode = mode(machine);
    let output = Output {
        mode,
        kernel: match machine.smoothing {
            Smoothing::None => 0,
            Smoothing::Box => 1,
            Smoothing::Binomial => 2,
        },
        has_overlay: machine.overlay,
    };
    let shape = || shape(&machine.zone_machine());
    let loader_bits = || machine.loader_words().next_power_of_two().trailing_zeros() as usize;
    let size = machine
        .frame_size()
        .expect("a description that was checked");
    let (width, height) = (size.0 as usize, size.1 as usize);
    let kind = match (machine.machine, machine.output) {
        (MachineKind::Zone, Picture::Pins) => Kind::ZoneDisplay(shape(), output),
        (MachineKind::Zone, Picture::Stream) => Kind::ZoneMachine(shape()),
        (MachineKind::Beam, Picture::Pins) => Kind::BeamDisplay(loader_bits(), output),
        (MachineKind::Beam, Picture::Stream) => Kind::BeamStream(loader_bits(), width, height),
    };
    let format = machine.format().expect("a description that was checked");
    let mut slots = machine.slots();
    MachineRequest {
        kind,
        words: format.widths(),
        rows_per_stage: machine.rows_per_stage as usize,
        layers: slots.split_off(slots.len() - machine.layers),
        slots,
        products: machine.products.0.clone(),
        decider: machine.decider,
        volumes: machine.volumes,
        volume_planes: machine.volume_planes,
        lights: machine.lights,
        suns: machine.suns,
        sphere: machine.lit_sphere.map(|sphere| Tables {
            places: sphere.places(),
            count: (sphere.materials as u32) << machine.lights,
            nearest: sphere.nearest,
            entries: tables.to_vec(),
        }),
        pixels_per_clock: machine.pixels_per_clock as usize,
        modules: machine.modules as usize,
        interlaced: machine.interlaced,
        prefix: String::new(),
        command: command.to_owned(),
    }
}

/// The request for the deciding part of a zone machine.
pub fn core_request(
    machine: &ZoneMachine,
    format: &Format,
    rows_per_stage: usize,
) -> MachineRequest {
    MachineRequest {
        kind: Kind::ZoneCore(shape(machine)),
        products: machine.products.clone(),
        volumes: machine.volume_processors,
        volume_planes: machine.volume_planes,
        ..MachineRequest::fitted(format.widths(), rows_per_stage, machine.slots.clone())
    }
}

fn shape(machine: &ZoneMachine) -> ZoneShape {
    let pixels = machine.zone_width * machine.zone_height;
    ZoneShape {
        zone_bits: pixels.next_power_of_two().trailing_zeros().max(1) as usize,
        samples: machine.samples as usize,
    }
}

/// The clocks of a zone machine's passes, as the analytic count wants them: after the clock that takes the command.
pub fn zone_timing(request: &MachineRequest) -> Result<ZoneTiming, RequestError> {
    let clocks = request.clocks()?;
    Ok(ZoneTiming {
        draw_drain: clocks.draw as u32 - 1,
        light_drain: clocks.light as u32 - 1,
        show_drain: clocks.show as u32 - 1,
        settle: clocks.settle as u32,
        command: 1,
    })
}

/// What the hardware of a machine that streams takes.
pub fn timing(request: &MachineRequest) -> Result<Timing, RequestError> {
    Ok(Timing {
        latency: request.clocks()?.pixel as u32,
        zone: match request.clocks()?.draw {
            0 => ZoneTiming::default(),
            _ => zone_timing(request)?,
        },
    })
}

/// The screen of a description that was checked.
pub fn mode(machine: &MachineDescription) -> VideoMode {
    let mode = machine.video_mode();
    mode.expect("a description that was checked")
}
