//! Molecules from text to scene: what real files have, and that no bytes make the reader panic.

use crate::common::cases::cases;
use crate::common::says;
use crate::common::structure::{names, places, with};
use imogene_algebra::rational::{from_decimal, to_f64};
use imogene_golden::format::Format;
use imogene_import::pdb::{
    self, Alternates, Colouring, Format as Kind, ModelChoice, Options, Style,
};
use imogene_import::{ImportError, Imported, Place};
use imogene_prepare::Framing;
use imogene_scene::{SceneFile, Shape, Step};
use proptest::prelude::*;

/// Our own helix, which ships as an example.
const HELIX: &[u8] = include_bytes!("../../../scenes/molecules/helix.pdb");

fn read(bytes: &[u8], file: &str, options: &Options) -> Result<Imported, ImportError> {
    pdb::read(bytes, Kind::Pdb, file, options)
}

fn import(text: &str, options: Options) -> Imported {
    read(text.as_bytes(), "f.pdb", &options).expect("readable")
}

fn refusal(text: &[u8], options: Options) -> String {
    read(text, "f.pdb", &options).unwrap_err().to_string()
}

const ONE: &str = "ATOM      1  CA  ALA A   1      11.104  13.207   9.327  1.00  0.00           C";

#[test]
fn an_atom_is_a_sphere_at_its_place() {
    let imported = import(ONE, Options::default());
    let object = &imported.scene.objects[0];
    assert_eq!(object.name, "A/1/CA");
    assert_eq!(object.shape, Shape::Sphere { radius: 1.7 });
    assert_eq!(object.place, [Step::Translate([11.104, 13.207, 9.327])]);
    assert_eq!(object.material, "C");
    assert_eq!(imported.report["atoms_drawn"], 1);
}

/// Short lines, CRLF, an old Mac's CR, lower case, a byte order mark, Latin-1 in a remark, odd serial numbers, and
/// lines of other records.
#[test]
fn what_other_programs_write_is_read() {
    let crlf = format!("REMARK\r\n{ONE}\r\nTER\r\nEND\r\n");
    let cr = format!("REMARK\r{ONE}\rTER\rEND");
    let lower = ONE.to_lowercase();
    let bom = format!("\u{feff}{ONE}");
    let short = &ONE[..54];
    let anisou = format!("{ONE}\nANISOU    1  CA  ALA A   1     nonsense\nSIGATM\n\n\x1a");
    for text in [&crlf, &cr, &lower, &bom, short, &anisou] {
        let imported = import(text, Options::default());
        assert_eq!(places(&imported), [[11.104, 13.207, 9.327]], "{text:?}");
        assert_eq!(imported.scene.objects[0].material, "C", "{text:?}");
    }
    let mut latin = b"REMARK   1 caf\xe9 \xff\xfe\n".to_vec();
    latin.extend(ONE.bytes());
    assert!(read(&latin, "f.pdb", &Options::default()).is_ok());
    // A serial number is told as it is written, and a name that is taken has a number behind.
    for serial in "*****|A0000|186a0|     |99999|    0|  007".split('|') {
        let text = ONE.replacen("    1", serial, 1);
        let imported = import(&format!("{text}\n{text}\n{text}"), Options::default());
        let shown = Some(serial.trim()).filter(|shown| !shown.is_empty());
        let second = format!("A/1/CA #{}", shown.unwrap_or("-"));
        let third = format!("{second} (2)");
        assert_eq!(names(&imported), ["A/1/CA", &second, &third], "{serial}");
    }
    for six in ["ATOM 100000  CA", "ATOM  100000 CA", "HETATM100000 CA"] {
        let text = format!("{six}{}", &ONE[15..]);
        let imported = import(&format!("{text}\n{text}"), Options::default());
        assert_eq!(names(&imported), ["A/1/CA", "A/1/CA #100000"], "{six}");
    }
}

