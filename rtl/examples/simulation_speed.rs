//! Clocks per second of the built-in simulation at format 24: `cargo run --release --example simulation_speed`.

use imogene_rtl::machine::beam::Beam;
use imogene_rtl::object::quadric_processor::QuadricProcessor;
use imogene_rtl::step::{Clocked, step};
use imogene_rtl::unit::square_root::SquareRoot;
use imogene_rtl::word::{Int, Word};
use std::time::Instant;

const PLANES: usize = 3;
const OBJECTS: usize = 10;

fn measure<B: Clocked>(name: &str, clocks: u64, mut block: Box<B>, drive: impl Fn(&mut B, u64)) {
    block.connect_all();
    let begin = Instant::now();
    for clock in 0..clocks {
        drive(block.as_mut(), clock);
        step(block.as_mut());
    }
    let rate = clocks as f64 / begin.elapsed().as_secs_f64();
    println!("{name}: {rate:.0} clocks per second");
}

fn radicand(clock: u64) -> u64 {
    clock.wrapping_mul(6_364_136_223_846_793_005) >> 17
}

fn main() {
    for rows in [1, 2, 4] {
        let network = Box::new(SquareRoot::<48, 24, 25, 26>::new(rows));
        measure(
            &format!("square_root, {rows} rows per stage"),
            20_000,
            network,
            |network, clock| {
                network.radicand.next = Word::new(radicand(clock));
            },
        );
        let processor = Box::new(QuadricProcessor::<24, 25, 26, 48, 36>::new(PLANES, rows));
        measure(
            &format!("quadric_processor, {PLANES} planes, {rows} rows per stage"),
            10_000,
            processor,
            |processor, clock| {
                processor.valid.next = true;
                processor.start.next = clock == 0;
                processor.line.next = clock % 160 == 0 && clock > 0;
                processor.x.next = Word::new(clock % 160);
                processor.y.next = Word::new(clock / 160);
                processor.box_x1.next = Word::new(4095);
                processor.box_y1.next = Word::new(4095);
                processor.f1_a.next = Int::new(12_345);
                processor.f1_b.next = Int::new(-5_432);
                processor.f2_a2.next = Int::new(-40_000_000);
                processor.f2_b2.next = Int::new(-30_000_000);
                processor.f2_f.next = Int::new(1 << 44);
            },
        );
        let beam = Box::new(Beam::<24, 25, 26, 48, 36>::new(OBJECTS, PLANES, rows));
        measure(
            &format!("beam, {OBJECTS} objects, {PLANES} planes, {rows} rows per stage"),
            2_000,
            beam,
            |beam, clock| {
                beam.go.next = true;
                beam.width.next = Word::new(160);
                beam.height.next = Word::new(120);
                let object = clock / 9;
                beam.load_valid.next = object < OBJECTS as u64;
                beam.load_object.next = Word::new(object);
                beam.load_address.next =
                    Word::new([0, 1, 3, 4, 8, 9, 10, 21, 22][clock as usize % 9]);
                beam.load_data.next = Word::new(
                    [
                        77,
                        55,
                        1 << 47,
                        1 << 47,
                        1 << 44,
                        99,
                        88,
                        0xfff_000,
                        0xfff_000,
                    ][clock as usize % 9],
                );
            },
        );
    }
}
