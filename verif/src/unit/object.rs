//! The object processors and the shadow and light volumes, each tried on zones that reach every branch.

use super::description::{Description, WORDS, zone};
use super::likely::Likely::{self, Any, Bulge, Conic, Depth, Line, UpTo};
use super::likely::{even_differences, held, planes_any_kind, planned, words};
use super::words::Ports;
use crate::signal::Signal;
use crate::stimulus::{depth, mapped, word};
use crate::subject::{Inputs, Stimuli, Subject};
use imogene_contract::object::Kind;
use imogene_contract::slots::FittedSlot;
use imogene_contract::words::{BACK_PLANE, FRONT_PLANE, far_end, saturated_near};
use imogene_contract::{Request, Unit};
use imogene_golden::format::Format;
use imogene_golden::object::load_slot::held as held_by;
use imogene_golden::object::polyhedron::{self, PolyhedronWords};
use imogene_golden::object::quadric::{self, PlaneWords};
use imogene_golden::object::screen_box::ScreenBox;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::volume::{
    FROM_DEPTH, VolumeKind, VolumePlane, VolumeQuadric, VolumeWords, polyhedral_latency,
    quadric_latency,
};
use imogene_golden::object::words::Object;
use imogene_golden::object::{
    curved_facet, cylinder, facet, first_generation, patch, quotient, sphere,
};
use proptest::prelude::*;

/// The kind of a plane that cuts away what lies before it; a kind without this bit does not.
const FRONT: i64 = FRONT_PLANE as i64;

/// What the words of a processor are likely to be.
#[rustfmt::skip]
fn plan(unit: Unit) -> &'static [(&'static str, Likely)] {
    match unit {
        Unit::FacetProcessor => &[("side_", Line), ("depth_", Depth(10))],
        Unit::CurvedFacetProcessor => &[("side_", Conic), ("depth_", Bulge)],
        Unit::SphereProcessor => &[("outline_", Conic), ("front_", Bulge), ("depth_sum", Depth(1))],
        Unit::CylinderProcessor => &[("side_", Line), ("disc_", Conic), ("body_", Bulge), ("lid_", Depth(10))],
        Unit::PatchProcessor => &[("f1_", Depth(0)), ("f2_", Conic), ("plane_0_kind", Any), ("plane_", Depth(0))],
        Unit::FirstGenerationProcessor => &[("f1_", Depth(0)), ("f2_", Conic), ("depth_", Depth(0)), ("conic_", Conic), ("polar_", Line)],
        Unit::QuadricProcessor => &[("f1_", Depth(0)), ("f2_", Conic), ("plane_", Depth(0))],
        // About as many units as half a depth word has, over a denominator of a few hundred.
        Unit::QuotientProcessor => &[("numerator_", Bulge), ("denominator_", Line), ("plane_", Depth(0))],
        other => unreachable!("{other:?} hands on no single face"),
    }
}

