use imogene_studies::trade::run::quoted;

#[test]
fn words_of_a_command_line_survive_a_shell() {
    assert_eq!(quoted("scenes/teapot.toml"), "scenes/teapot.toml");
    assert_eq!(quoted("my scene.toml"), "'my scene.toml'");
    assert_eq!(quoted("it's"), "'it'\\''s'");
    assert_eq!(quoted(""), "''");
}
