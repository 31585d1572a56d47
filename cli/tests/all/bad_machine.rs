//! Bad machine descriptions: for every key, a message that says what is wrong, where, and what would be accepted; exit
//! code 2, and nothing written.

use crate::common::{Place, repository};
use imogene_plan::description::MachineDescription;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};

const BEAM: &str = "machine = \"beam\"\nobjects = 10\nplanes = 3\nmode = \"160x120\"\n";
const ZONE: &str = "machine = \"zone\"\nobjects = 3\nplanes = 3\nmode = \"160x120\"\nzone = { width = 32, height = 24 }\n";

const SPHERE: &str = "machine = \"beam\"\nobjects = 10\nplanes = 3\nmode = \"160x120\"\nlights = 0\nlit_sphere = { side = 64, materials = 2 }\n";
const OWN_MODE: &str = "machine = \"beam\"\nobjects = 10\nplanes = 3\nmode = { columns = [160, 2, 2, 4], lines = [120, 1, 1, 4] }\n";

/// The description of a name in the table.
fn base(name: &str) -> &'static str {
    match name {
        "zone" => ZONE,
        "sphere" => SPHERE,
        "own_mode" => OWN_MODE,
        _ => BEAM,
    }
}

/// A key and its errors, as `bad_machine.toml` says.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Errors {
    #[serde(default)]
    base: String,
    wrong_type: Vec<String>,
    out_of_range: Vec<String>,
    contradiction: Option<Vec<String>>,
    missing: Option<Vec<String>>,
}

/// Every key, `table.key` within a table.
fn all() -> BTreeMap<String, Errors> {
    toml::from_str(include_str!("bad_machine.toml")).expect("the table")
}

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
        let begin = format!("{key} = ");
        let rest = base.lines().filter(|line| !line.starts_with(&begin));
        return rest.collect::<Vec<&str>>().join("\n");
    };
    with(base, &line_of(base, table, inner, None))
}

/// The line of a table, in which a key has another value or is left out.
fn line_of(base: &str, table: &str, inner: &str, value: Option<&str>) -> String {
    let text: toml::Table = base.parse().expect("a description");
    let own = text.get(table).and_then(toml::Value::as_table);
    let others = own.into_iter().flatten().filter(|(key, _)| *key != inner);
    let keys = others.map(|(key, value)| format!("{key} = {value}"));
    let keys = keys.chain(value.map(|value| format!("{inner} = {value}")));
    let keys: Vec<String> = keys.collect();
    format!("{table} = {{ {} }}", keys.join(", "))
}

/// A description in which a key has a value.
fn with_value(base: &str, key: &str, value: &str) -> String {
    match key.split_once('.') {
        Some((table, inner)) => with(base, &line_of(base, table, inner, Some(value))),
        None => with(base, &format!("{key} = {value}")),
    }
}

/// The message with which a description is refused.
fn refusal(text: &str) -> String {
    let place = Place::new();
    place.write("m.toml", text);
    let line = "machine scenes/cone.toml --machine m.toml --emit-only --out out";
    let said = place.run(line).ended(2).said;
    assert!(said.starts_with("error: m.toml"), "{text}{said}");
    assert_eq!(said.lines().count(), 1, "{text}{said}");
    for rust in "panicked|struct |enum |i128|usize|u32|u64|Some(".split('|') {
        assert!(!said.contains(rust), "{rust}: {said}");
    }
    assert_eq!(place.names(), ["m.toml"], "something was written: {said}");
    said
}

/// The refusal has these parts, and names a key and the line where its value stands.
fn assert_said(text: &str, key: Option<&str>, parts: &[impl AsRef<str>]) {
    let said = refusal(text);
    for part in parts.iter().map(AsRef::as_ref) {
        assert!(said.contains(part), "no '{part}' in: {said}{text}");
    }
    let Some(key) = key else { return };
    let table = key.split('.').next().expect("a key");
    let begin = format!("{table} = ");
    let line = text.lines().position(|line| line.starts_with(&begin));
    let place = format!("m.toml:{}:", line.expect("it stands there") + 1);
    let is_named = said.contains(&place) && said.contains(table);
    assert!(is_named, "{place}: {said}{text}");
}

