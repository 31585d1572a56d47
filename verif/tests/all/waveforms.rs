//! Waveforms read back: FST has what VCD has, windows begin where it is said, nets inside are those of the machine.

use crate::faults::{FAULT, teapot};
use crate::machines::{drawn, small};
use fst_reader::{FstFilter, FstHierarchyEntry, FstReader, FstSignalValue};
use imogene_contract::{Request, Unit};
use imogene_plan::description::{MachineDescription, Output};
use imogene_plan::display::Image;
use imogene_verif::display::pins::{PinsRun, run};
use imogene_verif::engine::Engine;
use imogene_verif::engine::simulator::Simulator;
use imogene_verif::report::Report;
use imogene_verif::scene::{self, Options};
use imogene_verif::unit::subject;
use imogene_verif::waveform::{Trace, WaveformRequest, WindowStart};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::slice::from_ref;
use vcd::{Command, Parser, ScopeItem};

/// Of each variable, by its path and range, the times at which it changes, and its bits from then on.
#[derive(Debug, Default, PartialEq)]
struct Waves(BTreeMap<String, Vec<(u64, String)>>);

impl Waves {
    fn change(&mut self, name: &str, time: u64, bits: String) {
        let changes = self.0.get_mut(name).expect("a declared variable");
        let is_same = match changes.last() {
            Some((_, before)) => *before == bits,
            None => bits.contains('x'),
        };
        if !is_same {
            changes.push((time, bits));
        }
    }

    fn of_vcd(path: &Path) -> Waves {
        let mut parser = Parser::new(BufReader::new(File::open(path).unwrap()));
        let header = parser.parse_header().unwrap();
        let (mut waves, mut names) = (Waves::default(), BTreeMap::new());
        let items = header.items.iter();
        let mut open: Vec<(String, &ScopeItem)> = items.map(|i| (String::new(), i)).collect();
        while let Some((around, item)) = open.pop() {
            match item {
                ScopeItem::Scope(scope) => {
                    let around = format!("{around}{}.", scope.identifier);
                    open.extend(scope.items.iter().map(|item| (around.clone(), item)));
                }
                ScopeItem::Var(var) => {
                    let range = var.index.map_or(String::new(), |range| format!(" {range}"));
                    let name = format!("{around}{}{range}", var.reference);
                    waves.0.insert(name.clone(), vec![]);
                    names.insert(var.code, name);
                }
                _ => {}
            }
        }
        let mut now = 0;
        for command in parser {
            match command.unwrap() {
                Command::Timestamp(time) => now = time,
                Command::ChangeScalar(id, bit) => waves.change(&names[&id], now, bit.to_string()),
                Command::ChangeVector(id, bits) => {
                    waves.change(&names[&id], now, bits.to_string());
                }
                _ => {}
            }
        }
        waves
    }

    fn of_fst(path: &Path) -> Waves {
        let mut reader = FstReader::open(BufReader::new(File::open(path).unwrap())).unwrap();
        let (mut waves, mut names, mut scopes) = (Waves::default(), BTreeMap::new(), vec![]);
        let hierarchy = |entry| match entry {
            FstHierarchyEntry::Scope { name, .. } => scopes.push(name),
            FstHierarchyEntry::UpScope => drop(scopes.pop()),
            FstHierarchyEntry::Var { name, handle, .. } => {
                let name = format!("{}.{name}", scopes.join("."));
                waves.0.insert(name.clone(), vec![]);
                names.insert(handle.get_index(), name);
            }
            _ => {}
        };
        reader.read_hierarchy(hierarchy).unwrap();
        let told = reader.read_signals(&FstFilter::all(), |time, handle, value| {
            let FstSignalValue::String(bits) = value else {
                return Err("a number");
            };
            let bits = String::from_utf8_lossy(bits).into_owned();
            waves.change(&names[&handle.get_index()], time, bits);
            Ok(())
        });
        told.unwrap();
        waves
    }

    /// Both files of a trace, which have to be the same.
    fn of(trace: &Trace) -> Waves {
        let folder = tempfile::tempdir().unwrap();
        let [vcd, fst] = ["w.vcd", "w.fst"].map(|name| folder.path().join(name));
        trace.write(&vcd).unwrap();
        let files = trace.write(&fst).unwrap();
        let save = std::fs::read_to_string(&files[1]).unwrap();
        assert!(save.starts_with("[dumpfile] \"w.fst\"\n"), "{save}");
        let waves = Waves::of_vcd(&vcd);
        assert!(waves == Waves::of_fst(&fst), "FST and VCD differ");
        waves
    }

    fn changes(&self, path: &str) -> &[(u64, String)] {
        let mut all = self.0.iter();
        let found = all.find(|(name, _)| name.split(' ').next() == Some(path));
        found.unwrap_or_else(|| panic!("no {path}")).1
    }

    /// The value of a signal at a clock, if it has one.
    fn at(&self, path: &str, clock: u64) -> Option<u64> {
        let changes = self.changes(path).iter();
        let last = changes.take_while(|(time, _)| *time <= 10 * clock).last();
        last.and_then(|(_, bits)| u64::from_str_radix(bits, 2).ok())
    }

