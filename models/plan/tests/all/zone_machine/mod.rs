//! The zone machine: what its stream draws is what the beam machine and the volumes of the whole screen draw, however
//! the work is divided.

mod clocks;
mod conversion;
mod refine;
mod refusals;
mod solids;

use imogene_contract::slots::{self, FittedSlot};
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::{ALL_SOURCES, Lighting};
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::machine::zone::beat::{Beat, kind};
use imogene_golden::machine::zone::golden::ZoneMachineModel;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::Slot;
use imogene_golden::object::volume::VolumeKind;
use imogene_plan::zone::plan::{Pass, ZonePlan};
use imogene_prepare::Framing;
use imogene_prepare::{PreparedScene, prepare};
use imogene_scene::SceneFile;
use proptest::prelude::*;
use std::path::Path;
use std::sync::LazyLock;

/// Twelve planes and ten of a volume: enough for every scene.
static MACHINE: LazyLock<ZoneMachine> = LazyLock::new(|| ZoneMachine {
    layers: vec![],
    slots: quadrics(4),
    products: vec![],
    volume_processors: 2,
    volume_planes: 10,
    zone_width: 32,
    zone_height: 32,
    samples: 1,
});

/// Processors of quadrics for every scene.
fn quadrics(count: usize) -> Vec<FittedSlot> {
    vec![FittedSlot::quadric(12); count]
}

/// The base format with the guard bits that the depth of a facet needs.
fn with_facets() -> Format {
    Format::BASE.with_guards(10, 0).expect("guard bits")
}

/// The text of a file below the folder of the workspace.
fn text(path: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    std::fs::read_to_string(root.join(path)).expect("a readable file")
}

fn scene(path: &str, size: (u32, u32), format: Format) -> PreparedScene {
    scene_of(&text(path), size, format)
}

fn scene_of(text: &str, (width, height): (u32, u32), format: Format) -> PreparedScene {
    let file = SceneFile::parse(text, "a scene").expect("a valid scene");
    let framed = file.frame(width, height).expect("a valid size");
    prepare(&framed, format).expect("fits the format")
}

/// The polyhedra of the collection with shadows, which are volumes of planes alone.
fn polyhedra_with_shadows(size: (u32, u32)) -> PreparedScene {
    let text = text("scenes/processors/polyhedron.toml");
    let shadows = text.replace("[[lights]]\n", "[[lights]]\nshadows = true\n");
    scene_of(&shadows, size, Format::BASE)
}

/// What the machine is measured against.
struct Truth {
    frame: Frame,
    lighting: Lighting,
}

impl Truth {
    fn of(prepared: &PreparedScene, slots: &[Slot]) -> Truth {
        let (width, height) = (prepared.width as usize, prepared.height as usize);
        let frame = beam::render(slots, &prepared.format, width, height, || ());
        let mut lighting = prepared.light(&frame, || ());
        // Flags of the background mean nothing; a zone without objects is never lit.
        for (flags, id) in lighting.flags.iter_mut().zip(&frame.id) {
            if *id < 0 {
                *flags = ALL_SOURCES;
            }
        }
        Truth { frame, lighting }
    }

    /// The picture of a plan is this one; face numbers are not kept by the machine.
    fn assert_is_drawn(&self, plan: &ZonePlan) {
        let mut model = ZoneMachineModel::new(&plan.format, &plan.machine);
        self.assert_is(&mut model, plan.beats(), &format!("{:?}", plan.machine));
    }

    fn assert_is(
        &self,
        model: &mut ZoneMachineModel,
        beats: impl IntoIterator<Item = Beat>,
        what: &str,
    ) {
        let (width, height) = (self.frame.width, self.frame.height);
        let (frame, lighting) = model.frame(beats, width, height).expect("a valid stream");
        assert!(frame.depth == self.frame.depth, "depths, {what}");
        assert!(frame.id == self.frame.id, "objects, {what}");
        assert!(frame.normal == self.frame.normal, "normals, {what}");
        assert!(lighting == self.lighting, "flags, {what}");
    }
}

/// Zones of every size and shape, also greater than the picture; one processor to more than there are objects.
const MACHINES: [[u32; 4]; 6] = [
    // Width and height of a zone, K, V.
    [8, 8, 1, 1],
    [16, 16, 4, 2],
    [33, 7, 3, 5],
    [64, 64, 16, 4],
    [1, 200, 2, 1],
    [128, 128, 256, 256],
];

