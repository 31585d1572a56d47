//! A co-simulation that could not find a fault would prove nothing: broken units and a broken coefficient must be
//! reported with cycle, pixel, values and a trace.

use super::scene;
use imogene_circuits::raster::{Flags, Linear, pe1};
use imogene_contract::{Request, Unit};
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_prepare::PreparedScene;
use imogene_verif::engine::Engine;
use imogene_verif::engine::circuit::Circuit;
use imogene_verif::random;
use imogene_verif::report::Report;
use imogene_verif::scene::{Fault, Options, run as run_scene, slots_for};
use imogene_verif::subject::{Hardware, Inputs, LANES, Subject};
use imogene_verif::unit::{subject, units};
use imogene_verif::waveform::{Place, WaveformRequest, WindowStart};
use std::path::Path;

/// A PE1 wired wrongly: at a line start it is given the pixel increment in place of the line increment.
struct Crossed(Circuit);

impl Hardware for Crossed {
    fn clock(&mut self, inputs: &[&[i64]]) {
        let i = inputs[0];
        self.0.clock(&[i[0], i[1], i[2], i[3], i[3], i[5]]);
    }

    fn outputs(&mut self, lane: usize, found: &mut Vec<Option<i64>>) {
        self.0.outputs(lane, found);
    }
}

fn broken_pe1() -> Subject {
    let mut broken = subject(&Request::new(Unit::Pe1)).unwrap();
    broken.lanes = 1;
    broken.hardware = Box::new(|_| {
        let unit = Circuit::of(|| pe1("top", Flags::input(), Linear::input(26)));
        Box::new(Crossed(unit))
    });
    broken
}

#[test]
fn a_broken_unit_is_reported_with_cycle_values_and_trace() {
    let broken = broken_pe1();
    let stimulus = broken.seeded_stimulus(200, 7);
    let (report, trace) = broken.run(&stimulus, true);
    assert!(!report.passed() && report.mismatches > 0);
    let first = &report.first_mismatches[0];
    assert_eq!(first.signal, "value");
    assert_ne!(first.hardware, Some(first.golden));
    let text = first.to_string();
    assert!(text.contains(&format!("cycle {}", first.cycle)), "{text}");

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pe1.vcd");
    let files = trace.unwrap().write(&path).unwrap();
    let vcd = std::fs::read_to_string(&files[0]).unwrap();
    for name in ["hardware", "golden", "mismatch", "stimulus"] {
        assert!(vcd.contains(name), "the trace has no {name}");
    }
    // The marker of the save file stands at the first mismatch, ten time units a clock.
    let save = std::fs::read_to_string(&files[1]).unwrap();
    let zoom = save.lines().find_map(|line| line.strip_prefix('*'));
    let mut zoom = zoom.expect("a line of zoom and markers").split(' ');
    let shown: f64 = zoom.next().unwrap().parse().unwrap();
    let marker = (first.cycle * 10).to_string();
    assert_eq!(zoom.next(), Some(marker.as_str()), "{save}");
    // GTKWave draws 2^-zoom time units on 200 pixels. A value of 26 bits has up to nine characters, of some eight
    // pixels.
    let clock = 10.0 * 200.0 / (-shown).exp2();
    assert!((72.0..120.0).contains(&clock), "{clock} pixels a clock");
}

/// Hardware whose first output is wrong in some lanes and clocks.
struct Planted<F> {
    inner: Box<dyn Hardware>,
    is_wrong: F,
    clocks: u64,
}

impl<F: Fn(usize, u64) -> bool + Send> Hardware for Planted<F> {
    fn clock(&mut self, inputs: &[&[i64]]) {
        self.inner.clock(inputs);
        self.clocks += 1;
    }

    fn outputs(&mut self, lane: usize, found: &mut Vec<Option<i64>>) {
        self.inner.outputs(lane, found);
        if (self.is_wrong)(lane, self.clocks - 1) {
            found[0] = found[0].map(|value| value ^ 1);
        }
    }
}

