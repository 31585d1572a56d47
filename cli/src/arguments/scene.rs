//! A scene as an argument, how it is looked at, and the commands that draw, prepare and check one.

use super::parse::{self, Choices, FrameRange, choice, depth_word, option};
use clap::{Args, ValueEnum};
use imogene_contract::MachineWords;
use imogene_golden::format::{FittedError, Format};
use imogene_golden::widths;
use imogene_plan::split::Division;
use imogene_scene::{Look, Side};
use serde::Serialize;
use std::path::PathBuf;

/// Which model draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Model {
    /// The exact reference in big integers.
    Exact,
    /// The golden integer model.
    Golden,
    /// The hardware in simulation.
    Rtl,
}

/// A scene, its size and the format it is prepared for.
#[derive(Clone, Debug, Args)]
pub struct Scene {
    /// Scene file (TOML).
    pub scene: PathBuf,
    /// Picture size in pixels; the scene's own if not given.
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<Size>,
    /// Depth word in bits, 8 to 32.
    #[arg(long, default_value_t = 24, value_name = "W", value_parser = depth_word)]
    pub format: u32,
    /// Words that do not follow from it.
    #[command(flatten)]
    pub words: SceneWords,
    /// How it is looked at.
    #[command(flatten)]
    pub view: View,
}

impl Scene {
    /// The format that is asked for.
    pub fn format(&self) -> Result<Format, FittedError> {
        self.words.format(self.format)
    }
}

/// Words of a scene's machine that do not follow from its depth word.
#[derive(Clone, Debug, Args)]
pub struct SceneWords {
    /// Guard bits of f1 and f2 below their last bits, 0 to 16 each.
    #[arg(long, default_value = "0:0", value_name = "G1:G2", value_parser = guards)]
    pub guards: (u32, u32),
    /// Every width of a machine that is fitted to a scene, instead of --format and --guards:
    /// depth=20,root=18,plane=30,normal=16,g1=2,g2=4,dropped=0; what is left out follows from the depth.
    #[arg(long, value_name = "LIST", value_parser = widths::parse, conflicts_with_all = ["format", "guards"])]
    pub widths: Option<MachineWords>,
}

impl SceneWords {
    /// The format with a depth word that holds where no widths are given.
    pub fn format(&self, depth: u32) -> Result<Format, FittedError> {
        if let Some(widths) = self.widths {
            return Format::fitted(&widths);
        }
        let (guard_linear, guard_quadratic) = self.guards;
        Format::fitted(&MachineWords {
            guard_linear,
            guard_quadratic,
            ..MachineWords::of(depth)
        })
    }

    /// As on the command line, with a blank before each option.
    pub fn options(&self, depth: u32) -> String {
        if let Some(widths) = self.widths {
            return format!(" --widths {}", widths::print(&widths));
        }
        match self.guards {
            (0, 0) => format!(" --format {depth}"),
            (linear, quadratic) => format!(" --format {depth} --guards {linear}:{quadratic}"),
        }
    }
}

/// What of a scene is looked at, and from where.
#[derive(Clone, Debug, Default, Args)]
pub struct View {
    /// Look through the camera of this name instead of the active one.
    #[arg(long, value_name = "NAME")]
    pub camera: Option<String>,
    /// One frame of the scene's animation, counted from 1, instead of the scene as it is written.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub frame: Option<u32>,
}

impl View {
    /// As on the command line, with a blank before each option; nothing for the scene as it is written.
    pub fn options(&self) -> String {
        let camera = self.camera.as_ref().map(|name| format!("'{name}'"));
        option("camera", camera) + &option("frame", self.frame)
    }
}

/// Arguments of `new`.
#[derive(Debug, Args)]
pub struct New {
    /// Scene file to write; a file that is there is never overwritten.
    #[arg(default_value = "scene.toml", value_name = "FILE.toml")]
    pub file: PathBuf,
}

