//! Every cost table of the source counted again, beside the printed value (source: Nyiri, chapter 5; Chaillou, chapter IV).
//!
//! No figure of ours is typed in. Operations are counted by running the algorithms in numbers that count ([`count`], [`work`]); words, beats and clocks are those of the
//! golden machines; parts of processors come from the hierarchy that is emitted and are handed in as [`Hardware`]; cells and clock rates come from the table of resources.

mod costs;
pub mod count;
mod duplication;
mod first_machine;
mod omitted;
mod page;
mod pipeline;
mod plot;
mod preparation;
pub mod row;
mod scenes;
mod silicon;
mod software;
mod storage;
pub mod work;
mod zones;

pub use duplication::{Edges, Touched, formula, touched};
pub use page::{markdown, page};
pub use plot::{duplication_plot, operations_plot};

use imogene_plan::zone::clocks::ZoneTiming;
use imogene_plan::zone::plan::PlanError;
use imogene_prepare::error::PrepareError;
use imogene_scene::SceneError;
use row::{Group, Omitted, Row};
use serde::Serialize;
use silicon::Resources;
use thiserror::Error;

/// The parts of a processor as it is emitted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parts {
    /// Unit.
    pub unit: String,
    /// Its parameters besides the format, such as `4 planes`.
    pub parameters: String,
    /// First-degree elementary processors.
    pub pe1: usize,
    /// Second-degree elementary processors.
    pub pe2: usize,
    /// Square root networks.
    pub roots: usize,
    /// Multipliers.
    pub multipliers: usize,
}

/// What the counts need of the hardware.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hardware {
    /// The object processors in the base format.
    pub processors: Vec<Parts>,
    /// Clocks of a zone machine of [`MACHINE_PROCESSORS`] processors with four planes.
    pub zone_timing: ZoneTiming,
}

/// Object processors of the zone machine whose clocks are handed in.
pub const MACHINE_PROCESSORS: usize = 100;
/// Their cut planes.
pub const MACHINE_PLANES: usize = 4;

/// A count that is not possible: a defect of this workspace.
#[derive(Debug, Error)]
pub enum EvaluateError {
    /// A scene that is compiled in is wrong.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// It does not fit the base format.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// It does not fit the zone machine.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The table of resources is not one.
    #[error("docs/resources.json: {0}")]
    Resources(#[from] serde_json::Error),
    /// A figure is missing.
    #[error("no {figure} of `{unit}` for {target}")]
    Missing {
        /// Of what.
        unit: String,
        /// On which device, or with which parameters.
        target: String,
        /// Which figure.
        figure: &'static str,
    },
    /// The page or a plot cannot be made.
    #[error("{what} cannot be made: {problem}")]
    Draw {
        /// What.
        what: &'static str,
        /// Why not.
        problem: String,
    },
}

/// All that is counted; the keys are stable.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Evaluation {
    /// By subject.
    pub groups: Vec<Group>,
    /// What is not counted.
    pub omitted: Vec<Omitted>,
}

impl Evaluation {
    /// A row by the names of its group and itself.
    pub fn row(&self, group: &str, name: &str) -> Option<&Row> {
        let group = self.groups.iter().find(|g| g.name == group)?;
        group.rows.iter().find(|row| row.name == name)
    }
}

/// Counts everything.
///
/// # Errors
///
/// A defect of this workspace, if any.
pub fn evaluate(hardware: &Hardware) -> Result<Evaluation, EvaluateError> {
    let resources = Resources::compiled_in()?;
    let [ball, _, patch] = scenes::balls()?;
    let others = scenes::others()?;
    Ok(Evaluation {
        groups: vec![
            storage::group(&patch, &others)?,
            preparation::frame(),
            preparation::facet(),
            preparation::quadric(),
            preparation::polyhedron(),
            zones::group(),
            duplication::group(&ball)?,
            software::group(),
            first_machine::processors(hardware)?,
            silicon::group(&resources)?,
            pipeline::group(&patch, hardware, &resources)?,
            pipeline::preparation(),
            first_machine::machine(&resources)?,
        ],
        omitted: omitted::OMITTED.to_vec(),
    })
}
