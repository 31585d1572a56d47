//! The words of `imogene prepare --json`, and no others, in a machine that has more processors and planes than the
//! scene.

use crate::common::{Place, scene};
use imogene_golden::format::Format;
use imogene_golden::machine::zone::beat::{Beat, kind};
use imogene_plan::description::MachineDescription;
use imogene_plan::display::{Image, image};
use imogene_prepare::Framing;
use imogene_prepare::prepare;
use imogene_scene::SceneFile;
use imogene_verif::display::pins::{PinsRun, run};
use imogene_verif::engine::Engine;
use serde_json::Value;

const SIZE: (u32, u32) = (32, 24);
const OBJECTS: usize = 4;
const PLANES: usize = 5;
const VOLUMES: usize = 14;
const VOLUME_PLANES: usize = 10;

/// A beam machine in which every scene of this test leaves something unused.
fn machine() -> MachineDescription {
    let text = format!(
        "machine = \"beam\"\nobjects = {OBJECTS}\nplanes = {PLANES}\nvolumes = {VOLUMES}\nvolume_planes = {VOLUME_PLANES}\n\
         lights = 2\nrows_per_stage = 6\nmode = {{ columns = [{}, 4, 4, 4], lines = [{}, 2, 2, 60] }}\n",
        SIZE.0, SIZE.1
    );
    MachineDescription::parse(&text, "a machine").expect("a description")
}

/// The scene's golden picture with the words that the host of this project sends.
fn golden(text: &str) -> Image {
    let file = SceneFile::parse(text, "a scene").expect("a scene");
    let framed = file.frame(SIZE.0, SIZE.1).expect("a size");
    let prepared = prepare(&framed, Format::BASE).expect("fits the format");
    image(&framed, &prepared, &machine()).expect("fits the machine")
}

/// The words of a list, for a processor; `offset` is added to the addresses.
fn words(list: &Value, kind: u8, unit: usize, offset: u64) -> Vec<Beat> {
    let number = |word: &Value, key: &str| word[key].as_u64().expect("a number");
    let beat = |word: &Value| {
        let address = number(word, "address") + offset;
        Beat::new(kind, unit as u8, address as u16, number(word, "bits"))
    };
    list.as_array().expect("words").iter().map(beat).collect()
}

/// The frame of a user who has the document alone: objects, volumes, and whatever they leave unused.
fn frame_of(document: &Value) -> Vec<Beat> {
    let unused = |kind: &str| {
        let list = document["unused"].as_array().expect("a list");
        let found = list.iter().find(|entry| entry["processor"] == kind);
        found.expect("the kind of processor").clone()
    };
    let kinds = [
        ("objects", "quadric", kind::OBJECT, OBJECTS, PLANES),
        ("volumes", "volume", kind::VOLUME, VOLUMES, VOLUME_PLANES),
    ];
    let mut beats = vec![];
    for (list, processor, kind, slots, planes) in kinds {
        let list = document[list].as_array().expect("a list");
        let nothing = unused(processor);
        let step = nothing["plane_address_step"].as_u64().expect("a step");
        for unit in 0..slots {
            let Some(entry) = list.get(unit) else {
                beats.extend(words(&nothing["slot_load_words"], kind, unit, 0));
                continue;
            };
            beats.extend(words(&entry["load_words"], kind, unit, 0));
            let used = entry["words"]["planes"].as_array().expect("planes").len();
            for plane in used..planes {
                let offset = step * plane as u64;
                beats.extend(words(&nothing["plane_load_words"], kind, unit, offset));
            }
        }
    }
    beats
}

#[test]
fn unused_planes_and_slots_are_switched_off_by_the_words_of_the_document() {
    let place = Place::new();
    let plain = std::fs::read_to_string(scene("crossing-cylinders.toml")).expect("a scene");
    let shadows = "kind = \"directional\"\nshadows = true";
    let full = plain.replacen("kind = \"directional\"", shadows, 1);
    // Fewer objects with fewer planes, and no volumes: what the first scene left has to be switched off.
    let (sparse, _) = full.rsplit_once("[[objects]]").expect("two objects");
    let sparse = sparse.replacen(shadows, "kind = \"directional\"", 1);
    let (sparse, _) = sparse.rsplit_once("cuts =").expect("planes");
    let mut images = vec![];
    let names = ["full.toml", "sparse.toml", "again.toml"];
    for (name, text) in names.into_iter().zip([&*full, sparse, &full]) {
        place.write(name, text);
        let document = place.json(&format!("prepare {name} --size {}x{}", SIZE.0, SIZE.1));
        let mut image = golden(text);
        let is_shading = |beat: &Beat| beat.kind == kind::SHADING || beat.kind == kind::MATERIAL;
        image.beats.retain(is_shading);
        image.beats.extend(frame_of(&document));
        image.beats.last_mut().expect("words").last = true;
        images.push(image);
    }
    let mut flags = images[0].lighting.flags.iter();
    assert!(flags.any(|&flags| flags != u16::MAX), "a shadow");
    assert_ne!(images[0].picture, images[1].picture);
    let options = PinsRun::plain(Engine::BuiltIn);
    let outcome = run(&machine(), &images, &options, || ()).expect("a machine that runs");
    let first = outcome.report.first_mismatches.first();
    assert_eq!(outcome.report.mismatches, 0, "{first:?}");
    assert!(outcome.shown.contains(&Some(1)) && outcome.picture == images[2].picture);
}