/// Arguments of `render`.
#[derive(Debug, Args)]
pub struct Render {
    /// Scene.
    #[command(flatten)]
    pub scene: Scene,
    /// Another look at it.
    #[command(flatten)]
    pub look: LookOptions,
    /// Smooth the picture as the machine's accumulator does: the mean of so many pictures, 4 or 16, that sample other
    /// places of each pixel. Depth words, indices and normals stay those of the plain picture.
    #[arg(long, value_name = "COUNT", value_parser = samples, conflicts_with_all = ["zone", "split", "frames"])]
    pub samples: Option<u32>,
    /// Round the coefficients anew for each zone of so many columns and lines, 8 or more (model golden).
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(8..=4096))]
    pub zone: Option<u32>,
    /// Workers of a divided screen.
    #[command(flatten)]
    pub split: Split,
    /// Which model draws.
    #[arg(long, value_enum, default_value_t = Model::Golden)]
    pub model: Model,
    /// Picture file (PNG); with --frames the folder of the pictures [default: named after the scene, in the current
    /// folder].
    #[arg(short = 'o', long = "output", value_name = "FILE.png")]
    pub output: Option<PathBuf>,
    /// Draw the frames of the scene's animation, all or those from FIRST to LAST, counted from 1: frame-0001.png and
    /// so on, animation.png and frames.json in the folder of --output.
    #[arg(long, value_name = "FIRST..LAST", num_args = 0..=1, default_missing_value = "",
          conflicts_with_all = ["zone", "depth", "ids", "normals", "frame", "side", "rotate", "fit", "zoom"])]
    pub frames: Option<FrameRange>,
    /// Depth words as a NumPy array (int64, background = 2^(W-1) - 1).
    #[arg(long, value_name = "FILE.npy")]
    pub depth: Option<PathBuf>,
    /// Object indices as a NumPy array (int32, background = -1).
    #[arg(long, value_name = "FILE.npy")]
    pub ids: Option<PathBuf>,
    /// Normals as a NumPy array (int16, three components).
    #[arg(long, value_name = "FILE.npy")]
    pub normals: Option<PathBuf>,
    /// Rows of the root network per register stage (model rtl).
    #[arg(long, default_value_t = 1, value_name = "R")]
    pub rows_per_stage: usize,
}

/// Arguments of a divided picture.
#[derive(Clone, Copy, Debug, Args)]
pub struct Split {
    /// Divide the screen among workers that know nothing of each other: zones:WxH, or lines:N for N groups of
    /// interleaved lines (model golden).
    #[arg(long, value_name = "zones:WxH|lines:N", conflicts_with = "zone")]
    pub split: Option<Division>,
    /// Workers of a divided screen, 1 to 1024; worker i of N has the pieces i, i + N, i + 2 N, .. [default: one for
    /// each core].
    #[arg(long, value_name = "N", requires = "split", value_parser = clap::value_parser!(u16).range(1..=1_024))]
    pub workers: Option<u16>,
}

impl Render {
    /// The picture file, or the folder of the frames: what was asked for, or the scene's name without its ending.
    pub fn output(&self) -> PathBuf {
        self.output.clone().unwrap_or_else(|| {
            let scene = &self.scene.scene;
            let mut name = scene.file_stem().unwrap_or(scene.as_os_str()).to_owned();
            if self.frames.is_none() {
                name.push(".png");
            }
            PathBuf::from(name)
        })
    }
}

