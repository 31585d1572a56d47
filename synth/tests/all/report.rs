use imogene_synth::{SeedResult, median};

fn runs(clocks: &[f64]) -> Vec<SeedResult> {
    let numbered = clocks.iter().enumerate();
    numbered
        .map(|(seed, &fmax_mhz)| SeedResult {
            seed,
            fmax_mhz,
            critical_path: None,
        })
        .collect()
}

#[test]
fn the_median_is_a_clock_that_was_reached() {
    assert_eq!(median(&runs(&[])), None);
    assert_eq!(median(&runs(&[80.0])), Some(80.0));
    assert_eq!(median(&runs(&[90.0, 70.0, 80.0])), Some(80.0));
    assert_eq!(median(&runs(&[90.0, 70.0])), Some(70.0));
}
