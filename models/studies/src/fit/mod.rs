//! The smallest machine that draws a scene, or every frame of an animation, within a budget of errors.
//!
//! [`budget`] says what is allowed, [`frames`] holds the pictures and their truth, [`search`](mod@search) finds the
//! words that meet the budget, [`omission`] what is left out of the scene, [`machine`](mod@machine) what stands around
//! them, and [`proof`] says of the one that is taken what is proven by bounds and what by comparing every pixel.
//! `docs/fit.md` is the user's page.

pub mod budget;
pub mod estimate;
pub mod frames;
pub mod machine;
pub mod omission;
pub mod proof;
pub mod search;
mod spare;

use imogene_plan::description::DescriptionError;
use thiserror::Error;

/// What is wrong with a scene.
pub type Cause = Box<dyn std::error::Error + Send + Sync>;

/// Why nothing can be fitted.
#[derive(Debug, Error)]
pub enum FitError {
    /// A scene that is none at this size or not of one animation with the others, that no machine takes whatever its
    /// words, or that none shows.
    #[error("{scene}: {source}")]
    Scene {
        /// The file.
        scene: String,
        /// What is in the way.
        source: Cause,
    },
    /// More objects or volumes than a beam machine has processors.
    #[error(
        "the scene has more objects or volumes than the 256 processors of a beam machine; --machine zone would do"
    )]
    TooManyForBeam,
    /// No machine is as fast as asked for.
    #[error(
        "{scene}: no machine reaches {wanted} frames per second at {mhz} MHz; the fastest one makes {fastest:.1}{remedy}"
    )]
    Slow {
        /// The file of the slowest frame.
        scene: String,
        /// Frames per second that are asked for.
        wanted: f64,
        /// Clock.
        mhz: f64,
        /// Frames per second of the fastest machine.
        fastest: f64,
        /// What would be faster, if anything.
        remedy: String,
    },
    /// Not a machine: too large a picture.
    #[error(transparent)]
    Description(#[from] DescriptionError),
    /// Nothing says how much may be left out.
    #[error(
        "--leave-out auto takes out what the budget allows; give both --max-silhouette-errors and --max-face-errors"
    )]
    NoCounts,
    /// Nothing is limited.
    #[error(
        "the budget limits nothing; give at least one of --max-depth-error, --max-silhouette-errors, --max-face-errors, --max-colour-error, \
         --max-normal-error"
    )]
    NoBudget,
}

impl FitError {
    fn of(scene: &str, source: impl Into<Cause>) -> FitError {
        FitError::Scene {
            scene: scene.to_owned(),
            source: source.into(),
        }
    }
}
