//! Texts in the PDBx/mmCIF format: their forms, what each item means, what is refused and where, and that no words
//! make the reader panic.

use crate::common::cases::cases;
use crate::common::says;
use crate::common::structure::{cif, names, places, with};
use imogene_import::pdb::{ModelChoice, Options, Style};
use proptest::prelude::*;

/// Two cysteines, which only the file bonds: too far for the distance rule.
const FAR: &str = "data_far
loop_
_struct_conn.id
_struct_conn.conn_type_id
_struct_conn.ptnr1_label_asym_id
_struct_conn.ptnr1_label_atom_id
_struct_conn.ptnr1_auth_seq_id
_struct_conn.ptnr1_symmetry
_struct_conn.ptnr2_label_asym_id
_struct_conn.ptnr2_label_atom_id
_struct_conn.ptnr2_auth_seq_id
_struct_conn.ptnr2_symmetry
s1 disulf A SG 1 1_555 B SG 2 1_555
s2 disulf A SG 1 1_555 B SG 3 2_555
h1 hydrog A SG 1 1_555 B SG 3 1_555
s3 covale A SG 1 1_555 B SG 9 1_555
loop_
_atom_site.type_symbol
_atom_site.label_atom_id
_atom_site.label_comp_id
_atom_site.label_asym_id
_atom_site.auth_asym_id
_atom_site.auth_seq_id
_atom_site.pdbx_PDB_ins_code
_atom_site.Cartn_x
_atom_site.Cartn_y
_atom_site.Cartn_z
S SG CYS A HH 1 ? 0 0 0
S SG CYS B HH 2 ? 5 0 0
S SG CYS B HH 3 ? 10 0 0
";

#[test]
fn bonds_of_the_file_are_drawn_where_they_are_in_the_cell() {
    let options = with(|o| o.style = Style::BallAndStick);
    let imported = cif(FAR, &options).expect("readable");
    let expected = ["HH/1/SG", "HH/2/SG", "HH/3/SG", "HH/1/SG-HH/2/SG"];
    assert_eq!(names(&imported), expected);
    assert_eq!(imported.report["bonds_from_file_alone"], 1);
    let notes = imported.notes.join("\n");
    says(notes, "1 bond to other cells of the crystal left out");
}

/// What an author may leave out, in what order, in which case, with which line ends; and what is not drawn.
#[test]
fn texts_of_every_form_are_read() {
    let columns =
        "loop_\n_Atom_Site.Cartn_Z\n_atom_site.Cartn_y\n_atom_site.cartn_x\n_atom_site.other\n";
    let text =
        format!("# made by hand\ndata_x {columns} 3.5(2) 2 1 'two words' # behind\n -1e1 ? ");
    let error = cif(&text, &Options::default()).unwrap_err();
    says(error, "the last row of the loop has 2 of 4 values");
    let text = format!(
        "data_x {columns} 3.5(2) 2 1\n;text\nof lines\n;\n-1e1 -2.5 +.5 \"a 'b' c\"\ndata_y {columns} 1 2 3 4"
    );
    for text in [
        text.clone(),
        text.replace('\n', "\r\n"),
        text.replace('\n', "\r"),
        format!("\u{feff}{text}"),
    ] {
        let imported = cif(&text, &Options::default()).expect("readable");
        assert_eq!(places(&imported), [[1.0, 2.0, 3.5], [0.5, -2.5, -10.0]]);
        says(imported.notes.join("\n"), "further data blocks left out");
        assert_eq!(imported.scene.title, "x");
    }
    let one = "data_one _entry.id 'an entry' _struct.title\n;a title\nof two lines\n;\n_atom_site.Cartn_x 1 _atom_site.Cartn_y 2 _atom_site.Cartn_z 3 _atom_site.type_symbol Fe3+ _atom_site.label_atom_id FE";
    let imported = cif(one, &Options::default()).expect("readable");
    assert_eq!(imported.scene.title, "an entry: a title of two lines");
    assert_eq!(imported.scene.objects[0].material, "Fe");
    assert_eq!(names(&imported), ["-/-/FE"]);
}

