//! The counts that the rows are made of, by name: numbers to keep and to send, scans in software, loading, clocks.

use super::EvaluateError;
use super::duplication::{Edges, planned, touched};
use super::hardware::{
    self, DEVICE, GATES, Hardware, MACHINE_PLANES, MACHINE_PROCESSORS, PLAIN_DEVICE,
};
use super::scenes::{Moving, OBJECT_SIDE, balls, others, zone_machine};
use super::steps;
use super::work::pixel;
use crate::kit::page::fixed;
use crate::primitives::fair_sides;
use crate::primitives::tessellate::to_mesh;
use imogene_algebra::rational::from_decimal;
use imogene_contract::object::{PLANE_WORDS, PLANES};
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ID_BITS;
use imogene_golden::object::load::{LoadWord, load_words};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::volume::SOURCES;
use imogene_golden::unit::interlaced::MemoryPe2;
use imogene_golden::unit::pe2::Quadratic;
use imogene_plan::zone::clocks::{FrameClocks, clocks};
use imogene_plan::zone::plan::ZonePlan;
use imogene_scene::{Mesh, Object, Plane, Quadric, SceneFile, Shape};
use minijinja::value::Serde;
use minijinja::{Environment, Error, ErrorKind, UndefinedBehavior};
use serde::Serialize;
use serde_json::{Value, json};
use std::sync::Arc;

/// Patches of the frame whose clocks are counted.
const PATCHES: u64 = 1000;
/// Its screen, the source's.
const SCREEN: [u32; 2] = [720, 540];
const SOLIDS: &str = include_str!("../../../../scenes/comparison/three-solids.toml");

/// Every count, as names of expressions.
pub fn counts(hardware: &Hardware) -> Result<Environment<'static>, EvaluateError> {
    let mut names = Environment::new();
    names.set_undefined_behavior(UndefinedBehavior::Strict);
    names.add_filter("fixed", fixed);
    resources(&mut names)?;
    let [ball, _, patch] = balls()?;
    let figures = [
        Value::Object(steps::costs()),
        duplication(&ball)?,
        software(),
        storage(&patch)?,
        pipeline(&patch, hardware)?,
        machine()?,
    ];
    for (name, value) in figures.iter().flat_map(|f| f.as_object()).flatten() {
        names.add_global(name.clone(), Serde(value.clone()));
    }
    Ok(names)
}

/// The table of resources, as functions of a unit.
fn resources(names: &mut Environment) -> Result<(), EvaluateError> {
    let table = Arc::new(hardware::resources()?);
    let figures = [
        ("cells", DEVICE, ["cells", "cells"]),
        ("transistors", GATES, ["transistors", "transistors"]),
        ("fmax", DEVICE, ["clock", "fmax_mhz"]),
        ("flip_flops", DEVICE, ["flip-flops", "ff"]),
    ];
    for (name, usual, figure) in figures {
        let table = Arc::clone(&table);
        let of = move |unit: &str, target: Option<&str>, planes: Option<usize>| {
            let found = hardware::figure(&table, figure, unit, target.unwrap_or(usual), planes);
            found.map_err(|problem| Error::new(ErrorKind::InvalidOperation, problem.to_string()))
        };
        names.add_function(name, of);
    }
    names.add_global("device", DEVICE);
    names.add_global("plain", PLAIN_DEVICE);
    Ok(())
}

fn duplication(ball: &Moving) -> Result<Value, EvaluateError> {
    Ok(json!({
        "small": touched(20, 32, Edges::Anywhere),
        "great": touched(80, 128, Edges::Anywhere),
        "half": touched(80, 64, Edges::Anywhere),
        "small_pixels": touched(20, 32, Edges::OnPixels),
        "great_pixels": touched(80, 128, Edges::OnPixels),
        "planned": planned(ball)?,
    }))
}

