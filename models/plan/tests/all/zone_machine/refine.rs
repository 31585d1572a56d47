//! A refined plan draws the same picture from less, and the count of its clocks is that of its stream.

use super::clocks::{TIMING, by_beats};
use super::{
    MACHINE, MACHINES, Truth, machine_of, planned, polyhedra_with_shadows, scene, with_facets,
};
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_plan::zone::clocks::clocks;
use imogene_plan::zone::plan::Zone;
use imogene_plan::zone::refine::Refinement;
use imogene_prepare::PreparedScene;

const REFINEMENTS: [Refinement; 3] = [Refinement::Box, Refinement::Bounds, Refinement::Pixels];

fn is_part_of(less: &[u32], more: &[u32]) -> bool {
    less.iter().all(|index| more.contains(index))
}

/// The counts of a scene on one machine, box to pixels: parts, volumes, beats, clocks.
pub fn assert_same(prepared: &PreparedScene, machine: ZoneMachine, truth: &Truth) -> [[u64; 4]; 3] {
    let plan = planned(prepared, machine);
    let mut before: Option<Vec<Zone>> = None;
    REFINEMENTS.map(|refinement| {
        let refined = plan.clone().refined(refinement);
        truth.assert_is_drawn(&refined);
        let counted = clocks(&refined, &TIMING);
        assert_eq!(counted.total, by_beats(refined.beats(), &TIMING));
        assert_eq!(counted.beats, refined.beats().count() as u64);
        if let Some(before) = &before {
            for (less, more) in refined.zones.iter().zip(before) {
                assert!(is_part_of(&less.parts, &more.parts), "{refinement:?}");
                assert!(is_part_of(&less.volumes, &more.volumes), "{refinement:?}");
            }
        }
        let zones = &refined.zones;
        let parts: usize = zones.iter().map(|zone| zone.all_parts().count()).sum();
        let volumes: usize = zones.iter().map(|zone| zone.volumes.len()).sum();
        before = Some(refined.zones.clone());
        [parts as u64, volumes as u64, counted.beats, counted.total]
    })
}

#[test]
fn refined_plans_draw_the_same_pictures() {
    let size = (83, 61);
    let scenes = [
        scene("scenes/teapot.toml", size, Format::BASE),
        scene("scenes/front-view.toml", size, Format::BASE),
        scene("scenes/orthographic.toml", size, Format::BASE),
        scene("scenes/processors/mesh.toml", size, with_facets()),
        scene("scenes/processors/polyhedron.toml", size, Format::BASE),
        scene("scenes/processors/patch-processor.toml", size, Format::BASE),
        scene("scenes/shadows/robot.toml", size, Format::BASE),
        scene("scenes/shadows/dna.toml", size, Format::BASE),
        scene("models/testkit/scenes/shadows.toml", size, Format::BASE),
        polyhedra_with_shadows(size),
    ];
    for prepared in &scenes {
        let truth = Truth::of(prepared, &prepared.slots());
        let mut sums = [[0; 4]; 3];
        for machine in MACHINES.map(machine_of) {
            let counts = assert_same(prepared, machine, &truth);
            for (sum, counts) in sums.iter_mut().zip(counts) {
                for (sum, count) in sum.iter_mut().zip(counts) {
                    *sum += count;
                }
            }
        }
        let [boxes, bounds, pixels] = sums;
        // Every scene has something to leave out, and bounds find some of it.
        assert!(bounds[0] < boxes[0] && bounds[2] < boxes[2], "{sums:?}");
        assert!(pixels[0] <= bounds[0] && pixels[2] <= bounds[2], "{sums:?}");
        assert!(pixels[1] <= bounds[1] && bounds[1] <= boxes[1], "{sums:?}");
    }
}

/// The robot's shadows: two in three do not reach the zones that their boxes meet, and bounds say so.
#[test]
fn most_shadows_of_the_robot_stay_out_of_most_zones() {
    let prepared = scene("scenes/shadows/robot.toml", (160, 120), Format::BASE);
    let truth = Truth::of(&prepared, &prepared.slots());
    let counts = assert_same(&prepared, machine_of([16, 16, 4, 2]), &truth);
    let [boxes, bounds, pixels] = counts;
    assert!(bounds[1] < boxes[1] / 3, "{boxes:?} {bounds:?} {pixels:?}");
    assert!(bounds[3] < boxes[3] / 2, "{boxes:?} {bounds:?} {pixels:?}");
}

#[test]
fn guard_bits_and_other_depth_words_are_refined() {
    for (depth, linear, quadratic) in [(16, 3, 5), (20, 10, 8), (32, 2, 0)] {
        let format = Format::new(depth).expect("in the catalogue");
        let format = format.with_guards(linear, quadratic).expect("guard bits");
        for path in ["scenes/shadows/robot.toml", "scenes/front-view.toml"] {
            let prepared = scene(path, (60, 45), format);
            let truth = Truth::of(&prepared, &prepared.slots());
            let [boxes, bounds, pixels] = assert_same(&prepared, MACHINE.clone(), &truth);
            assert!(bounds[2] <= boxes[2] && pixels[2] <= bounds[2], "{path}");
            assert!(boxes[1] == 0 || bounds[1] < boxes[1], "{path}");
        }
    }
}
