//! The first help, in groups, and the examples of every command's own.

use crate::arguments::Arguments;
use clap::CommandFactory;

/// Commands for one kind of work.
pub struct Group {
    /// Its heading in the first help.
    pub title: &'static str,
    /// Lines that can be typed as they stand, with the repository as current folder, those of a command together; what
    /// follows a `#` is said to the reader.
    pub examples: &'static [&'static str],
}

impl Group {
    /// The commands, each with its examples.
    pub fn commands(&self) -> impl Iterator<Item = (&'static str, &'static [&'static str])> {
        let name = |line: &'static str| line.split(' ').nth(1).unwrap_or_default();
        let commands = self.examples.chunk_by(move |a, b| name(a) == name(b));
        commands.map(move |examples| (name(examples[0]), examples))
    }
}

/// Every command, in the order of the first help.
pub const GROUPS: &[Group] = &[
    Group {
        title: "Draw",
        examples: &[
            "imogene demo --out out/demo",
            "imogene new",
            "imogene new mine.toml  # then: imogene render mine.toml",
            "imogene render scenes/teapot.toml  # writes teapot.png",
            "imogene render scenes/cone.toml --model rtl --size 160x120 -o cone.png  # by the hardware in simulation",
            "imogene render scenes/animation/arm.toml --frames -o arm  # arm/animation.png",
            "imogene render scenes/teapot.toml --view top --fit --samples 4 -o top.png  # another look, smooth",
            "imogene render scenes/teapot.toml --depth depth.npy --ids ids.npy  # for NumPy",
        ],
    },
    Group {
        title: "Import",
        examples: &[
            "imogene import scenes/molecules/helix.pdb --style ball-and-stick -o helix.toml",
            "imogene import parts/fixture.step -o fixture.toml",
            "imogene import scenes/terrain/hills.heights -o hills.toml",
            "imogene terrain --levels 5 --seed 3 -o hills.heights  # then: imogene import hills.heights -o hills.toml",
        ],
    },
    Group {
        title: "Check a scene",
        examples: &[
            "imogene check scenes/teapot.toml",
            "imogene check scenes/teapot.toml --format 16 --guards 2:4",
            "imogene prepare scenes/teapot.toml --size 320x240 --json",
            "imogene detail scenes/shadows/robot.toml --size 320x240 --zone 64 --out detail",
            "imogene raytrace scenes/teapot.toml --size 160x120 -o differences.png",
            "imogene cracks scenes/teapot.toml --size 320x240 -o cracks.png",
            "imogene repair scenes/cone.toml --size 160x120 --format 16 -o cone.png",
        ],
    },
    Group {
        title: "Hardware",
        examples: &[
            "imogene units",
            "imogene units --json",
            "imogene processors",
            "imogene contract square_root --format 16",
            "imogene emit square_root --out rtl_out",
            "imogene emit beam --objects 2 --planes 3 --out rtl_out",
            "imogene package --clocks 0 --out cores",
            "imogene machine scenes/teapot.toml --machine machines/beam-640x480.toml --out vga",
            "imogene machine scenes/teapot.toml --machine machines/beam-640x480.toml --emit-only --out vga",
            "imogene machine scenes/teapot.toml --machine machines/beam-160x120.toml --out vga --vcd vga.fst --vcd-from line:60",
            "imogene board ulx3s-85 scenes/teapot.toml --out board",
            "imogene board simulation scenes/cone.toml --mode 160x120 --out board",
            "imogene synth quadric_pe --target ecp5-45k  # scripts/setup --synth installs the tools",
            "imogene synth --check cut_plane",
            "imogene peers --rtl root.v --top isqrt --against square_root --target ecp5-45k",
        ],
    },
    Group {
        title: "Verify",
        examples: &[
            "imogene cosim scenes/cone.toml --size 64x48 --vcd cone.vcd  # then: gtkwave cone.gtkw",
            "imogene cosim scenes/cone.toml --size 64x48 --vcd cone.fst --vcd-from line:20 --vcd-nets processors_0.quadric",
            "imogene cosim quadric_processor --clocks 2000 --seed 7",
            "imogene cosim cut_plane --engine icarus",
            "imogene cosim extremes",
            "imogene prove pe1",
            "imogene prove pe1 --mutants",
            "imogene mutate cut_plane",
            "imogene mutate scenes/shadows/ball-before-ball.toml --machine machines/beam-48x32.toml --stimuli 2",
            "imogene speed pe1 --seconds 1",
        ],
    },
    Group {
        title: "Explore",
        examples: &[
            "imogene fit scenes/teapot.toml --size 320x240 --max-depth-error 0.5px --out fit",
            "imogene trade scenes/teapot.toml --size 320x240 --points quick --no-cost --out trade  # then open trade/index.html",
            "imogene bounds --cases 1000",
            "imogene bounds scenes/cone.toml --sizes 160x120,320x240",
            "imogene sweep word-length --out sweeps",
            "imogene primitives --out primitives",
            "imogene roots --format 16",
            "imogene shading --cases 10000",
            "imogene evaluate --out evaluation",
        ],
    },
];

/// The command line with its groups and examples.
pub fn command() -> clap::Command {
    let mut command = Arguments::command();
    for (name, examples) in GROUPS.iter().flat_map(Group::commands) {
        let examples = format!("Examples:\n  {}", examples.join("\n  "));
        command = command.mut_subcommand(name, |c| c.after_help(examples));
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
        for (name, _) in group.commands() {
            let found = command.find_subcommand(name);
            let about = found.and_then(clap::Command::get_about);
            text += &format!("  {name:<11} {}\n", about.unwrap_or_default());
        }
        text.push('\n');
    }
    text
}