fn software() -> Value {
    let solid = |side| pixel::solid(side, &pixel::ball(side, 3)).figures();
    let patch = |side| pixel::patch(side, &pixel::ball(side, 4)).figures();
    json!({
        "facet_scan": pixel::facet(20, pixel::FACET).figures(),
        "solid_128": solid(128),
        "solid_80": solid(80),
        "patch_80": patch(80),
        "patch_64": patch(64),
    })
}

/// Numbers in a structure, wherever they stand in it, but for its screen box, which the source's machines do not have.
pub fn numbers(of: &impl Serialize) -> f64 {
    fn leaves(value: &Value) -> usize {
        match value {
            Value::Number(_) => 1,
            Value::Array(list) => list.iter().map(leaves).sum(),
            Value::Object(map) => {
                let kept = map.iter().filter(|(key, _)| *key != "screen_box");
                kept.map(|(_, value)| leaves(value)).sum()
            }
            _ => 0,
        }
    }
    leaves(&json!(of)) as f64
}

/// Reals of a quadric with so many planes.
fn quadric_reals(planes: usize) -> f64 {
    let quadric = Quadric::from_array(std::array::from_fn(|_| from_decimal(0.0)));
    let [a, b, c, d] = std::array::from_fn(|_| from_decimal(0.0));
    let plane = Plane { a, b, c, d };
    (quadric.coefficients().len() + planes * plane.coefficients().len()) as f64
}

fn mesh_of(object: &Object, sides: usize) -> Mesh {
    let mut object = object.clone();
    to_mesh(&mut object, sides);
    match object.shape {
        Shape::Mesh(mesh) => mesh,
        _ => unreachable!("to_mesh makes a mesh"),
    }
}

/// Facets of a ball of 80 pixels, within half a pixel of its outline: around, and facing the viewer.
pub fn fair_ball() -> Result<[f64; 2], EvaluateError> {
    let scene = SceneFile::parse(SOLIDS, "three-solids.toml")?;
    let mut objects = scene.objects.iter();
    let ball = objects.find(|object| matches!(object.shape, Shape::Sphere { .. }));
    let sides = fair_sides(f64::from(OBJECT_SIDE) / 2.0);
    let mesh = mesh_of(ball.expect("the scene has a ball"), sides);
    // Seen along z, a facet faces the viewer if the normals of its corners do so on the whole.
    let towards = |face: &Vec<usize>| face.iter().map(|&corner| mesh.normals[corner][2]).sum();
    let sums = mesh.faces.iter().map(towards);
    let seen = sums.filter(|&sum: &f64| sum > 0.0).count();
    Ok([sides as f64, seen as f64])
}

/// Mean of the reals of a mesh with 20 sides over those of the quadric, and the reals of a facet.
fn file_ratio() -> Result<[f64; 2], EvaluateError> {
    let scene = SceneFile::parse(SOLIDS, "three-solids.toml")?;
    let meshes: Vec<Mesh> = scene.objects.iter().map(|o| mesh_of(o, 20)).collect();
    // A corner with its normal, which the facets of a mesh share.
    let corner = (meshes[0].vertices[0].len() + meshes[0].normals[0].len()) as f64;
    let ratio = |(object, mesh): (&Object, &Mesh)| {
        mesh.vertices.len() as f64 * corner / quadric_reals(object.cuts.len())
    };
    let sum: f64 = scene.objects.iter().zip(&meshes).map(ratio).sum();
    Ok([sum / meshes.len() as f64, 3.0 * corner])
}

/// Bits of load words, without those that a patch processor does not read: the constant normals of planes.
fn patch_bits(words: &[LoadWord]) -> f64 {
    let is_read = |word: &&LoadWord| {
        let place = u64::from(word.address).checked_sub(PLANES);
        place.is_none_or(|place| place % PLANE_WORDS < 4)
    };
    let read = words.iter().filter(is_read);
    read.map(|word| f64::from(word.width)).sum()
}

