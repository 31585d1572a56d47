//! The search for the smallest machine: what is found meets the budget, and one bit less anywhere does not.

mod budget;
mod estimate;

use imogene_contract::MachineWords;
use imogene_contract::slots::FittedSlot;
use imogene_plan::description::{MachineDescription, MachineKind};
use imogene_plan::zone::clocks::ZoneTiming;
use imogene_scene::SceneFile;
use imogene_studies::fit::budget::{Budget, CountLimit, DepthLimit};
use imogene_studies::fit::frames::{Drawn, Frames};
use imogene_studies::fit::machine::{Fitted, Pace, machine};
use imogene_studies::fit::proof::Proof;
use imogene_studies::fit::search::{Outcome, search};
use imogene_studies::fit::{FitError, proof};
use imogene_studies::kit::words::widest;
use imogene_testkit::{scene_file, scene_path};
use std::sync::atomic::{AtomicUsize, Ordering};

const SIZE: Option<(u32, u32)> = Some((48, 36));

fn file(name: &str) -> (String, SceneFile) {
    (name.to_owned(), scene_file(name))
}

fn frames(names: &[&str]) -> Result<Frames, FitError> {
    let files: Vec<_> = names.iter().map(|name| file(name)).collect();
    Frames::new(&files, SIZE, None, || ())
}

fn found(frames: &Frames, budget: &Budget) -> Vec<Drawn> {
    match search(frames, budget, || ()).unwrap() {
        Outcome::Fits(found) => found,
        Outcome::Unreachable(nearest) => panic!("out of reach: {:?}", nearest.items),
    }
}

fn words_of(drawn: &Drawn) -> MachineWords {
    let w = &drawn.widths;
    let guards = (w.guard_linear, w.guard_quadratic);
    widest(w.depth, w.normal, guards, w.dropped_rows)
}

fn budgets() -> [Budget; 3] {
    let nothing = Budget::default();
    let depth = |limit| Budget {
        depth: Some(limit),
        ..nothing
    };
    let share = Some(CountLimit::Percent(0.1));
    [
        Budget {
            silhouette: Some(CountLimit::Pixels(0)),
            ..depth(DepthLimit::Words(1.0))
        },
        depth(DepthLimit::Pixels(0.5)),
        Budget {
            colour: Some(2.0),
            silhouette: share,
            faces: share,
            ..nothing
        },
    ]
}

#[test]
fn what_is_found_meets_the_budget_and_one_bit_less_does_not() {
    for name in ["cut-sphere", "crossing-cylinders"] {
        let frames = frames(&[name]).unwrap();
        for budget in budgets() {
            let found = found(&frames, &budget);
            assert!(!found.is_empty() && found.iter().all(Drawn::fits));
            for drawn in &found {
                let words = words_of(drawn);
                let fits = |words: &MachineWords| {
                    let drawn = frames.draw(words, &budget).unwrap();
                    drawn.is_some_and(|drawn| drawn.fits())
                };
                let mut less = vec![];
                if let Some(guard_linear) = words.guard_linear.checked_sub(1) {
                    less.push(MachineWords {
                        guard_linear,
                        ..words
                    });
                }
                if words.normal > 10 {
                    let normal = words.normal - 1;
                    less.push(MachineWords { normal, ..words });
                }
                for less in less {
                    assert!(!fits(&less), "{name}, {budget:?}: {less:?} fits too");
                }
            }
        }
    }
}

/// A machine of these words, whose passes take a few clocks more than their pixels.
fn machine_of(frames: &Frames, drawn: &Drawn, pace: Option<Pace>) -> Result<Fitted, FitError> {
    let timing = |_: &MachineDescription| ZoneTiming {
        draw_drain: 40,
        light_drain: 40,
        show_drain: 3,
        settle: 40,
        command: 1,
    };
    machine(frames, drawn, 1, pace, &timing)
}

fn beam_slots(frames: &Frames, drawn: &Drawn) -> Vec<FittedSlot> {
    let machine = machine_of(frames, drawn, None).unwrap();
    assert_eq!(machine.description.machine, MachineKind::Beam);
    machine.description.slots()
}