#[test]
fn every_key_of_a_machine_has_its_errors() {
    for (key, errors) in all() {
        let base = base(&errors.base);
        for bad in [errors.wrong_type, errors.out_of_range] {
            assert_said(&with_value(base, &key, &bad[0]), Some(&key), &bad[1..]);
        }
        if let Some(mut says) = errors.contradiction {
            says.push("error: m.toml:".into());
            assert_said(&with(base, &says[0]), None, &says[1..]);
        }
        if let Some(says) = errors.missing {
            assert_said(&without(base, &key), None, &says);
        }
    }
}

/// A key that is written wrong is named with its place, and those that are accepted stand beside it.
#[test]
fn a_key_that_is_nearly_one_is_named() {
    for (key, errors) in all() {
        let (table, inner) = key.split_once('.').unwrap_or(("", &key));
        let typo = format!("{inner}s");
        let line = match table {
            "" => format!("{typo} = 1"),
            _ => format!("{table} = {{ {typo} = 1 }}"),
        };
        let text = with(base(&errors.base), &line);
        let place = format!("m.toml:{}:", text.lines().count());
        let unknown = format!("unknown field `{typo}`");
        assert_said(&text, None, &[unknown, format!("`{inner}`"), place]);
    }
}

#[test]
fn a_key_that_stands_twice_is_refused() {
    for (key, errors) in all().iter().filter(|(key, _)| !key.contains('.')) {
        let line = format!("{key} = 1\n");
        let text = format!("{}{line}", with(base(&errors.base), line.trim_end()));
        let place = format!("m.toml:{}:1: duplicate key", text.lines().count());
        assert_said(&text, None, &[place.as_str(), "once"]);
    }
}

/// The reader itself tells its keys: one that is added needs its errors in the table.
#[test]
fn no_key_is_left_out() {
    let of_table = |(table, base): (&str, &str)| -> Vec<String> {
        let (line, prefix) = match table {
            "" => ("unknown = 1".to_owned(), String::new()),
            _ => (format!("{table} = {{ unknown = 1 }}"), format!("{table}.")),
        };
        let said = refusal(&with(base, &line));
        let list = said.split_once("unknown field `unknown`, expected ");
        let list = list.expect("a list").1.trim_end();
        let list = list.trim_start_matches("one of ").replace(" or ", ", ");
        let keys = list.split(", ").map(|key| key.trim_matches('`'));
        keys.map(|key| format!("{prefix}{key}")).collect()
    };
    let names = ["", "widths", "zone", "mode", "lit_sphere"].into_iter();
    let tables = names.zip([BEAM, BEAM, ZONE, BEAM, SPHERE]);
    let read: BTreeSet<String> = tables.flat_map(of_table).collect();
    assert_eq!(read, all().into_keys().collect());
}

/// What the errors start from is right, and so are all machines of the repository.
#[test]
fn machines_that_are_right_are_read() {
    for text in [BEAM, ZONE, OWN_MODE, SPHERE] {
        let machine = MachineDescription::parse(text, "m.toml");
        assert!(machine.is_ok(), "{machine:?}");
    }
    let mut count = 0;
    for entry in std::fs::read_dir(repository("machines")).expect("the machines") {
        let path = entry.expect("readable").path();
        let machine = MachineDescription::read(&path);
        let machine = machine.unwrap_or_else(|error| panic!("{error}"));
        let again = MachineDescription::parse(&machine.to_toml(), "again");
        assert_eq!(again.expect("its own text"), machine);
        count += 1;
    }
    assert!(count >= 10, "{count}");
}
