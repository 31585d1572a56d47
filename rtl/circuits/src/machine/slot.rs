//! Places for objects, and the processors in them that are not of quadrics.

use super::{Held, LoadBus, coefficient_hold, coefficient_store};
use crate::arith::Network;
use crate::object::{
    Cylinder, Facet, Factors, FirstGeneration, Gradients, HalfSpace, Normal, Patch, Plane,
    Polyhedron, Quadric, Quotient, ScreenBox, Sphere, Visible, Widths, curved_facet_processor,
    cylinder_processor, facet_processor, first_generation_processor, levels_beyond,
    patch_processor, polyhedron_processor, quadric_processor, quotient_processor,
    quotient_processor_clocks, sphere_processor,
};
use crate::raster::{Laned, Linear, Quadratic, Scan};
use crate::rows::numbered;
use crate::tree::levels;
use imogene_contract::object::{CONTROL, Kind};
use imogene_contract::slots::FittedSlot;
use imogene_contract::words;
use imogene_hdl::{Bits, Bundle, Int, Plain, Ports, Value, module, net};

/// Clocks from the flags of a pixel to what the processor of a slot sees.
pub(super) fn slot_clocks(slot: &FittedSlot, root: &Network) -> u32 {
    match slot.kind {
        Kind::Quadric => root.latency() + 11 + levels_beyond(slot.planes as usize),
        Kind::Patch => root.latency() + 9,
        Kind::FirstGeneration => root.latency() + 9,
        Kind::Polyhedron => levels(slot.planes as usize) + 6,
        Kind::Facet | Kind::CurvedFacet | Kind::Cylinder => 3,
        Kind::Sphere => 4,
        Kind::Quotient => {
            quotient_processor_clocks(root.depth, root.rows_per_stage, slot.planes as usize)
        }
    }
}

/// Bits of the load bus of slots in words of these widths.
pub(super) fn bus(slots: &[FittedSlot], widths: &Widths) -> u32 {
    let numerator = match slots.iter().any(|slot| slot.kind == Kind::Quotient) {
        true => widths.numerator(),
        false => 0,
    };
    widths.bus().max(numerator)
}

/// The words of a store, each at the next address.
struct Words {
    bus: LoadBus,
    take: Option<Bits>,
    next: u64,
}

impl Words {
    fn take(&mut self, words: u64) -> u64 {
        self.next += words;
        self.next - words
    }

    fn number(&mut self, width: u32) -> Int {
        self.bus.number(self.take(1), width)
    }

    fn bits(&mut self, width: u32) -> Bits {
        self.bus.bits(self.take(1), width - 1, 0)
    }

    fn numbers<const N: usize>(&mut self, width: u32) -> [Int; N] {
        self.bus.numbers(self.take(N as u64), width)
    }

    fn linear(&mut self, width: u32) -> Linear {
        Linear::of(self.numbers(width))
    }

    fn quadratic(&mut self, width: u32) -> Quadratic {
        Quadratic::of(self.numbers(width))
    }

    fn normal(&mut self, width: u32) -> Normal {
        Normal::of(self.numbers(width))
    }

    fn half_space(&mut self, width: u32) -> HalfSpace {
        HalfSpace {
            kind: self.bits(2),
            linear: self.linear(width),
        }
    }

    /// At power-up it is empty, and where words are taken over that were not written.
    fn screen_box(&mut self) -> ScreenBox {
        let columns = self.take(2);
        net! { let inverted_box_x0 = (!self.bus.data.low(12)).reg_when(self.bus.writes(columns)); }
        let box_x0 = match self.take {
            Some(take) => {
                let nowhere = Bits::new(0xfff, 12);
                let is_present = self.bus.is_new(columns, take);
                is_present.select(!inverted_box_x0, nowhere)
            }
            None => !inverted_box_x0,
        };
        self.bus.screen_box(columns, box_x0)
    }

    /// Words of the quadric of a surface, its screen box before them.
    fn quadric(&mut self, widths: Widths) -> Quadric {
        let screen_box = self.screen_box();
        let f1 = self.linear(widths.linear);
        let f2 = self.quadratic(widths.quadratic);
        Quadric {
            f1,
            f2,
            gradients: self.gradients(widths),
            screen_box,
            shift: self.bits(5),
        }
    }

    fn gradients(&mut self, widths: Widths) -> Gradients {
        let [gx, gy, gz] = [(); 3].map(|()| self.linear(widths.gradient));
        let factors = Factors::of(self.numbers(widths.normal));
        Gradients {
            gx,
            gy,
            gz,
            factors,
        }
    }

    /// Planes with their normals.
    fn planes(&mut self, count: usize, widths: Widths) -> Vec<Plane> {
        self.many(count, |words| Plane {
            half_space: words.half_space(widths.plane),
            normal: words.normal(widths.normal),
        })
    }