/// Depths, face and normal behind `out_valid`, as many clocks after the flags as the processor takes.
pub(super) fn object_processor(request: &Request, format: Format) -> Description {
    let (unit, rows) = (request.unit, request.rows_per_stage);
    let count = match unit.has("sides") {
        true => request.sides,
        false => request.planes,
    };
    let planes = count as usize;
    let (kind, latency) = match unit {
        Unit::FacetProcessor => (Kind::Facet, facet::LATENCY),
        Unit::CurvedFacetProcessor => (Kind::CurvedFacet, curved_facet::LATENCY),
        Unit::SphereProcessor => (Kind::Sphere, sphere::LATENCY),
        Unit::CylinderProcessor => (Kind::Cylinder, cylinder::LATENCY),
        Unit::PatchProcessor => (Kind::Patch, patch::latency(&format, rows)),
        Unit::FirstGenerationProcessor => (
            Kind::FirstGeneration,
            first_generation::latency(&format, rows),
        ),
        Unit::QuadricProcessor => (Kind::Quadric, quadric::latency(&format, planes, rows)),
        Unit::QuotientProcessor => (Kind::Quotient, quotient::latency(&format, planes, rows)),
        other => unreachable!("{other:?} hands on no single face"),
    };
    // Words of its shape.
    let words = held_by(
        &vec![0; kind.words(planes)],
        &format,
        &FittedSlot::of(kind, count),
    );
    let pixel = |words: &ProcessorWords, [x, y]: [i64; 2], format: &Format, _: &[i64]| {
        let p = words.at(x, y, format);
        let [nx, ny, nz] = p.normal.map(i64::from);
        [p.zf, p.zb, p.number.into(), nx, ny, nz]
    };
    let plan = planned(plan(unit));
    let stimulus = move |subject: &Subject, clocks| {
        let zones = plan(subject, clocks);
        match unit {
            Unit::SphereProcessor => backs_near_the_end(subject, zones),
            Unit::PatchProcessor => {
                faces_beside_planes(subject, faces_near_the_end(subject, zones))
            }
            Unit::QuotientProcessor => {
                let zones = ends_near_the_far_end(subject, zones);
                faces_beside_planes(subject, faces_near_the_end(subject, zones))
            }
            Unit::QuadricProcessor | Unit::FirstGenerationProcessor => {
                fronts_near_the_end(subject, faces_near_the_end(subject, zones))
            }
            _ => zones,
        }
    };
    zone(
        stimulus,
        format,
        [0, latency],
        words,
        Ports::processor,
        pixel,
    )
}

/// What is free of a flat surface: which face is meant, and what changes it nowhere.
type Drawn = (bool, [i64; 2]);

/// Makes a surface flat, with one of its faces at a depth.
type Level = Box<dyn Fn(&mut Inputs, Drawn, i64)>;

/// Of a quadric, whose near or far root it is, or of a quotient, whose denominator may be as great as can be.
fn level(subject: &Subject) -> Level {
    if let Some(surface) = Surface::of(subject) {
        let level = move |inputs: &mut Inputs, (is_far, [at, _]): Drawn, depth| {
            surface.level(inputs, (is_far, at), depth);
        };
        return Box::new(level);
    }
    let place = |name| place(subject, name).expect("a word of a quotient");
    let (numerator, denominator) = (place("numerator_f"), place("denominator_c"));
    let most = subject.inputs[denominator].width - 1;
    Box::new(move |inputs, (is_down, [drawn, rest]), depth| {
        let power = 1i64 << (drawn & 63).min(most.into());
        // The least denominator alone has a magnitude of so many bits.
        let others = if power >> most == 1 { 0 } else { power - 1 };
        let divisor = power | (drawn >> 6 & others);
        let sign = if is_down || power >> most == 1 { -1 } else { 1 };
        inputs[numerator - 5..numerator].fill(0);
        inputs[numerator] = sign * (depth * divisor + rest.rem_euclid(divisor));
        inputs[denominator - 2..denominator].fill(0);
        inputs[denominator] = sign * divisor;
    })
}

/// The same zones, but that in one of so many all clocks are changed by what is drawn.
fn changed<S: Strategy<Value: Copy> + 'static>(
    zones: Stimuli,
    one_in: u32,
    drawn: S,
    change: impl Fn(&mut Inputs, S::Value) + 'static,
) -> Stimuli {
    mapped(
        (zones, 0..one_in, drawn),
        move |(mut zone, chance, drawn)| {
            let changed = zone.iter_mut().filter(|_| chance == 0);
            changed.for_each(|inputs| change(inputs, drawn));
            zone
        },
    )
}

/// One bit away from the least depth word.
fn near_the_end(width: u32) -> impl Strategy<Value = i64> + 'static {
    (0..width - 1).prop_map(move |bit| (1 << bit) - (1 << (width - 1)))
}

