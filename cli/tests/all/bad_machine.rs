//! Bad machine descriptions: for every key, a message that says what is wrong, where, and what would be accepted; exit
//! code 2, and nothing written.

use crate::common::{imogene, scene};
use std::collections::BTreeSet;
use std::path::Path;

const BEAM: &str = "machine = \"beam\"\nobjects = 10\nplanes = 3\nmode = \"160x120\"\n";
const ZONE: &str = "machine = \"zone\"\nobjects = 3\nplanes = 3\nmode = \"160x120\"\nzone = { width = 32, height = 24 }\n";

const SPHERE: &str = "machine = \"beam\"\nobjects = 10\nplanes = 3\nmode = \"160x120\"\nlights = 0\nlit_sphere = { side = 64, materials = 2 }\n";

/// What is given and what the message says of it, besides the key and its place.
type Said = (&'static str, &'static [&'static str]);

/// A key and its errors.
struct Bad {
    /// `table.key` within a table.
    key: &'static str,
    /// The description in which it stands, or which it is added to.
    base: &'static str,
    /// A value of another type.
    wrong_type: Said,
    /// A value out of its range.
    out_of_range: Said,
    /// Lines beside which a value is accepted, and what the message says if it stands beside them.
    contradiction: Option<Said>,
    /// What is said if the key is left out.
    missing: Option<&'static [&'static str]>,
}

const fn bad(key: &'static str, wrong_type: Said, out_of_range: Said) -> Bad {
    Bad {
        key,
        base: BEAM,
        wrong_type,
        out_of_range,
        contradiction: None,
        missing: None,
    }
}

/// Every key of a description, and of its tables.
fn all() -> Vec<Bad> {
    vec![
        Bad {
            missing: Some(&["machine is missing", "\"beam\" or \"zone\""]),
            contradiction: Some((
                "machine = \"beam\"\nzone = { width = 8, height = 8 }",
                &["zone is given", "a zone machine alone"],
            )),
            ..bad(
                "machine",
                ("3", &["expected a string", "\"beam\" or \"zone\""]),
                ("\"ray\"", &["`ray`", "`beam` or `zone`"]),
            )
        },
        Bad {
            contradiction: Some((
                "depth_word = 30\nwidths = { g2 = 5 }",
                &["widths", "a depth word of 30 bits accepts at most 4"],
            )),
            ..bad(
                "depth_word",
                ("\"24\"", &["string \"24\"", "8 to 32"]),
                ("33", &["33 bits", "8 to 32"]),
            )
        },
        Bad {
            contradiction: Some((
                "widths = { root = 20 }\ndepth_word = 18",
                &["root of 20 bits", "4 to 18"],
            )),
            ..bad(
                "widths",
                ("5", &["integer `5`", "a table", "g1 = 2"]),
                ("{ root = 3 }", &["root of 3 bits", "4 to 24"]),
            )
        },
        bad(
            "widths.root",
            ("\"x\"", &["string \"x\"", "a table such as"]),
            ("25", &["root of 25 bits", "4 to 24"]),
        ),
        bad(
            "widths.plane",
            ("1.5", &["floating point `1.5`", "a table such as"]),
            ("37", &["plane word of 37 bits", "24 to 36"]),
        ),
        bad(
            "widths.normal",
            ("true", &["boolean `true`", "a table such as"]),
            ("9", &["normal component of 9 bits", "10 to 16"]),
        ),
        bad(
            "widths.g1",
            ("[1]", &["sequence", "a table such as"]),
            ("17", &["17", "at most 16"]),
        ),
        bad(
            "widths.g2",
            ("-1", &["integer `-1`", "a table such as"]),
            ("17", &["17", "at most 16"]),
        ),
        bad(
            "widths.dropped",
            ("\"\"", &["string \"\"", "a table such as"]),
            ("9", &["dropped digits of the root of 9 bits", "0 to 8"]),
        ),
        Bad {
            base: SPHERE,
            contradiction: Some((
                "lights = 3",
                &[
                    "lit_sphere is { side = 64, materials = 2 }",
                    "half as many for each of the lights",
                ],
            )),
            ..bad(
                "lit_sphere",
                ("64", &["integer `64`", "a table", "side = 64"]),
                (
                    "{ side = 128, materials = 3 }",
                    &["materials = 3", "of 128 to 2"],
                ),
            )
        },
        Bad {
            base: SPHERE,
            missing: Some(&["lit_sphere: missing field `side`", "side = 64"]),
            ..bad(
                "lit_sphere.side",
                ("\"x\"", &["string \"x\"", "a side of 16"]),
                ("48", &["side = 48", "16, 32, 64 or 128"]),
            )
        },
        Bad {
            base: SPHERE,
            missing: Some(&["lit_sphere: missing field `materials`", "1 to 32 materials"]),
            ..bad(
                "lit_sphere.materials",
                ("true", &["boolean `true`", "1 to 32 materials"]),
                ("0", &["materials = 0", "1 to 32 materials"]),
            )
        },
        Bad {
            contradiction: Some((
                "root_form = \"quadratic1\"\nwidths = { root = 11 }",
                &["quadratic root of 11 bits", "12 to 32"],
            )),
            ..bad(
                "root_form",
                ("2", &["integer `2`", "\"linear2\""]),
                ("\"cubic1\"", &["'cubic1' is no form", "restoring"]),
            )
        },
        Bad {
            contradiction: Some((
                "rows_per_stage = 13\nwidths = { root = 16, dropped = 4 }",
                &["rows_per_stage is 13", "1 to 12"],
            )),
            ..bad(
                "rows_per_stage",
                ("1.0", &["floating point `1.0`", "digits of the root"]),
                ("0", &["rows_per_stage is 0", "1 to 24"]),
            )
        },
        Bad {
            contradiction: Some((
                "objects = 4\nslots = \"3,0,2v\"",
                &["objects is 4", "3, as slots has"],
            )),
            missing: Some(&["objects is missing", "1 to 256", "slots"]),
            ..bad(
                "objects",
                ("\"ten\"", &["string \"ten\"", "1 to 256"]),
                ("99999999999", &["objects is 99999999999", "1 to 256"]),
            )
        },
        Bad {
            contradiction: Some((
                "planes = 2\nslots = \"3,0,2v,1,1,1,1,1,1,1\"",
                &["planes is 2", "3, as slots has"],
            )),
            ..bad(
                "planes",
                ("{ a = 1 }", &["map", "0 to 12"]),
                ("13", &["planes is 13", "0 to 12"]),
            )
        },
        Bad {
            contradiction: Some((
                "slots = \"sphere,0,0,0,0,0,0,0,0,3\"\nwidths = { root = 20 }",
                &["slots is sphere", "g1 and g2 alone"],
            )),
            ..bad(
                "slots",
                ("3", &["integer `3`", "\"3,0,2v,patch2,sphere\""]),
                ("\"13\"", &["'13' is no slot", "0 to 12"]),
            )
        },
        Bad {
            contradiction: Some((
                "products = \"8-1,2-0\"",
                &["products is 8-1,2-0", "products of 10 slots"],
            )),
            ..bad(
                "products",
                ("[2, 1]", &["sequence", "\"2-1,1-3\""]),
                ("\"17-1\"", &["'17-1' is no product", "1 to 16"]),
            )
        },
        Bad {
            contradiction: Some((
                "layers = 2\nobjects = 2",
                &["layers is 2", "fewer than the 2 slots"],
            )),
            ..bad(
                "layers",
                ("\"2\"", &["string \"2\"", "0 to 8"]),
                ("9", &["layers is 9", "0 to 8"]),
            )
        },
        bad(
            "volumes",
            ("-1", &["integer `-1`", "0 to 256"]),
            ("257", &["volumes is 257", "0 to 256"]),
        ),
        bad(
            "volume_planes",
            ("false", &["boolean `false`", "0 to 12"]),
            ("13", &["volume_planes is 13", "0 to 12"]),
        ),
        bad(
            "lights",
            ("\"one\"", &["string \"one\"", "0 to 16"]),
            ("17", &["lights is 17", "0 to 16"]),
        ),
        Bad {
            contradiction: Some(("suns = 3\nlights = 2", &["suns is 3", "0 to 2"])),
            ..bad(
                "suns",
                ("0.5", &["floating point `0.5`", "number of lights"]),
                ("2", &["suns is 2", "0 to 1"]),
            )
        },
        Bad {
            base: ZONE,
            contradiction: Some((
                "machine = \"zone\"\nloader_words = 64",
                &["loader_words is given", "a beam machine alone"],
            )),
            missing: Some(&["zone is missing", "{ width = 32, height = 32 }"]),
            ..bad(
                "zone",
                (
                    "\"32x24\"",
                    &["string \"32x24\"", "a table", "{ width = 32, height = 32 }"],
                ),
                (
                    "{ width = 129, height = 128 }",
                    &["129 x 128", "1 to 16384 pixels"],
                ),
            )
        },
        Bad {
            base: ZONE,
            missing: Some(&["missing field `width`", "{ width = 32, height = 32 }"]),
            ..bad(
                "zone.width",
                ("\"32\"", &["string \"32\"", "1 to 16384 pixels"]),
                ("0", &["zone is 0 x 24", "1 to 16384 pixels"]),
            )
        },
        Bad {
            base: ZONE,
            missing: Some(&["missing field `height`", "{ width = 32, height = 32 }"]),
            ..bad(
                "zone.height",
                ("[24]", &["sequence", "1 to 16384 pixels"]),
                ("4294967296", &["integer `4294967296`", "1 to 16384 pixels"]),
            )
        },
        Bad {
            contradiction: Some((
                "loader_words = 64\nmachine = \"zone\"\nzone = { width = 8, height = 8 }",
                &["loader_words is given", "a beam machine alone"],
            )),
            ..bad(
                "loader_words",
                ("\"many\"", &["string \"many\"", "2 to 65536"]),
                ("65537", &["loader_words is 65537", "2 to 65536"]),
            )
        },
        Bad {
            contradiction: Some((
                "mode = \"1280x720\"\nmachine = \"zone\"\nzone = { width = 8, height = 8 }\nsupersampling = 4",
                &["supersampling is 4", "up to 1024 x 1024"],
            )),
            missing: Some(&["mode is missing", "\"640x480\"", "columns = [shown"]),
            ..bad(
                "mode",
                (
                    "640",
                    &[
                        "integer `640`",
                        "the name of a mode or a table",
                        "\"640x480\"",
                    ],
                ),
                (
                    "\"640x481\"",
                    &["mode is \"640x481\"", "\"1280x720\"", "columns = [shown"],
                ),
            )
        },
        Bad {
            base: OWN_MODE,
            missing: Some(&["missing field `columns`", "columns = [shown"]),
            ..bad(
                "mode.columns",
                ("[160, 4, 4]", &["length 3", "length 4", "columns = [shown"]),
                ("[4096, 4, 4, 4]", &["columns = [4096", "1 to 4095 shown"]),
            )
        },
        Bad {
            base: OWN_MODE,
            missing: Some(&["missing field `lines`", "lines = [..]"]),
            ..bad(
                "mode.lines",
                (
                    "120",
                    &["integer `120`", "an array of length 4", "lines = [..]"],
                ),
                (
                    "[120, 2, 0, 4]",
                    &["lines = [120, 2, 0, 4]", "a sync of 1 at least"],
                ),
            )
        },
        Bad {
            base: OWN_MODE,
            ..bad(
                "mode.hsync_high",
                ("1", &["integer `1`", "a boolean", "hsync_high = true"]),
                (
                    "\"high\"",
                    &["string \"high\"", "a boolean", "hsync_high = true"],
                ),
            )
        },
        Bad {
            base: OWN_MODE,
            ..bad(
                "mode.vsync_high",
                ("1", &["integer `1`", "a boolean", "vsync_high = true"]),
                (
                    "\"high\"",
                    &["string \"high\"", "a boolean", "vsync_high = true"],
                ),
            )
        },
        Bad {
            contradiction: Some((
                "output = \"stream\"\noverlay = true",
                &["output is stream", "neither smoothing nor overlay"],
            )),
            ..bad(
                "output",
                ("true", &["expected a string", "\"pins\" or \"stream\""]),
                ("\"hdmi\"", &["`hdmi`", "`pins` or `stream`"]),
            )
        },
        Bad {
            contradiction: Some((
                "supersampling = 2",
                &["supersampling is 2", "1 in a beam machine"],
            )),
            ..bad(
                "supersampling",
                ("\"2x2\"", &["string \"2x2\"", "1, 2 or 4"]),
                ("3", &["supersampling is 3", "1, 2 or 4"]),
            )
        },
        Bad {
            contradiction: Some((
                "smoothing = \"3x3\"\noutput = \"stream\"",
                &["output is stream", "neither smoothing nor overlay"],
            )),
            ..bad(
                "smoothing",
                ("3", &["expected a string", "\"none\", \"2x2\" or \"3x3\""]),
                ("\"4x4\"", &["`4x4`", "`none`, `2x2`, `3x3`"]),
            )
        },
        Bad {
            contradiction: Some((
                "overlay = true\noutput = \"stream\"",
                &["output is stream", "neither smoothing nor overlay"],
            )),
            ..bad(
                "overlay",
                ("1", &["integer `1`", "true or false"]),
                ("\"mask.png\"", &["string \"mask.png\"", "true or false"]),
            )
        },
    ]
}

const OWN_MODE: &str = "machine = \"beam\"\nobjects = 10\nplanes = 3\nmode = { columns = [160, 2, 2, 4], lines = [120, 1, 1, 4] }\n";

/// A description in which the keys of some lines are given by these lines alone.
fn with(base: &str, lines: &str) -> String {
    let is_given = |line: &&str| {
        let key = line.split(" = ").next();
        !lines.lines().any(|own| own.split(" = ").next() == key)
    };
    let rest: Vec<&str> = base.lines().filter(is_given).collect();
    format!("{}\n{lines}\n", rest.join("\n"))
}

/// A description without a key.
fn without(base: &str, key: &str) -> String {
    let Some((table, inner)) = key.split_once('.') else {
        let rest = base
            .lines()
            .filter(|line| !line.starts_with(&format!("{key} = ")));
        return rest.collect::<Vec<&str>>().join("\n");
    };
    with(base, &line_of(base, table, inner, None))
}

/// The line of a table, in which a key has another value or is left out.
fn line_of(base: &str, table: &str, inner: &str, value: Option<&str>) -> String {
    let text: toml::Table = base.parse().expect("a description");
    let own = text.get(table).and_then(toml::Value::as_table);
    let others = own.into_iter().flatten().filter(|(key, _)| *key != inner);
    let mut keys: Vec<String> = others
        .map(|(key, value)| format!("{key} = {value}"))
        .collect();
    keys.extend(value.map(|value| format!("{inner} = {value}")));
    format!("{table} = {{ {} }}", keys.join(", "))
}

/// A description in which a key has a value.
fn with_value(bad: &Bad, value: &str) -> String {
    match bad.key.split_once('.') {
        Some((table, inner)) => with(bad.base, &line_of(bad.base, table, inner, Some(value))),
        None => with(bad.base, &format!("{} = {value}", bad.key)),
    }
}

/// The message with which a description is refused.
fn refusal(text: &str) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("m.toml");
    std::fs::write(&path, text).expect("a file");
    let output = imogene()
        .current_dir(folder.path())
        .arg("machine")
        .arg(scene("cone.toml"))
        .args(["--machine", "m.toml", "--emit-only", "--out", "out"])
        .output()
        .expect("the program runs");
    let said = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(2), "{text}{said}");
    assert!(said.starts_with("error: m.toml"), "{text}{said}");
    assert_eq!(said.lines().count(), 1, "{text}{said}");
    for rust in [
        "panicked", "struct ", "enum ", "i128", "usize", "u32", "u64", "Some(",
    ] {
        assert!(!said.contains(rust), "{rust}: {said}");
    }
    let left = std::fs::read_dir(folder.path()).expect("a folder").count();
    assert_eq!(left, 1, "something was written: {said}");
    said
}

