//! Arguments of the commands about units: what they are, their Verilog, contracts and packages.

use super::parse::depth_word;
use clap::{Arg, ArgGroup, ArgMatches, Args, Command, FromArgMatches, value_parser};
use imogene_contract::parameters::{PARAMETERS, Parameter};
use imogene_contract::slots::{self, FittedSlot};
use imogene_contract::{MachineWords, Request, RequestError, RootForm};
use imogene_golden::widths;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

/// Arguments of `processors`.
#[derive(Debug, Args)]
pub struct Processors {
    /// Write the list as a page (Markdown) to this file.
    #[arg(long, value_name = "FILE.md")]
    pub out: Option<PathBuf>,
}

/// Arguments of `roots`.
#[derive(Debug, Args)]
pub struct Roots {
    /// Depth word in bits, that is the root's, 8 to 32.
    #[arg(long, default_value_t = 24, value_name = "W", value_parser = depth_word)]
    pub format: u32,
}

/// Arguments of `demo`.
#[derive(Debug, Args)]
pub struct Demo {
    /// Output folder.
    #[arg(long, default_value = "out/demo")]
    pub out: PathBuf,
}

/// Format and parameters of a unit or machine.
#[derive(Clone, Debug, Args)]
pub struct Shape {
    /// Depth word in bits, 8 to 32.
    #[arg(long, default_value_t = 24, value_name = "W", value_parser = depth_word)]
    pub format: u32,
    /// All others.
    #[command(flatten)]
    pub others: Parameters,
}

impl Shape {
    /// The unit of this name with these parameters.
    pub fn request(&self, unit: &str) -> Result<Request, RequestError> {
        self.others.request(unit, self.format)
    }

    /// Rows of the root networks of a machine between registers.
    pub fn rows_per_stage(&self) -> usize {
        let mut values = self.others.values.iter();
        let given = values.find(|(option, _)| *option == "rows-per-stage");
        given.and_then(|(_, value)| *value).unwrap_or(1) as usize
    }
}

/// Parameters of a unit or machine beside its depth word.
#[derive(Clone, Debug)]
pub struct Parameters {
    /// Form of the root.
    pub root_form: RootForm,
    /// The values that were given, by option.
    values: Vec<(&'static str, Option<u32>)>,
}

impl Parameters {
    /// The unit of this name with these parameters and a depth word.
    pub fn request(&self, unit: &str, format: u32) -> Result<Request, RequestError> {
        Request::given(unit, format, &self.values)?.with_root_form(self.root_form)
    }
}

impl fmt::Display for Parameters {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.root_form.is_usual() {
            write!(f, " --root-form {}", self.root_form)?;
        }
        let given = self.values.iter();
        let mut given = given.filter_map(|(option, value)| Some((option, (*value)?)));
        given.try_for_each(|(option, value)| write!(f, " --{option} {value}"))
    }
}

impl FromArgMatches for Parameters {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Parameters, clap::Error> {
        let value = |parameter: &Parameter| {
            let value = matches.get_one(parameter.option).copied();
            (parameter.option, value)
        };
        Ok(Parameters {
            root_form: matches.get_one("root-form").copied().unwrap_or_default(),
            values: PARAMETERS.iter().map(value).collect(),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Parameters::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The options are those of the parameters that units have.
impl Args for Parameters {
    fn augment_args(command: Command) -> Command {
        let form = Arg::new("root-form")
            .long("root-form")
            .help("How quadric_pe, beam, quadric_volume and the processors of quadrics take their root: restoring, non-restoring, linear0 to linear2, quadratic0 to quadratic2, leading8 [default: restoring]")
            .value_name("FORM")
            .value_parser(RootForm::from_str);
        let option = |parameter: &Parameter| {
            Arg::new(parameter.option)
                .long(parameter.option)
                .help(parameter.meaning)
                .value_name(parameter.symbol)
                .value_parser(value_parser!(u32))
        };
        let options = PARAMETERS.iter().map(|parameter| parameter.option);
        let group = ArgGroup::new("parameters").multiple(true);
        command
            .arg(form)
            .args(PARAMETERS.iter().map(option))
            .group(group.arg("root-form").args(options))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Parameters::augment_args(command)
    }
}

/// Arguments of `emit`.
#[derive(Debug, Args)]
pub struct Emit {
    /// Unit, as listed by `imogene units`.
    #[arg(required_unless_present = "machine")]
    pub unit: Option<String>,
    /// Whole machine in the place of a unit, as those in machines/; with a scene `imogene machine` writes it, with what
    /// it is loaded with.
    #[arg(long, value_name = "FILE.toml", conflicts_with_all = ["unit", "widths", "format", "parameters"])]
    pub machine: Option<PathBuf>,
    /// Parameters.
    #[command(flatten)]
    pub shape: Shape,
    /// Output folder.
    #[arg(long)]
    pub out: PathBuf,
    /// One file for each module, and UNIT.f that lists them, instead of the one file UNIT.v.
    #[arg(long)]
    pub split: bool,
    /// Put NAME before the names of all modules and files, so that several configurations of a unit fit in one design.
    #[arg(long, value_name = "NAME")]
    pub prefix: Option<String>,
    /// Widths and slots instead.
    #[command(flatten)]
    pub fitted: Fitted,
}

/// A beam machine that is fitted to a scene.
#[derive(Debug, Args)]
pub struct Fitted {
    /// Widths of a machine that is fitted to a scene, instead of --format; with --slots, for the unit beam alone.
    #[arg(long, value_name = "LIST", value_parser = widths::parse, requires = "slots",
          conflicts_with_all = ["format", "root-form", "planes", "objects"])]
    pub widths: Option<MachineWords>,
    /// Slots of that machine, as a machine description has them: the planes of each, and behind it the bits of a
    /// shorter root and of shorter planes, such as 3,0,2:r14:p20.
    #[arg(long, value_name = "LIST", value_parser = slots::parse, requires = "widths")]
    pub slots: Option<Slots>,
}

/// Slots of a fitted machine.
pub type Slots = Vec<FittedSlot>;

/// Arguments of `contract`.
#[derive(Debug, Args)]
pub struct Contract {
    /// Unit, as listed by `imogene units`.
    pub unit: String,
    /// Parameters.
    #[command(flatten)]
    pub shape: Shape,
    /// File to write instead of printing.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Arguments of `package`.
#[derive(Debug, Args)]
pub struct Package {
    /// Units, as listed by `imogene units`; all if none is named.
    pub units: Vec<String>,
    /// Output folder.
    #[arg(long)]
    pub out: PathBuf,
    /// Clocks of random stimulus in the vectors of each bench; 0 leaves benches and the target sim out.
    #[arg(long, default_value_t = 500)]
    pub clocks: usize,
}
