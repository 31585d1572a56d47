//! What a scene requires, counted: objects, pixels visited, planes, zones, and the stream of a zone machine; and what
//! changes in the picture.

use imogene_analysis::phong::shade;
use imogene_contract::slots::FittedSlot;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::machine::transparency::MOST_LAYERS;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::object::quadric::MAX_PLANES;
use imogene_plan::culling::reduce::{Fate, Reduced, ReducedObject};
use imogene_plan::culling::zones::{Touches, ZoneTouches};
use imogene_plan::zone::clocks::{ZoneTiming, clocks};
use imogene_plan::zone::plan::{PlanError, ZonePlan};
use imogene_plan::zone::refine::Refinement;
use imogene_prepare::PreparedScene;
use imogene_scene::FramedScene;
use serde::Serialize;

/// Work of a picture, before (0) and after (1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct WorkSaved {
    /// Objects with at least a processor.
    pub objects: [u64; 2],
    /// Processors.
    pub processors: [u64; 2],
    /// Pixels that object processors visit: those of their boxes.
    pub object_pixels: [u64; 2],
    /// Cut planes.
    pub planes: [u64; 2],
    /// Depths of planes that are computed.
    pub plane_depths: [u64; 2],
}

/// Pixels of the picture that are not what they were.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Changed {
    /// In anything at all.
    pub pixels: u64,
    /// In depth.
    pub depth: u64,
    /// In the object that is seen.
    pub object: u64,
    /// In colour.
    pub colour: u64,
    /// Greatest difference of a colour component, of 255.
    pub greatest_colour: u8,
}

/// The stream of a zone machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ZoneStream {
    /// How the host decides.
    pub refinement: Refinement,
    /// Objects loaded, all zones together.
    pub parts: u64,
    /// Volumes loaded.
    pub volumes: u64,
    /// Draw passes.
    pub draw_passes: u64,
    /// Light passes.
    pub light_passes: u64,
    /// Pixels of all passes: clocks without drains, commands and waiting.
    pub pass_pixels: u64,
    /// Beats of the stream.
    pub beats: u64,
}

/// Everything that is known of a scene.
#[derive(Clone, Debug)]
pub struct Report {
    /// The objects.
    pub reduced: Reduced,
    /// Work of all of them.
    pub work: WorkSaved,
    /// Objects that are drawn but hidden by others at every pixel.
    pub hidden: u64,
    /// Zones of each object and objects of each zone: boxes and bounds of the scene, pixels of what is left.
    pub touches: ZoneTouches,
    /// The same of all objects.
    pub loads: Touches,
    /// What changed.
    pub changed: Changed,
    /// The stream of the machine that [`machine`] describes for the whole scene; or why it cannot draw it.
    pub streams: Result<[ZoneStream; 3], PlanError>,
    /// Volumes of each zone by boxes, by bounds and in truth; empty without a zone machine.
    pub volumes_of_zones: Vec<[u64; 3]>,
    /// The picture of what is left.
    pub picture: Vec<u8>,
}

/// The zone machine whose stream is counted: eight object and four volume processors with all planes there can be, and
/// as many layers as there can be.
pub fn machine(side: u32) -> ZoneMachine {
    let slot = FittedSlot::quadric(MAX_PLANES as u32);
    ZoneMachine {
        slots: vec![slot; 8],
        products: vec![],
        layers: vec![slot; MOST_LAYERS],
        volume_processors: 4,
        volume_planes: MAX_PLANES,
        zone_width: side,
        zone_height: side,
        samples: 1,
    }
}

struct Drawn {
    frame: Frame,
    lighting: Lighting,
    picture: Vec<u8>,
}

fn draw(scene: &PreparedScene, framed: &FramedScene, reduced: Option<&Reduced>) -> Drawn {
    let slots = reduced.map_or_else(|| scene.slots(), Reduced::slots);
    let (width, height) = (scene.width as usize, scene.height as usize);
    let mut frame = beam::render(&slots, &scene.format, width, height, || ());
    if let Some(reduced) = reduced {
        reduced.restore_faces(&mut frame);
    }
    let lighting = scene.light(&frame, || ());
    let picture = shade(&frame, &lighting, framed, &scene.format);
    Drawn {
        frame,
        lighting,
        picture,
    }
}

