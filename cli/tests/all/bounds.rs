//! `imogene check` and `bounds`: guard bits, random cases, headroom.

use crate::common::{assert_keys, json, scene};

#[test]
fn guard_bits_sharpen_the_bounds_of_a_check() {
    let cone = scene("cone.toml");
    let depth = |guards: &str| {
        let report = json(&[
            "check",
            cone.to_str().unwrap(),
            "--size",
            "96x72",
            "--guards",
            guards,
        ]);
        report["objects"][0]["bounds"]["f2"].as_f64().unwrap()
    };
    assert!(depth("2:4") < depth("0:0") / 4.0);
}

#[test]
fn bounds_hold_on_random_cases() {
    let trial = json(&["bounds", "--cases", "300", "--seed", "5"]);
    assert_eq!(
        (&trial["violations"], &trial["cases"]),
        (&0.into(), &300.into())
    );
    let formats = trial["formats"].as_array().unwrap();
    assert!(formats.len() >= 8);
    for format in formats {
        assert_keys(
            format,
            &[
                "depth",
                "guard_linear",
                "guard_quadratic",
                "pixels",
                "decided_exactly",
            ],
        );
        assert_eq!(format["cases"], 300);
        for term in format["terms"].as_array().unwrap() {
            assert_keys(
                term,
                &[
                    "term",
                    "comparisons",
                    "tightness",
                    "mean",
                    "observed",
                    "bound",
                ],
            );
        }
    }
    assert_eq!(
        trial,
        json(&["bounds", "--cases", "300", "--seed", "5"]),
        "not reproducible"
    );
}

#[test]
fn headroom_of_scenes_is_a_table() {
    let (cone, ellipsoid) = (scene("cone.toml"), scene("ellipsoid.toml"));
    let rows = json(&[
        "bounds",
        cone.to_str().unwrap(),
        ellipsoid.to_str().unwrap(),
        "--sizes",
        "64x48,32x24",
        "--formats",
        "16,24",
    ]);
    let summary = rows["summary"].as_array().unwrap();
    assert_eq!(summary.len(), 4);
    assert_keys(
        &summary[0],
        &[
            "width",
            "depth_word",
            "silhouette_errors",
            "derived",
            "confirmed",
        ],
    );
    let rows = rows["scenes"].as_array().unwrap();
    assert_eq!(rows.len(), 8);
    for row in rows {
        assert_keys(
            row,
            &[
                "scene",
                "width",
                "depth_word",
                "silhouette_errors",
                "derived",
                "confirmed",
                "depth_max_lsb",
                "depth_rms_lsb",
            ],
        );
    }
    // Longer words need fewer guard bits: 16 bits more of f2.
    let derived = |row: usize| rows[row]["derived"].as_i64().unwrap();
    assert!((derived(0) - derived(1) - 16).abs() <= 1);
}