/// Words in all their forms, as the title of a text with keywords in any case.
#[test]
fn every_kind_of_word_is_known() {
    let table = [
        ("'5'-end'", "5'-end"),
        ("\"a 'b'\"", "a 'b'"),
        ("d_x", "d_x"),
        ("loop_x", "loop_x"),
        ("a#b", "a#b"),
        (";b", ";b"),
        ("# a comment\r\n;two\r\nlines; \r\n;", "two  lines;"),
        ("\n;\n;", ""),
    ];
    for (word, title) in table {
        let text = format!(
            "DATA_1abc save_x stop_ GLOBAL_ _Struct.title {word}\r\nLoop_ _atom_site.cartn_x _atom_site.cartn_y _atom_site.cartn_z 1 2 3"
        );
        let imported = cif(&text, &Options::default()).expect(word);
        let expected = match title {
            "" => "1abc".to_owned(),
            title => format!("1abc: {title}"),
        };
        assert_eq!(imported.scene.title, expected);
    }
}

/// The molecule of three sulphurs with operator n, which moves by n along x, and X0, which turns x into y.
fn assembled(expression: &str) -> String {
    let list = "loop_ _pdbx_struct_oper_list.id";
    let mut text = format!(
        "{FAR}_pdbx_struct_assembly_gen.assembly_id 1
_pdbx_struct_assembly_gen.oper_expression '{expression}'
_pdbx_struct_assembly_gen.asym_id_list A,B,C\n{list}"
    );
    for row in 1..=3 {
        let columns = (1..=3).map(|column| format!("matrix[{row}][{column}]"));
        for item in columns.chain([format!("vector[{row}]")]) {
            text += &format!(" _pdbx_struct_oper_list.{item}");
        }
    }
    for n in 1..=30 {
        text += &format!("\n{n} 1 0 0 {n} 0 1 0 0 0 0 1 0");
    }
    text + "\nX0 0 -1 0 0 1 0 0 0 0 0 1 0\n"
}

#[test]
fn expressions_are_lists_ranges_and_products() {
    let asked = with(|o| {
        o.assembly = Some("1".into());
        o.style = Style::BallAndStick;
    });
    let good = [
        ("1", "1"),
        ("1,2, 3", "1 2 3"),
        ("(1-4)", "1 2 3 4"),
        ("(1-2,21-22)", "1 2 21 22"),
        ("(X0)(1-3)", "X0-1 X0-2 X0-3"),
        ("(1,2)(3,4)", "1-3 1-4 2-3 2-4"),
        ("X0(1)", "X0-1"),
    ];
    for (text, expected) in good {
        let imported = cif(&assembled(text), &asked).expect(text);
        let names = names(&imported);
        let first = names.iter().filter_map(|name| name.strip_suffix("/1/SG"));
        let first = first.filter(|name| !name.contains('/'));
        let operators: Vec<&str> = first.map(|name| &name["HH-".len()..]).collect();
        assert_eq!(operators.join(" "), expected, "{text}");
        // What the file says is bonded is bonded in each copy.
        for own in expected.split(' ') {
            let bond = format!("HH-{own}/1/SG-HH-{own}/2/SG");
            assert!(names.contains(&bond.as_str()), "{bond}");
        }
    }
    // The right one first: along x to 7, then x is turned into y.
    for (text, place) in [("(X0)(2)", [0.0, 7.0, 0.0]), ("(2)(X0)", [2.0, 5.0, 0.0])] {
        let imported = cif(&assembled(text), &asked).expect(text);
        assert_eq!(places(&imported)[1], place);
    }
    let bad = [
        ("", "names no operator"),
        ("()", "names no operator"),
        ("(1-99999999)", "no operator `31`"),
        ("(3-1)", "backwards"),
        ("(1", "is no list"),
        ("1)", "is no list"),
        ("(P)", "no operator `P`"),
        ("(1-30)(1-30)(1-30)(1-30)", "more than"),
    ];
    for (text, problem) in bad {
        says(cif(&assembled(text), &asked).unwrap_err(), problem);
    }
}