#[test]
fn a_bad_coordinate_is_refused_where_it_stands() {
    let table = "
  11.104 |   11.x04 | 33 | the x coordinate `11.x04` is not a number
  13.207 |      nan | 44 | the y coordinate `nan` is not a number
  13.207 |      inf | 44 | the y coordinate `inf` is not a number
   9.327 |          | 47 | the atom has no z coordinate
   9.327 |    1e300 | 50 | the z coordinate `1e300` is not a number
";
    for [good, wrong, column, problem] in cases(table) {
        let column = column.parse().expect("a number");
        let text = format!("REMARK\n{}", ONE.replace(&good, &wrong));
        let error = read(text.as_bytes(), "f.pdb", &Options::default()).unwrap_err();
        assert_eq!(
            error.error.place,
            Some(Place { line: 2, column }),
            "{wrong}"
        );
        says(&error, &problem);
        says(&error, "would be accepted");
    }
    // A file that was cut off does not move its last atom.
    for (length, place) in [
        (40, "f.pdb:2:39: the line ends within the y"),
        (52, "f.pdb:2:50: the line ends within the z"),
    ] {
        let cut = format!("{ONE}\n{}", &ONE[..length]);
        says(refusal(cut.as_bytes(), Options::default()), place);
    }
    // Columns are counted in characters.
    let wide = ONE.replace("CA  ALA", "C\u{e9}  ALA");
    let wide = wide.replace("11.104", "11.1o4");
    let error = refusal(wide.as_bytes(), Options::default());
    says(error, "f.pdb:1:33: the x");
    let error = refusal(&ONE.as_bytes()[..30], Options::default());
    says(error, "f.pdb:1:31: the line ends before the x coordinate");
}

#[test]
fn what_is_no_structure_is_refused_by_name() {
    let no_atom = "no ATOM or HETATM line";
    let cases: [(&[u8], &str); 4] = [
        (b"", no_atom),
        (b"REMARK nothing\nEND\n", no_atom),
        (b"\xff\xfeA\x00T\x00", "UTF-16"),
        (b"\x00\x00\x00", no_atom),
    ];
    for (bytes, problem) in cases {
        let error = refusal(bytes, Options::default());
        says(&error, problem);
        says(&error, "would be accepted");
    }
    let nothing = with(|o| o.water = false);
    let error = refusal(ONE.replace("ALA", "HOH").as_bytes(), nothing);
    says(error, "the options leave no atom");
}

#[test]
fn models_are_chosen_by_number() {
    let model = |n: i32, x: &str| format!("MODEL {n:>8}\n{}\nENDMDL\n", ONE.replace("  11.104", x));
    let text = model(3, "   1.000") + &model(7, "   2.000") + "END\n";
    for (model, x) in [(ModelChoice::First, 1.0), (ModelChoice::Number(7), 2.0)] {
        let imported = import(&text, with(|o| o.model = model));
        assert_eq!(places(&imported), [[x, 13.207, 9.327]]);
    }
    let error = refusal(text.as_bytes(), with(|o| o.model = ModelChoice::Number(2)));
    says(error, "it has no model 2; 3, 7 or all would be accepted");
    let by_model = with(|o| {
        o.model = ModelChoice::All;
        o.colouring = Colouring::Model;
    });
    let all = import(&text, by_model);
    assert_eq!(names(&all), ["3/A/1/CA", "7/A/1/CA"]);
    let materials = all.scene.materials.iter().map(|m| m.name.as_str());
    assert_eq!(materials.collect::<Vec<_>>(), ["model 3", "model 7"]);
    // Without MODEL lines the ends part the models.
    let parted = format!("{ONE}\nENDMDL\n{ONE}\nEND\n{ONE}\n");
    let imported = import(&parted, Options::default());
    assert_eq!(imported.report["models"], serde_json::json!([1, 2, 3]));
    assert_eq!(imported.report["left_out"]["other_models"], 2);
}

