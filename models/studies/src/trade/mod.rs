//! Speed, area and accuracy of the machines that can draw a scene: every point of a design space measured against the
//! truth.
//!
//! [`design`] says what points there are, [`measure`](mod@measure) draws one, compares it and says what is built for
//! it, [`run`](mod@run) does all of them and keeps each in a file of its own, [`report`] sums them up, [`speed`],
//! [`plot`] and [`page`](mod@page) show them.
//! `docs/trade.md` is the user's page.

pub mod design;
pub mod measure;
pub mod page;
pub mod plot;
pub mod point;
mod prices;
pub mod report;
pub mod run;
pub mod speed;
pub mod view;

use std::path::Path;
use thiserror::Error;

/// Why there is no result.
#[derive(Debug, Error)]
pub enum TradeError {
    /// The scene at this size.
    #[error(transparent)]
    Scene(#[from] imogene_scene::SceneError),
    /// An object that no machine of quadric processors draws, or a file that cannot be read.
    #[error("{0}")]
    Refused(String),
    /// A file that cannot be written.
    #[error(transparent)]
    Write(#[from] crate::kit::picture::WriteError),
    /// A plot or the page.
    #[error(transparent)]
    Draw(#[from] crate::kit::DrawError),
}

impl TradeError {
    fn unreadable(file: &Path, problem: impl std::fmt::Display) -> TradeError {
        TradeError::Refused(format!("cannot read '{}': {problem}", file.display()))
    }
}
