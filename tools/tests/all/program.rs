use imogene_tools::{COMPILER, Program};
use std::path::Path;

#[test]
fn a_missing_program_names_its_package() {
    let program = Program::new("imogene-no-such-program", "some-package");
    let outcome = program.run(["--version"], Path::new("."));
    let message = outcome.expect_err("there is no such program").to_string();
    assert!(message.contains("imogene-no-such-program"), "{message}");
    assert!(message.contains("package 'some-package'"), "{message}");
}

#[test]
fn a_refusal_has_the_words_of_the_program() {
    let outcome = COMPILER.run(["no-such-file.cpp"], Path::new("."));
    let message = outcome.expect_err("there is no such file").to_string();
    assert!(message.contains("no-such-file.cpp"), "{message}");
}
