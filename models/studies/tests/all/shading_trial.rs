use imogene_golden::machine::shader::ShaderWidths;
use imogene_studies::shading_trial::errors;

#[test]
fn no_level_is_off_by_more_than_one() {
    let errors = errors(&ShaderWidths::default(), 200_000, 1, |_| {});
    println!("{errors:?}");
    assert_eq!(errors.beyond, 0, "{errors:?}");
    assert!(errors.differing > 0 && errors.error < 1.0);
}
