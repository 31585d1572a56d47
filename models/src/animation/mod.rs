//! Animations: the frames of a scene with key images, and the preparation of each from what did not change (source: animator).
//!
//! [`Playback`] says which frames there are and what the scene is in each of them, again as a [`SceneFile`](crate::scene::SceneFile). An [`Animator`]
//! prepares frame after frame and keeps the words of every object and shadow that the next frame has as well.

mod animator;
mod parts;
mod placement;
mod playback;
mod preview;
mod state;

pub use animator::{AnimationError, Animator, FrameError, FrameProblem, PreparedFrame};
pub use playback::{FrameOf, Playback, PlaybackError};
pub use preview::Preview;
pub use state::MAX_MOVES;
