//! Checks of pictures.
//!
//! [`trace`] draws a scene file by rays in scene coordinates, in intervals, and exactly where these cannot tell;
//! [`compare`] holds the golden picture against it. No algorithm of the preparation, the golden model or the exact
//! reference takes part. [`crack`] looks for cracks without any reference, [`inject`] makes some to see whether it
//! finds them. [`repair`] solves the pixels that short words leave open. [`ordinary`] writes scenes at random,
//! [`survey`] counts what becomes of them.
//!
//! ```
//! use imogene_golden::format::Format;
//! use imogene_oracle::run::{Outcome, run};
//! use imogene_scene::SceneFile;
//!
//! let text = r#"format = 1
//! title = "A ball"
//! camera = { kind = "orthographic", eye = [0, 0, 9], target = [0, 0, 0], view_height = 4, half_depth = 2 }
//! materials = [{ name = "clay", colour = [0.8, 0.4, 0.3] }]
//! objects = [{ name = "ball", kind = "sphere", radius = 1, material = "clay" }]"#;
//! let scene = SceneFile::parse(text, "ball.toml")?;
//!
//! let Outcome::Compared(found) = run(&scene, 40, 40, Format::BASE, &|_| ())? else {
//!     panic!("a ball is drawn by any machine");
//! };
//! // At 10 pixels a unit the tracer sees the pixels of a disc of radius 10.
//! let disc = (-20..20).flat_map(|y| (-20..20).map(move |x| x * x + y * y)).filter(|square| *square <= 100);
//! assert_eq!(found.comparison.covered, disc.count());
//! // The golden picture is the same beside edges, and its depths are within their bounds.
//! assert!(found.comparison.depths > 0 && found.comparison.holds());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod body;
pub mod bounds;
pub mod camera;
pub mod colour;
pub mod compare;
pub mod crack;
mod decide;
pub mod facet;
pub mod inject;
pub mod interval;
pub mod ordinary;
pub mod paint;
pub mod plot;
pub mod repair;
pub mod root;
pub mod run;
mod solid;
mod solve;
pub mod survey;
pub mod table;
pub mod trace;
pub mod transform;
pub mod verdict;