fn machine_of([zone_width, zone_height, k, v]: [u32; 4]) -> ZoneMachine {
    ZoneMachine {
        zone_width,
        zone_height,
        slots: quadrics(k as usize),
        volume_processors: v as usize,
        ..MACHINE.clone()
    }
}

fn planned(prepared: &PreparedScene, machine: ZoneMachine) -> ZonePlan {
    ZonePlan::of(prepared, machine).expect("fits the machine")
}

fn assert_same_on_every_machine(prepared: &PreparedScene) -> Truth {
    let truth = Truth::of(prepared, &prepared.slots());
    for machine in MACHINES.map(machine_of) {
        truth.assert_is_drawn(&planned(prepared, machine));
    }
    truth
}

#[test]
fn scenes_without_shadows_are_drawn() {
    for path in [
        "scenes/teapot.toml",
        "scenes/molecule.toml",
        "scenes/cut-sphere.toml",
        "scenes/front-view.toml",
        "scenes/orthographic.toml",
    ] {
        let truth = assert_same_on_every_machine(&scene(path, (83, 61), Format::BASE));
        assert!(truth.frame.covered() > 300, "{path}");
    }
}

/// Transparent objects at every sample, whether something hides them or not; also where there is nothing else.
#[test]
fn glass_is_drawn() {
    let mut prepared = scene("scenes/glass/still-life.toml", (88, 68), Format::BASE);
    for is_alone in [false, true] {
        if is_alone {
            prepared.objects.clear();
        }
        let frame = beam::render(&prepared.slots(), &Format::BASE, 88, 68, || ());
        let alone = prepared.layers.clone();
        assert_eq!(frame.layers.len(), alone.len());
        for (samples, side) in [(1, 16), (1, 100), (2, 7), (4, 5)] {
            let machine = ZoneMachine {
                samples,
                layers: quadrics(alone.len()),
                ..machine_of([side, side + 1, 4, 2])
            };
            let plan = planned(&prepared, machine);
            let mut model = ZoneMachineModel::new(&Format::BASE, &plan.machine);
            let (drawn, _) = model.frame(plan.beats(), 88, 68).expect("a valid stream");
            let number = drawn.number.clone();
            let frame = frame.clone();
            assert!(drawn == Frame { number, ..frame });
        }
    }
    let few = ZoneMachine {
        layers: quadrics(2),
        ..MACHINE.clone()
    };
    let refused = ZonePlan::of(&prepared, few).expect_err("too few layers");
    assert!(
        refused.to_string().contains("accepted is layers = 3"),
        "{refused}"
    );
}

/// S x S passes over every zone draw what one draws on a grid that is S times finer, bit for bit.
#[test]
fn samples_are_the_pixels_of_a_finer_picture() {
    for path in ["scenes/teapot.toml", "scenes/shadows/robot.toml"] {
        let prepared = scene(path, (88, 68), Format::BASE);
        let truth = Truth::of(&prepared, &prepared.slots());
        assert!(truth.frame.covered() > 300, "{path}");
        for (samples, side) in [(2, 16), (2, 7), (4, 64), (4, 5)] {
            let machine = ZoneMachine {
                samples,
                ..machine_of([side, side + 1, 4, 2])
            };
            truth.assert_is_drawn(&planned(&prepared, machine));
        }
    }
}

/// A scene of many more objects than processors.
#[test]
fn four_hundred_and_eighty_spheres_are_drawn() {
    let prepared = scene("scenes/zones/molecule-480.toml", (320, 240), Format::BASE);
    let truth = Truth::of(&prepared, &prepared.slots());
    let plan = planned(&prepared, MACHINE.clone());
    truth.assert_is_drawn(&plan);
    let mut seen: Vec<i32> = truth.frame.id;
    seen.sort_unstable();
    seen.dedup();
    assert!(seen.len() > 400, "{} objects are seen", seen.len());
}

#[test]
fn scenes_of_other_processors_are_drawn() {
    for name in ["polyhedron", "patch-processor", "tetrahedra", "mesh"] {
        let path = format!("scenes/processors/{name}.toml");
        let truth = assert_same_on_every_machine(&scene(&path, (83, 61), with_facets()));
        assert!(truth.frame.covered() > 300, "{name}");
    }
}

