//! One solid with its cut planes, small enough for a tile of a shared chip.

use super::tile_raster::{TileScan, tile_raster};
use crate::arith::Network;
use crate::object::{HalfSpace, Limits, Roots, Widths, absent, quadric_cut, quadric_pe};
use crate::raster::{Linear, Quadratic, pe1};
use imogene_contract::tile::{
    FACTOR, LIGHT, LIGHT_FRACTION, LIGHT_LINEAR, PIN_BITS, TileLight, TilePlane, TileWords,
};
use imogene_contract::words::{FIRST_PLANE, SIDE};
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, module, net, unregistered};

bundles! {
    /// The pins of a tile.
    TilePins {
        hsync: Bits as "hsync", "synchronisation of the line, with the polarity of the mode";
        vsync: Bits as "vsync", "synchronisation of the frame, with the polarity of the mode";
        red: Bits as "red", "red of the pixel; 0 in the blanking";
        green: Bits as "green", "green of the pixel";
        blue: Bits as "blue", "blue of the pixel";
    }
}

/// Clocks from the raster flags to the sums: a PE, the root, the sums.
const LEAD: u64 = 3;

/// A number modulo a width.
fn word(value: i64, width: u32) -> u64 {
    value as u64 & (u64::MAX >> (u64::BITS - width))
}

fn constant(value: i64, width: u32) -> Int {
    Int::literal(word(value, width), width)
}

fn linear(words: [i64; 3], width: u32) -> Linear {
    Linear::of(words.map(|word| constant(word, width)))
}

/// Draws one solid, one pixel a clock, in a window that goes over the screen and turns at its edges; the depth of its
/// first plane goes with it. All words are constants, so that synthesis leaves of every unit what they need.
///
/// The units are those of a quadric processor. A clock of 40 ns has time for all rows of the root, and for all that is
/// behind the sums of the two depths: there is no register but that of the pins. `docs/boards.md`.
pub fn tile(at: &str, words: &TileWords) -> TilePins {
    module("tile", at, (), |()| {
        let scan = tile_raster("raster", words, LEAD);
        let (light, is_there) = seen(scan, words);
        let colour = |part: usize| {
            let lit = light * Bits::new(words.colour[part], FACTOR);
            let around = Bits::new(words.background[part], LIGHT);
            let level = is_there.select(lit.high(LIGHT), around);
            let dithered = level + scan.threshold.extend(LIGHT);
            let none = Bits::new(0, PIN_BITS);
            scan.is_shown.select(dithered.high(PIN_BITS), none).reg()
        };
        TilePins {
            hsync: scan.hsync,
            vsync: scan.vsync,
            red: colour(0),
            green: colour(1),
            blue: colour(2),
        }
    })
}

/// The light of the face that is seen at a pixel of the window, and whether there is one.
fn seen(scan: TileScan, words: &TileWords) -> (Bits, Bits) {
    let rows = words.widths.root - words.widths.dropped_rows;
    let (root, widths) = (Network::of(&words.widths, rows), Widths::of(&words.widths));
    let [a, b, c, d, e, f] = words.f2;
    let f2 = [2 * a, 2 * b, c, e + b, d + a, f].map(|word| constant(word, widths.quadratic));
    let f = (linear(words.f1, widths.linear), Quadratic::of(f2));
    let (depths, early) = quadric_pe("quadric", scan.flags, f, root);
    let late = early.delayed(2);
    let roots = Roots {
        near_sum: depths.near_sum,
        far_sum: depths.far_sum,
        is_inside: depths.is_inside,
        in_box: late.valid.delay(1),
    };
    let still = pe1("light", late, linear(words.light.linear, LIGHT_LINEAR));
    let half_space = |plane: &TilePlane| HalfSpace {
        kind: Bits::new(plane.kind, 2),
        linear: linear(plane.depth, widths.plane),
    };
    let mut planes: Vec<HalfSpace> = words.planes.iter().map(half_space).collect();
    if let Some(first) = planes.first_mut() {
        let begin = words.planes[0].depth[2];
        first.linear.c = drifting(scan, widths.plane, (begin, words.drift));
    }
    let seen = unregistered(|| {
        let limits = Limits::of(late, &planes, root.depth);
        quadric_cut("cut", roots, Bits::new(SIDE, 2), limits)
    });
    let on_quadric = lit(depths.root, still, &words.light);
    let planes = words.planes.iter().zip(FIRST_PLANE..);
    let light = planes.fold(on_quadric, |other, (plane, number)| {
        let is_seen = seen.number.is(number);
        is_seen.select(Bits::new(plane.light, LIGHT), other)
    });
    (light, !seen.zf.equals(absent(root.depth)))
}

/// A word that grows in frames in which the window goes to the right, and shrinks in others.
fn drifting(scan: TileScan, width: u32, (begin, step): (i64, i64)) -> Int {
    let [ahead, back] = [step, -step].map(|step| constant(step, width));
    net! {
        let drifted = Int::register(width).initially(word(begin, width));
        let next = drifted + scan.goes_right.select(ahead, back);
    }
    drifted.load_when(scan.steps, next);
    drifted
}

/// The light on the quadric, of its linear part and the root.
fn lit(root: Bits, still: Int, light: &TileLight) -> Bits {
    // Both signs of three bits of a factor.
    let width = root.width() + 4;
    net! {
        let product = (root.extend(width).int() * constant(light.factor, 4)).low(width);
        let turned = product.high(width - light.shift);
        let whole = still.high(LIGHT_LINEAR - LIGHT_FRACTION);
    }
    let width = whole.width().max(turned.width()) + 1;
    net! {
        let sum = whole.extend(width) + turned.extend(width);
        let is_dark = sum.less(constant(light.ambient as i64, width));
        let is_full = !sum.high(width - LIGHT).bits().is(0);
    }
    let most = Bits::new((1 << LIGHT) - 1, LIGHT);
    let bright = is_full.select(most, sum.low(LIGHT).bits());
    is_dark.select(Bits::new(light.ambient, LIGHT), bright)
}