/// The same zones of a surface, but one in eight has flat faces, one of these one bit away from the least word.
fn faces_near_the_end(subject: &Subject, zones: Stimuli) -> Stimuli {
    let level = level(subject);
    let flat = (near_the_end(subject.outputs[1].width), any::<Drawn>());
    changed(zones, 8, flat, move |inputs, (depth, drawn)| {
        level(inputs, drawn, depth);
    })
}

/// The same zones of a quotient, but one in eight has a flat solid without planes, from the near end to one bit away
/// from the far end.
fn ends_near_the_far_end(subject: &Subject, zones: Stimuli) -> Stimuli {
    let (level, planes) = (level(subject), planes(subject));
    let is_solid = place(subject, "is_solid").expect("a word of a quotient");
    let width = subject.outputs[1].width;
    let depth = (0..width - 1).prop_map(move |bit| far_end(width) - (1 << bit));
    let flat = (depth, any::<[i64; 2]>());
    changed(zones, 8, flat, move |inputs, (depth, drawn)| {
        level(inputs, (false, drawn), depth);
        inputs[is_solid] = 1;
        planes.iter().for_each(|[kind, _]| inputs[*kind] = 0);
    })
}

/// Where a word stands among the inputs.
fn place(subject: &Subject, name: &str) -> Option<usize> {
    subject.inputs.iter().position(|signal| signal.name == name)
}

/// Where the kind and the constant of each plane stand among the inputs.
fn planes(subject: &Subject) -> Vec<[usize; 2]> {
    let word = |n, word| place(subject, &format!("plane_{n}_{word}"));
    let plane = |n: u32| Some([word(n, "kind")?, word(n, "c")?]);
    (0..).map_while(plane).collect()
}

/// The same zones, but one in eight has a flat front plane, one bit away from the least word, before most others.
fn fronts_near_the_end(subject: &Subject, zones: Stimuli) -> Stimuli {
    let planes = planes(subject);
    // The first generation has contours, and the depth of a plane that is always a front.
    let of_plane = planes.first().map(|[_, constant]| *constant);
    let Some(constant) = of_plane.or(place(subject, "depth_0_c")) else {
        return zones;
    };
    let depth = near_the_end(subject.outputs[1].width);
    changed(zones, 8, depth, move |inputs, depth| {
        planes.iter().for_each(|[kind, _]| inputs[*kind] &= !FRONT);
        if let Some([kind, _]) = planes.first() {
            inputs[*kind] = FRONT;
        }
        inputs[constant - 2..constant].fill(0);
        inputs[constant] = depth;
    })
}

/// The same zones of a surface with planes, but that in one of four one plane alone is there, flat, often beyond an
/// end, and a flat face in it or one bit away from it.
fn faces_beside_planes(subject: &Subject, zones: Stimuli) -> Stimuli {
    let planes = planes(subject);
    if planes.is_empty() {
        return zones;
    }
    let level = level(subject);
    let width = subject.outputs[1].width;
    let (least, far) = (saturated_near(width), far_end(width));
    let one_bit = (0..width - 1).prop_map(move |bit| least + (1 << bit));
    let end = prop_oneof![1 => -far..=far, 2 => Just(least), 2 => Just(far), 1 => one_bit];
    let kind = FRONT..=BACK_PLANE as i64;
    let plane = (0..planes.len(), kind, end);
    let beside = prop_oneof![Just(0), 0..width];
    let bits = (0..width, beside);
    let drawn = (plane, bits, -1..=1i64, any::<Drawn>());
    changed(
        zones,
        4,
        drawn,
        move |inputs, ((n, kind, end), bits, side, drawn)| {
            let (beyond, beside) = (1i64 << bits.0, 1i64 << bits.1);
            planes.iter().for_each(|[kind, _]| inputs[*kind] = 0);
            let [own_kind, constant] = planes[n];
            inputs[own_kind] = kind;
            inputs[constant - 2..constant].fill(0);
            inputs[constant] = match end {
                end if end == far => far + beyond,
                end if end == least => least - beyond,
                inside => inside,
            };
            level(inputs, drawn, (end + side * beside).clamp(least, far));
        },
    )
}

