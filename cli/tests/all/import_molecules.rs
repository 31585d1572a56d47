//! `imogene import` of molecules: formats, options, messages, and scenes that name their structure file.

use crate::common::{json_in, refusal_in};
use std::path::{Path, PathBuf};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../import/tests/data")
        .join(name)
}

/// Whatever its name, a file is read as what it holds; `--as` is obeyed.
#[test]
fn files_are_known_by_what_they_hold() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let cases = [
        ("1A8O.pdb", "pdb"),
        ("2BEG.pdb.gz", "pdb"),
        ("1A8O.cif", "mmcif"),
        ("3jqh.bcif.gz", "bcif"),
    ];
    for (file, kind) in cases {
        std::fs::copy(data(file), folder.join("molecule.step")).unwrap();
        let report = json_in(&["import", "molecule.step", "-o", "a.toml"], folder);
        assert_eq!(report["kind"], kind, "{file}");
        assert_eq!(report["report"]["atoms_drawn"], report["objects"]);
    }
    let message = refusal_in(
        &[
            "import",
            "molecule.step",
            "--as",
            "step",
            "-o",
            "never.toml",
        ],
        folder,
    );
    assert!(message.contains("ISO-10303-21"), "{message}");
    std::fs::write(folder.join("a.txt"), "hello\n").unwrap();
    let message = refusal_in(&["import", "a.txt", "-o", "never.toml"], folder);
    for kind in [
        "PDB",
        "mmCIF",
        "BinaryCIF",
        "CAD faces",
        "STEP",
        "heights",
        "gzip",
        "--as",
    ] {
        assert!(message.contains(kind), "{message}");
    }
    let message = refusal_in(&["import", "a.toml", "-o", "never.toml"], folder);
    assert!(message.contains("this is a scene already"), "{message}");
    let packed = std::fs::read(data("2BEG.pdb.gz")).unwrap();
    std::fs::write(folder.join("cut.gz"), &packed[..9_000]).unwrap();
    let message = refusal_in(&["import", "cut.gz", "-o", "never.toml"], folder);
    assert!(message.contains("cannot be unpacked"), "{message}");
}

/// The prepared words of a scene that names its file are those of the scene with a line for each atom, wherever the
/// two lie.
#[test]
fn scenes_that_name_their_file_are_prepared_to_the_same_words() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::create_dir(folder.join("scenes")).unwrap();
    std::fs::copy(data("3jqh.bcif.gz"), folder.join("molecule")).unwrap();
    let sets: [&[&str]; 3] = [
        &[
            "--style",
            "ball-and-stick",
            "--alternates",
            "A",
            "--without-water",
        ],
        &[
            "--colour",
            "chain",
            "--assembly",
            "1",
            "--chain",
            "A",
            "--residue",
            "1-40,ALA",
        ],
        &[
            "--style",
            "ball-and-stick",
            "--model",
            "all",
            "--no-hydrogens",
            "--no-water",
        ],
    ];
    for options in sets {
        let import = |output: &str, form: &str| {
            let arguments = [&["import", "molecule", "-o", output, form], options].concat();
            json_in(&arguments, folder)
        };
        let (lines, named) = (
            import("a.toml", "--inline"),
            import("scenes/b.toml", "--reference"),
        );
        assert_eq!(lines["objects"], named["objects"]);
        let text = std::fs::read_to_string(folder.join("scenes/b.toml")).unwrap();
        assert!(
            text.contains("file = \"../molecule\"") && !text.contains("[[objects]]"),
            "{text}"
        );
        let words = |scene: &str| {
            let prepared = json_in(&["prepare", scene, "--size", "64x48"], folder);
            let draw = [
                "render",
                scene,
                "--size",
                "64x48",
                "--depth",
                "depth.npy",
                "-o",
                "a.png",
            ];
            assert!(json_in(&draw, folder)["covered_pixels"].as_u64().unwrap() > 20);
            (prepared, std::fs::read(folder.join("depth.npy")).unwrap())
        };
        // The words are too many to be shown.
        assert!(words("a.toml") == words("scenes/b.toml"), "{options:?}");
    }
}

#[test]
fn scenes_that_name_wrong_files_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::copy(data("1A8O.cif"), folder.join("a.cif")).unwrap();
    json_in(&["import", "a.cif", "--reference", "-o", "a.toml"], folder);
    let text = std::fs::read_to_string(folder.join("a.toml")).unwrap();
    let cases = [
        (
            "file = \"a.cif\"",
            "file = \"b.cif\"",
            "cannot read 'b.cif'",
        ),
        (
            "file = \"a.cif\"",
            "file = \"a.toml\"",
            "a.toml: it is no structure, as the scene bad.toml says",
        ),
        (
            "style = \"space-filling\"",
            "style = \"sticks\"",
            "a.cif: style: `sticks` is not known",
        ),
        (
            "model = \"first\"",
            "model = 3",
            "a.cif: it has no model 3; 1 or all would be accepted",
        ),
        (
            "model = \"first\"",
            "model = 1.5",
            "a number, \"first\" or \"all\" would be accepted",
        ),
        (
            "model = \"first\"",
            "chain = \"A\"",
            "unknown field `chain`",
        ),
        (
            "model = \"first\"",
            "residues = [\"9-1\"]",
            "residues: the range 9-1 runs backwards",
        ),
        (
            "model = \"first\"",
            "group = \"none\"",
            "`none` is not a group of this scene",
        ),
    ];
    for (good, wrong, problem) in cases {
        assert!(text.contains(good));
        std::fs::write(folder.join("bad.toml"), text.replace(good, wrong)).unwrap();
        let message = refusal_in(&["render", "bad.toml", "-o", "never.toml"], folder);
        assert!(message.contains(problem), "{message}");
    }
}

#[test]
fn nothing_that_is_left_is_told_with_what_would_be() {
    let folder = tempfile::tempdir().unwrap();
    let path = data("1A8O.cif");
    let file = path.to_str().unwrap();
    let cases: [(&[&str], &str); 5] = [
        (&["--chain", "Z"], "it has no chain Z; A would be accepted"),
        (
            &["--residue", "1-9"],
            "no residue 1-9 in what is asked for; numbers from 151 to",
        ),
        (
            &["--model", "4"],
            "it has no model 4; 1 or all would be accepted",
        ),
        (
            &["--assembly", "2"],
            "it has no assembly 2; --assembly 1 would be accepted",
        ),
        (
            &["--residue", "HOH", "--without-water"],
            "water is drawn without --without-water, other residues without --residue",
        ),
    ];
    for (options, problem) in cases {
        let arguments = [&["import", file, "-o", "never.toml"], options].concat();
        let message = refusal_in(&arguments, folder.path());
        assert!(message.contains(problem), "{message}");
    }
}