/// The refusal has these parts, and names a key and the line where its value stands.
fn assert_said(text: &str, key: Option<&str>, parts: &[&str]) {
    let said = refusal(text);
    for part in parts {
        assert!(said.contains(part), "no '{part}' in: {said}{text}");
    }
    let Some(key) = key else { return };
    let table = key.split('.').next().expect("a key");
    let line = text
        .lines()
        .position(|line| line.starts_with(&format!("{table} = ")));
    let place = format!("m.toml:{}:", line.expect("it stands there") + 1);
    assert!(
        said.contains(&place) && said.contains(table),
        "{place}: {said}{text}"
    );
}

#[test]
fn every_key_of_a_machine_has_its_errors() {
    for bad in all() {
        for (value, says) in [bad.wrong_type, bad.out_of_range] {
            assert_said(&with_value(&bad, value), Some(bad.key), says);
        }
        if let Some((lines, says)) = bad.contradiction {
            let at_a_line = &["error: m.toml:"];
            assert_said(&with(bad.base, lines), None, &[says, at_a_line].concat());
        }
        if let Some(says) = bad.missing {
            assert_said(&without(bad.base, bad.key), None, says);
        }
    }
}

/// A key that is written wrong is named with its place, and those that are accepted stand beside it.
#[test]
fn a_key_that_is_nearly_one_is_named() {
    for bad in all() {
        let (table, inner) = bad.key.split_once('.').unwrap_or(("", bad.key));
        let typo = format!("{inner}s");
        let line = match table {
            "" => format!("{typo} = 1"),
            _ => format!("{table} = {{ {typo} = 1 }}"),
        };
        let says = [format!("unknown field `{typo}`"), format!("`{inner}`")];
        let text = with(bad.base, &line);
        let place = format!("m.toml:{}:", text.lines().count());
        let says = says.iter().chain([&place]).map(String::as_str);
        assert_said(&text, None, &says.collect::<Vec<&str>>());
    }
}