/// Chains of several letters, insertion codes, models out of order, alternates, names with quotes, and the names of
/// the authors before the others.
#[test]
fn every_column_has_its_meaning() {
    let text = "data_x loop_
_atom_site.id _atom_site.type_symbol _atom_site.label_atom_id _atom_site.label_alt_id _atom_site.label_comp_id _atom_site.auth_comp_id
_atom_site.label_asym_id _atom_site.auth_asym_id _atom_site.label_seq_id _atom_site.auth_seq_id _atom_site.pdbx_PDB_ins_code
_atom_site.Cartn_x _atom_site.Cartn_y _atom_site.Cartn_z _atom_site.occupancy _atom_site.pdbx_PDB_model_num
1 C  \"C1'\" . LIG XXX A AAA 1 -7 B 1 0 0 1.0 5
2 N  N1    A LIG XXX A ?   1 .  . 2 0 0 0.3 2
3 N  N1    B LIG XXX A ?   1 .  . 3 0 0 0.7 2
4 ?  O2    . LIG XXX A .   . ?  ? 4 0 0 ?   5
";
    let all = with(|o| o.model = ModelChoice::All);
    let imported = cif(text, &all).expect("readable");
    let expected = ["5/AAA/-7B/C1'", "5/A/-/O2", "2/A/1/N1.B"];
    assert_eq!(names(&imported), expected);
    assert_eq!(imported.report["models"], serde_json::json!([5, 2]));
    assert_eq!(imported.report["elements_from_names"], 1);
    assert_eq!(imported.scene.objects[1].material, "O");
    let own = with(|o| {
        o.residues = vec!["XXX".parse().expect("a name")];
        o.chains = vec!["AAA".into()];
    });
    assert_eq!(names(&cif(text, &own).expect("readable")), ["AAA/-7B/C1'"]);
}

#[test]
fn what_is_wrong_is_refused_where_it_stands() {
    let row = "data_x\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
    let table = r"
{row}1 2 x3 | f.cif:6:5: the z coordinate `x3` is not a number
{row}1 ? 3 | f.cif:6:3: the atom has no y coordinate
{row}1 nan 3 | f.cif:6:3: the y coordinate `nan`
{row}1 2 1e300 | f.cif:6:5: the z coordinate `1e300`
{row}1 2 3 4 | f.cif:6:7: the last row of the loop has 1 of 3 values
{row}1 2 '3 | f.cif:6:5: the quote is not closed
{row};1\n2 3 | f.cif:6:1: the text that begins here is not closed
data_x\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.pdbx_PDB_model_num\n_atom_site.Cartn_z\n1 2 x 3 | f.cif:7:5: the number `x` of the model
; | f.cif:1:1: the text that begins here is not closed
_é.a 'b | f.cif:1:6: the quote is not closed
data_x\nloop_\n1 2 | f.cif:2:1: a loop without names
data_x\n_entry.id\n_struct.title a | f.cif:2:1: the item `_entry.id` has no value
data_x\néé y | f.cif:2:1: a value without a name
data_x\n_entry.id 1\n_atom_site.id 2 | no atom in the category _atom_site
data_x\nloop_\n_atom_site_label\n_atom_site_fract_x\nC1 0.5 | the CIF of a small molecule
data_x\n_refln.id 1 | these are structure factors
data_x\n_chem_comp_atom.atom_id 1 | the definition of a chemical component
";
    for [text, start] in cases(table) {
        let error = cif(&text.replace("{row}", row), &Options::default()).unwrap_err();
        says(&error, &start);
        says(&error, " would ");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    /// Whatever the words of a text, there is a scene that can be written, or a message that says what would be
    /// accepted.
    #[test]
    fn no_words_make_it_panic(words in proptest::collection::vec(word(), 0..80)) {
        match cif(&words.join(" "), &Options::default()) {
            Ok(imported) => prop_assert!(imported.scene.to_toml().is_ok()),
            Err(error) => prop_assert!(error.contains("would"), "{error}"),
        }
    }
}

fn word() -> impl Strategy<Value = String> {
    const KNOWN: &str = "data_x|loop_|_atom_site.Cartn_x|_atom_site.Cartn_y|_atom_site.Cartn_z|_atom_site.id|_struct_conn.conn_type_id|_pdbx_struct_oper_list.id|_pdbx_struct_assembly_gen.assembly_id|?|.|1.5|'a b'|\n;\ntext\n;\n|#|\n|save_";
    let known: Vec<&str> = KNOWN.split('|').collect();
    prop_oneof![
        9 => (0..known.len()).prop_map(move |k| known[k].to_owned()),
        1 => any::<String>(),
    ]
}
