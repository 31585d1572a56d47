//! The deciding part of a zone machine against its golden model: the same command stream into both, every shown pixel
//! compared.

use super::Machine;
use super::request::core_request;
use super::stalls::Stalls;
use crate::engine::Engine;
use crate::engine::design::DesignError;
use crate::report::Report;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::machine::zone::beat::Beat;
use imogene_golden::machine::zone::golden::{ShownPixel, StreamError, ZoneMachineModel};
use std::time::Instant;

/// Puts a beat on the command stream of a machine, or none.
pub fn offer(hardware: &mut Machine, beat: Option<&Beat>) {
    hardware.set("s_tvalid", i64::from(beat.is_some()));
    if let Some(beat) = beat {
        hardware.set("s_tdest", beat.kind.into());
        let user = i64::from(beat.unit) << 16 | i64::from(beat.address);
        hardware.set("s_tuser", user);
        hardware.set("s_tdata", beat.data as i64);
    }
}

/// What a run takes.
#[derive(Clone, Copy, Debug)]
pub struct CoreRun {
    /// Rows of the root networks between registers.
    pub rows_per_stage: usize,
    /// Engine.
    pub engine: Engine,
    /// Seed of random stalls on the stream and behind the core; none if neither side ever stalls.
    pub stalls: Option<u64>,
}

/// Why a run cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum CoreError {
    /// The hardware cannot be run.
    #[error(transparent)]
    Design(#[from] DesignError),
    /// The stream is none.
    #[error(transparent)]
    Stream(#[from] StreamError),
}

/// Runs a stream through hardware and golden model. The report's cycles are those from the first beat to the last
/// pixel.
pub fn run(
    beats: &[Beat],
    format: &Format,
    machine: &ZoneMachine,
    options: &CoreRun,
) -> Result<Report, CoreError> {
    let mut golden = ZoneMachineModel::new(format, machine);
    let mut wanted = Vec::new();
    for beat in beats {
        golden.beat(beat, |pixel| wanted.push(pixel))?;
    }
    let request = core_request(machine, format, options.rows_per_stage);
    let mut hardware = Machine::start(&request, options.engine, &[])?;
    let mut stalls = Stalls::new(options.stalls);
    let started = Instant::now();
    let mut report = Report {
        subject: "zone_core".into(),
        engine: options.engine.name().into(),
        seed: options.stalls,
        ..Report::default()
    };
    hardware.set("room", 0);
    hardware.clock();
    hardware.clocks = 0;
    let (mut sent, mut seen, mut idle) = (0, 0, 0u64);
    while seen < wanted.len() && idle < 1 << 20 {
        let is_ready = hardware.is_set("s_tready");
        let beat = beats.get(sent).filter(|_| !stalls.stall());
        offer(&mut hardware, beat);
        hardware.set("room", i64::from(!stalls.stall()));
        sent += usize::from(beat.is_some() && is_ready);
        hardware.clock();
        idle += 1;
        if hardware.is_set("valid") {
            compare(&hardware, &wanted[seen], format, &mut report);
            seen += 1;
            idle = 0;
        }
    }
    let all = wanted.len() as i64;
    report.compare(hardware.clocks, None, "pixels", Some(seen as i64), all);
    report.cycles = hardware.clocks;
    report.pixels = seen as u64;
    report.timed(started.elapsed().as_secs_f64());
    Ok(report)
}

fn compare(hardware: &Machine, wanted: &ShownPixel, format: &Format, report: &mut Report) {
    let mut values = vec![
        ("x", i64::from(wanted.x)),
        ("y", i64::from(wanted.y)),
        ("depth", wanted.depth),
        ("sample", (wanted.sample.bits() >> 3) as i64),
        ("pass_ends", wanted.pass_ends.into()),
        ("frame_ends", wanted.last.into()),
    ];
    if wanted.depth != format.z_max() {
        let [nx, ny, nz] = wanted.normal.map(i64::from);
        values.extend([("id", wanted.id.into()), ("nx", nx), ("ny", ny), ("nz", nz)]);
        values.push(("source_flags", wanted.flags.into()));
    }
    for (port, golden) in values {
        let pixel = Some((wanted.x.into(), wanted.y.into()));
        report.compare(hardware.clocks, pixel, port, hardware.get(port), golden);
    }
}
