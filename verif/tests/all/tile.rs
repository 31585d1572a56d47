//! A tile of a shared chip, frame by frame against its golden model, also where its words mean nothing.

use crate::video::Numbers;
use imogene_circuits::machines;
use imogene_contract::MachineWords;
use imogene_contract::tile::{TileLight, TilePlane, TileWords};
use imogene_contract::video::{Span, VideoMode};
use imogene_golden::machine::tile::Tile;
use imogene_hdl::{Port, Simulator};
use std::collections::BTreeSet;

/// A screen on which a window comes to every edge within a few frames.
const MODE: VideoMode = VideoMode {
    line: Span::new(21, 3, 2, 4),
    frame: Span::new(13, 2, 1, 3),
    hsync_high: true,
    vsync_high: false,
};
const FRAMES: u64 = 24;

struct Screen {
    simulator: Simulator,
    hsync: Port,
    vsync: Port,
    colours: [Port; 3],
}

impl Screen {
    fn of(words: &TileWords) -> Screen {
        let simulator = Simulator::new(&machines::tile(words));
        let port = |name: &str| simulator.port(name);
        Screen {
            hsync: port("hsync"),
            vsync: port("vsync"),
            colours: ["red", "green", "blue"].map(port),
            simulator,
        }
    }

    /// The pins of the next frame, in the order of a frame: front porch, synchronisation, back porch, shown part.
    fn frame(&mut self) -> Vec<u8> {
        let (line, frame) = (MODE.line, MODE.frame);
        let mut picture = vec![];
        for (row, column) in (0..frame.total()).flat_map(|y| (0..line.total()).map(move |x| (y, x)))
        {
            self.simulator.clock();
            let mut get = |port: Port| self.simulator.get(port);
            let is_sync = |place: u64, span: Span| place.wrapping_sub(span.front) < span.sync;
            // It changes with the synchronisation of a line.
            let changes = row.wrapping_sub(u64::from(column < line.front));
            let syncs = (get(self.hsync) == 1, get(self.vsync) == 0);
            let wanted = (is_sync(column, line), is_sync(changes, frame));
            assert_eq!(syncs, wanted, "hsync and vsync at {column}, {row}");
            let colour = self.colours.map(|port| get(port) as u8);
            match column >= line.blank() && row >= frame.blank() {
                true => picture.extend(colour),
                false => assert_eq!(colour, [0; 3], "the blanking at {column}, {row}"),
            }
        }
        picture
    }
}

/// Words of a quadric that is there in most of the window, with planes and a light that are drawn.
fn words(numbers: &mut Numbers, planes: usize) -> TileWords {
    let mut within = |most: i64| numbers.below(2 * most as u64 + 1) as i64 - most;
    let mut linear = |slope: i64, most: i64| [within(slope), within(slope), within(most)];
    // Most of what they cut stays.
    let plane = |at: usize, [a, b, c]: [i64; 3]| TilePlane {
        kind: at as u64 + 1,
        depth: [a, b, c + [-40, 60, 30][at]],
        light: 20 * at as u64 + 7,
    };
    TileWords {
        mode: MODE,
        widths: MachineWords {
            root: 7,
            plane: 11,
            normal: 10,
            guard_linear: 1,
            guard_quadratic: 1,
            dropped_rows: 1,
            ..MachineWords::of(9)
        },
        window: [11, 6],
        start: [4, 3],
        f1: linear(15, 100),
        f2: [-90, -300, 40, 900, 1500, 4000],
        planes: (0..planes).map(|at| plane(at, linear(6, 30))).collect(),
        light: TileLight {
            linear: linear(900, 9000),
            factor: within(7),
            shift: 3,
            ambient: 9,
        },
        drift: within(12),
        colour: [24, 11, 5],
        background: [4, 9, 48],
    }
}

#[test]
fn every_frame_is_the_golden_one() {
    let mut numbers = Numbers(1);
    for planes in [0, 1, 2, 3, 3, 3, 3, 3] {
        let words = words(&mut numbers, planes);
        let mut golden = Tile::new(&words).expect("words of its widths");
        let mut screen = Screen::of(&words);
        let (mut places, mut pictures) = (BTreeSet::new(), BTreeSet::new());
        for frame in 0..FRAMES {
            places.insert(golden.place);
            let wanted = golden.frame();
            assert_eq!(screen.frame(), wanted, "frame {frame} of {words:?}");
            pictures.insert(wanted);
        }
        let columns: BTreeSet<u64> = places.iter().map(|place| place[0]).collect();
        let lines: BTreeSet<u64> = places.iter().map(|place| place[1]).collect();
        let seen = (columns.len(), lines.len());
        assert_eq!(seen, (11, 8), "it comes to every edge");
        assert!(pictures.len() > 8, "it moves");
    }
}