    /// The clocks that it has.
    fn clocks(&self) -> Vec<u64> {
        let rises = self.changes("imogene.clock").iter();
        let rises = rises.filter(|(_, bit)| bit == "1");
        rises.map(|(time, _)| time / 10).collect()
    }
}

fn request(from: &str, clocks: u64, nets: &[&str]) -> WaveformRequest {
    let place = from.parse().map(WindowStart::At);
    WaveformRequest {
        from: place.unwrap_or(WindowStart::Mismatch),
        clocks,
        nets: nets.iter().map(|path| path.to_string()).collect(),
    }
}

#[test]
fn the_fst_of_a_unit_has_what_its_vcd_has() {
    let unit = subject(&Request::new(Unit::CutPlane)).unwrap();
    let (_, trace) = unit.run(&unit.seeded_stimulus(200, 3), true);
    let waves = Waves::of(&trace.unwrap());
    assert_eq!(waves.clocks(), (0..200).collect::<Vec<u64>>());
}

/// The inside of a processor is traced with its golden values as well: the same nets by their paths are the same.
#[test]
fn nets_of_a_scene_are_recorded_by_their_paths() {
    let options = |nets: &[&str]| Options {
        trace: Some(request("frame:1,line:20", 70, nets)),
        traced: 1,
        ..Options::plain(4, 2)
    };
    let run = |options: &Options, engine| scene::run(&teapot(48, 36), options, engine, || ());
    let nets = ["processors_1.quadric", "processors_0.cut.zf"];
    let (report, _) = run(&options(&nets), Engine::BuiltIn).unwrap();
    assert!(report.passed());
    let waves = Waves::of(&report.trace.unwrap());
    let first = 2 * 48;
    assert_eq!(waves.clocks(), (first..first + 70).collect::<Vec<u64>>());
    let inside = "imogene.beam.inside.processors_1.quadric";
    for (net, probe) in [("near_sum", "near_sum"), ("square_root.root", "root")] {
        let probe = waves.changes(&format!("imogene.processor_1.hardware.{probe}"));
        assert!(waves.changes(&format!("{inside}.{net}")) == probe && probe.len() > 9);
    }
    waves.changes("imogene.beam.inside.processors_0.cut.zf");

    let refused = |nets: &[&str], engine| run(&options(nets), engine).unwrap_err().to_string();
    let said = refused(&["processors_1.quadrik"], Engine::BuiltIn);
    let says =
        "there is no net or instance 'processors_1.quadrik': processors_1 has quadric, planes_0,";
    assert!(said.starts_with(says), "{said}");
    let said = refused(&nets, Engine::Verilog(Simulator::Icarus));
    assert!(said.contains("built-in engine alone"), "{said}");
    let second = Options {
        trace: Some(request("frame:2", 70, &[])),
        ..Options::plain(4, 1)
    };
    let said = run(&second, Engine::BuiltIn).unwrap_err().to_string();
    assert!(said.contains("accepted: frame:1"), "{said}");
}

/// A mismatch far before the window is recorded with what led to it, and not all that lies between.
#[test]
fn a_mismatch_has_a_window_of_its_own() {
    let options = Options {
        trace: Some(request("line:30", 50, &[])),
        fault: Some(FAULT),
        ..Options::plain(4, 1)
    };
    let (report, _) = scene::run(&teapot(48, 36), &options, Engine::BuiltIn, || ()).unwrap();
    let first = report.first_mismatches[0].cycle;
    let waves = Waves::of(&report.trace.unwrap());
    let wanted = (first.saturating_sub(60)..first + 200).chain(30 * 48..30 * 48 + 50);
    assert_eq!(waves.clocks(), wanted.collect::<Vec<u64>>());
}

/// Clocks until the words of the scene come: too late for the first frame, which is black.
const LATE: u64 = 2_000;

fn shown(machine: &MachineDescription, image: &Image, request: &WaveformRequest) -> Report {
    let options = PinsRun {
        waveforms: Some(request),
        late: LATE,
        ..PinsRun::plain(Engine::BuiltIn)
    };
    let outcome = run(machine, from_ref(image), &options, || ());
    outcome.unwrap().report
}

const NAMES: [&str; 2] = ["imogene.beam_display", "imogene.zone_machine"];

/// The frame, column and line at a clock.
fn place(waves: &Waves, name: &str, clock: u64) -> [Option<u64>; 3] {
    ["frame", "column", "line"].map(|of| waves.at(&format!("{name}.place.{of}"), clock))
}