/// Slots that are not all alike: of the kinds of a scene, of fewer planes than some of its parts have, and both.
#[test]
fn slots_of_every_kind_draw_the_same() {
    for row in [
        "processors/polyhedron: polyhedron8 polyhedron6,polyhedron8,0 0,8",
        "processors/patch-processor: patch4 2,patch0,patch12 12,1",
        "processors/tetrahedra: patch4,4 4,patch4,2 1,4",
        "processors/mesh: facet4,facet3 facet3 3,facet4",
        "processors/first-generation: first_generation 1,first_generation,first_generation 0,first_generation",
        "processors/paraboloids: sphere,cylinder,0 0,cylinder,0,sphere,sphere 0,cylinder,sphere",
        "processors/curved-facet: curved_facet4 curved_facet4,curved_facet4 0,curved_facet4",
        "extremes/eye-on-quadric: 0,quotient2 quotient12,1 2,quotient1",
        "shadows/robot: 12,patch12 3,patch3,polyhedron6 0,0,2,6",
    ] {
        let (path, slots) = row
            .split_once(": ")
            .expect("a scene and the slots of machines");
        let prepared = scene(&format!("scenes/{path}.toml"), (83, 61), Format::BASE);
        let truth = Truth::of(&prepared, &prepared.slots());
        for slots in slots.split(' ') {
            let slots = slots::parse(slots).expect("slots");
            for side in [9, 64] {
                let machine = ZoneMachine {
                    slots: slots.clone(),
                    ..machine_of([side, side + 1, 4, 2])
                };
                let [boxes, _, pixels] = refine::assert_same(&prepared, machine, &truth);
                assert!(pixels[0] <= boxes[0], "{path}");
            }
        }
    }
}

/// A part goes to the smallest free slot, and waits behind another part of its object.
#[test]
fn parts_of_one_object_keep_their_order() {
    let prepared = scene("scenes/processors/mesh.toml", (83, 61), Format::BASE);
    let machine = ZoneMachine {
        slots: slots::parse("facet4,facet3,facet3,0,facet4").expect("slots"),
        ..MACHINE.clone()
    };
    let plan = planned(&prepared, machine);
    let mut drawn = 0;
    for zone in &plan.zones {
        let passes = plan.passes(zone, false).filter_map(|pass| match pass {
            Pass::Draw { parts, .. } => Some(parts),
            _ => None,
        });
        let mut last = vec![None; prepared.objects.len()];
        for parts in passes {
            for pair in parts.windows(2) {
                let [a, b] = [0, 1].map(|k| plan.parts[pair[k].1 as usize].object);
                assert!(a != b || pair[0].0 < pair[1].0, "{parts:?}");
            }
            for (_, part) in parts {
                let last = &mut last[plan.parts[part as usize].object];
                assert!(last.replace(part) < Some(part));
                drawn += 1;
            }
        }
    }
    let parts = plan.zones.iter().map(|zone| zone.parts.len());
    assert_eq!(drawn, parts.sum::<usize>());
}

#[test]
fn scenes_with_shadows_are_drawn() {
    let of_file = |path| (path, scene(path, (72, 54), Format::BASE));
    for (path, prepared) in [
        of_file("scenes/shadows/robot.toml"),
        of_file("scenes/shadows/dna.toml"),
        of_file("models/testkit/scenes/shadows.toml"),
        ("polyhedra with shadows", polyhedra_with_shadows((72, 54))),
    ] {
        let truth = assert_same_on_every_machine(&prepared);
        let dark = truth.lighting.flags.iter().filter(|&&f| f != ALL_SOURCES);
        let dark = dark.count();
        assert!(dark > 60, "{path}: {dark} pixels");
    }
}

/// Outside its box a spot is dark: also in zones that the box does not touch.
#[test]
fn a_spot_is_dark_in_all_other_zones() {
    let mut prepared = scene("models/testkit/scenes/shadows.toml", (72, 54), Format::BASE);
    let mut volumes = prepared.volumes.iter_mut().map(|volume| &mut volume.words);
    let spot = volumes.find(|words| words.kind == VolumeKind::Light);
    spot.expect("a spot").screen_box = ScreenBox::of([30, 45], [20, 33]);
    assert_same_on_every_machine(&prepared);
}

