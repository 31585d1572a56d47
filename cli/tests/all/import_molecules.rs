//! `imogene import` of molecules: formats, options, messages, and scenes that name their structure file.

use crate::common::{Place, columns, repository};
use std::path::PathBuf;

fn data(name: &str) -> PathBuf {
    repository("import/tests/data").join(name)
}

/// A command that writes a scene is refused with a message that has these parts, and writes nothing.
fn refused(place: &Place, line: &str, parts: &[&str]) {
    place.run(&format!("{line} -o never.toml")).refused(parts);
    assert!(!place.has("never.toml"), "{line}");
}

/// Whatever its name, a file is read as what it holds; `--as` is obeyed.
#[test]
fn files_are_known_by_what_they_hold() {
    let place = Place::new();
    for (file, kind) in [
        ("1A8O.pdb", "pdb"),
        ("2BEG.pdb.gz", "pdb"),
        ("1A8O.cif", "mmcif"),
        ("3jqh.bcif.gz", "bcif"),
    ] {
        std::fs::copy(data(file), place.path("molecule.step")).unwrap();
        let report = place.json("import molecule.step -o a.toml");
        assert_eq!(report["kind"], kind, "{file}");
        assert_eq!(report["report"]["atoms_drawn"], report["objects"]);
    }
    refused(&place, "import molecule.step --as step", &["ISO-10303-21"]);
    place.write("a.txt", "hello\n");
    let kinds = "PDB,mmCIF,BinaryCIF,CAD faces,STEP,heights,gzip,--as";
    let kinds: Vec<&str> = kinds.split(',').collect();
    refused(&place, "import a.txt", &kinds);
    refused(&place, "import a.toml", &["this is a scene already"]);
    let packed = std::fs::read(data("2BEG.pdb.gz")).unwrap();
    place.write("cut.gz", &packed[..9_000]);
    refused(&place, "import cut.gz", &["cannot be unpacked"]);
}

/// The prepared words of a scene that names its file are those of the scene with a line for each atom, wherever the
/// two lie.
#[test]
fn scenes_that_name_their_file_are_prepared_to_the_same_words() {
    let place = Place::new();
    std::fs::create_dir(place.path("scenes")).unwrap();
    std::fs::copy(data("3jqh.bcif.gz"), place.path("molecule")).unwrap();
    for options in [
        "--style ball-and-stick --alternates A --without-water",
        "--colour chain --assembly 1 --chain A --residue 1-40,ALA",
        "--style ball-and-stick --model all --no-hydrogens --no-water",
    ] {
        let import = |form: &str| place.json(&format!("import molecule {form} {options}"));
        let lines = import("--inline -o a.toml");
        let named = import("--reference -o scenes/b.toml");
        assert_eq!(lines["objects"], named["objects"]);
        let text = place.text("scenes/b.toml");
        let names = text.contains("file = \"../molecule\"");
        assert!(names && !text.contains("[[objects]]"), "{text}");
        let words = |scene: &str| {
            let prepared = place.json(&format!("prepare {scene} --size 64x48"));
            let draw = format!("render {scene} --size 64x48 --depth depth.npy -o a.png");
            assert!(place.json(&draw)["covered_pixels"].as_u64().unwrap() > 20);
            (prepared, place.bytes("depth.npy"))
        };
        // The words are too many to be shown.
        assert!(words("a.toml") == words("scenes/b.toml"), "{options}");
    }
}

#[test]
fn scenes_that_name_wrong_files_are_refused() {
    let place = Place::new();
    std::fs::copy(data("1A8O.cif"), place.path("a.cif")).unwrap();
    place.json("import a.cif --reference -o a.toml");
    let text = place.text("a.toml");
    let cases = r#"
        file = "a.cif" | file = "b.cif" | cannot read 'b.cif'
        file = "a.cif" | file = "a.toml" | a.toml: it is no structure, as the scene bad.toml says
        style = "space-filling" | style = "sticks" | a.cif: style: `sticks` is not known
        model = "first" | model = 3 | a.cif: it has no model 3; 1 or all would be accepted
        model = "first" | model = 1.5 | a number, "first" or "all" would be accepted
        model = "first" | chain = "A" | unknown field `chain`
        model = "first" | residues = ["9-1"] | residues: the range 9-1 runs backwards
        model = "first" | group = "none" | `none` is not a group of this scene
    "#;
    for [good, wrong, problem] in columns(cases) {
        assert!(text.contains(good));
        place.write("bad.toml", text.replace(good, wrong));
        refused(&place, "render bad.toml", &[problem]);
    }
}

#[test]
fn nothing_that_is_left_is_told_with_what_would_be() {
    let place = Place::new();
    let file = data("1A8O.cif");
    for [options, problem] in columns("
        --chain Z | it has no chain Z; A would be accepted
        --residue 1-9 | no residue 1-9 in what is asked for; numbers from 151 to
        --model 4 | it has no model 4; 1 or all would be accepted
        --assembly 2 | it has no assembly 2; --assembly 1 would be accepted
        --residue HOH --without-water | water is drawn without --without-water, other residues without --residue
    ") {
        let line = format!("import {} {options}", file.display());
        refused(&place, &line, &[problem]);
    }
}
