use imogene_synth::Target;

#[test]
fn names_lead_back_to_targets() {
    for target in Target::ALL {
        assert_eq!(Target::from_name(target.name()).expect("a target"), target);
    }
}

#[test]
fn an_unknown_target_is_answered_with_the_names() {
    let error = Target::from_name("ice41").expect_err("no target");
    let message = error.to_string();
    assert!(message.contains("ice41"), "{message}");
    for name in Target::names() {
        assert!(message.contains(name), "{message}");
    }
}