fn storage(patch: &Moving) -> Result<Value, EvaluateError> {
    let format = Format::BASE;
    let [file_ratio, facet_reals] = file_ratio()?;
    // Of the first of each kind.
    let mut counts = serde_json::Map::new();
    for words in others()? {
        let found = match &words {
            ProcessorWords::Facet(facet) if facet.edges.len() == 3 => {
                let planes = numbers(&facet.edges) + numbers(&facet.depth);
                let normal = f64::from(format.normal_linear) * numbers(&facet.normal);
                let bits = planes * f64::from(format.plane) + normal;
                counts.entry("facet_bits").or_insert(json!(bits));
                ("facet_words", numbers(facet))
            }
            ProcessorWords::Sphere(sphere) => ("sphere_words", numbers(sphere)),
            ProcessorWords::Cylinder(cylinder) => ("cylinder_words", numbers(cylinder)),
            _ => continue,
        };
        counts.entry(found.0).or_insert(json!(found.1));
    }
    let pixel = f64::from(format.depth + ID_BITS + 3 * format.normal) + f64::from(SOURCES);
    let others = json!({
        "file_ratio": file_ratio,
        "facet_reals": facet_reals,
        "quadric_reals": quadric_reals(3),
        "patch_bits": patch_bits(&load_words(&patch.object.words, &format, MACHINE_PLANES)),
        "depth_of_quadric_words": load_words(&patch.object.words, &format, 0).iter().take(9).count(),
        "pixel_bits": pixel,
        "depth_bits": format.depth,
        "id_bits": ID_BITS,
        "normal_bits": format.normal,
        "sources": SOURCES,
    });
    counts.extend(others.as_object().cloned().unwrap_or_default());
    Ok(Value::Object(counts))
}

/// Clocks of a frame of many patches, spread evenly over the screen by the golden ratio and the plastic number.
fn frame(patch: &Moving, hardware: &Hardware) -> Result<FrameClocks, EvaluateError> {
    let room = SCREEN.map(|side| u64::from(side - OBJECT_SIDE + 1));
    // Kronecker's sequence with the powers of one over the plastic number, in whole numbers.
    let place = |k: u64| {
        let along = |step: u64, room: u64| ((k * step % 1_000_000) * room / 1_000_000) as i64;
        [along(754_878, room[0]), along(569_840, room[1])]
    };
    let places: Vec<[i64; 2]> = (1..=PATCHES).map(place).collect();
    let plan = ZonePlan::of(&patch.at(&places, SCREEN), zone_machine(MACHINE_PROCESSORS))?;
    Ok(clocks(&plan, &hardware.zone_timing))
}

fn pipeline(patch: &Moving, hardware: &Hardware) -> Result<Value, EvaluateError> {
    let alone = patch.at(&[[0, 0]], [OBJECT_SIDE; 2]);
    let plan = ZonePlan::of(&alone, zone_machine(MACHINE_PROCESSORS))?;
    let draw = plan.passes(&plan.zones[0], false).next();
    let beats = draw.map_or(vec![], |pass| plan.words_of(&pass, &plan.zones[0]));
    let frame = frame(patch, hardware)?;
    Ok(json!({
        "beats": beats.len(),
        "drain": hardware.zone_timing.draw_drain,
        "patches": PATCHES,
        "frame": {
            "total": frame.total,
            "draw_passes": frame.draw_passes,
            "zones": frame.zones,
            "waiting": frame.waiting,
        },
    }))
}

/// Clocks from the last pixel of a line to the first of the next, and words of memory, of a memory-based PE2.
fn memory_pe2(mut pe: MemoryPe2) -> Value {
    pe.line_start();
    let before = pe.clocks();
    pe.line_start();
    json!({ "clocks": pe.clocks() - before, "words": pe.memory_words() })
}

fn machine() -> Result<Value, EvaluateError> {
    let expression = Quadratic::default();
    let mut interlaced = MemoryPe2::interlaced(&expression, 48);
    interlaced.field_start(0);
    let [facets_around, facets_seen] = fair_ball()?;
    Ok(json!({
        "memory": memory_pe2(MemoryPe2::progressive(&expression, 48)),
        "interlaced": memory_pe2(interlaced),
        "facets_around": facets_around,
        "facets_seen": facets_seen,
    }))
}