/// The same zones of a sphere, but one in eight has a flat front, and a back one bit away from the least word.
fn backs_near_the_end(subject: &Subject, zones: Stimuli) -> Stimuli {
    let place = |name| place(subject, name).expect("a word of a sphere");
    let (first, front, sum) = (place("front_a2"), place("front_f"), place("depth_sum"));
    let width = subject.outputs[1].width;
    changed(zones, 8, near_the_end(width), move |inputs, back| {
        inputs[first..front].fill(0);
        inputs[sum] = (inputs[front] >> (width - 2)) + back;
    })
}

pub(super) fn polyhedron_processor(format: Format, planes: usize) -> Description {
    // Both faces go on, each with its normal.
    let pixel = |words: &PolyhedronWords, [x, y]: [i64; 2], format: &Format, _: &[i64]| {
        let p = words.faces_at(x, y, format);
        let ([fx, fy, fz], [bx, by, bz]) = (p.front_normal, p.back_normal);
        let [fx, fy, fz, bx, by, bz] = [fx, fy, fz, bx, by, bz].map(i64::from);
        let (nf, nb) = (p.interval.nf.into(), p.interval.nb.into());
        [p.interval.zf, p.interval.zb, nf, fx, fy, fz, nb, bx, by, bz]
    };
    let plan = planned(&[("plane_", Depth(0))]);
    let stimulus =
        move |subject: &Subject, clocks| fronts_near_the_end(subject, plan(subject, clocks));
    let clocks = [0, polyhedron::latency(planes)];
    let mut words = PolyhedronWords::default();
    words.planes.resize_with(planes, PlaneWords::default);
    zone(stimulus, format, clocks, words, Ports::polyhedron, pixel)
}

/// Words of an object about the middle of a small zone: depths of a few thousand units, planes through them.
pub(super) fn plausible(ports: &[Signal]) -> BoxedStrategy<Vec<i64>> {
    let one = |signal: &Signal| -> BoxedStrategy<i64> {
        let spread = |range: i64| (-range..=range).boxed();
        match signal.name.as_str() {
            "f1_a" | "f1_b" => spread(300),
            "f1_c" => spread(20_000),
            "f2_a2" | "f2_b2" => spread(1 << 18),
            "f2_c" => spread(1 << 16),
            "f2_i0" | "f2_p0" => spread(1 << 22),
            "f2_f" => spread(1 << 26),
            "box_x0" | "box_y0" => (0i64..4).boxed(),
            "box_x1" | "box_y1" => (4i64..30).boxed(),
            "shift" => (0i64..3).boxed(),
            name if name.ends_with("_a") || name.ends_with("_b") => spread(2_000),
            name if name.starts_with("plane_") && name.ends_with("_c") => spread(20_000),
            _ => word(signal),
        }
    };
    let words: Vec<_> = ports.iter().map(one).collect();
    even_differences(ports, words.boxed())
}

/// The visible depth comes in before the words.
const DEPTH: usize = WORDS;

/// Whether the visible point is inside; with a quadric, whose root network has so many rows in a stage, or without.
pub(super) fn volume(format: Format, planes: usize, rows_per_stage: Option<usize>) -> Description {
    let latency = rows_per_stage.map(|rows| quadric_latency(&format, rows as u32));
    let clocks = match latency {
        Some(latency) => [latency - FROM_DEPTH, latency],
        None => [0, polyhedral_latency()],
    };
    // Shadow or light, and whose: the flags behind the processor are told, not the processor.
    let words = VolumeWords {
        kind: VolumeKind::Shadow,
        source: 0,
        screen_box: ScreenBox::EMPTY,
        margin: 0,
        quadric: latency.map(|_| VolumeQuadric::EVERYWHERE),
        planes: vec![VolumePlane::default(); planes],
    };
    let read = |ports: &mut Ports, words: &mut VolumeWords| {
        ports.number(&mut 0, |depth| depth);
        ports.volume(words);
    };
    let pixel = |words: &VolumeWords, [x, y]: [i64; 2], format: &Format, i: &[i64]| {
        [words.holds(x, y, i[DEPTH], format).into()]
    };
    zone(points, format, clocks, words, read, pixel)
}

