//! Clocks of units as machine code, in one lane and in four, and of mutants.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use imogene_compiled::{Program, Simulation};
use imogene_contract::{Request, Unit};
use imogene_faults::{Controls, sites};
use imogene_hdl::Direction;
use std::hint::black_box;
use std::sync::Arc;

/// Clocks of one measurement.
const CLOCKS: usize = 1000;

fn units(criterion: &mut Criterion) {
    for unit in [Unit::QuadricPe, Unit::QuadricProcessor, Unit::Beam] {
        let design = imogene_rtl::emit::design(&Request::new(unit)).expect("a unit by default");
        let mut group = criterion.benchmark_group(unit.name());
        for program in [Program::new(&design, &[]), Program::in_lanes(&design, &[])] {
            let lanes = program.lanes();
            group.throughput(Throughput::Elements((CLOCKS * lanes) as u64));
            let mut simulation = Simulation::new(&Arc::new(program));
            group.bench_function(format!("lanes/{lanes}"), |bencher| {
                bencher.iter(|| (0..CLOCKS).for_each(|_| simulation.clock()));
            });
        }
    }
}

/// Sites of a group of mutants, as in `imogene mutate`.
const SITES: usize = 24;

/// Four mutants side by side, with words handed over in each clock and all outputs read.
fn mutants(criterion: &mut Criterion) {
    let request = Request::of(Unit::QuadricProcessor, 16);
    let design = imogene_rtl::emit::design(&request).expect("a unit by default");
    let sites = sites(&design);
    let controls = Controls::new(&design, &sites[sites.len() / 2..][..SITES]);
    let program = Arc::new(Program::in_lanes(&controls.design, &[]));
    let mut simulation = Simulation::new(&program);
    for (lane, mutant) in controls.mutants().iter().step_by(7).take(4).enumerate() {
        for (register, word) in &mutant.upsets {
            simulation.upset(lane, *register, *word);
        }
    }
    let inputs = design.top.ports_of(Direction::In).count() as u64;
    let mut group = criterion.benchmark_group("mutants");
    group.throughput(Throughput::Elements(4 * CLOCKS as u64));
    group.bench_function("quadric_processor", |bencher| {
        bencher.iter(|| {
            for clock in 0..CLOCKS as u64 {
                // A zone starts now and then, and its lines.
                let flags = [1, u64::from(clock == 0), u64::from(clock % 16 == 1)];
                let words = (3..inputs).map(|port| port * 0x9e37_79b9 + clock / 500);
                simulation.set_all(flags.into_iter().chain(words));
                simulation.clock();
                black_box(simulation.outputs());
            }
        });
    });
}

criterion_group!(benches, units, mutants);
criterion_main!(benches);
