//! Preparation: from a framed scene to the coefficient words that the golden model and the hardware are loaded with.
//!
//! Exact rationals all the way, rounded once ([`rounding`]); every accumulator is proven to hold its value on the
//! object's screen box, or the object is refused by name ([`error`]).
//!
//! ```
//! use imogene_golden::{format::Format, object::words::Object};
//! use imogene_prepare::{Framing, prepare, prepare_for_roots};
//! use imogene_scene::SceneFile;
//!
//! let text = r#"format = 1
//! title = "A ball"
//! camera = { kind = "orthographic", eye = [0, 0, 9], target = [0, 0, 0], view_height = 4, half_depth = 2 }
//! materials = [{ name = "clay", colour = [0.8, 0.4, 0.3] }]
//! objects = [{ name = "ball", kind = "sphere", radius = 1, material = "clay" }]"#;
//! let scene = SceneFile::parse(text, "ball.toml")?;
//!
//! let prepared = prepare(&scene.frame(40, 40)?, Format::BASE)?;
//! let words = &prepared.slots()[0].words;
//! // In the middle the front is a unit before the screen, half of the way to the near end.
//! assert!((words.at(20, 20, &Format::BASE).zf + (1 << 22)).abs() <= 2);
//!
//! // A radius of 500.5 times the greatest depth has a square of 2 (23 + log2 500.5) = 63.9 bits: refused by name.
//! let huge = text.replace("radius = 1", "radius = 1001, place = [{ translate = [0, 0, -1000] }]");
//! let huge = SceneFile::parse(&huge, "huge.toml")?.frame(40, 40)?;
//! let refusal = prepare_for_roots(&huge, Format::BASE).unwrap_err();
//! assert!(refusal.to_string().starts_with("object 'ball': too large for the format: f2 reaches 2^63.9"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod again;
pub mod animator;
pub mod cell;
mod context;
mod depth;
mod enclosure;
pub mod error;
pub mod extent;
mod first_generation;
pub mod forms;
mod framing;
mod known;
mod layers;
mod ledger;
pub mod lit_sphere;
mod located;
mod memo;
pub mod memory;
mod mesh;
mod object;
mod paraboloids;
pub mod perspective;
mod planes;
mod polyhedron;
mod prepared;
mod projected;
mod quotient;
mod range;
pub mod rounding;
mod run;
mod scene;
pub mod screen_box;
pub mod seams;
pub mod shader;
pub mod shapes;
pub mod solids;
mod unseen;
pub mod volume;
mod witness;

pub use again::{Kept, Reuse, prepare_again};
pub use context::{Options, Quotients};
pub use error::Missing;
pub use framing::Framing;
pub use prepared::{
    ExactForms, NeededWidths, NeededWord, PreparedObject, PreparedParts, PreparedQuadric,
    RoundingBounds,
};
pub use run::{
    LocatedScene, prepare, prepare_for_roots, prepare_reporting, prepare_with, refused, steps,
};
pub use scene::PreparedScene;
pub use solids::{PreparedSolids, Product};
pub use unseen::Seen;
