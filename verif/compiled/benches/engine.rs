//! Clocks of units as machine code, in one lane and in four.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use imogene_compiled::{Program, Simulation};
use imogene_contract::{Request, Unit};
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

criterion_group!(benches, units);
criterion_main!(benches);
