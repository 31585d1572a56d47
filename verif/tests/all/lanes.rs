//! Several pixels of a line at once: each lane has the values that words moved to its pixels have, and machines stream
//! the golden picture.

use super::machines::{host, run, small};
use super::prepared;
use imogene_circuits::raster::{LANES_LATENCY, Laned, Scan, lane_scans};
use imogene_circuits::raster::{Linear, Quadratic, pe1, pe2};
use imogene_golden::format::Format;
use imogene_golden::unit::lattice::Lattice;
use imogene_golden::unit::{pe1::Linear as Line, pe2::Quadratic as Conic};
use imogene_hdl::{Bundle, Design, Int, Simulator, module};
use imogene_plan::description::MachineDescription;
use imogene_plan::display::{Image, image};
use imogene_plan::needs::enough;
use imogene_verif::display::pins;
use imogene_verif::engine::Engine;
use proptest::collection::vec;
use proptest::prelude::*;

/// PE1 and PE2 in so many lanes of a line.
fn design(width: u32, lanes: u32) -> Design {
    Design::of(|| {
        let words = (Linear::input(width), Quadratic::input(width));
        let inputs = (Scan::input(), (("linear", words.0), ("quadratic", words.1)));
        module("lanes", "top", inputs, |(scan, (linear, conic))| {
            let scans = lane_scans(scan.delayed(LANES_LATENCY), lanes);
            let firsts = linear.laned("linear", scan.flags, lanes).into_iter();
            let seconds = conic.laned("quadratic", scan.flags, lanes);
            let lane = |(lane, (scan, (linear, conic))): (usize, (&Scan, (Linear, Quadratic)))| {
                let first = pe1(&format!("first_{lane}"), scan.flags, linear);
                let second = pe2(&format!("second_{lane}"), scan.flags, conic);
                (first, second)
            };
            let values = scans.iter().zip(firsts.zip(seconds)).enumerate().map(lane);
            let (firsts, seconds): (Vec<Int>, Vec<Int>) = values.unzip();
            let place = scans[0].registered();
            (("late", place), ("first", firsts), ("second", seconds))
        })
    })
}

/// A zone: words, groups of a line, lines, and the clocks of which no pixel comes before each group.
#[derive(Clone, Debug)]
struct Zone {
    words: Vec<i64>,
    size: (usize, usize),
    waits: Vec<u8>,
}

fn zone(width: u32) -> impl Strategy<Value = Zone> {
    let most = 1i64 << (width - 1);
    let size = (4usize..10, 1usize..6);
    (vec(-most..most, 9), size, vec(0u8..3, 60)).prop_map(|(words, size, waits)| Zone {
        words,
        size,
        waits,
    })
}

impl Zone {
    /// The values of PE1 and PE2 at the pixels of a lane, in their order.
    fn wanted(&self, width: u32, lane: u32, lanes: u32) -> Vec<(i128, i128)> {
        let own: Vec<i128> = self.words.iter().copied().map(i128::from).collect();
        let pixels = Lattice::columns(lanes.into(), lane.into());
        let line = Line::new(own[0], own[1], own[2]).on(&pixels);
        let conic = Conic::new([own[3], own[4], own[5], own[6], own[7], own[8]]).on(&pixels);
        let (columns, lines) = self.size;
        let places = (0..lines as i64).flat_map(|y| (0..columns as i64).map(move |x| (x, y)));
        let values = places.map(|(x, y)| {
            let first = line.wrapped_at(x, y, width);
            (first, conic.wrapped_at(x, y, width))
        });
        values.collect()
    }

    /// The same of the circuit, lane by lane.
    fn found(&self, width: u32, lanes: u32) -> Vec<Vec<(i128, i128)>> {
        let design = design(width, lanes);
        let mut simulator = Simulator::new(&design);
        let own: Vec<i128> = self.words.iter().copied().map(i128::from).collect();
        let conic = Conic::new([own[3], own[4], own[5], own[6], own[7], own[8]]);
        let conic = conic.preconditioned(width);
        let words = [
            ("linear_a", own[0]),
            ("linear_b", own[1]),
            ("linear_c", own[2]),
            ("quadratic_a2", conic.a2),
            ("quadratic_b2", conic.b2),
            ("quadratic_c", conic.c),
            ("quadratic_i0", conic.i0),
            ("quadratic_p0", conic.p0),
            ("quadratic_f", conic.f),
        ];
        for (name, word) in words {
            let port = simulator.port(name);
            simulator.set(port, word as u64);
        }
        // Words are there before the first pixel: their multiples are registers.
        simulator.clock();
        let mut found = vec![vec![]; lanes as usize];
        let (columns, lines) = self.size;
        let of_groups = (0..columns * lines).flat_map(|group| {
            let wait = self.waits[group % self.waits.len()].into();
            std::iter::repeat_n(None, wait).chain([Some(group)])
        });
        let until_the_last = std::iter::repeat_n(None, LANES_LATENCY as usize + 1);
        for group in of_groups.chain(until_the_last) {
            let begins_line = group.is_some_and(|group| group > 0 && group % columns == 0);
            let (valid, start) = (group.is_some(), group == Some(0));
            for (name, flag) in [("valid", valid), ("start", start), ("line", begins_line)] {
                let port = simulator.port(name);
                simulator.set(port, flag.into());
            }
            simulator.clock();
            let out = simulator.port("late_valid");
            if simulator.get(out) == 0 {
                continue;
            }
            for (lane, found) in found.iter_mut().enumerate() {
                let value = |name: &str| simulator.port(&format!("{name}_{lane}"));
                let [first, second] = ["first", "second"].map(value);
                let signed = |word: u64| i128::from((word << (64 - width)) as i64 >> (64 - width));
                let [first, second] = [first, second].map(|port| signed(simulator.get(port)));
                found.push((first, second));
            }
        }
        found
    }
}

proptest! {
    #[test]
    fn lanes_have_the_values_of_their_pixels(
        (width, zone) in (4u32..50).prop_flat_map(|width| (Just(width), zone(width))),
        lanes in prop_oneof![Just(2u32), Just(4)],
    ) {
        let found = zone.found(width, lanes);
        for (lane, found) in (0..lanes).zip(found) {
            prop_assert_eq!(found, zone.wanted(width, lane, lanes), "lane {}", lane);
        }
    }
}

/// Several pixels on every clock: quadrics cut by planes, solids, glass, shadows; with stalls on both sides.
#[test]
fn several_pixels_per_clock_stream_the_golden_picture() {
    let asked = MachineDescription {
        objects: 1,
        planes: 0,
        ..small("beam-stream.toml", 120, 20, 40)
    };
    for name in "teapot solids/bracket glass/still-life shadows/ball-before-ball".split(' ') {
        let scene = super::scene(&format!("{name}.toml"));
        let (framed, prepared) = prepared(&scene, (120, 20), Format::BASE);
        let machine = enough(&asked, &[(&framed, &prepared)]).expect("a machine");
        let image = image(&framed, &prepared, &machine).expect("fits the machine");
        let blank = Image {
            picture: vec![0; image.picture.len()],
            ..image.clone()
        };
        for pixels_per_clock in [2, 4] {
            let machine = MachineDescription {
                pixels_per_clock,
                ..machine.clone()
            };
            machine.check("lanes").expect("lines that are long enough");
            let stalling = host(Engine::BuiltIn, Some(7), 0);
            run(&machine, std::slice::from_ref(&image), &stalling);
            let wrong = pins::run(&machine, std::slice::from_ref(&blank), &stalling, || ());
            assert!(wrong.expect("a machine that runs").report.mismatches > 300);
        }
    }
}
