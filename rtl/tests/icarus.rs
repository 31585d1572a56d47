//! The emitted Verilog does, clock by clock, what the built-in simulation does, at the extremes too.

mod support;

use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::{Direction, EmitRequest, emit};
use imogene_rtl::simulator::{
    BeamInputs, PlaneWords, ProcessorInputs, ProcessorOutputs, QuadricWords, beam_simulator,
    quadric_processor_simulator, unit_simulator,
};
use imogene_rtl::step::step;
use imogene_rtl::unit::normal_unit::NormalUnit;
use imogene_rtl::unit::plane_depth::PlaneDepth;
use imogene_rtl::unit::square_root::SquareRoot;
use imogene_rtl::word::{Int, Word};
use rust_hdl::core::prelude::Block;
use support::{Random, icarus};

fn mask(value: i64, width: usize) -> u64 {
    value as u64 & (u64::MAX >> (64 - width))
}

fn random_words(
    random: &mut Random,
    depth_word: u32,
    planes: usize,
    columns: u64,
    lines: u64,
) -> QuadricWords {
    let s = depth_word + 2;
    let f = 2 * depth_word;
    // The value of the first pixel is large and the increments small, so that many pixels lie inside.
    let value = (random.next() >> (66 - f)) as i64;
    let small = |random: &mut Random| random.number(f - 12);
    QuadricWords {
        f1: [
            random.number(s - 6),
            random.number(s - 6),
            random.number(s - 2),
        ],
        f2: [
            small(random),
            small(random),
            small(random),
            small(random),
            small(random),
            value,
        ],
        g: [0; 3].map(|_| [0; 3].map(|_| random.number(24))),
        k: [0; 3].map(|_| random.number(16) as i16),
        box_x: (
            random.below(2) as u16,
            random.below(columns) as u16 + columns as u16 / 2,
        ),
        box_y: (
            random.below(2) as u16,
            random.below(lines) as u16 + lines as u16 / 2,
        ),
        class: random.below(4) as u8,
        shift: random.below(32) as u8,
        planes: (0..planes)
            .map(|_| PlaneWords {
                // About two planes cut; more would leave nothing to see.
                kind: if random.below(planes as u64) < 2 {
                    random.below(4) as u8
                } else {
                    0
                },
                a: random.number(depth_word - 4),
                b: random.number(depth_word - 4),
                c: random.number(depth_word + 2),
                normal: [0; 3].map(|_| random.number(16) as i16),
            })
            .collect(),
    }
}

/// The words of the processor's ports, in their order.
fn port_words(inputs: ProcessorInputs, words: &QuadricWords, depth_word: usize) -> Vec<u64> {
    let (s, f, p) = (depth_word + 2, 2 * depth_word, depth_word + 12);
    let mut ports = vec![
        inputs.valid.into(),
        inputs.start.into(),
        inputs.line.into(),
        inputs.x.into(),
        inputs.y.into(),
    ];
    ports.extend(words.f1.map(|word| mask(word, s)));
    ports.extend(words.f2.map(|word| mask(word, f)));
    ports.extend(words.g.as_flattened().iter().map(|word| mask(*word, 24)));
    ports.extend(words.k.map(|word| mask(word.into(), 16)));
    let (x, y) = (words.box_x, words.box_y);
    ports.extend([x.0, x.1, y.0, y.1].map(u64::from));
    ports.extend([words.class, words.shift].map(u64::from));
    ports.extend(words.planes.iter().map(|plane| u64::from(plane.kind)));
    ports.extend(words.planes.iter().map(|plane| mask(plane.a, p)));
    ports.extend(words.planes.iter().map(|plane| mask(plane.b, p)));
    ports.extend(words.planes.iter().map(|plane| mask(plane.c, p)));
    for axis in 0..3 {
        ports.extend(
            words
                .planes
                .iter()
                .map(|plane| mask(plane.normal[axis].into(), 16)),
        );
    }
    ports
}

fn output_words(outputs: ProcessorOutputs, depth_word: usize) -> Vec<u64> {
    let mut words = vec![
        outputs.valid.into(),
        mask(outputs.zf, depth_word),
        mask(outputs.zb, depth_word),
        outputs.number.into(),
    ];
    words.extend(outputs.normal.map(|component| mask(component.into(), 16)));
    words
}