#[test]
fn other_formats_are_drawn() {
    let formats = [
        Format::new(16).expect("in the catalogue").with_guards(3, 5),
        Format::new(32).expect("in the catalogue").with_guards(2, 0),
    ];
    for format in formats {
        let format = format.expect("guard bits");
        let prepared = scene("scenes/shadows/robot.toml", (60, 45), format);
        assert_same_on_every_machine(&prepared);
    }
}

/// One machine draws frame after frame: nothing of one frame is left in the next.
#[test]
fn a_machine_is_used_again() {
    let mut model = ZoneMachineModel::new(&Format::BASE, &MACHINE);
    for path in [
        "scenes/shadows/robot.toml",
        "scenes/teapot.toml",
        "models/testkit/scenes/shadows.toml",
    ] {
        let prepared = scene(path, (72, 54), Format::BASE);
        let plan = planned(&prepared, MACHINE.clone());
        let truth = Truth::of(&prepared, &prepared.slots());
        truth.assert_is(&mut model, plan.beats(), path);
    }
}

#[test]
fn the_last_beat_and_the_last_pixel_say_so() {
    let prepared = scene("scenes/teapot.toml", (83, 61), Format::BASE);
    let plan = planned(&prepared, MACHINE.clone());
    let objects = prepared.objects.len();
    let materials: Vec<u32> = (0..objects as u32).map(|id| 7 * id % 256).collect();
    let shading = vec![(3, 0xffff_ffff), (700, 5)];
    let plan = plan.shaded(shading, materials);
    let plan = plan.expect("one for each object");
    let beats: Vec<Beat> = plan.beats().collect();
    assert_eq!(beats.iter().filter(|b| b.last).count(), 1);
    assert!(beats.last().expect("beats").last);
    assert_eq!(beats[0], Beat::new(kind::SHADING, 0, 3, 0xffff_ffff));

    let mut model = ZoneMachineModel::new(&plan.format, &plan.machine);
    let mut shown = vec![];
    for beat in &beats {
        let sink = |pixel| shown.push(pixel);
        model.beat(beat, sink).expect("a valid stream");
    }
    assert_eq!(shown.len(), 83 * 61);
    assert_eq!(shown.iter().filter(|p| p.last).count(), 1);
    let last = shown.last().expect("pixels");
    assert_eq!((last.last, last.x, last.y), (true, 82, 60));
    // A zone goes out line by line: the first one has 32 columns.
    assert_eq!(
        (shown[31].x, shown[31].y, shown[32].x, shown[32].y),
        (31, 0, 0, 1)
    );
    for id in 0..objects as u16 {
        assert_eq!(model.materials[&id], u64::from(id) * 7 % 256);
    }
    assert_eq!(
        model.shading.iter().collect::<Vec<_>>(),
        [(&3, &0xffff_ffff), (&700, &5)]
    );
}

/// Two scenes with many ties: the same objects twice, under two ids.
static PERMUTED: LazyLock<Vec<(ZonePlan, Truth)>> = LazyLock::new(|| {
    let twice = |path: &str| {
        let mut prepared = scene(path, (60, 45), Format::BASE);
        prepared.objects.extend(prepared.objects.clone());
        let plan = planned(&prepared, MACHINE.clone());
        let truth = Truth::of(&prepared, &prepared.slots());
        (plan, truth)
    };
    vec![
        twice("scenes/shadows/robot.toml"),
        twice("scenes/molecule.toml"),
    ]
});

fn shuffle(list: &mut [u32], random: &mut u64) {
    for i in (1..list.len()).rev() {
        *random = random
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        list.swap(i, (*random >> 33) as usize % (i + 1));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_order_over_processors_and_batches_gives_the_same_picture(
        which in 0usize..2, seed in any::<u64>(), k in 1usize..=9, v in 1usize..=5
    ) {
        let (plan, truth) = &PERMUTED[which];
        let mut plan = plan.clone();
        let mut random = seed;
        plan.machine.slots = quadrics(k);
        plan.machine.volume_processors = v;
        for zone in &mut plan.zones {
            shuffle(&mut zone.parts, &mut random);
            shuffle(&mut zone.volumes, &mut random);
        }
        truth.assert_is_drawn(&plan);
    }
}