#[test]
fn a_window_of_pins_begins_at_a_frame_a_line_or_a_pixel() {
    let machine = small("beam-160x120.toml", 32, 24, 40);
    let image = drawn("teapot.toml", &machine);
    for (from, wanted) in [
        ("frame:1", [1, 0, 0]),
        ("frame:2,line:9", [2, 0, 9]),
        ("frame:1,5,7", [1, 5, 7]),
        ("16,12", [2, 16, 12]),
        ("line:3", [2, 0, 3]),
    ] {
        let request = request(from, 60, &["core", "loader.comes"]);
        let report = shown(&machine, &image, &request);
        assert_eq!(report.mismatches, 0);
        let waves = Waves::of(&report.trace.expect(from));
        let clocks = waves.clocks();
        assert_eq!(clocks.len(), 60, "{from}");
        let begin = place(&waves, NAMES[0], clocks[0]);
        assert_eq!(begin, wanted.map(Some), "{from}");
        waves.changes("imogene.beam_display.inside.core.objects.processors_0.quadric.near_sum");
        let first = |signal| waves.at(&format!("{}.hardware.{signal}", NAMES[0]), clocks[0]);
        let [frame, column, line] = wanted.map(|n| n as usize);
        let red = [0, image.picture[3 * (line * 32 + column)]][frame - 1];
        let shown = [first("de"), first("red")];
        assert_eq!(shown, [Some(1), Some(red.into())], "{from}");
    }
    let never = shown(&machine, &image, &request("frame:9", 60, &[]));
    assert!(never.trace.is_none());
}

/// A wrong pixel of the golden picture: the clocks around it are there beside those of the window.
#[test]
fn the_pins_around_a_mismatch_are_recorded() {
    let machine = small("beam-160x120.toml", 32, 24, 40);
    let mut image = drawn("teapot.toml", &machine);
    image.picture[3 * (15 * 32 + 4)] ^= 1;
    for (from, more) in [("mismatch", 0), ("frame:1", 30)] {
        let report = shown(&machine, &image, &request(from, 30, &["loader"]));
        let first = &report.first_mismatches[0];
        assert_eq!((first.signal.as_str(), first.pixel), ("red", Some((4, 15))));
        let waves = Waves::of(&report.trace.unwrap());
        let clocks = waves.clocks();
        assert_eq!(clocks.len(), 60 + 200 + more, "{from}");
        assert!(clocks.contains(&first.cycle));
        // Nets lead up to the mismatch where nothing else is asked for.
        let net = |clock| waves.at("imogene.beam_display.inside.loader.comes", clock);
        assert_eq!(net(first.cycle), Some(0));
        assert_eq!(net(first.cycle - 1).is_some(), more == 0);
        let differs = |clock| waves.at("imogene.beam_display.mismatch", clock);
        assert_eq!(differs(first.cycle), Some(1));
        assert_eq!(differs(first.cycle + 1), Some(0));
    }
}

fn streamed_teapot() -> (MachineDescription, Image) {
    let machine = MachineDescription {
        output: Output::Stream,
        ..small("zone-160x120.toml", 32, 24, 40)
    };
    let image = drawn("teapot.toml", &machine);
    (machine, image)
}

/// What the bus shows at a clock is what the next edge meets: every beat that the host sends is taken where valid and
/// ready are both 1.
#[test]
fn the_bus_shows_the_handshake() {
    let (machine, image) = streamed_teapot();
    let request = WaveformRequest {
        from: WindowStart::Usual,
        ..request("0,0", 5_000, &[])
    };
    let options = PinsRun {
        stalls: Some(7),
        waveforms: Some(&request),
        ..PinsRun::plain(Engine::BuiltIn)
    };
    let beats = image.beats.len();
    let report = run(&machine, &[image], &options, || ()).unwrap().report;
    assert_eq!(report.mismatches, 0);
    let waves = Waves::of(&report.trace.unwrap());
    let at = |signal: &str, clock| waves.at(&format!("{}.{signal}", NAMES[1]), clock) == Some(1);
    let taken = |clock: &&u64| at("stimulus.s_tvalid", **clock) && at("outputs.s_tready", **clock);
    let clocks = waves.clocks();
    assert_eq!(clocks.iter().filter(taken).count(), beats);
    let sent = |clock: &&u64| at("outputs.m_tvalid", **clock) && at("stimulus.m_tready", **clock);
    assert_eq!(clocks.iter().filter(sent).count(), 32 * 24);
}

#[test]
fn a_window_of_a_stream_begins_at_its_pixel() {
    let (machine, image) = streamed_teapot();
    let report = shown(&machine, &image, &request("5,7", 40, &[]));
    let waves = Waves::of(&report.trace.unwrap());
    let first = waves.clocks()[0];
    assert_eq!(place(&waves, NAMES[1], first), [1, 5, 7].map(Some));
    let pixel = waves.at("imogene.zone_machine.hardware.m_tdata", first);
    let [red, green, blue] = [0, 1, 2].map(|k| u64::from(image.picture[3 * (7 * 32 + 5) + k]));
    assert_eq!(pixel, Some(red << 16 | green << 8 | blue));

    let options = PinsRun {
        waveforms: Some(&request("line:24", 40, &[])),
        ..PinsRun::plain(Engine::BuiltIn)
    };
    let refused = run(&machine, &[image], &options, || ()).unwrap_err();
    let refused = refused.to_string();
    assert!(refused.contains("accepted: 0,0 to 31,23"), "{refused}");
}