/// Two carbons and an oxygen on a line, 1.5 and 1.4 apart: one bond of one colour and one of two.
#[test]
fn sticks_join_the_middles_of_their_atoms() {
    let atom = |serial: u32, name: &str, x: f64, y: f64, z: f64| {
        let symbol = &name[1..2];
        format!(
            "HETATM{serial:>5} {name:<4} LIG A   1    {x:8.3}{y:8.3}{z:8.3}  1.00  0.00          {symbol:>2}\n"
        )
    };
    let text = atom(1, " C1 ", 0.0, 0.0, 0.0)
        + &atom(2, " C2 ", 0.9, 1.2, 0.0)
        + &atom(3, " O1 ", 0.9, 1.2, -1.4);
    let options = with(|o| o.style = Style::BallAndStick);
    let imported = import(&text, options);
    assert_eq!(imported.report["bonds"], 2);
    // The ends of each stick along itself and, placed by the scene's own steps, the middles of the atoms, or half way,
    // to 10^-5.
    let (c1, c2, o1) = ([0.0, 0.0, 0.0], [0.9, 1.2, 0.0], [0.9, 1.2, -1.4]);
    let half = [0.9, 1.2, -0.7];
    let sticks = [
        ("A/1/C1-A/1/C2", [0.0, 1.5], [c1, c2]),
        ("A/1/C2>A/1/O1", [0.0, 0.7], [c2, half]),
        ("A/1/O1>A/1/C2", [0.7, 1.4], [half, o1]),
    ];
    assert_eq!(names(&imported)[..3], ["A/1/C1", "A/1/C2", "A/1/O1"]);
    assert_eq!(imported.scene.objects.len(), 6);
    for (object, (name, along, ends)) in imported.scene.objects[3..].iter().zip(sticks) {
        assert_eq!(object.name, name);
        let placed = imogene_scene::Transform::placement(&object.place);
        for (cut, (along, end)) in object.cuts.iter().zip(along.into_iter().zip(ends)) {
            assert_eq!(cut.point[1], along, "{name}");
            let at = placed.point(&cut.point.map(from_decimal));
            let off = at.iter().zip(end).map(|(a, b)| (to_f64(a) - b).abs());
            assert!(off.fold(0.0, f64::max) < 1e-5, "{name}: {at:?}");
        }
    }
    // Half bonds have the same plane in the middle, so that no pixel between them is missed.
    let [one, other] = &imported.scene.objects[4..] else {
        panic!("two halves")
    };
    assert_eq!(one.place, other.place);
    assert_eq!(one.cuts[1].point, other.cuts[0].point);
}

#[test]
fn the_helix_is_drawn_in_every_style() {
    let text = std::str::from_utf8(HELIX).expect("text");
    for style in [Style::SpaceFilling, Style::BallAndStick] {
        for alternates in ["best", "B", "all"] {
            let alternates = alternates.parse().expect("alternates");
            let options = with(|o| (o.style, o.alternates) = (style, alternates));
            let imported = import(text, options);
            let toml = imported.scene.to_toml().expect("a valid scene");
            let scene = SceneFile::parse(&toml, "helix").expect("read back");
            assert_eq!(scene, imported.scene);
            let framed = scene.frame(160, 120).expect("framed");
            let format = Format::new(24).expect("catalogue");
            imogene_prepare::prepare(&framed, format).expect("prepared");
        }
    }
}

/// Every stick of the helix is prepared because its ends are no steep planes, whatever the direction of its bond: a
/// fan of bonds across the line of sight.
#[test]
fn no_direction_of_a_bond_is_refused() {
    let mut text = String::new();
    for k in 0..90 {
        let (row, angle) = (f64::from(k / 10), f64::from(k) * 0.000_7 - 0.03);
        let (x, y) = (f64::from(k % 10) * 5.0, row * 5.0);
        let ends = [[x, y, 0.0], [x + 1.5 * angle.cos(), y, 1.5 * angle.sin()]];
        for (n, [x, y, z]) in ends.into_iter().enumerate() {
            text += &format!(
                "HETATM{:>5}  C{n}  LIG A{k:>4}    {x:8.3}{y:8.3}{z:8.3}  1.00  0.00           C\n",
                2 * k + n as i32
            );
        }
    }
    let imported = import(&text, with(|o| o.style = Style::BallAndStick));
    assert_eq!(imported.report["cylinders"], 90);
    let cuts = imported.scene.objects.iter().filter_map(|o| o.cuts.first());
    let tilted = cuts.filter(|c| c.normal[0] != 0.0 || c.normal[2] != 0.0);
    // Most of them lie across the line of sight.
    assert!(tilted.count() > 40);
    for depth in [16, 24, 32] {
        let framed = imported.scene.frame(1280, 960).expect("framed");
        let format = Format::new(depth).expect("catalogue");
        imogene_prepare::prepare(&framed, format).expect("prepared");
    }
}