/// The words that are not searched are those that the scene requires: a bit less of the root or the planes and it
/// cannot be prepared.
#[test]
fn the_machine_has_the_planes_that_its_objects_have() {
    let frames = frames(&["cut-sphere"]).unwrap();
    let drawn = &found(&frames, &budgets()[1])[0];
    let slots = beam_slots(&frames, drawn);
    let objects = frames.all[0].scene.objects.iter();
    let objects: Vec<usize> = objects.map(|o| o.quadric().unwrap().planes.len()).collect();
    let planes: Vec<usize> = slots.iter().map(|s| s.planes as usize).collect();
    assert_eq!(planes, objects);
    assert!(drawn.widths.root < drawn.widths.depth && drawn.widths.plane < drawn.widths.depth + 12);
}

/// At every pixel of every object, in whole numbers: what f2 and the planes come to is in the words of its slot, and a
/// bit less of the root would be too short for half of the slots.
#[test]
fn every_value_of_an_object_is_in_the_words_of_its_slot() {
    let frames = frames(&["teapot"]).unwrap();
    let drawn = &found(&frames, &budgets()[1])[0];
    let slots = beam_slots(&frames, drawn);
    let own = slots.iter().filter(|slot| slot.root.is_some()).count();
    assert!(own >= 5, "{slots:?}");
    let (machine, guards) = (&drawn.widths, drawn.widths.guard_quadratic);
    let bits = |value: i128| 129 - (value ^ (value >> 127)).leading_zeros();
    let mut is_tight = 0;
    for ((_, object), slot) in drawn.prepared[0].quadrics().zip(&slots) {
        let (words, widths) = (&object.words, slot.words(machine));
        let (mut f2, mut plane) = (0, 0);
        for (x, y) in words.screen_box.each() {
            let (x, y) = (i128::from(x), i128::from(y));
            let q = &words.f2;
            let value = q.a * x * x + q.b * y * y + q.c * x * y + q.d * x + q.e * y + q.f;
            f2 = f2.max(bits(value >> guards));
            for cut in &words.planes {
                plane = plane.max(bits(cut.depth.a * x + cut.depth.b * y + cut.depth.c));
            }
        }
        let fits = f2 <= 2 * widths.root && plane <= widths.plane;
        assert!(fits, "{slot}: {f2}, {plane}");
        is_tight += usize::from(f2 > 2 * (widths.root - 1));
    }
    assert!(2 * is_tight >= slots.len(), "{is_tight} of {slots:?}");
}

#[test]
fn limits_are_proven_by_bounds_where_these_are_not_above_them() {
    let frames = frames(&["cut-sphere"]).unwrap();
    let budget = Budget {
        depth: Some(DepthLimit::Pixels(0.5)),
        colour: Some(2.0),
        ..Budget::default()
    };
    let drawn = &found(&frames, &budget)[0];
    let bounds = proof::bounds(&frames, drawn);
    let proofs = proof::proofs(&frames, &budget, drawn, Some(&bounds));
    for proof in &proofs {
        if let Some(bound) = proof.bound {
            assert!(proof.item.measured <= bound, "{proof:?}");
            let is_proven = bound <= proof.item.allowed;
            assert_eq!(proof.proof == Proof::Bound, is_proven, "{proof:?}");
        } else {
            let found = (proof.item.limit, proof.proof);
            assert_eq!(found, ("colour", Proof::Exhaustive));
        }
    }
}

/// An animation is fitted over all of its frames: the machine meets the budget in each, and needs at least what each
/// needs.
#[test]
fn an_animation_takes_the_worst_of_its_frames() {
    let text = std::fs::read_to_string(scene_path("cut-sphere")).unwrap();
    let moved = text.replace("eye = [0.37, 3.89, 9.61]", "eye = [0.4, 2.9, 8.6]");
    assert_ne!(moved, text);
    let files = [text, moved].map(|text| {
        let file = SceneFile::parse(&text, "a frame").unwrap();
        ("a frame".to_owned(), file)
    });
    let both = Frames::new(&files, SIZE, None, || ()).unwrap();
    let budget = budgets()[0];
    let drawn = &found(&both, &budget)[0];
    assert_eq!((drawn.prepared.len(), drawn.metrics.len()), (2, 2));
    for (index, file) in files.iter().enumerate() {
        let one = Frames::new(std::slice::from_ref(file), SIZE, None, || ()).unwrap();
        let alone = one.draw(&words_of(drawn), &budget).unwrap().unwrap();
        assert!(alone.fits());
        assert!(alone.widths.root <= drawn.widths.root, "frame {index}");
        assert!(alone.widths.plane <= drawn.widths.plane, "frame {index}");
    }
}

