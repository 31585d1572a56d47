//! Scenes: the file a person writes, its checks, and its exact image in the camera frame.
//!
//! [`SceneFile`] is the text of a scene in its own words (scene units, local coordinates, degrees). [`FramedScene`] is
//! the same scene for one picture size: every quadric and cut plane in camera pixels, in exact rationals, ready for
//! the preparation of integer coefficients. `docs/scene-format.md` is the user's page of the file format.
//!
//! ```
//! use imogene_algebra::rational::integer;
//! use imogene_scene::{DepthRange, SceneFile};
//!
//! let text = r#"format = 1
//! title = "A ball"
//! camera = { kind = "orthographic", eye = [0, 0, 9], target = [0, 0, 0], view_height = 4, half_depth = 2 }
//! materials = [{ name = "clay", colour = [0.8, 0.4, 0.3] }]
//! objects = [{ name = "ball", kind = "sphere", radius = 1, material = "clay" }]"#;
//! let scene = SceneFile::parse(text, "ball.toml")?;
//!
//! // The window is 4 units high, so 40 lines are 10 pixels a unit, and the ball is x^2 + y^2 + z^2 - 10^2.
//! let range = DepthRange::of_camera(&scene.camera);
//! let framed = scene.flattened().frame_within(&range, (60, 40), |_, _| Ok(None))?;
//! let quadric = &framed.objects[0].quadric().ok_or("a ball is a quadric")?.quadric;
//! assert_eq!(&quadric.j / &quadric.a, integer(-100));
//!
//! // A key that the format has not is refused where it stands: line 2, column 1.
//! let wrong = SceneFile::parse(&text.replace("title", "titel"), "ball.toml").unwrap_err();
//! assert!(wrong.to_string().starts_with("ball.toml:2:1: unknown field `titel`"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod animation;
mod camera;
pub mod error;
mod file;
mod flat;
mod frame;
mod framed;
mod group;
mod image;
mod image_validation;
mod keys;
mod kind_validation;
mod light;
mod limits;
mod look;
mod mesh;
mod molecule;
mod names;
mod object;
mod paraboloids;
mod quadric;
mod range;
mod reach;
mod shape;
mod solid;
mod solid_validation;
mod source;
mod step;
mod text;
mod transform;
mod validation;

pub use camera::{Camera, FloatCamera, Lens};
pub use error::{SceneError, in_plain_words, line_and_column};
pub use file::{FORMAT_VERSION, ImageSize, Material, SceneFile};
pub use frame::{FramedLight, FramedScene};
pub use framed::{Absence, Absent, FramedObject, Unseen};
pub use group::{Group, Node};
pub use image::{Action, KeyImage, MoveFrame};
pub use keys::{is_default, number, text_or_table};
pub use light::{Aim, Beam, Light};
pub use limits::MAX_CUTS;
pub use look::{Look, MARGIN, Side, fitting, fitting_from};
pub use mesh::{FramedFacet, FramedMesh};
pub use molecule::Molecule;
pub use names::MAX_NESTING;
pub use object::Object;
pub use paraboloids::{FramedCylinder, FramedSphere, on_unit_circle, root};
pub use quadric::{FramedQuadric, Plane, Quadric};
pub use range::{CutOff, DepthRange, End, Projection, RangeOrigin, RangeReport};
pub use reach::Body;
pub use shape::{Cut, Mesh, Processor, Shape, Surface};
pub use solid::{FramedSolid, Operand, Operation, Solid, Tree};
pub use source::{FramedSource, SpotCone};
pub use step::{Axis, Rotation, Scale, Step};
pub use transform::{Transform, WholeInverse, WholeTransform, rotation_matrix};