fn compare_processor(depth_word: usize, planes: usize, rows_per_stage: usize) {
    let mut random = Random(depth_word as u64);
    let mut simulator = quadric_processor_simulator(depth_word, planes, rows_per_stage).unwrap();
    let (columns, lines) = (13, 5);
    let (mut stimulus, mut expected) = (Vec::new(), Vec::new());
    let mut present = 0;
    for _ in 0..40 {
        let words = random_words(&mut random, depth_word as u32, planes, columns, lines);
        simulator.set_words(&words);
        let mut pixel = 0;
        let mut idle = simulator.latency();
        while idle > 0 {
            let valid = pixel < columns * lines && random.below(8) > 0;
            idle -= usize::from(pixel == columns * lines);
            let inputs = ProcessorInputs {
                valid,
                start: pixel == 0,
                line: pixel > 0 && pixel % columns == 0,
                x: (pixel % columns) as u16,
                y: (pixel / columns) as u16,
            };
            pixel += u64::from(valid);
            stimulus.push(port_words(inputs, &words, depth_word));
            let outputs = simulator.clock(inputs);
            present += usize::from(outputs.valid && outputs.zf < (1 << (depth_word - 1)) - 1);
            expected.push(output_words(outputs, depth_word));
        }
    }
    assert!(
        present > 200,
        "too few visible pixels ({present}) at {planes} planes to prove anything"
    );
    let request = EmitRequest {
        depth_word,
        planes,
        rows_per_stage,
        ..EmitRequest::new(Unit::QuadricProcessor)
    };
    let found = icarus(
        &format!("processor-{depth_word}-{planes}-{rows_per_stage}"),
        &request,
        &stimulus,
    );
    assert_eq!(found.len(), expected.len());
    for (clock, (found, expected)) in found.iter().zip(&expected).enumerate() {
        assert_eq!(found, expected, "format {depth_word}, clock {clock}");
    }
}

#[test]
fn quadric_processor_agrees() {
    compare_processor(16, 0, 16);
    compare_processor(20, 1, 6);
    compare_processor(24, 3, 1);
    compare_processor(28, 2, 9);
    compare_processor(32, 12, 4);
}

#[test]
fn beam_agrees() {
    let (depth_word, objects, planes, rows_per_stage) = (20, 3, 2, 5);
    let mut random = Random(7);
    let mut simulator = beam_simulator(depth_word, objects, planes, rows_per_stage).unwrap();
    let (mut stimulus, mut expected) = (Vec::new(), Vec::new());
    let outputs = |outputs: imogene_rtl::simulator::BeamOutputs| {
        let mut words = vec![
            outputs.valid.into(),
            mask(outputs.depth, depth_word),
            outputs.id.into(),
            outputs.number.into(),
        ];
        words.extend(outputs.normal.map(|component| mask(component.into(), 16)));
        words
    };
    let (columns, lines) = (11, 7);
    for zone in 0..6 {
        for object in 0..objects as u8 {
            // The first zone is drawn with nothing loaded.
            for (address, data) in
                random_words(&mut random, depth_word as u32, planes, columns, lines).load_words()
            {
                if zone > 0 {
                    simulator.load(object, address, data);
                    let data = mask(data as i64, 2 * depth_word);
                    stimulus.push(vec![
                        0,
                        columns,
                        lines,
                        1,
                        object.into(),
                        address.into(),
                        data,
                    ]);
                    expected.push(None);
                }
            }
        }
        for clock in 0..columns * lines + simulator.latency() as u64 {
            let inputs = BeamInputs {
                go: clock == 0,
                width: columns as u16,
                height: lines as u16,
            };
            stimulus.push(vec![inputs.go.into(), columns, lines, 0, 0, 0, 0]);
            expected.push(Some(outputs(simulator.clock(inputs))));
        }
    }
    let request = EmitRequest {
        depth_word,
        planes,
        rows_per_stage,
        objects,
        ..EmitRequest::new(Unit::Beam)
    };
    let found = icarus("beam", &request, &stimulus);
    assert_eq!(found.len(), expected.len());
    for (clock, (found, expected)) in found.iter().zip(&expected).enumerate() {
        if let Some(expected) = expected {
            assert_eq!(found, expected, "clock {clock}");
        }
    }
}

/// Random words on every input of every unit, in every format.
#[test]
fn every_unit_agrees() {
    for unit in Unit::ALL.into_iter().filter(|unit| *unit != Unit::Beam) {
        for (depth_word, planes, rows_per_stage, objects) in [
            (16, 0, 16, 1),
            (20, 1, 3, 2),
            (24, 3, 24, 3),
            (28, 12, 5, 6),
            (32, 2, 7, 5),
        ] {
            let request = EmitRequest {
                depth_word,
                // A polyhedron has a plane at least.
                planes: usize::max(planes, usize::from(unit == Unit::PolyhedronProcessor)),
                rows_per_stage,
                objects,
                ..EmitRequest::new(unit)
            };
            let mut random = Random(unit as u64 * 100 + depth_word as u64);
            let mut simulator = unit_simulator(&request).unwrap();
            let ports = emit(&request).unwrap().ports;
            let inputs = ports
                .iter()
                .filter(|port| port.direction == Direction::Input && port.name != "clock");
            let widths: Vec<_> = inputs.map(|port| port.width).collect();
            let mut words = vec![0; widths.len()];
            let (mut stimulus, mut expected) = (Vec::new(), Vec::new());
            for _ in 0..150 {
                for (word, width) in words.iter_mut().zip(&widths) {
                    // A word often stays, so that two words meet for more than one clock.
                    if random.below(3) > 0 {
                        *word = mask(random.number(*width as u32), *width);
                    }
                }
                stimulus.push(words.clone());
                expected.push(simulator.clock(&words));
            }
            let name = format!("unit-{}-{depth_word}", unit.name());
            assert_eq!(icarus(&name, &request, &stimulus), expected, "{request:?}");
        }
    }
}

