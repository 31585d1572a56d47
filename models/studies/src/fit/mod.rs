//! The smallest machine that draws a scene, or every frame of an animation, within a budget of errors.
//!
//! [`budget`] says what is allowed, [`frames`] holds the pictures and their truth, [`search`](mod@search) finds the
//! machines that meet the budget, and [`proof`] says of the one that is taken what is proven by bounds and what by
//! comparing every pixel. `docs/fit.md` is the user's page.

pub mod budget;
mod estimate;
pub mod frames;
pub mod proof;
pub mod search;

use imogene_files::text::counted;
use imogene_prepare::error::PrepareError;
use imogene_scene::SceneError;
use thiserror::Error;

/// Why nothing can be fitted.
#[derive(Debug, Error)]
pub enum FitError {
    /// A scene at this size.
    #[error("{scene}: {source}")]
    Scene {
        /// The file.
        scene: String,
        /// What is wrong with it.
        source: Box<SceneError>,
    },
    /// A scene that no machine takes, whatever its words.
    #[error("{scene}: {source}")]
    Prepare {
        /// The file.
        scene: String,
        /// What is in the way.
        source: Box<PrepareError>,
    },
    /// An object of another processor.
    #[error(
        "{scene}: object '{object}' is drawn by the processor \"{processor}\"; fitted machines have quadric processors, which draw \
         every object of a quadric: leave `processor` out"
    )]
    Processor {
        /// The file.
        scene: String,
        /// Name of the object.
        object: String,
        /// Its processor.
        processor: &'static str,
    },
    /// Frames that are not of one animation.
    #[error(
        "{scene}: {}, but the first frame has {expected}; the frames of an animation have the same objects in the same order",
        counted(.count.to_owned(), "object")
    )]
    Objects {
        /// The file.
        scene: String,
        /// Its objects.
        count: usize,
        /// Those of the first frame.
        expected: usize,
    },
    /// A scene without an object.
    #[error("{scene}: there is no object, and no machine to fit")]
    Empty {
        /// The file.
        scene: String,
    },
    /// Nothing is limited.
    #[error(
        "the budget limits nothing; give at least one of --max-depth-error, --max-silhouette-errors, --max-face-errors, --max-colour-error, \
         --max-normal-error"
    )]
    NoBudget,
}