impl Report {
    /// Of a scene, with square zones of `side` pixels; up to `pixels` pixels of each object may change.
    pub fn of(framed: &FramedScene, scene: &PreparedScene, side: u32, pixels: u64) -> Report {
        let whole = draw(scene, framed, None);
        let reduced = Reduced::of(scene, &whole.frame, pixels);
        let again = draw(scene, framed, Some(&reduced));
        let mut work = WorkSaved::default();
        for object in &reduced.objects {
            for when in [0, 1] {
                work.objects[when] += u64::from(object.processors[when] > 0);
                work.processors[when] += object.processors[when];
                work.object_pixels[when] += object.visited[when];
                work.planes[when] += object.planes[when];
                work.plane_depths[when] += object.plane_depths[when];
            }
        }
        let hidden = |o: &&ReducedObject| o.fate == Fate::Drawn && o.seen == 0;
        let size = (scene.width, scene.height);
        let objects = scene.objects.len();
        // Boxes and bounds of the scene as it is, pixels of what is left of it.
        let before = ZoneTouches::of(&scene.slots(), objects, &scene.format, size, side);
        let mut touches = ZoneTouches::of(&reduced.slots(), objects, &scene.format, size, side);
        let objects = touches.objects.iter_mut().zip(&before.objects);
        for (to, from) in objects.chain(touches.zones.iter_mut().zip(&before.zones)) {
            (to.boxes, to.bounds) = (from.boxes, from.bounds);
        }
        let mut loads = Touches::default();
        touches.objects.iter().for_each(|one| loads += *one);
        let (streams, volumes_of_zones) = match streams(scene, side) {
            Ok((streams, volumes)) => (Ok(streams), volumes),
            Err(why) => (Err(why), vec![]),
        };
        Report {
            work,
            hidden: reduced.objects.iter().filter(hidden).count() as u64,
            touches,
            loads,
            changed: changed(&whole, &again),
            streams,
            volumes_of_zones,
            picture: again.picture,
            reduced,
        }
    }
}

fn changed(before: &Drawn, after: &Drawn) -> Changed {
    let mut changed = Changed::default();
    for at in 0..before.frame.depth.len() {
        let (old, new) = (&before.frame, &after.frame);
        let depth = old.depth[at] != new.depth[at];
        let object = old.id[at] != new.id[at];
        let other = old.number[at] != new.number[at]
            || old.normal[at] != new.normal[at]
            || before.lighting.flags[at] != after.lighting.flags[at];
        let colours = (3 * at..3 * at + 3).map(|k| before.picture[k].abs_diff(after.picture[k]));
        let colour = colours.max().unwrap_or(0);
        changed.pixels += u64::from(depth || object || other);
        changed.depth += u64::from(depth);
        changed.object += u64::from(object);
        changed.colour += u64::from(colour > 0);
        changed.greatest_colour = changed.greatest_colour.max(colour);
    }
    changed
}

/// The streams, and the volumes of each zone.
fn streams(
    scene: &PreparedScene,
    side: u32,
) -> Result<([ZoneStream; 3], Vec<[u64; 3]>), PlanError> {
    let plan = ZonePlan::of(scene, machine(side))?;
    let refinements = [Refinement::Box, Refinement::Bounds, Refinement::Pixels];
    let plans = refinements.map(|refinement| (refinement, plan.clone().refined(refinement)));
    let volumes_of = |zone: usize| [0, 1, 2].map(|k| plans[k].1.zones[zone].volumes.len() as u64);
    let volumes = (0..plan.zones.len()).map(volumes_of).collect();
    let stream = |(refinement, plan): &(Refinement, ZonePlan)| {
        let counted = clocks(plan, &ZoneTiming::default());
        let zones = plan.zones.iter();
        let parts = zones.clone().map(|zone| zone.all_parts().count() as u64);
        ZoneStream {
            refinement: *refinement,
            parts: parts.sum(),
            volumes: zones.map(|zone| zone.volumes.len() as u64).sum(),
            draw_passes: counted.draw_passes,
            light_passes: counted.light_passes,
            pass_pixels: counted.draw + counted.light + counted.show,
            beats: counted.beats,
        }
    };
    Ok((plans.each_ref().map(stream), volumes))
}
