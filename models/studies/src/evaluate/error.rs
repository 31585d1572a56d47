//! Why there is no evaluation.

use crate::kit::DrawError;
use imogene_plan::zone::plan::PlanError;
use imogene_prepare::error::PrepareError;
use imogene_scene::SceneError;
use thiserror::Error;

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
    /// The rows are none.
    #[error("evaluation.toml: {0}")]
    Rows(#[from] toml::de::Error),
    /// An expression of a row has no value.
    #[error("evaluation.toml, `{expression}`: {problem}")]
    Expression {
        /// Which.
        expression: String,
        /// Why not.
        problem: String,
    },
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
    #[error(transparent)]
    Draw(#[from] DrawError),
}
