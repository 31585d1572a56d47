//! The first help, in groups, and the examples of every command's own.

use super::Arguments;
use clap::CommandFactory;

/// Commands for one kind of work.
pub struct Group {
    /// Its heading in the first help.
    pub title: &'static str,
    /// Its commands.
    pub entries: &'static [Entry],
}

/// A command and lines that can be typed as they stand, with the repository as current folder.
pub struct Entry {
    /// The command.
    pub name: &'static str,
    /// Its examples; what follows a `#` is said to the reader.
    pub examples: &'static [&'static str],
}

const fn entry(name: &'static str, examples: &'static [&'static str]) -> Entry {
    Entry { name, examples }
}

/// Every command, in the order of the first help.
pub const GROUPS: &[Group] = &[
    Group {
        title: "Draw",
        entries: &[
            entry("demo", &["imogene demo --out out/demo"]),
            entry(
                "new",
                &[
                    "imogene new",
                    "imogene new mine.toml  # then: imogene render mine.toml",
                ],
            ),
            entry(
                "render",
                &[
                    "imogene render scenes/teapot.toml  # writes teapot.png",
                    "imogene render scenes/cone.toml --model rtl --size 160x120 -o cone.png  # by the hardware in simulation",
                    "imogene render scenes/animation/arm.toml --frames -o arm  # arm/animation.png",
                    "imogene render scenes/teapot.toml --view top --fit --samples 4 -o top.png  # another look, smooth",
                    "imogene render scenes/teapot.toml --depth depth.npy --ids ids.npy  # for NumPy",
                ],
            ),
        ],
    },
    Group {
        title: "Import",
        entries: &[
            entry(
                "import",
                &[
                    "imogene import scenes/molecules/helix.pdb --style ball-and-stick -o helix.toml",
                    "imogene import parts/fixture.step -o fixture.toml",
                    "imogene import scenes/terrain/hills.heights -o hills.toml",
                ],
            ),
            entry(
                "terrain",
                &[
                    "imogene terrain --levels 5 --seed 3 -o hills.heights  # then: imogene import hills.heights -o hills.toml",
                ],
            ),
        ],
    },
    Group {
        title: "Check a scene",
        entries: &[
            entry(
                "check",
                &[
                    "imogene check scenes/teapot.toml",
                    "imogene check scenes/teapot.toml --format 16 --guards 2:4",
                ],
            ),
            entry(
                "prepare",
                &["imogene prepare scenes/teapot.toml --size 320x240 --json"],
            ),
            entry(
                "detail",
                &["imogene detail scenes/shadows/robot.toml --size 320x240 --zone 64 --out detail"],
            ),
            entry(
                "raytrace",
                &["imogene raytrace scenes/teapot.toml --size 160x120 -o differences.png"],
            ),
            entry(
                "cracks",
                &["imogene cracks scenes/teapot.toml --size 320x240 -o cracks.png"],
            ),
            entry(
                "repair",
                &["imogene repair scenes/cone.toml --size 160x120 --format 16 -o cone.png"],
            ),
        ],
    },
    Group {
        title: "Hardware",
        entries: &[
            entry("units", &["imogene units", "imogene units --json"]),
            entry("processors", &["imogene processors"]),
            entry("contract", &["imogene contract square_root --format 16"]),
            entry(
                "emit",
                &[
                    "imogene emit square_root --out rtl_out",
                    "imogene emit beam --objects 2 --planes 3 --out rtl_out",
                ],
            ),
            entry("package", &["imogene package --clocks 0 --out cores"]),
            entry(
                "machine",
                &[
                    "imogene machine scenes/teapot.toml --machine machines/beam-640x480.toml --out vga",
                    "imogene machine scenes/teapot.toml --machine machines/beam-640x480.toml --emit-only --out vga",
                ],
            ),
            entry(
                "synth",
                &[
                    "imogene synth quadric_pe --target ecp5-45k  # scripts/setup --synth installs the tools",
                    "imogene synth --check cut_plane",
                ],
            ),
            entry(
                "peers",
                &["imogene peers --rtl root.v --top isqrt --against square_root --target ecp5-45k"],
            ),
        ],
    },
    Group {
        title: "Verify",
        entries: &[
            entry(
                "cosim",
                &[
                    "imogene cosim scenes/cone.toml --size 64x48 --vcd cone.vcd  # then: gtkwave cone.gtkw",
                    "imogene cosim quadric_processor --clocks 2000 --seed 7",
                    "imogene cosim cut_plane --engine icarus",
                    "imogene cosim extremes",
                ],
            ),
            entry(
                "prove",
                &["imogene prove pe1", "imogene prove pe1 --mutants"],
            ),
            entry("mutate", &["imogene mutate cut_plane"]),
            entry("speed", &["imogene speed pe1 --seconds 1"]),
        ],
    },
    Group {
        title: "Explore",
        entries: &[
            entry(
                "fit",
                &[
                    "imogene fit scenes/teapot.toml --size 320x240 --max-depth-error 0.5px --out fit",
                ],
            ),
            entry(
                "trade",
                &[
                    "imogene trade scenes/teapot.toml --size 320x240 --points quick --no-cost --out trade  # then open trade/index.html",
                ],
            ),
            entry(
                "bounds",
                &[
                    "imogene bounds --cases 1000",
                    "imogene bounds scenes/cone.toml --sizes 160x120,320x240",
                ],
            ),
            entry("sweep", &["imogene sweep word-length --out sweeps"]),
            entry("primitives", &["imogene primitives --out primitives"]),
            entry("roots", &["imogene roots --format 16"]),
            entry("shading", &["imogene shading --cases 10000"]),
            entry("evaluate", &["imogene evaluate --out evaluation"]),
        ],
    },
];

/// The command line with its groups and examples.
pub fn command() -> clap::Command {
    let mut command = Arguments::command();
    for entry in GROUPS.iter().flat_map(|group| group.entries) {
        let examples = format!("Examples:\n  {}", entry.examples.join("\n  "));
        command = command.mut_subcommand(entry.name, |c| c.after_help(examples));
    }
    let template = format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{}Options:\n{{options}}{{after-help}}",
        groups(&command)
    );
    command.help_template(template).after_help(
        "\nFirst steps: imogene new, then imogene render scene.toml.\nExamples of a command: imogene COMMAND --help.",
    )
}

