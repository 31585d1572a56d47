use imogene_golden::machine::shader::curves::Curve;

#[test]
fn a_curve_stays_near_its_function() {
    let curve = Curve::new(|t| (1.0 + t).log2(), 5, 1.0 / 32.0, 15, 21);
    for argument in 0..1u64 << 20 {
        let exact = (1.0 + argument as f64 / (1u64 << 20) as f64).log2();
        let error = curve.value(argument) as f64 - exact * (1u64 << 21) as f64;
        assert!(error.abs() < 3.0, "{argument}: {error}");
    }
}