/// Stimuli of several lengths run side by side, and each by itself, with the same report, and a difference is found in
/// its lane and clock alone.
#[test]
fn a_difference_is_found_in_its_lane_at_its_clock() {
    let request = Request::new(Unit::Pe1);
    let good = subject(&request).unwrap();
    let lengths = [90, 40, 120, 60, 70, 30, 50, 45, 80, 20];
    let stimuli = (0..).zip(lengths);
    let stimuli = stimuli.map(|(seed, clocks)| good.seeded_stimulus(clocks, seed));
    let stimuli: Vec<Vec<Inputs>> = stimuli.collect();
    let one_by_one = stimuli.iter().map(|stimulus| good.run(stimulus, false).0);
    let count = |report: &Report| (report.cycles, report.comparisons);
    let counts: Vec<_> = one_by_one.map(|report| count(&report)).collect();
    for (lane, clock) in [(0, 85), (1, 35), (2, 119), (3, 59), (7, 44)] {
        let mut broken = subject(&request).unwrap();
        let make = subject(&request).unwrap().hardware;
        broken.hardware = Box::new(move |runs| {
            Box::new(Planted {
                inner: make(runs),
                is_wrong: move |own, now| (own, now) == (lane, clock),
                clocks: 0,
            })
        });
        let outcomes = broken.run_all(&stimuli[..LANES], true);
        let all = outcomes.iter().map(|(report, _)| count(report));
        assert!(all.eq(counts[..LANES].iter().copied()));
        for (place, (report, trace)) in outcomes.into_iter().enumerate() {
            let found = report.first_mismatches.iter().map(|found| found.cycle);
            let wanted = vec![clock; usize::from(place == lane)];
            assert!(found.eq(wanted), "lane {place}");
            assert!(!trace.unwrap().is_empty());
        }
    }
    // More than there are lanes.
    let outcomes = good.run_all(&stimuli, false);
    assert!(outcomes.iter().map(|(report, _)| count(report)).eq(counts));
}

/// The first stimuli come first in the report, in lanes as one by one.
#[test]
fn many_stimuli_have_one_report_in_lanes_and_alone() {
    let report = |is_in_lanes: bool| {
        let request = Request::new(Unit::Pe1);
        let mut broken = subject(&request).unwrap();
        let make = subject(&request).unwrap().golden;
        broken.golden = Box::new(move || {
            let mut inner = make();
            Box::new(move |inputs: &[i64]| {
                let differs = i64::from(inputs[3] % 64 == 5);
                let stated = inner(inputs).into_iter();
                stated.map(|value| Some(value? ^ differs)).collect()
            })
        });
        if !is_in_lanes {
            broken.lanes = 1;
        }
        let (report, trace) = random::run(&broken, 40_000, 3, true);
        let counts = [report.cycles, report.pixels, report.comparisons];
        let length = trace.map(|trace| trace.len());
        (counts, report.mismatches, report.first_mismatches, length)
    };
    let (in_lanes, alone) = (report(true), report(false));
    assert_eq!(in_lanes, alone);
    assert!(alone.2.len() == 20 && alone.1 > 20);
}

/// For every unit: hardware whose first output has its lowest bit inverted now and then is found.
#[test]
fn every_scoreboard_finds_a_flipped_output_bit() {
    for unit in units() {
        let (name, request) = (unit.name(), Request::new(unit));
        let good = subject(&request).unwrap();
        let stimulus = good.seeded_stimulus(120, 3);
        let make = subject(&request).unwrap().hardware;
        let mut broken = subject(&request).unwrap();
        broken.lanes = 1;
        broken.hardware = Box::new(move |runs| {
            Box::new(Planted {
                inner: make(runs),
                is_wrong: |_, clock| clock % 7 == 6,
                clocks: 0,
            })
        });
        assert_eq!(good.run(&stimulus, false).0.mismatches, 0, "{name}");
        assert!(broken.run(&stimulus, false).0.mismatches > 0, "{name}");
    }
}

pub(crate) fn teapot(width: u32, height: u32) -> PreparedScene {
    crate::prepared(&scene("teapot.toml"), (width, height), Format::BASE).1
}

/// Bit 18 of f1's constant term of object 0, the pot's body.
pub(crate) const FAULT: Fault = Fault {
    object: 0,
    address: 2,
    bit: 18,
};

/// Waveforms without nets inside.
fn waveforms(from: WindowStart, clocks: u64) -> Option<WaveformRequest> {
    let nets = vec![];
    Some(WaveformRequest { from, clocks, nets })
}

#[test]
fn a_wrong_coefficient_bit_is_reported_with_pixel_and_trace() {
    let folder = tempfile::tempdir().unwrap();
    let scene = teapot(48, 36);
    let mut options = Options {
        trace: waveforms(WindowStart::Usual, 100),
        ..Options::plain(4, 1)
    };
    let run = |options: &Options| run_scene(&scene, options, Engine::BuiltIn, || ()).unwrap();
    let (good, frame) = run(&options);
    assert!(good.passed(), "{:?}", good.first_mismatches);

    options.fault = Some(FAULT);
    let (report, broken_frame) = run(&options);
    assert!(report.mismatches > 0);
    assert_ne!(frame, broken_frame);
    let first = &report.first_mismatches[0];
    assert!(first.pixel.is_some() && first.hardware != Some(first.golden));
    let trace = report.trace.expect("waveforms were asked for");
    let files = trace.write(&folder.path().join("teapot.vcd")).unwrap();
    assert_eq!(files.len(), 2);
    let vcd = std::fs::read_to_string(&files[0]).unwrap();
    assert!(vcd.contains("processor_0") && vcd.contains("beam"));
}

