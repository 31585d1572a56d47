//! What the reader of molecules decides: elements, alternate locations, bonds, and what options say.

use crate::common::says;
use crate::common::structure::{names, with};
use imogene_algebra::vector::{cross, dot, length, minus};
use imogene_import::Imported;
use imogene_import::pdb::{self, Alternates, Format, ModelChoice, Options, Residues, Style};
use imogene_scene::{Camera, Lens, Molecule, Object, Shape, Step};
use proptest::prelude::*;

/// A line of an atom: its name in four columns, its alternate, residue and symbol.
struct Atom<'a> {
    serial: &'a str,
    name: &'a str,
    alternate: char,
    residue: &'a str,
    number: usize,
    place: [f64; 3],
    occupancy: f64,
    symbol: &'a str,
}

const CARBON: Atom = Atom {
    serial: "1",
    name: " C  ",
    alternate: ' ',
    residue: "LIG",
    number: 7,
    place: [0.0; 3],
    occupancy: 1.0,
    symbol: "C",
};

impl Atom<'_> {
    fn line(&self) -> String {
        let [x, y, z] = self.place;
        format!(
            "ATOM  {:>5} {:<4}{}{:>3} A{:>4}    {x:8.3}{y:8.3}{z:8.3}{:6.2}  0.00          {:>2}\n",
            self.serial,
            self.name,
            self.alternate,
            self.residue,
            self.number,
            self.occupancy,
            self.symbol
        )
    }
}

/// Atoms of an element at places, numbered from 1.
fn lines(atoms: &[(&str, [f64; 3])]) -> String {
    let line = |(k, (symbol, place)): (usize, &(&str, [f64; 3]))| {
        Atom {
            serial: &(k + 1).to_string(),
            number: k + 1,
            symbol,
            place: *place,
            ..CARBON
        }
        .line()
    };
    atoms.iter().enumerate().map(line).collect()
}

fn read(text: &str, options: &Options) -> Result<Imported, String> {
    let read = pdb::read(text.as_bytes(), Format::Pdb, "f.pdb", options);
    read.map_err(|error| error.to_string())
}

fn bonded(text: &str) -> Result<Imported, String> {
    let options = with(|o| {
        o.style = Style::BallAndStick;
        o.alternates = Alternates::All;
    });
    read(text, &options)
}

fn bonds(text: &str) -> u64 {
    let report = bonded(text).expect("readable").report;
    report["bonds"].as_u64().expect("a number")
}

/// Columns 13 and 14 of the format's description: "alignment of one-letter atom name such as C starts at column 14,
/// while two-letter atom name such as FE starts at column 13".
#[test]
fn names_are_read_by_their_alignment() {
    let cases = [
        (" CA ", "ALA", "C"),
        ("CA  ", "CA", "Ca"),
        (" N  ", "GLY", "N"),
        ("NA  ", "NA", "Na"),
        ("FE  ", "HEM", "Fe"),
        (" C1'", "DA", "C"),
        ("1HB ", "ALA", "H"),
        ("HG11", "VAL", "H"),
        ("HG  ", "HG", "Hg"),
        ("HH12", "LIG", "H"),
        (" D  ", "DOD", "H"),
        ("DD11", "LIG", "H"),
        ("CL1 ", "LIG", "Cl"),
        ("SE  ", "MSE", "Se"),
        ("CA  ", "ALA", "C"),
        ("cl  ", "lig", "Cl"),
        (" ZN ", "ZN", "Zn"),
        (" CU ", "CU", "Cu"),
        (" ZN1", "LIG", "Zn"),
        ("C   ", "LIG", "C"),
        (" Q1 ", "LIG", "unknown element"),
        ("    ", "LIG", "unknown element"),
        ("XA  ", "LIG", "unknown element"),
        ("****", "LIG", "unknown element"),
        ("OP1A", "LIG", "O"),
    ];
    for (name, residue, element) in cases {
        let atom = Atom {
            name,
            residue,
            symbol: "",
            ..CARBON
        };
        let imported = read(&atom.line(), &Options::default()).expect(name);
        let material = &imported.scene.objects[0].material;
        assert_eq!(material, element, "{name:?} of {residue}");
    }
}

