//! What a machine is given of the words of a scene: culling, zones, divisions, screens.
//!
//! ```
//! use imogene_golden::{format::Format, machine::beam};
//! use imogene_plan::split::Divided;
//! use imogene_prepare::{Framing, prepare};
//! use imogene_scene::SceneFile;
//!
//! let text = r#"format = 1
//! title = "A ball"
//! camera = { kind = "orthographic", eye = [0, 0, 9], target = [0, 0, 0], view_height = 6.4, half_depth = 2 }
//! materials = [{ name = "clay", colour = [0.8, 0.4, 0.3] }]
//! objects = [{ name = "ball", kind = "sphere", radius = 1, material = "clay" }]"#;
//! let scene = SceneFile::parse(text, "ball.toml")?;
//!
//! // A disc of radius 10 about pixel (32, 32): four of the sixteen zones touch it and load the ball.
//! let prepared = prepare(&scene.frame(64, 64)?, Format::BASE)?;
//! let divided = Divided::draw(&prepared, "zones:16x16".parse()?, 2, || ());
//! assert_eq!((divided.pieces.len(), divided.duplication.loads), (16, 4));
//! // Zone by zone it is the same picture as all at once.
//! let whole = beam::render(&prepared.slots(), &Format::BASE, 64, 64, || ());
//! assert_eq!(divided.frame.depth, whole.depth);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod beam;
pub mod culling;
pub mod description;
pub mod display;
pub mod needs;
pub mod pace;
mod products;
pub mod split;
pub mod tile;
pub mod zone;
