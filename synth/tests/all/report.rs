use imogene_synth::{SeedResult, median};

fn runs(clocks: &[f64]) -> Vec<SeedResult> {
    let run = |(seed, &fmax_mhz): (usize, &f64)| SeedResult {
        seed,
        fmax_mhz,
        critical_path: None,
    };
    clocks.iter().enumerate().map(run).collect()
}

#[test]
fn the_median_is_a_clock_that_was_reached() {
    assert_eq!(median(&runs(&[])), None);
    assert_eq!(median(&runs(&[80.0])), Some(80.0));
    assert_eq!(median(&runs(&[90.0, 70.0, 80.0])), Some(80.0));
    assert_eq!(median(&runs(&[90.0, 70.0])), Some(70.0));
}