/// Printed in the sources: Cordero's Table 2, Bondi's Table 1 and Alvarez's Table 1, and the colours of Jmol's page.
#[test]
fn radii_and_colours_are_those_of_the_sources() {
    let cases = [
        ("H", 0.31, 1.20, 0xffffff),
        ("C", 0.76, 1.70, 0x909090),
        ("N", 0.71, 1.55, 0x3050f8),
        ("O", 0.66, 1.52, 0xff0d0d),
        ("P", 1.07, 1.80, 0xff8000),
        ("S", 1.05, 1.80, 0xffff30),
        ("Fe", 1.32, 2.44, 0xe06633),
        ("Ca", 1.76, 2.62, 0x3dff00),
        ("Zn", 1.22, 1.39, 0x7d80b0),
        ("Se", 1.20, 1.90, 0xffa100),
    ];
    for (symbol, covalent, radius, colour) in cases {
        let imported = read(&lines(&[(symbol, [0.0; 3])]), &Options::default()).expect(symbol);
        assert_eq!(imported.scene.objects[0].shape, Shape::Sphere { radius });
        let levels = imported.scene.materials[0].colour;
        let [r, g, b] = levels.map(|v| (v * 255.0).round() as u32);
        assert_eq!(r << 16 | g << 8 | b, colour, "{symbol}");
        assert!(imported.notes.iter().all(|note| !note.contains("radius")));
        // To a carbon: as long as both radii and the tolerance.
        let longest = covalent + 0.76 + 0.45;
        for (x, count) in [(longest - 0.01, 1), (longest + 0.01, 0)] {
            let pair = [(symbol, [0.0; 3]), ("C", [x, 0.0, 0.0])];
            assert_eq!(bonds(&lines(&pair)), count, "{symbol} at {x}");
        }
    }
    let imported = read(&lines(&[("Pm", [0.0; 3])]), &Options::default()).expect("promethium");
    assert!(imported.notes[1].starts_with("no published radius of Pm"));
}

/// What is kept of atoms, written as names, alternates or `-`, residues and occupancies, in the order of the file.
fn kept_of(atoms: &str, alternates: &str) -> String {
    let line = |atom: &str| {
        let [name, alternate, residue, occupancy] = atom.split(' ').collect::<Vec<_>>()[..] else {
            panic!("{atom}")
        };
        Atom {
            name: &format!(" {name}"),
            alternate: alternate.replace('-', " ").chars().next().expect(atom),
            residue,
            occupancy: occupancy.parse().expect(atom),
            ..CARBON
        }
        .line()
    };
    let text: String = atoms.split(", ").map(line).collect();
    let asked = with(|o| o.alternates = alternates.parse().expect("alternates"));
    let imported = read(&text, &asked).expect("atoms left");
    let left_out = imported.report["left_out"]["alternate_locations"].as_u64();
    let count = imported.scene.objects.len() as u64 + left_out.expect("a number");
    assert_eq!(count, text.lines().count() as u64);
    let own = |name: &str| name["A/7/".len()..].replace('.', "").replace(" #1", "");
    let kept: Vec<String> = names(&imported).into_iter().map(own).collect();
    kept.join(" ")
}

const SIDE: &str = "N - SER 1.0, CA A SER 0.4, CA B SER 0.6, CB A SER 0.7, CB B SER 0.6, OG A SER 0.4, OG B SER 0.6";
/// Of a published file: the first location of CZ has no letter, and belongs to A.
const ARGININE: &str =
    "CZ - ARG 0.5, CZ B ARG 0.5, NH1 A ARG 0.5, NH1 B ARG 0.5, NH2 A ARG 0.5, NH2 B ARG 0.5";
const HYDROGEN: &str = "CA A SER 0.6, CA B SER 0.4, HG B SER 0.4";
/// Two residues at one place.
const BOTH: &str =
    "N - SER 1.0, CA A SER 0.3, CA B THR 0.7, OG A SER 0.3, OG1 B THR 0.7, CG2 B THR 0.7";

#[test]
fn a_residue_keeps_one_alternate() {
    let cases = [
        // B has the mean 0.6, A that of 0.5; atom by atom CB would be A's.
        (SIDE, "best", "N CAB CBB OGB"),
        (SIDE, "A", "N CAA CBA OGA"),
        (SIDE, "Z", "N CAB CBB OGB"),
        (SIDE, "all", "N CAA CAB CBA CBB OGA OGB"),
        // Of equal occupancies the first.
        ("CA B SER 0.5, CA A SER 0.5", "best", "CAB"),
        (ARGININE, "best", "CZ NH1A NH2A"),
        (ARGININE, "B", "CZB NH1B NH2B"),
        (BOTH, "best", "N CAB OG1B CG2B"),
        (BOTH, "A", "N CAA OGA"),
        // An atom that only the other alternate has stays.
        (HYDROGEN, "best", "CAA HGB"),
        // A molecule of water that is there half of the time, and two atoms of the same name and letter.
        ("O A HOH 0.5", "best", "OA"),
        ("C A LIG 0.5, C A LIG 0.5", "best", "CA CA"),
    ];
    for (atoms, asked, kept) in cases {
        assert_eq!(kept_of(atoms, asked), kept, "{asked} of {atoms}");
    }
}

