use clap::CommandFactory;
use imogene::arguments::Arguments;
use imogene::help::{GROUPS, Group, command};
use std::collections::BTreeSet;

#[test]
fn every_command_is_in_one_group() {
    let commands = GROUPS.iter().flat_map(Group::commands);
    let named: Vec<&str> = commands.map(|(name, _)| name).collect();
    let once: BTreeSet<&str> = named.iter().copied().collect();
    assert_eq!(once.len(), named.len(), "a command is in two groups");
    let command = Arguments::command();
    let all: BTreeSet<&str> = command.get_subcommands().map(|c| c.get_name()).collect();
    assert_eq!(once, all);
}

#[test]
fn every_example_parses_and_stands_in_its_help() {
    for (name, examples) in GROUPS.iter().flat_map(Group::commands) {
        let mut command = command();
        let own = command.find_subcommand_mut(name).expect("a command");
        let help = own.render_help().to_string();
        for example in examples {
            assert!(help.contains(example), "{example} is not in:\n{help}");
            let words = example.split(" #").next().unwrap_or_default();
            let parsed = imogene::help::command().try_get_matches_from(words.split_whitespace());
            let matches = parsed.unwrap_or_else(|error| panic!("{example}: {error}"));
            assert_eq!(matches.subcommand_name(), Some(name), "{example}");
        }
    }
}

#[test]
fn old_names_are_understood_and_not_listed() {
    let help = command().render_help().to_string();
    for (old, new) in [("trace", "raytrace"), ("compare", "primitives")] {
        let line = ["imogene", old, "scenes/cone.toml"];
        let words = &line[..if old == "trace" { 3 } else { 2 }];
        let matches = command().try_get_matches_from(words).expect(old);
        assert_eq!(matches.subcommand_name(), Some(new));
        assert!(!help.contains(&format!("\n  {old} ")), "{help}");
    }
}