#[test]
fn the_shipped_scene_is_what_the_reader_writes() {
    let options = with(|o| o.style = Style::BallAndStick);
    let imported = read(HELIX, "helix.pdb", &options).expect("readable");
    let shipped = include_str!("../../../scenes/molecules/helix.toml");
    let stale = "scenes/molecules/helix.toml is stale: imogene import scenes/molecules/helix.pdb --style ball-and-stick -o scenes/molecules/helix.toml";
    let is_fresh = imported.scene.to_toml().expect("valid") == shipped;
    assert!(is_fresh, "{stale}");
}

/// A line of an atom, or of something else, with some bytes of it changed.
fn line() -> impl Strategy<Value = Vec<u8>> {
    let records = prop_oneof![
        Just(ONE.as_bytes().to_vec()),
        Just(ONE.replace("  CA  ALA", "  CB BALA").into_bytes()),
        Just(b"MODEL        2".to_vec()),
        Just(b"ENDMDL".to_vec()),
        Just(b"CONECT    1    1    2    3 A000".to_vec()),
        Just(b"TITLE     A TITLE".to_vec()),
        Just(b"HEADER    HYDROLASE                               01-JAN-00   1ABC".to_vec()),
        proptest::collection::vec(any::<u8>(), 0..100),
    ];
    let changes = proptest::collection::vec((0usize..100, any::<u8>()), 0..3);
    (records, changes, 0usize..100).prop_map(|(mut line, changes, length)| {
        for (at, byte) in changes {
            if let Some(place) = line.get_mut(at) {
                *place = byte;
            }
        }
        if length < 20 {
            line.truncate(length * 5);
        }
        line
    })
}

fn options() -> impl Strategy<Value = Options> {
    let models = prop_oneof![
        Just(ModelChoice::First),
        Just(ModelChoice::All),
        any::<i64>().prop_map(ModelChoice::Number)
    ];
    let alternates = prop_oneof![
        Just(Alternates::Best),
        Just(Alternates::All),
        "[A-Za-z0-9]".prop_map(Alternates::Named)
    ];
    (models, alternates, 0usize..3, any::<[bool; 3]>()).prop_map(
        |(model, alternates, colours, [sticks, hydrogens, water])| Options {
            style: [Style::SpaceFilling, Style::BallAndStick][usize::from(sticks)],
            colouring: [Colouring::Element, Colouring::Chain, Colouring::Model][colours],
            model,
            alternates,
            hydrogens,
            water,
            ..Options::default()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    /// Whatever the bytes, there is a scene that is valid and is read back as the same, or a message that says what
    /// would be accepted.
    #[test]
    fn no_bytes_make_it_panic(lines in proptest::collection::vec(line(), 0..30), options in options(), end in prop_oneof![Just("\n"), Just("\r\n"), Just("\r")]) {
        let text = lines.join(end.as_bytes());
        match read(&text, "f.pdb", &options) {
            Ok(imported) => {
                let toml = imported.scene.to_toml();
                prop_assert!(toml.is_ok(), "{:?}", toml);
                prop_assert_eq!(SceneFile::parse(&toml.unwrap(), "s").expect("read back"), imported.scene);
            }
            Err(error) => prop_assert!(error.to_string().contains("would be accepted") || error.to_string().contains("drawn without"), "{error}"),
        }
    }

    /// Any choice of coordinates is drawn where it is.
    #[test]
    fn coordinates_are_taken_as_written(place in [-999_999i32..9_999_999, -999_999..9_999_999, -999_999..9_999_999]) {
        let written = place.map(|v| format!("{:8.3}", f64::from(v) / 1000.0));
        let text = format!("{}{}{}", &ONE[..30], written.concat(), &ONE[54..]);
        let imported = import(&text, Options::default());
        let expected = place.map(|v| f64::from(v) / 1000.0);
        prop_assert_eq!(&imported.scene.objects[0].place, &vec![Step::Translate(expected)]);
    }
}