#[test]
fn bonds_have_a_least_length_and_join_no_hydrogens_and_no_alternates() {
    for (x, count) in [(0.41, 1), (0.39, 0)] {
        let pair = [("C", [0.0; 3]), ("N", [x, 0.0, 0.0])];
        assert_eq!(bonds(&lines(&pair)), count, "{x}");
    }
    assert_eq!(bonds(&lines(&[("H", [0.0; 3]), ("H", [0.8, 0.0, 0.0])])), 0);
    for ([a, b], count) in [(['A', 'B'], 0), (['A', 'A'], 1), (['A', ' '], 1)] {
        let atom = |alternate, x| Atom {
            alternate,
            place: [x, 0.0, 0.0],
            ..CARBON
        };
        let text = atom(a, 0.0).line() + &atom(b, 0.8).line();
        assert_eq!(bonds(&text), count, "{a} and {b}");
    }
}

#[test]
fn connections_are_taken_when_their_numbers_are_unique() {
    let far = [("1", 0.0), ("A0000", 5.0), ("3", 10.0), ("3", 15.0)];
    let line = |(serial, x)| Atom {
        serial,
        number: x as usize,
        place: [x, 0.0, 0.0],
        ..CARBON
    };
    let text: String = far.map(|atom| line(atom).line()).concat();
    let said = "CONECT    1A0000    3    9\nCONECTA0000    1\n";
    let imported = bonded(&(text + said)).expect("readable");
    assert_eq!(imported.report["bonds_from_file_alone"], 1);
    assert_eq!(names(&imported)[4..], ["A/0/C-A/5/C"]);
}

#[test]
fn crowds_are_refused_and_stars_are_thinned() {
    let row = |count: u32, step: f64| -> String {
        let place = |k| ("C", [step * f64::from(k), 0.0, 0.0]);
        lines(&(0..count).map(place).collect::<Vec<_>>())
    };
    let error = bonded(&row(1000, 0.001)).unwrap_err();
    says(error, "f.pdb: more than 256 atoms within 2.0 angstroms");
    let said: String = (2..=20).map(|k| format!("CONECT    1{k:>5}\n")).collect();
    let imported = bonded(&(row(20, 100.0) + &said)).expect("readable");
    assert_eq!(imported.report["bonds"], 16);
    let thinned = "3 bonds left out at atoms that have sixteen already";
    assert!(imported.notes.iter().any(|note| note == thinned));
}

fn ball(object: &Object) -> ([f64; 3], f64) {
    match (&object.shape, &object.place[..]) {
        (Shape::Sphere { radius }, [Step::Translate(place)]) => (*place, *radius),
        other => panic!("{other:?}"),
    }
}

/// Atoms in a box of 180 x 120 x 40 angstroms.
fn atoms() -> impl Strategy<Value = Vec<(&'static str, [f64; 3])>> {
    let place = [-90_000..90_000, -50_000..70_000, -20_000..20_000];
    let element = prop_oneof![Just("H"), Just("C"), Just("S"), Just("Cs")];
    let atom = (element, place);
    let atom = atom.prop_map(|(element, p)| (element, p.map(|v| f64::from(v) / 1000.0)));
    proptest::collection::vec(atom, 1..40)
}

