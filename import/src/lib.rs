//! Readers of real data: each turns one kind of file into a [`SceneFile`](imogene_scene::SceneFile) and says what it
//! left out, what is exact and what is not.
//!
//! Each kind of file is a feature: `pdb` for molecules, `cad` for lists of faces and STEP, `terrain` for grids of
//! heights.
//!
//! ```
//! use imogene_import::pdb::{Format, Options, read};
//! use imogene_scene::{Shape, Step};
//!
//! let atom = "ATOM      1  CA  ALA A   1      11.104  13.207   9.327  1.00  0.00           C";
//! let imported = read(atom.as_bytes(), Format::Pdb, "atom.pdb", &Options::default())?;
//!
//! // A carbon is a sphere of its van der Waals radius, 1.7 Angstrom, at its place.
//! let ball = &imported.scene.objects[0];
//! assert_eq!(ball.shape, Shape::Sphere { radius: 1.7 });
//! assert_eq!(ball.place, [Step::Translate([11.104, 13.207, 9.327])]);
//!
//! // What is no coordinate is refused where it stands.
//! let wrong = atom.replace("13.207", "13.2o7");
//! let refusal = read(wrong.as_bytes(), Format::Pdb, "atom.pdb", &Options::default()).unwrap_err();
//! assert!(refusal.to_string().starts_with("atom.pdb:1:41: the y coordinate `13.2o7` is not a number"));
//! # Ok::<(), imogene_import::ImportError>(())
//! ```

// What all readers share is not all used by some of them.
#![cfg_attr(
    not(all(feature = "pdb", feature = "cad", feature = "terrain")),
    allow(dead_code)
)]

mod error;
#[cfg(feature = "cad")]
pub mod faces;
mod kind;
mod kit;
#[cfg(feature = "pdb")]
pub mod pdb;
#[cfg(feature = "terrain")]
pub mod terrain;

pub use error::{Error, ImportError, Place};
pub use kind::{Kind, is_compressed, is_scene, kinds, unpack};
pub use kit::Imported;
