//! Clocks of units as machine code that draw lines of pixels, in one lane and in more, and of mutants.

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use imogene_compiled::{Program, Simulation};
use imogene_contract::{Request, Unit};
use imogene_faults::{Controls, sites};
use imogene_hdl::{Design, Direction};
use std::hint::black_box;
use std::sync::Arc;

/// Clocks of one measurement.
const CLOCKS: usize = 1000;

/// Sites of a group of mutants, as in `imogene mutate`.
const SITES: usize = 24;

/// A unit that stands still does less: a beam machine scans, other units have a zone of short lines.
fn rows(unit: Unit, design: &Design) -> Vec<Vec<i64>> {
    let inputs = design.top.ports_of(Direction::In).count();
    let row = |clock| {
        let begins = i64::from(clock == 0);
        let first = match unit {
            Unit::Beam => [begins, 640, 480],
            _ => [1, begins, i64::from(clock % 50 == 49)],
        };
        let words = (3..inputs as i64).map(|port| match unit {
            Unit::Beam => 0,
            _ => port * 0x9e37_79b9,
        });
        first.into_iter().chain(words).collect()
    };
    (0..CLOCKS).map(row).collect()
}

fn run(
    group: &mut BenchmarkGroup<WallTime>,
    name: &str,
    simulation: &mut Simulation,
    (rows, lanes): (&[Vec<i64>], usize),
) {
    group.throughput(Throughput::Elements((CLOCKS * lanes) as u64));
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            for row in rows {
                black_box(simulation.step(&[row]));
            }
        });
    });
}

/// Compiles a design with points inside.
type Compile = fn(&Design, &[String]) -> Program;

const PROGRAMS: [(&str, Compile); 3] = [
    ("one lane", Program::new),
    ("lanes", Program::in_lanes),
    ("one stimulus", Program::on_one_stimulus),
];

fn units(criterion: &mut Criterion) {
    for unit in [Unit::QuadricPe, Unit::QuadricProcessor, Unit::Beam] {
        let design = imogene_rtl::emit::design(&Request::new(unit)).expect("a unit by default");
        let rows = rows(unit, &design);
        let mut group = criterion.benchmark_group(unit.name());
        for (name, compile) in PROGRAMS {
            let program = compile(&design, &[]);
            let lanes = program.lanes();
            let mut simulation = Simulation::new(&Arc::new(program));
            run(&mut group, name, &mut simulation, (&rows, lanes));
        }
    }
}

/// Mutants side by side; the rate is that of all together.
fn mutants(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("mutants");
    for unit in [Unit::QuadricPe, Unit::QuadricProcessor] {
        let design = imogene_rtl::emit::design(&Request::of(unit, 16)).expect("a unit by default");
        let sites = sites(&design);
        let controls = Controls::new(&design, &sites[sites.len() / 2..][..SITES]);
        let (mutants, rows) = (controls.mutants(), rows(unit, &design));
        for (name, compile) in &PROGRAMS[1..] {
            let program = Arc::new(compile(&controls.design, &[]));
            let lanes = program.lanes();
            let mut simulation = Simulation::new(&program);
            for (lane, mutant) in mutants.iter().step_by(7).take(lanes).enumerate() {
                for (register, word) in &mutant.upsets {
                    simulation.upset(lane, *register, *word);
                }
            }
            let name = format!("{}/{name}", unit.name());
            run(&mut group, &name, &mut simulation, (&rows, lanes));
        }
    }
}

criterion_group!(benches, units, mutants);
criterion_main!(benches);