#[test]
fn plane_depth_agrees_at_the_extremes() {
    let mut random = Random(3);
    let mut block = PlaneDepth::<16, 28>::new();
    block.connect_all();
    let bounds = [
        -32_769,
        -32_768,
        -32_767,
        32_766,
        32_767,
        32_768,
        -(1 << 27),
        (1 << 27) - 1,
        0,
        -1,
    ];
    let (mut stimulus, mut expected) = (Vec::new(), Vec::new());
    for clock in 0..400 {
        let c = bounds
            .get(clock)
            .copied()
            .unwrap_or_else(|| random.number(28));
        let (a, b) = (random.number(28), random.number(28));
        let flags = if clock < bounds.len() {
            [true, true, false]
        } else {
            [0; 3].map(|_| random.below(4) > 0)
        };
        stimulus.push(vec![
            flags[0].into(),
            flags[1].into(),
            flags[2].into(),
            mask(a, 28),
            mask(b, 28),
            mask(c, 28),
        ]);
        [block.valid.next, block.start.next, block.line.next] = flags;
        block.a.next = Int::new(a);
        block.b.next = Int::new(b);
        block.c.next = Int::new(c);
        step(&mut block);
        if (1..=bounds.len()).contains(&clock) {
            assert_eq!(
                block.depth.val().get(),
                bounds[clock - 1].clamp(-32_768, 32_767)
            );
        }
        expected.push(vec![mask(block.depth.val().get(), 16)]);
    }
    let request = EmitRequest {
        depth_word: 16,
        ..EmitRequest::new(Unit::PlaneDepth)
    };
    assert_eq!(icarus("plane-depth", &request, &stimulus), expected);
}

#[test]
fn normal_unit_agrees_at_the_extremes() {
    let mut random = Random(4);
    let mut block = NormalUnit::<24>::new(1);
    block.connect_all();
    let (mut stimulus, mut expected) = (Vec::new(), Vec::new());
    for _ in 0..600 {
        let flags = [0; 3].map(|_| random.below(2) == 1);
        let faces = if random.below(4) == 0 { 16 } else { 4 };
        let number = random.below(faces);
        let absent = random.below(8) == 0;
        let root = mask(random.number(24), 24);
        let shift = random.below(32);
        let g = [0; 9].map(|_| random.number(24));
        let k = [0; 3].map(|_| random.number(16));
        let plane = [0; 3].map(|_| random.number(16));
        let mut words = vec![
            flags[0].into(),
            flags[1].into(),
            flags[2].into(),
            number,
            absent.into(),
            root,
            shift,
        ];
        words.extend(g.map(|word| mask(word, 24)));
        words.extend(k.iter().chain(&plane).map(|word| mask(*word, 16)));
        stimulus.push(words);
        [block.valid.next, block.start.next, block.line.next] = flags;
        block.number.next = Word::new(number);
        block.absent.next = absent;
        block.root.next = Word::new(root);
        block.shift.next = Word::new(shift);
        [block.gx_a.next, block.gx_b.next, block.gx_c.next] = [g[0], g[1], g[2]].map(Int::new);
        [block.gy_a.next, block.gy_b.next, block.gy_c.next] = [g[3], g[4], g[5]].map(Int::new);
        [block.gz_a.next, block.gz_b.next, block.gz_c.next] = [g[6], g[7], g[8]].map(Int::new);
        [block.kx.next, block.ky.next, block.kz.next] = k.map(Int::new);
        [
            block.plane_nx[0].next,
            block.plane_ny[0].next,
            block.plane_nz[0].next,
        ] = plane.map(Int::new);
        step(&mut block);
        expected.push(
            [block.nx.val(), block.ny.val(), block.nz.val()]
                .map(|n| mask(n.get(), 16))
                .to_vec(),
        );
    }
    let request = EmitRequest {
        planes: 1,
        ..EmitRequest::new(Unit::NormalUnit)
    };
    assert_eq!(icarus("normal", &request, &stimulus), expected);
}

#[test]
fn square_root_agrees() {
    let mut random = Random(5);
    let mut block = SquareRoot::<64, 32, 33, 34>::new(5);
    block.connect_all();
    let (mut stimulus, mut expected) = (Vec::new(), Vec::new());
    for _ in 0..300 {
        let radicand = random.number(64) as u64;
        stimulus.push(vec![radicand]);
        block.radicand.next = Word::new(radicand);
        step(&mut block);
        expected.push(vec![block.root.val().get(), block.remainder.val().get()]);
    }
    let request = EmitRequest {
        depth_word: 32,
        rows_per_stage: 5,
        ..EmitRequest::new(Unit::SquareRoot)
    };
    assert_eq!(icarus("square-root", &request, &stimulus), expected);
}
