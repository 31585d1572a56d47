//! `imogene emit`: files, prefixes, JSON keys.

use crate::common::{Place, assert_keys, columns};

#[test]
fn emit_reports_top_files_latency_and_ports() {
    let place = Place::new();
    let emit = "emit quadric_processor --planes 2 --rows-per-stage 4 --out .";
    let report = place.json(emit);
    assert_keys(&report, "top files latency ports");
    assert_eq!(report["latency"], 6 + 11);
    let file = report["files"][0].as_str().unwrap();
    let first = place.text(file);
    place.json(emit);
    assert_eq!(first, place.text(file), "emission is not deterministic");
    let command = "imogene emit quadric_processor --format 24 --planes 2 --rows-per-stage 4";
    assert!(first.contains(command));
}

/// Every file of a list has the module of its name, and no other.
fn assert_modules(place: &Place, list: &str) {
    for file in list.lines() {
        let text = place.text(file);
        let module = file.strip_suffix(".v").unwrap();
        assert_eq!(text.matches("\nmodule ").count(), 1, "{file}");
        assert!(text.contains(&format!("\nmodule {module} (")), "{file}");
    }
}

#[test]
fn emit_split_writes_each_module_once_and_lists_them() {
    let place = Place::new();
    let report = place.json("emit quadric_pe --split --out .");
    let list = place.text("quadric_pe.f");
    assert_eq!(list.lines().last(), Some("quadric_pe.v"));
    assert_eq!(report["modules"], list.lines().count());
    assert_modules(&place, &list);
}

#[test]
fn emit_puts_a_prefix_before_modules_and_files() {
    let place = Place::new();
    for (prefix, word) in [("narrow_", "16"), ("wide_", "24")] {
        let options = format!("--format {word} --split --prefix {prefix} --out .");
        let report = place.json(&format!("emit square_root {options}"));
        assert_eq!(report["top"], format!("{prefix}square_root"));
        let list = place.text(&format!("{prefix}square_root.f"));
        assert_eq!(list.lines().count(), 3);
        assert!(list.lines().all(|file| file.starts_with(prefix)), "{list}");
        assert_modules(&place, &list);
    }
}

/// A machine without a scene, from its description alone.
#[test]
fn emit_writes_a_whole_machine() {
    let place = Place::new();
    let description = "machine = \"zone\"\nslots = \"2,facet3\"\ndecider = \"chain\"\n\
        zone = { width = 8, height = 8 }\nmode = \"640x480\"\n";
    place.write("m.toml", description);
    let report = place.json("emit --machine m.toml --prefix own_ --out out");
    assert_eq!(report["unit"], "own_zone_display");
    assert_eq!(report["top"], "own_zone_display");
    let text = place.text("out/own_zone_display.v");
    for part in [
        "imogene emit --machine m.toml --prefix own_ --out DIR",
        "decider chain",
        "\nmodule own_visibility_chain (",
        "\nmodule own_facet_shared_store (",
    ] {
        assert!(text.contains(part), "{part}");
    }
    let cases = "
        emit --out out                           | <UNIT>
        emit pe1 --machine m.toml --out out      | cannot be used with
        emit --machine none.toml --out out       | none.toml: the machine description cannot be read
        synth --machine none.toml --target gowin | none.toml: the machine description cannot be read
    ";
    for [line, part] in columns(cases) {
        place.run(line).refused(&[part]);
    }
}