/// Words held over a zone, and a visible depth that changes every clock: at parts of the volume, at ends, anywhere.
fn points(subject: &Subject, clocks: usize) -> Stimuli {
    let width = subject.inputs[DEPTH].width;
    let plan = [
        ("f1_", Depth(0)),
        ("f2_", Conic),
        ("plane_", Depth(0)),
        ("depth_shift", UpTo(8)),
        ("margin", UpTo((1 << (width - 1)) - 1)),
    ];
    let words = planes_any_kind(words(&subject.inputs, width, &plan), subject);
    let near = 12_000i64.min((1 << (width - 1)) - 1);
    let point = prop_oneof![3 => -near..near, 2 => -12i64..12, 1 => depth(width)];
    let surface = Surface::of(subject);
    mapped(
        (
            held(&subject.inputs, words, clocks),
            proptest::collection::vec(point, clocks),
            proptest::option::of((any::<bool>(), any::<i64>())),
        ),
        move |(mut list, points, flat)| {
            for (inputs, point) in list.iter_mut().zip(points) {
                // The golden model takes no more than half the depth word.
                inputs[DEPTH + 1] &= (1 << (width - 1)) - 1;
                inputs[DEPTH] = point;
                if let (Some((is_far, at)), Some(surface)) = (flat, &surface) {
                    surface.flatten(inputs, is_far, at, width);
                }
            }
            list
        },
    )
}

/// Where the words of a quadric stand among the inputs.
struct Surface {
    /// The first word of the linear part, and the last one of the quadratic part, which follows it.
    linear: usize,
    constant: usize,
    /// The longest constant.
    longest: i64,
    /// Of a volume.
    shift: Option<usize>,
}

impl Surface {
    /// `None` if there are none.
    fn of(subject: &Subject) -> Option<Surface> {
        let constant = place(subject, "f2_f")?;
        Some(Surface {
            linear: place(subject, "f1_a")?,
            constant,
            longest: i64::MAX >> (64 - subject.inputs[constant].width),
            shift: place(subject, "depth_shift"),
        })
    }

    /// Makes both depths of the quadric constant, of any root, and one of them this.
    fn level(&self, inputs: &mut Inputs, (is_far, at): (bool, i64), depth: i64) {
        let drawn = inputs[self.constant];
        let drawn = if drawn < 0 { !drawn } else { drawn };
        let root = drawn.isqrt();
        // Any, or the least and the greatest of a root.
        let radicand = match at & 3 {
            0 => root * root,
            // Of the longest words the greatest one has no place in a word.
            1 => (root * root).saturating_add(2 * root),
            _ => drawn,
        };
        inputs[self.linear..=self.constant].fill(0);
        inputs[self.constant] = radicand;
        inputs[self.linear + 2] = if is_far { depth - root } else { depth + root };
    }

    /// The same, and the visible point is near it, or as far behind it as the margin is: the lowest digit of the root
    /// decides, often of a long one.
    fn flatten(&self, inputs: &mut Inputs, is_far: bool, at: i64, width: u32) {
        if at >> 2 & 3 == 0 {
            inputs[self.constant] = at.rotate_left(20) & self.longest;
        }
        let unit = self.shift.map_or(0, |place| inputs[place]);
        let end = 1i64 << (width - 1);
        let depth = ((at >> 2).rem_euclid(2 * end) - end) >> unit;
        self.level(inputs, (is_far, at), depth);
        let margin = (inputs[DEPTH] >> 7 & 1) * inputs[DEPTH + 1];
        let point = (depth << unit) + margin + inputs[DEPTH].rem_euclid(5 << unit) - (2 << unit);
        inputs[DEPTH] = point.clamp(-end, end - 1);
    }
}
