//! Animations: the frames of a scene with key images (source: animator).
//!
//! [`Playback`] says which frames there are and what the scene is in each of them, again as a
//! [`SceneFile`](crate::SceneFile).

pub mod moves;
mod playback;

pub use playback::{FrameOf, MAX_MOVES, Playback, PlaybackError};