/// The commands by groups, one line each.
fn groups(command: &clap::Command) -> String {
    let mut text = String::new();
    for group in GROUPS {
        text += &format!("{}:\n", group.title);
        for entry in group.entries {
            let found = command.find_subcommand(entry.name);
            let about = found.and_then(clap::Command::get_about);
            text += &format!("  {:<11} {}\n", entry.name, about.unwrap_or_default());
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn entries() -> impl Iterator<Item = &'static Entry> {
        GROUPS.iter().flat_map(|group| group.entries)
    }

    #[test]
    fn every_command_is_in_one_group() {
        let named: Vec<&str> = entries().map(|entry| entry.name).collect();
        let once: BTreeSet<&str> = named.iter().copied().collect();
        assert_eq!(once.len(), named.len(), "a command is in two groups");
        let command = Arguments::command();
        let all: BTreeSet<&str> = command.get_subcommands().map(|c| c.get_name()).collect();
        assert_eq!(once, all);
    }

    #[test]
    fn every_example_parses_and_stands_in_its_help() {
        for entry in entries() {
            assert!(!entry.examples.is_empty(), "{}", entry.name);
            let mut command = command();
            let own = command.find_subcommand_mut(entry.name).expect("a command");
            let help = own.render_help().to_string();
            for example in entry.examples {
                assert!(help.contains(example), "{example} is not in:\n{help}");
                let words = example.split(" #").next().unwrap_or_default();
                let parsed = super::command().try_get_matches_from(words.split_whitespace());
                let matches = parsed.unwrap_or_else(|error| panic!("{example}: {error}"));
                assert_eq!(matches.subcommand_name(), Some(entry.name), "{example}");
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
}