/// The clocks that a trace holds.
fn clocks(vcd: &Path) -> Vec<u64> {
    let text = std::fs::read_to_string(vcd).unwrap();
    let times = text.lines();
    let times = times.filter_map(|line| line.strip_prefix('#')?.parse().ok());
    let rising = times.filter(|time: &u64| time.is_multiple_of(10));
    let mut clocks: Vec<u64> = rising.map(|time| time / 10).collect();
    // The last is the end of the last clock.
    clocks.pop();
    clocks
}

/// The window of a trace begins at the pixel asked for, counted from the first line of its band, or shows a mismatch
/// alone, in whichever band it is.
fn at_pixel(column: usize, line: usize) -> WindowStart {
    WindowStart::At(Place {
        frame: None,
        column,
        line,
    })
}

#[test]
fn a_window_begins_at_a_pixel_or_shows_a_mismatch_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("window.vcd");
    let scene = teapot(48, 36);
    let run = |from, count, fault| {
        let options = Options {
            trace: waveforms(from, count),
            fault,
            ..Options::plain(4, 2)
        };
        run_scene(&scene, &options, Engine::BuiltIn, || ()).map(|(report, _)| report)
    };
    // Lines 18 to 35 are the second band.
    let report = run(at_pixel(5, 20), 60, None).unwrap();
    report.trace.unwrap().write(&path).unwrap();
    assert!(clocks(&path).into_iter().eq(2 * 48 + 5..2 * 48 + 65));

    let report = run(WindowStart::Mismatch, 60, None).unwrap();
    assert!(report.trace.is_none(), "nothing differs");
    let report = run(WindowStart::Mismatch, 60, Some(FAULT)).unwrap();
    let first = report.first_mismatches[0].cycle;
    report.trace.unwrap().write(&path).unwrap();
    let held = clocks(&path);
    let is_short = held.contains(&first) && held.len() <= 300;
    assert!(is_short, "{first}: {held:?}");

    let refused = run(at_pixel(48, 0), 60, None).unwrap_err();
    let says = "there is no pixel 48,0 to trace from; accepted: 0,0 to 47,35";
    assert_eq!(refused.to_string(), says);
}

/// Bands of 7 and of 8 lines run in threads of their own; each counts its own latency and knows its own lines.
#[test]
fn every_band_reports_the_places_of_its_band() {
    let scene = teapot(48, 36);
    let run = |fault| {
        let options = Options {
            fault,
            ..Options::plain(4, 5)
        };
        run_scene(&scene, &options, Engine::BuiltIn, || ()).unwrap()
    };
    let (good, frame) = run(None);
    assert!(good.passed(), "{:?}", good.first_mismatches);
    let slots = slots_for(&scene, 4).unwrap();
    let latency = u64::from(beam::latency(&slots, &scene.format, 4));
    assert_eq!(good.pixels, 48 * 36);
    assert_eq!(good.cycles, 48 * 36 + 5 * (latency - 1));

    for object in 0..scene.objects.len() as u8 {
        let (report, broken) = run(Some(Fault { object, ..FAULT }));
        let depths = frame.depth.iter().zip(&broken.depth).enumerate();
        let differs = depths.filter(|(_, (good, broken))| good != broken);
        let wanted = differs.map(|(at, _)| at);
        let found = report.first_mismatches.iter();
        let found = found.filter(|m| m.signal == "depth");
        let places = found.map(|m| m.pixel.map(|(x, y)| (y * 48 + x) as usize).unwrap());
        let places: Vec<usize> = places.collect();
        assert_eq!(places, wanted.take(places.len()).collect::<Vec<_>>());
        assert!(!places.is_empty(), "object {object}");
    }
}

#[test]
fn faults_that_do_not_exist_are_refused() {
    let scene = teapot(16, 12);
    let options = Options {
        fault: Some(Fault {
            object: 99,
            bit: 0,
            ..FAULT
        }),
        ..Options::plain(24, 1)
    };
    let outcome = run_scene(&scene, &options, Engine::BuiltIn, || ());
    let message = outcome.err().unwrap().to_string();
    let is_told = message.contains("99:2:0") && message.contains("accepted");
    assert!(is_told, "{message}");
}
