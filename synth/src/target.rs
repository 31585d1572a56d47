//! The targets: a device, its synthesis command and its place and route command.

use imogene_contract::RootForm;
use thiserror::Error;

/// What a unit is synthesised for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// Lattice iCE40 HX8K.
    Ice40Hx8k,
    /// Lattice iCE40 UltraPlus 5K.
    Ice40Up5k,
    /// Lattice ECP5, 45k cells, speed grade 6.
    Ecp5With45k,
    /// Lattice ECP5, 85k cells, speed grade 6.
    Ecp5With85k,
    /// Xilinx 7 series; resources only.
    Xilinx7,
    /// Gowin GW1N and GW2A; resources only.
    Gowin,
    /// Static CMOS gates; transistors only.
    Transistors,
}

/// Architecture of a device, which names its cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Lattice iCE40.
    Ice40,
    /// Lattice ECP5.
    Ecp5,
    /// Xilinx 7 series.
    Xilinx7,
    /// Gowin GW1N and GW2A.
    Gowin,
    /// Static CMOS gates.
    Gates,
}

/// No target has this name.
#[derive(Debug, Error)]
#[error("there is no target `{}`; the targets are {}", .0, Target::names().join(", "))]
pub struct UnknownTarget(pub String);

/// How a device is placed and routed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PlaceAndRoute {
    /// Device, package and pins.
    pub arguments: &'static [&'static str],
    /// Clock asked for in MHz: out of reach, so that the tool never stops improving early.
    pub goal_mhz: u32,
    /// Name of a logic cell in the utilisation.
    pub logic_cell: &'static str,
}

/// The placer gives paths three times their usual weight: units reach 2.5 % more.
pub const TIMING_WEIGHT: [&str; 2] = ["--placer-heap-timingweight", "30"];

const ECP5_45K: [&str; 8] = ecp5("--45k");
const ECP5_85K: [&str; 8] = ecp5("--85k");

/// Device, package and pins of an ECP5.
const fn ecp5(device: &'static str) -> [&'static str; 8] {
    let ([weight, most], pins) = (TIMING_WEIGHT, "--lpf-allow-unconstrained");
    [
        device,
        "--package",
        "CABGA381",
        "--speed",
        "6",
        pins,
        weight,
        most,
    ]
}

impl Target {
    /// All targets.
    pub const ALL: [Self; 7] = [
        Self::Ice40Hx8k,
        Self::Ice40Up5k,
        Self::Ecp5With45k,
        Self::Ecp5With85k,
        Self::Xilinx7,
        Self::Gowin,
        Self::Transistors,
    ];

    /// Name on the command line, architecture, and the commands that synthesise the module `{top}`.
    const fn row(self) -> (&'static str, Family, &'static str) {
        // Wide look-up tables take a fifth more cells of ECP5 and give no more clock (docs/synthesis.md).
        const ECP5: &str = "synth_ecp5 -nowidelut -top {top}";
        // Products by Booth's recoding take three tables of four (docs/synthesis.md).
        const HX8K: &str = "hierarchy -top {top}; proc; booth; synth_ice40 -top {top}";
        match self {
            Self::Ice40Hx8k => ("ice40-hx8k", Family::Ice40, HX8K),
            Self::Ice40Up5k => (
                "ice40-up5k",
                Family::Ice40,
                "synth_ice40 -device u -dsp -top {top}",
            ),
            Self::Ecp5With45k => ("ecp5-45k", Family::Ecp5, ECP5),
            Self::Ecp5With85k => ("ecp5-85k", Family::Ecp5, ECP5),
            Self::Xilinx7 => (
                "xilinx7",
                Family::Xilinx7,
                "synth_xilinx -family xc7 -flatten -noiopad -top {top}",
            ),
            Self::Gowin => ("gowin", Family::Gowin, "synth_gowin -noiopads -top {top}"),
            // Enables become gates, for a plain flip-flop is the only one whose transistors are known; an `opt` after
            // dfflegalize would take them back.
            Self::Transistors => (
                "transistors",
                Family::Gates,
                "synth -flatten -top {top}; dfflegalize -cell $_DFF_P_ 01; techmap; abc -g cmos; opt_clean",
            ),
        }
    }

    /// Name on the command line.
    pub const fn name(self) -> &'static str {
        self.row().0
    }

    /// The names of all targets.
    pub fn names() -> Vec<&'static str> {
        Self::ALL.iter().map(|target| target.name()).collect()
    }

    /// The target of a name. Fails when there is none; the error lists the names.
    pub fn from_name(name: &str) -> Result<Self, UnknownTarget> {
        let found = Self::ALL.into_iter().find(|target| target.name() == name);
        found.ok_or_else(|| UnknownTarget(name.to_owned()))
    }

    /// The exact root of fewer cells. On an ECP5 a row of the non-restoring one is a sum and nothing else; elsewhere
    /// both are as large, and restoring rows need no register for a sign.
    pub const fn exact_root(self) -> RootForm {
        match self.family() {
            Family::Ecp5 => RootForm::NonRestoring,
            _ => RootForm::Restoring,
        }
    }

    /// Architecture of its device.
    pub const fn family(self) -> Family {
        self.row().1
    }

    /// Commands that synthesise the module `top` and leave only cells of the target.
    pub(crate) fn synthesis(self, top: &str) -> String {
        self.row().2.replace("{top}", top)
    }

    /// The same for a part of a machine, alone: in look-up tables of four inputs alone. Where nothing is around a
    /// module, all of its paths are critical, and Yosys would build them of wide look-up tables that it does not take
    /// within a machine.
    pub(crate) fn synthesis_of_part(self, top: &str) -> String {
        match self {
            Self::Xilinx7 | Self::Gowin => self.synthesis(top) + " -nowidelut",
            _ => self.synthesis(top),
        }
    }

    /// Options of the Yosys command `stat`.
    pub(crate) const fn statistics(self) -> &'static str {
        match self {
            Self::Transistors => "stat -tech cmos -json",
            _ => "stat -json",
        }
    }

    /// How the target is placed and routed; none where only resources are reported.
    pub(crate) const fn place_and_route(self) -> Option<PlaceAndRoute> {
        let (arguments, goal_mhz): (&[&str], u32) = match self {
            Self::Ice40Hx8k => (
                &[
                    "--hx8k",
                    "--package",
                    "ct256",
                    "--pcf-allow-unconstrained",
                    // Moves cells once more behind the placer: products reach 6 % more.
                    "--opt-timing",
                ],
                300,
            ),
            Self::Ice40Up5k => (
                &["--up5k", "--package", "sg48", "--pcf-allow-unconstrained"],
                100,
            ),
            Self::Ecp5With45k => (&ECP5_45K, 300),
            Self::Ecp5With85k => (&ECP5_85K, 300),
            Self::Xilinx7 | Self::Gowin | Self::Transistors => return None,
        };
        let logic_cell = match self.family() {
            Family::Ice40 => "ICESTORM_LC",
            _ => "TRELLIS_COMB",
        };
        Some(PlaceAndRoute {
            arguments,
            goal_mhz,
            logic_cell,
        })
    }
}