fn samples(text: &str) -> Result<u32, String> {
    let expected = "4 or 16 samples of each pixel are possible";
    parse::value(text, |count| [4, 16].contains(count), expected)
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub struct Check {
    /// Scene.
    #[command(flatten)]
    pub scene: Scene,
    /// Where rounding could change the picture: a picture of the scene's size (.png), or its marks (.npy, uint8, 0
    /// where all is decided).
    #[arg(long, value_name = "FILE")]
    pub map: Option<PathBuf>,
}

/// Arguments of `detail`.
#[derive(Debug, Args)]
pub struct Detail {
    /// Scene.
    #[command(flatten)]
    pub scene: Scene,
    /// Side of the square zones in pixels, 8 or more.
    #[arg(long, default_value_t = 64, value_name = "N", value_parser = clap::value_parser!(u32).range(8..=4095))]
    pub zone: u32,
    /// Leave out objects at fewer than P pixels, and planes of an object as long as at most P of its pixels change;
    /// with 0 no pixel changes.
    #[arg(long, default_value_t = 0, value_name = "P", value_parser = clap::value_parser!(u64).range(0..=1_000_000))]
    pub pixels: u64,
    /// Folder of the pictures: the scene with what is left of it, and maps of its zones.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Arguments of `primitives`.
#[derive(Debug, Args)]
pub struct Primitives {
    /// Folder for comparison.png, comparison.json and comparison.md; nothing is written without it.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Picture size in pixels.
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "320x240")]
    pub size: Size,
}

/// A picture size: pixels per line, and lines.
pub type Size = (u32, u32);

/// A picture size as written on the command line.
pub(super) fn size(text: &str) -> Result<Size, String> {
    let size = parse::pair(text, 'x');
    size.ok_or_else(|| "expected WIDTHxHEIGHT in pixels, such as 320x240".to_string())
}

fn guards(text: &str) -> Result<(u32, u32), String> {
    let guards = parse::pair(text, ':');
    guards.ok_or_else(|| "expected G1:G2, two numbers of bits, such as 2:4".to_string())
}

/// Options of another look at a scene.
#[derive(Clone, Debug, Default, Args)]
pub struct LookOptions {
    /// Look from this side: the eye goes there about the target, as far away as it is.
    #[arg(long = "view", value_parser = choice(SIDES), value_name = "SIDE")]
    side: Option<Side>,
    /// Turn what is seen, by degrees about the picture's directions to the right, upwards and, if a third angle is
    /// given, towards the viewer, in this order.
    #[arg(long, value_name = "AX,AY[,AZ]", value_parser = angles, allow_hyphen_values = true)]
    rotate: Option<[f64; 3]>,
    /// Move the eye, without turning it, until all visible objects fill the picture up to 4 %.
    #[arg(long)]
    fit: bool,
    /// Show everything so many times larger.
    #[arg(long, value_name = "FACTOR", value_parser = factor)]
    zoom: Option<f64>,
}

/// Sides; which axis is up is taken from the camera's `up`.
#[rustfmt::skip]
const SIDES: Choices<Side> = &[
    (Side::Front, "front", "From +z where y is up, from -y where z is up"),
    (Side::Back, "back", "From behind"),
    (Side::Left, "left", "From the left of the front"),
    (Side::Right, "right", "From the right of the front"),
    (Side::Top, "top", "From above, the front at the bottom of the picture"),
    (Side::Bottom, "bottom", "From below, the front at the top of the picture"),
    (Side::Iso, "iso", "From the front, the right and above, at equal angles"),
];

impl LookOptions {
    /// What is asked for; nothing for the scene as it is. `lights` says whether they turn with the camera.
    pub fn look(&self, lights: bool) -> Option<Look> {
        let look = Look {
            side: self.side,
            turn: self.rotate,
            fit: self.fit,
            zoom: self.zoom,
            lights: false,
        };
        (look != Look::default()).then_some(Look { lights, ..look })
    }
}

fn angles(text: &str) -> Result<[f64; 3], String> {
    let angles = match parse::list::<f64>(text).as_deref() {
        Some(&[x, y]) => [x, y, 0.0],
        Some(&[x, y, z]) => [x, y, z],
        _ => return Err("two or three angles in degrees such as 20,-35 are expected".to_owned()),
    };
    match angles.iter().all(|v| v.abs() <= 1e6) {
        true => Ok(angles),
        false => Err("angles up to 1000000 degrees are accepted".to_owned()),
    }
}

fn factor(text: &str) -> Result<f64, String> {
    let expected = "a factor from 0.001 to 1000 is expected";
    parse::value(text, |value| (1e-3..=1e3).contains(value), expected)
}
