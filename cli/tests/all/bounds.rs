//! `imogene check` and `bounds`: guard bits, random cases, headroom.

use crate::common::{assert_keys, json};

#[test]
fn guard_bits_sharpen_the_bounds_of_a_check() {
    let depth = |guards: &str| {
        let line = format!("check scenes/cone.toml --size 96x72 --guards {guards}");
        json(&line)["objects"][0]["bounds"]["f2"].as_f64().unwrap()
    };
    assert!(depth("2:4") < depth("0:0") / 4.0);
}

#[test]
fn bounds_hold_on_random_cases() {
    let trial = json("bounds --cases 300 --seed 5");
    assert_eq!(trial["violations"], 0);
    assert_eq!(trial["cases"], 300);
    let formats = trial["formats"].as_array().unwrap();
    assert!(formats.len() >= 8);
    for format in formats {
        let keys = "depth guard_linear guard_quadratic pixels decided_exactly";
        assert_keys(format, keys);
        assert_eq!(format["cases"], 300);
        for term in format["terms"].as_array().unwrap() {
            assert_keys(term, "term comparisons tightness mean observed bound");
        }
    }
    let again = json("bounds --cases 300 --seed 5");
    assert_eq!(trial, again, "not reproducible");
}

#[test]
fn headroom_of_scenes_is_a_table() {
    let scenes = "scenes/cone.toml scenes/ellipsoid.toml";
    let options = "--sizes 64x48,32x24 --formats 16,24";
    let rows = json(&format!("bounds {scenes} {options}"));
    let summary = rows["summary"].as_array().unwrap();
    assert_eq!(summary.len(), 4);
    let keys = "width depth_word silhouette_errors derived confirmed";
    assert_keys(&summary[0], keys);
    let rows = rows["scenes"].as_array().unwrap();
    assert_eq!(rows.len(), 8);
    for row in rows {
        assert_keys(row, keys);
        assert_keys(row, "scene depth_max_lsb depth_rms_lsb");
    }
    // Longer words need fewer guard bits: 16 bits more of f2.
    let derived = |row: usize| rows[row]["derived"].as_i64().unwrap();
    assert!((derived(0) - derived(1) - 16).abs() <= 1);
}