    fn many<T>(&mut self, count: usize, mut one: impl FnMut(&mut Words) -> T) -> Vec<T> {
        (0..count).map(|_| one(self)).collect()
    }
}

/// A slot among others: the names in it, and how words come to its processor.
pub(super) struct Place {
    /// Name of its processor.
    pub at: String,
    /// Name of the store of its words.
    pub store: String,
    /// Its load bus.
    pub bus: LoadBus,
    /// Where words are held, the name of what holds them or the id, and when a pass takes over what was written.
    pub hold: Option<(String, Bits)>,
}

/// Words of a quadric, and the id of the object where they are held.
pub(super) type Stored = (crate::object::Words, Option<Bits>);

impl Place {
    /// Keeps the words of one object of a kind. They act from the clock after they are written until they are written
    /// again, held ones from when they are taken over until that is done again.
    fn words<B: Ports>(&self, kind: Kind, words: impl FnOnce(&mut Words) -> B) -> B::Bare {
        let (at, bus, next) = (&self.store, self.bus, 0);
        let Some((_, take)) = self.hold else {
            let take = None;
            let name = format!("{}_store", kind.name());
            return module(&name, at, bus, |bus| words(&mut Words { bus, take, next }));
        };
        let inputs = (("take", take), bus);
        let name = format!("{}_shared_store", kind.name());
        module(&name, at, inputs, |(take, bus)| {
            let written = words(&mut Words {
                bus,
                take: Some(take),
                next,
            });
            written.registered_when(take)
        })
    }

    /// Those of a quadric, which has its store apart.
    pub(super) fn stored(&self, slot: &FittedSlot, widths: Widths) -> Option<Stored> {
        if slot.kind != Kind::Quadric {
            return None;
        }
        let words = coefficient_store(&self.store, self.bus, widths, slot.planes.into());
        let Some((at, take)) = &self.hold else {
            return Some((words, None));
        };
        let (id, held) = coefficient_hold(at, *take, self.bus, Held::of(&words));
        Some((held.in_place(words), Some(id)))
    }

    /// Those of a quadric, held as a whole: none of them acts before they are taken over.
    pub(super) fn whole(&self, slot: &FittedSlot, widths: Widths) -> Option<crate::object::Words> {
        if slot.kind != Kind::Quadric {
            return None;
        }
        let mut words = coefficient_store(&self.store, self.bus, widths, slot.planes.into());
        let Some((_, take)) = self.hold else {
            return Some(words);
        };
        let screen_box = &mut words.quadric.screen_box;
        let nowhere = Bits::new(0xfff, 12);
        let is_present = self.bus.is_new(CONTROL, take);
        screen_box.box_x0 = is_present.select(screen_box.box_x0, nowhere);
        Some(words.registered_when(take))
    }

    /// The id of an object of another kind, where words are held.
    fn id(&self) -> Option<Bits> {
        let (at, take) = self.hold.as_ref()?;
        let inputs = (("take", *take), self.bus);
        let id = module("object_id", at, inputs, |(take, bus)| {
            ("id", bus.held_id(take))
        });
        Some(id)
    }
}