#[test]
fn an_unreachable_budget_is_told_with_the_nearest_machine() {
    let frames = frames(&["cut-sphere"]).unwrap();
    let budget = Budget {
        normal: Some(0.0),
        depth: Some(DepthLimit::Pixels(1.0)),
        ..Budget::default()
    };
    match search(&frames, &budget, || ()).unwrap() {
        Outcome::Fits(_) => panic!("normals of integers are not exact"),
        Outcome::Unreachable(nearest) => {
            let broken = nearest.items.iter().filter(|i| !i.holds());
            let broken: Vec<&str> = broken.map(|i| i.limit).collect();
            assert_eq!(broken, ["normal"]);
            assert_eq!(nearest.widths.normal, 16);
        }
    }
}

/// The words of polyhedra and facets follow from the depth word, and nothing is proven of their errors.
#[test]
fn what_is_no_quadric_is_fitted_by_its_depth_word_alone() {
    let budget = Budget {
        depth: Some(DepthLimit::Pixels(1.0)),
        ..Budget::default()
    };
    for name in ["processors/polyhedron", "processors/mesh"] {
        let frames = frames(&[name]).unwrap();
        let drawn = &found(&frames, &budget)[0];
        assert!(drawn.fits() && !frames.has_bounds, "{name}");
        let words = MachineWords {
            guard_linear: drawn.widths.guard_linear,
            guard_quadratic: drawn.widths.guard_quadratic,
            ..MachineWords::of(drawn.widths.depth)
        };
        assert_eq!(drawn.widths, words, "{name}");
        let proofs = proof::proofs(&frames, &budget, drawn, None);
        assert!(proofs.iter().all(|p| p.proof == Proof::Exhaustive));
    }
}

/// More frames per second take more processors, and what none reaches is refused with what the fastest does.
#[test]
fn a_zone_machine_has_the_processors_that_its_pace_takes() {
    let zone = Some(MachineKind::Zone);
    let frames = Frames::new(&[file("teapot")], SIZE, zone, || ()).unwrap();
    let drawn = &found(&frames, &budgets()[1])[0];
    let with = |pace: Option<f64>| {
        let pace = pace.map(|frames| Pace { frames, mhz: 1.0 });
        machine_of(&frames, drawn, pace)
    };
    let smallest = with(None).unwrap();
    assert_eq!(smallest.description.objects, 1);
    let paced = 1.5e6 / smallest.clocks as f64;
    let faster = with(Some(paced)).unwrap();
    assert!(faster.description.objects > 1);
    assert!(faster.clocks as f64 * paced <= 1e6);
    let error = with(Some(1e4)).err().unwrap().to_string();
    let said = "10000 frames per second at 1 MHz";
    assert!(error.contains(said), "{error}");
}

/// What a description says as text is read back as the same machine.
#[test]
fn a_fitted_machine_is_a_file() {
    for kind in [MachineKind::Beam, MachineKind::Zone] {
        let frames = Frames::new(&[file("front-view")], SIZE, Some(kind), || ()).unwrap();
        let drawn = &found(&frames, &budgets()[1])[0];
        let machine = machine_of(&frames, drawn, None).unwrap().description;
        let text = machine.to_toml();
        let again = MachineDescription::parse(&text, "machine.toml").unwrap();
        assert_eq!(again, machine, "{text}");
        assert_eq!(again.format().unwrap().widths(), drawn.widths);
        assert_eq!(again.drawn_size(), SIZE);
    }
}

#[test]
fn what_cannot_be_fitted_is_refused_by_name() {
    let refused = |names: &[&str]| frames(names).err().map(|e| e.to_string()).unwrap();
    let message = refused(&["cut-sphere", "teapot"]);
    assert!(message.contains("teapot: 10 objects"), "{message}");
    let message = refused(&["extremes/eye-barely-inside"]);
    assert!(message.contains("'shell'"), "{message}");
    let frames = frames(&["cut-sphere"]).unwrap();
    let counted = AtomicUsize::new(0);
    let count = || {
        counted.fetch_add(1, Ordering::Relaxed);
    };
    let error = search(&frames, &Budget::default(), count).err().unwrap();
    assert!(error.to_string().contains("--max-depth-error"));
    assert_eq!(counted.into_inner(), 0);
}
