use imogene_verif::formal::bind::resolve;

const DESIGN: &str =
    "\nmodule a (\n    input q\n);\nendmodule\n\nmodule b (\n    input q\n);\nendmodule\n";

#[test]
fn the_instance_goes_into_its_module() {
    let properties =
        "module p (input q);\nendmodule\n\nbind a p #(.N(1)) checks (\n    .q(q)\n);\n";
    let text = resolve("job", DESIGN, properties).unwrap();
    let first = &text[..text.find("module b").unwrap()];
    let instance = "p #(.N(1)) checks (\n    .q(q)\n);\n\nendmodule";
    assert!(first.contains(instance), "{text}");
    assert!(!text.contains("bind") && text.contains("module p (input q);"));
}

#[test]
fn a_module_that_is_missing_or_there_twice_is_refused() {
    let properties = "bind c p checks (\n);\n";
    let error = resolve("job", DESIGN, properties).unwrap_err().to_string();
    assert!(error.contains("`c`") && error.contains("job"), "{error}");
    let twice = DESIGN.repeat(2);
    assert!(resolve("job", &twice, "bind a p checks (\n);\n").is_err());
}