/// Words of a facet.
type FacetWords<P> = (
    ScreenBox,
    (&'static str, Vec<P>),
    (&'static str, P),
    (&'static str, Vec<P>),
);

/// Words of a facet of polynomials.
fn facet_words<P: Plain + Copy>(
    (kind, sides): (Kind, usize),
    place: &Place,
    side: impl Fn(&mut Words) -> P,
    part: impl Fn(&mut Words) -> P,
) -> Facet<P> {
    let words = |words: &mut Words| -> FacetWords<P> {
        let screen_box = words.screen_box();
        let sides = ("side", words.many(sides, &side));
        let depth = ("depth", side(words));
        (screen_box, sides, depth, ("normal", words.many(3, &part)))
    };
    let (screen_box, sides, depth, normal) = place.words(kind, words);
    Facet {
        screen_box,
        sides,
        depth,
        normal: [normal[0], normal[1], normal[2]],
    }
}

/// The raster of a slot and those of its lanes, all with the same words.
pub(super) struct Lanes<'a> {
    /// Of the words that change from line to line.
    pub raster: Scan,
    /// Of each lane.
    pub scans: &'a [Scan],
}

impl Lanes<'_> {
    /// The processor of each lane: its name, its raster and its words; one alone takes them as they are.
    pub(super) fn of<W: Laned>(&self, at: &str, words: W) -> Vec<(String, Scan, W)> {
        if let [scan] = self.scans {
            return vec![(at.to_owned(), *scan, words)];
        }
        let words = words.laned(at, self.raster.flags, self.scans.len() as u32);
        let lanes = numbered(&format!("{at}_lane"), self.scans.iter().zip(words));
        let lanes = lanes.map(|(at, (scan, words))| (at, *scan, words));
        lanes.collect()
    }

    /// What processors of one shape see in each lane.
    fn each<W: Laned, S: Copy>(
        &self,
        at: &str,
        words: W,
        shape: S,
        processor: impl Fn(&str, Scan, W, S) -> Visible,
    ) -> Vec<Visible> {
        let lanes = self.of(at, words).into_iter();
        let seen = lanes.map(|(at, scan, words)| processor(&at, scan, words, shape));
        seen.collect()
    }
}

/// A processor of any kind in each lane, where it is not of quadrics with the store of its words; and the id of the
/// object where these are held.
pub(super) fn processor(
    slot: &FittedSlot,
    (place, stored): (&Place, Option<Stored>),
    lanes: &Lanes,
    (widths, root): (Widths, Network),
) -> (Vec<Visible>, Option<Bits>) {
    let (stored, id) = match stored {
        Some((words, id)) => (Some(words), id),
        None => (None, place.id()),
    };
    (seen(slot, (place, stored), lanes, (widths, root)), id)
}

/// What a processor of any kind sees in each lane; that of another one than quadrics has the store of its words.
pub(super) fn seen(
    slot: &FittedSlot,
    (place, stored): (&Place, Option<crate::object::Words>),
    lanes: &Lanes,
    (widths, root): (Widths, Network),
) -> Vec<Visible> {
    let at = &place.at;
    let (kind, planes) = (slot.kind, slot.planes as usize);
    // Guard bits are those of f1 and f2 alone.
    let (linear, quadratic) = (widths.plane, words::quadratic(root.digits));
    match kind {
        Kind::Quadric => {
            let words = stored.expect("quadrics have a store apart");
            lanes.each(at, words, root, quadric_processor)
        }
        Kind::Patch => {
            let words = place.words(kind, |words| Patch {
                quadric: words.quadric(widths),
                planes: words.many(planes, |words| words.half_space(linear)),
            });
            lanes.each(at, words, root, patch_processor)
        }
        Kind::FirstGeneration => {
            let pair = |words: &mut Words| [words.linear(linear), words.linear(linear)].to_vec();
            let words = place.words(kind, |words| FirstGeneration {
                quadric: words.quadric(widths),
                surface: words.bits(1),
                depths: pair(words),
                conics: words.many(2, |words| words.quadratic(quadratic)),
                polars: pair(words),
                normals: words.many(1, |words| words.normal(widths.normal)),
            });
            lanes.each(at, words, root, first_generation_processor)
        }
        Kind::Polyhedron => {
            let words = place.words(kind, |words| Polyhedron {
                screen_box: words.screen_box(),
                planes: words.planes(planes, widths),
            });
            lanes.each(at, words, root.depth, |at, scan, words, depth| {
                let seen = polyhedron_processor(at, scan, words, depth);
                Visible {
                    front: seen.front,
                    number: seen.number,
                    normal: seen.normal,
                }
            })
        }
        Kind::Quotient => {
            let words = place.words(kind, |words| Quotient {
                screen_box: words.screen_box(),
                numerator: words.quadratic(widths.numerator()),
                denominator: words.linear(widths.denominator()),
                gradients: words.gradients(widths),
                shift: words.bits(5),
                is_solid: words.bits(1),
                normal_from: words.number(widths.depth),
                planes: words.planes(planes, widths),
            });
            lanes.each(at, words, root, quotient_processor)
        }
        Kind::Facet => {
            let side = |words: &mut Words| words.linear(linear);
            let part = |words: &mut Words| words.linear(widths.gradient);
            let facet = facet_words((kind, planes), place, side, part);
            lanes.each(at, facet, root.depth, facet_processor)
        }
        Kind::CurvedFacet => {
            let word = |words: &mut Words| words.quadratic(quadratic);
            let facet = facet_words((kind, planes), place, word, word);
            lanes.each(at, facet, root.depth, curved_facet_processor)
        }
        Kind::Sphere => {
            let sum = words::depth_sum(root.depth);
            let words = place.words(kind, |words| Sphere {
                screen_box: words.screen_box(),
                outline: words.quadratic(quadratic),
                front: words.quadratic(quadratic),
                depth_sum: words.number(sum),
                nx: words.linear(widths.gradient),
                ny: words.linear(widths.gradient),
                nz: words.quadratic(quadratic),
            });
            lanes.each(at, words, (), |at, scan, words, ()| {
                sphere_processor(at, scan, words)
            })
        }
        Kind::Cylinder => {
            let words = place.words(kind, |words| Cylinder {
                screen_box: words.screen_box(),
                sides: words.many(4, |words| words.linear(linear)),
                discs: words.many(2, |words| words.quadratic(quadratic)),
                body: words.quadratic(quadratic),
                nx: words.quadratic(quadratic),
                ny: words.quadratic(quadratic),
                nz: words.quadratic(quadratic),
                lid: words.linear(linear),
                lid_normal: words.normal(widths.normal),
            });
            lanes.each(at, words, root.depth, cylinder_processor)
        }
    }
}