proptest! {
    /// Every ball is seen whole, and the one that reaches farthest leaves half of the margin of 4 % free, to what
    /// rounding moves: five digits of the height and four behind the point of the target, beside radii from 1.2.
    #[test]
    fn the_balls_fill_the_picture(atoms in atoms()) {
        let scene = read(&lines(&atoms), &Options::default()).expect("readable").scene;
        let balls: Vec<([f64; 3], f64)> = scene.objects.iter().map(ball).collect();
        let Camera { eye, target, up, view_height, lens, .. } = scene.camera;
        let Lens::Perspective { viewer_distance: d, .. } = lens else { panic!("perspective") };
        let towards = minus(eye, target).map(|v| v / length(minus(eye, target)));
        prop_assert!((dot(minus(eye, target), towards) - d).abs() < 2e-4);
        for value in [d, view_height] {
            prop_assert_eq!(format!("{value:.4e}").parse(), Ok(value), "five digits");
        }
        let mut widest = 0f64;
        for (place, radius) in &balls {
            let v = minus(*place, eye);
            let depth = -dot(v, towards);
            prop_assert!(depth - radius > 0.5 * d, "before the near end");
            for (axis, half) in [(cross(up, towards), view_height / 1.5), (up, 0.5 * view_height)] {
                // The side of a ball: the tangent plane through the eye that is parallel to the other axis.
                let a = dot(v, axis).abs();
                let angle = a.atan2(depth) + (radius / a.hypot(depth)).asin();
                widest = widest.max(d * angle.tan() / half);
            }
        }
        prop_assert!((0.959..0.961).contains(&widest), "{widest} of the picture");
        // The eye is six radii of a sphere around all balls away, which is nearly the smallest. Half the distance of
        // the farthest ends of any two is a lower bound; the smallest sphere is at most 2 / sqrt(3) of that for three
        // balls and sqrt(3 / 2) for four (Jung's theorem), beside what the steps towards its middle leave.
        let pairs = balls.iter().flat_map(|p| balls.iter().map(move |q| (p, q)));
        let least = pairs.map(|((p, r), (q, s))| (0.5 * (length(minus(p, q)) + r + s)).max(*r));
        let (least, radius) = (least.fold(0.0, f64::max), d / 6.0);
        prop_assert!(radius >= least * (1.0 - 1e-12));
        prop_assert!(radius <= least * 1.5f64.sqrt() * 1.02, "{radius} {least}");
    }

    /// As many as trying all pairs finds, by the radii that the sources print.
    #[test]
    fn no_pair_is_missed(places in proptest::collection::vec(([-9_000..9_000, -9_000..9_000, -9_000..9_000], 0usize..4), 2..60)) {
        let elements = [("H", 0.31), ("C", 0.76), ("S", 1.05), ("Fe", 1.32)];
        let atoms: Vec<(&str, [f64; 3])> = places.iter().map(|(p, k)| (elements[*k].0, p.map(|v| f64::from(v) / 1000.0))).collect();
        let mut expected = 0;
        for (i, (p, k)) in places.iter().enumerate() {
            for (q, l) in &places[..i] {
                let square: i32 = p.iter().zip(q).map(|(a, b)| (a - b) * (a - b)).sum();
                let longest = elements[*k].1 + elements[*l].1 + 0.45;
                let distance = f64::from(square).sqrt() / 1000.0;
                prop_assume!((distance - longest).abs() > 1e-9);
                expected += u64::from(k + l > 0 && (0.4..longest).contains(&distance));
            }
        }
        prop_assert_eq!(bonds(&lines(&atoms)), expected);
    }
}

#[test]
fn residues_are_numbers_ranges_and_names() {
    let ranges = [("10-20", 10, 20), ("-5-3", -5, 3), ("-5--1", -5, -1)];
    let ranges = ranges.map(|(text, first, last)| (text, Residues::Range(first, last)));
    let called = ["10", "52A", "-5", "HEM", "U-1"];
    let called = called.map(|text| (text, Residues::Called(text.into())));
    for (text, expected) in ranges.into_iter().chain(called) {
        let residues: Residues = text.parse().expect(text);
        assert_eq!(residues, expected);
        assert_eq!(residues.to_string(), text);
    }
    let error = "20-10".parse::<Residues>().unwrap_err();
    says(error, "10-20 would be accepted");
    assert!(" ".parse::<Residues>().is_err());
}

#[test]
fn a_scene_asks_in_words() {
    let molecule = Molecule {
        style: "ball-and-stick".into(),
        model: "-2".into(),
        alternates: "B".into(),
        residues: vec!["-3-7".into(), "HEM".into()],
        ..Molecule::default()
    };
    let options = Options::of(&molecule).expect("known words");
    assert_eq!(options.style, Style::BallAndStick);
    assert_eq!(options.model, ModelChoice::Number(-2));
    assert_eq!(options.alternates, Alternates::Named("B".into()));
    let residues = [Residues::Range(-3, 7), Residues::Called("HEM".into())];
    assert_eq!(options.residues, residues);
    let wrong = Molecule {
        style: "sticks".into(),
        ..molecule
    };
    let why = "style: `sticks` is not known; space-filling or ball-and-stick";
    says(Options::of(&wrong).unwrap_err(), why);
}
