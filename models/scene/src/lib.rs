//! Scenes: the file a person writes, its checks, and its exact image in the camera frame.
//!
//! [`SceneFile`] is the text of a scene in its own words (scene units, local coordinates, degrees). [`FramedScene`] is
//! the same scene for one picture size: every quadric and cut plane in camera pixels, in exact rationals, ready for
//! the preparation of integer coefficients. `docs/scene-format.md` is the user's page of the file format.

pub mod animation;
mod camera;
mod check;
mod check_kind;
mod error;
mod file;
mod flat;
mod float_camera;
mod frame;
mod framed;
mod group;
mod image;
mod image_check;
mod keys;
mod look;
mod mesh;
mod molecule;
mod names;
mod pixel;
mod plane;
mod quadric;
mod range;
mod reach;
mod round;
mod sight;
mod source;
mod tetrahedron;
mod transform;

pub use camera::{FILM_HEIGHT, LONGEST_FOCAL, NARROWEST_FIELD, SHORTEST_FOCAL, WIDEST_FIELD};
pub use check::{
    LARGEST_HALF_ANGLE, MAX_CUTS, MAX_IMAGE_SIDE, MAX_INTENSITY, MAX_LIGHTS, MAX_MAGNITUDE,
    MAX_SPECULAR_EXPONENT, SMALLEST_HALF_ANGLE,
};
pub use error::SceneError;
pub use error::{in_plain_words, line_and_column};
pub use file::{
    Aim, Axis, Camera, Cut, FORMAT_VERSION, ImageSize, Light, Material, Mesh, Object, Processor,
    Rotation, Scale, SceneFile, Shape, Step, Surface,
};
pub use float_camera::FloatCamera;
pub use frame::{FramedLight, FramedScene, Projection};
pub use framed::{Absence, Absent, FramedObject, FramedQuadric, Unseen};
pub use group::{Group, Node};
pub use image::{Action, FRAME_DURATION, KeyImage, MoveFrame};
pub use image_check::{LONGEST_FRAME, MAX_FRAMES, MAX_IMAGES, SHORTEST_FRAME};
pub use look::{Look, MARGIN, Side, fitting, fitting_from};
pub use mesh::{FramedFacet, FramedMesh};
pub use molecule::Molecule;
pub use names::MAX_NESTING;
pub use plane::Plane;
pub use quadric::Quadric;
pub use range::{CutOff, DepthRange, End, RangeOrigin, RangeReport};
pub use reach::Body;
pub use round::root;
pub use round::{FramedCylinder, FramedSphere};
pub use source::{FramedSource, SpotCone};
pub use transform::Transform;
pub use transform::{cofactor, rotation_matrix};