#[test]
fn a_key_that_stands_twice_is_refused() {
    for bad in all().iter().filter(|bad| !bad.key.contains('.')) {
        let line = format!("{} = 1\n", bad.key);
        let text = format!("{}{line}", with(bad.base, line.trim_end()));
        let place = format!("m.toml:{}:1: duplicate key", text.lines().count());
        assert_said(&text, None, &[&place, "once"]);
    }
}

/// The reader itself tells its keys: one that is added needs its errors above.
#[test]
fn no_key_is_left_out() {
    let of_table = |table: &str, text: &str| -> Vec<String> {
        let said = refusal(&with(
            text,
            &match table {
                "" => "unknown = 1".to_owned(),
                _ => format!("{table} = {{ unknown = 1 }}"),
            },
        ));
        let (_, list) = said
            .split_once("unknown field `unknown`, expected ")
            .expect("a list");
        let list = list.trim_end().trim_start_matches("one of ");
        let keys = list.replace(" or ", ", ");
        let keys = keys.split(", ").map(|key| key.trim_matches('`').to_owned());
        keys.map(|key| {
            if table.is_empty() {
                key
            } else {
                format!("{table}.{key}")
            }
        })
        .collect()
    };
    let mut read = of_table("", BEAM);
    for (table, base) in [
        ("widths", BEAM),
        ("zone", ZONE),
        ("mode", BEAM),
        ("lit_sphere", SPHERE),
    ] {
        read.extend(of_table(table, base));
    }
    let read: BTreeSet<String> = read.into_iter().collect();
    let known: BTreeSet<String> = all().into_iter().map(|bad| bad.key.to_owned()).collect();
    assert_eq!(read, known);
}

/// What the errors start from is right, and so are all machines of the repository.
#[test]
fn machines_that_are_right_are_read() {
    for text in [BEAM, ZONE, OWN_MODE, SPHERE] {
        let machine = imogene_plan::description::MachineDescription::parse(text, "m.toml");
        assert!(machine.is_ok(), "{machine:?}");
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../machines");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("the machines") {
        let path = entry.expect("readable").path();
        let machine = imogene_plan::description::MachineDescription::read(&path);
        let machine = machine.unwrap_or_else(|error| panic!("{error}"));
        let again =
            imogene_plan::description::MachineDescription::parse(&machine.to_toml(), "again");
        assert_eq!(again.expect("its own text"), machine);
        count += 1;
    }
    assert!(count >= 10, "{count}");
}
