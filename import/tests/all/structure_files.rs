//! Structure files in all their formats: published ones against what another program counts, and what each format may
//! hold.

use crate::common::list::file;
use crate::common::says;
use crate::common::structure::{cif, names, places, with};
use imogene_import::pdb::{self, Alternates, Colouring, Format, Options, Style};
use imogene_import::{ImportError, Imported, Kind, is_compressed, unpack};
use imogene_prepare::Framing;
use imogene_scene::{Molecule, SceneFile};

/// A file of the tests, unpacked.
fn bytes(name: &str) -> Vec<u8> {
    let bytes = file(&format!("import/tests/data/{name}"));
    if is_compressed(&bytes) {
        unpack(&bytes, 10_000_000, name).expect(name)
    } else {
        bytes
    }
}

fn try_import(name: &str, options: &Options) -> Result<Imported, ImportError> {
    let bytes = bytes(name);
    let kind = Kind::of(&bytes, "no ending").expect("known by what it holds");
    let Kind::Structure(format) = kind else {
        panic!("{kind:?} is no structure");
    };
    pdb::read(&bytes, format, name, options)
}

fn import(name: &str, options: &Options) -> Imported {
    try_import(name, options).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn published_files_hold_what_another_program_counts() {
    let table = include_str!("../data/expected.tsv");
    assert_eq!(table.lines().count(), 2 + 7);
    for row in table.lines().skip(2) {
        let row: Vec<&str> = row.split('\t').collect();
        let [file, atoms, models, first, chains, bonds, assembly, mean] = row[..] else {
            panic!("{row:?}");
        };
        let mut options = with(|o| {
            o.style = Style::BallAndStick;
            o.alternates = Alternates::All;
        });
        let imported = import(file, &options);
        let report = &imported.report;
        let words = |key: &str| {
            let list = report[key].as_array().expect(key).iter();
            let texts = list.map(|v| v.as_str().map_or_else(|| v.to_string(), str::to_owned));
            texts.collect::<Vec<_>>().join(" ")
        };
        assert_eq!(report["atoms_read"].to_string(), atoms, "{file}");
        assert_eq!(report["atoms_drawn"].to_string(), first, "{file}");
        assert_eq!(report["bonds"].to_string(), bonds, "{file}");
        assert_eq!(words("models"), models, "{file}");
        assert_eq!(words("chains"), chains, "{file}");
        if assembly == "-" {
            assert_eq!(words("assemblies"), "", "{file}");
            continue;
        }
        options.style = Style::SpaceFilling;
        options.assembly = Some("1".into());
        let places = places(&import(file, &options));
        assert_eq!(places.len().to_string(), assembly, "{file}");
        for (k, other) in mean.split(' ').enumerate() {
            let own = places.iter().map(|p| p[k]).sum::<f64>() / places.len() as f64;
            let other: f64 = other.parse().expect("a number");
            assert!((own - other).abs() <= 6e-4, "{file}: {own}, not {other}");
        }
    }
}

/// The same entry in two formats is the same scene, apart from the chains of water and the numbers of atoms, which the
/// formats have their own of.
#[test]
fn formats_of_an_entry_agree() {
    let options = with(|o| {
        o.style = Style::BallAndStick;
        o.colouring = Colouring::Chain;
        o.assembly = Some("1".into());
    });
    let scene = |file: &str| import(file, &options).scene;
    assert_eq!(scene("3JQH.cif"), scene("3jqh.bcif.gz"));
    let (text, lines) = (scene("1A8O.cif"), scene("1A8O.pdb"));
    assert_eq!(text.objects, lines.objects);
    assert_eq!(text.materials, lines.materials);
    assert_eq!(text.title, "1A8O: HIV CAPSID C-TERMINAL DOMAIN");
}

#[test]
fn copies_of_chains_are_named_and_coloured_by_their_operator() {
    let options = with(|o| {
        o.colouring = Colouring::Chain;
        o.assembly = Some("1".into());
    });
    let imported = import("1A8O.cif", &options);
    assert_eq!(imported.report["chains"], serde_json::json!(["A", "A-2"]));
    assert!(names(&imported).contains(&"A-2/151/CA"));
    // Operator 2 of the file: -y+41.98, -x+41.98, -z+44.46.
    let place = |name: &str| {
        let all = names(&imported);
        let at = all.iter().position(|n| *n == name).expect(name);
        places(&imported)[at]
    };
    let ([x, y, z], moved) = (place("A/151/CA"), place("A-2/151/CA"));
    for (own, expected) in moved.iter().zip([41.98 - y, 41.98 - x, 44.46 - z]) {
        assert!((own - expected).abs() < 1e-9, "{moved:?}");
    }
    let unknown = with(|o| o.assembly = Some("7".into()));
    for why in [
        "1A8O.pdb: it has no assembly 7; --assembly 1 would be accepted",
        "disordered.pdb: it describes no assembly",
    ] {
        let (file, _) = why.split_once(':').unwrap();
        says(try_import(file, &unknown).unwrap_err(), why);
    }
}

#[test]
fn chains_and_residues_are_chosen() {
    let chosen = |file: &str, chains: &[&str], residues: &[&str]| {
        let options = with(|o| {
            o.chains = chains.iter().map(|c| (*c).to_owned()).collect();
            o.residues = residues.iter().map(|r| r.parse().expect(r)).collect();
        });
        let read = try_import(file, &options).map_err(|error| error.to_string());
        read.map(|imported| imported.scene.objects.len())
    };
    // Counted with grep in the file: residues 151 to 153 of the chain, and selenomethionines.
    let lines = |test: fn(&str) -> bool| {
        let text = String::from_utf8(bytes("1A8O.pdb")).expect("text");
        let is_atom = |line: &&str| line.starts_with("ATOM") || line.starts_with("HETATM");
        let atoms = text.lines().filter(is_atom);
        atoms.filter(|line| test(line)).count()
    };
    let range = lines(|l| (151..=153).contains(&l[22..26].trim().parse().unwrap_or(0)));
    let named = lines(|l| &l[17..20] == "MSE");
    assert!(range > 0 && named > 0);
    assert_eq!(chosen("1A8O.pdb", &["A"], &["151-153"]), Ok(range));
    assert_eq!(chosen("1A8O.cif", &[], &["151", "152-153"]), Ok(range));
    assert_eq!(chosen("1A8O.cif", &["A"], &["mse"]), Ok(named));
    let file = "1LCD.pdb.gz";
    let [both, one, other] =
        [&["B", "C"][..], &["B"], &["C"]].map(|chains| chosen(file, chains, &[]).unwrap());
    assert_eq!(both, one + other);
    let why = "1LCD.pdb.gz: it has no chain D; A, B, C would be accepted";
    assert_eq!(chosen(file, &["A", "D"], &[]).unwrap_err(), why);
    let why = "no residue HEM in what is asked for; numbers from 1 to 3293 and the names DA, DC, DG, DT, HOH";
    says(chosen(file, &["B"], &["HEM"]).unwrap_err(), why);
}

/// What is wrong with an operator is told to those who ask for an assembly, and to nobody else.
#[test]
fn wrong_operators_are_refused_when_they_are_asked_for() {
    let whole = String::from_utf8(bytes("1A8O.cif")).expect("text");
    let asked = with(|o| o.assembly = Some("1".into()));
    let row = "0.0000000000 0.0000000000 41.98";
    let line = whole.lines().position(|l| l.starts_with(row));
    let line = line.expect("the operator") + 1;
    let bad = whole.replace(row, "0.0000000000 one 41.98");
    assert!(cif(&bad, &Options::default()).is_ok());
    let why = format!("f.cif:{line}:14: matrix[2][3] of operator `2` is `one`");
    says(cif(&bad, &asked).unwrap_err(), &why);
    let missing = whole.replace("oper_expression   1,2", "oper_expression   1,(2-4)");
    let why = "there is no operator `3`";
    says(cif(&missing, &asked).unwrap_err(), why);
    let old = String::from_utf8(bytes("1A8O.pdb")).expect("text");
    let read =
        |text: &str, options: &Options| pdb::read(text.as_bytes(), Format::Pdb, "f.pdb", options);
    let bad = old.replace("BIOMT2   2 -1.000000", "BIOMT2   2 -1.0000o0");
    assert!(read(&bad, &Options::default()).is_ok());
    let why = "f.pdb:262:24: `-1.0000o0` of an operator";
    says(read(&bad, &asked).unwrap_err(), why);
    let cut = old.replace("REMARK 350   BIOMT3   2", "REMARK 351   BIOMT3   2");
    let why = "without its lines BIOMT1, BIOMT2 and BIOMT3";
    says(read(&cut, &asked).unwrap_err(), why);
}

#[test]
fn kinds_are_known_by_what_files_hold() {
    let [pdb, mmcif, bcif] = [Format::Pdb, Format::Mmcif, Format::Bcif].map(Kind::Structure);
    let kinds = [
        ("import/tests/data/1A8O.cif", mmcif),
        ("import/tests/data/1SSU_mod.cif", mmcif),
        ("import/tests/data/1A8O.pdb", pdb),
        ("import/tests/data/disordered.pdb", pdb),
        ("scenes/molecules/helix.pdb", pdb),
        ("parts/bracket.faces.toml", Kind::Faces),
        ("parts/nut.step", Kind::Step),
        ("scenes/terrain/hills.heights", Kind::Heights),
    ];
    for (path, kind) in kinds {
        // A name that says something else counts for less.
        assert_eq!(Kind::of(&file(path), "a.stp"), Some(kind), "{path}");
    }
    let packed = bytes("3jqh.bcif.gz");
    assert_eq!(Kind::of(&packed, "a.stp"), Some(bcif));
    let texts = [
        ("NCOLS 2\nnrows 2", Some(Kind::Heights)),
        ("# heights\nstep 2 2\n1 2\n3 4", Some(Kind::Heights)),
        ("3\nwater\nO 0 0 0", None),
        ("ATOM 100000  CA  ALA", Some(pdb)),
        ("\u{feff}atom      1  CA", Some(pdb)),
        ("\r\n  DATA_x", Some(mmcif)),
        ("hello", None),
        ("HEADER;\nFILE_NAME('x')", None),
        ("", None),
    ];
    for (text, kind) in texts {
        assert_eq!(Kind::of(text.as_bytes(), "a.txt"), kind, "{text:?}");
    }
    // What its contents do not show, the name does.
    let named = [
        ("a.PDB", pdb),
        ("a.ent.gz", pdb),
        ("a.cif.gz", mmcif),
        ("a.bcif", bcif),
        ("a.asc", Kind::Heights),
    ];
    for (name, kind) in named {
        assert_eq!(Kind::of(b"?", name), Some(kind), "{name}");
    }
}

/// A scene that names the file gets the same objects, with the names and in the group that it asks for.
#[test]
fn a_scene_is_filled_from_the_file_that_it_names() {
    let options = with(|o| o.style = Style::BallAndStick);
    let whole = import("1A8O.cif", &options).scene;
    let mut scene = SceneFile {
        objects: vec![],
        molecules: vec![Molecule {
            file: "1A8O.cif".into(),
            style: "ball-and-stick".into(),
            ..Molecule::default()
        }],
        ..whole.clone()
    };
    let text = scene.to_toml().expect("a scene may name a file");
    let read = SceneFile::parse(&text, "s.toml").expect("readable");
    assert_eq!(read, scene);
    let error = scene.validate().unwrap_err();
    says(error, "molecules: `1A8O.cif` has not been read");
    assert!(scene.frame(64, 48).is_err());
    let [mut molecule] = <[_; 1]>::try_from(std::mem::take(&mut scene.molecules)).expect("one");
    let bytes = bytes("1A8O.cif");
    pdb::add(&mut scene, &molecule, &bytes, Format::Mmcif, "f").expect("readable");
    assert_eq!(scene, whole);
    molecule.name = Some("second".into());
    molecule.colour = "chain".into();
    pdb::add(&mut scene, &molecule, &bytes, Format::Mmcif, "f").expect("readable");
    assert_eq!(scene.objects.len(), 2 * whole.objects.len() - 292);
    // Names are parted by the molecule's, and its materials are added.
    scene.validate().expect("valid");
}
