//! What an object of a scene is in the camera frame.

use super::mesh::FramedMesh;
use super::paraboloids::{FramedCylinder, FramedSphere};
use super::quadric::FramedQuadric;
use super::shape::Surface;
use serde::Serialize;
use std::sync::Arc;

/// An object in the camera frame, by the processor that draws it.
#[derive(Clone, Debug, PartialEq)]
pub enum FramedObject {
    /// A cut quadric for the quadric processor.
    Quadric(Box<FramedQuadric>),
    /// A cut surface for the patch processor.
    Patch(Box<FramedQuadric>),
    /// A quadric between two parallel planes for the first generation.
    FirstGeneration(Box<FramedQuadric>),
    /// A convex solid of planes: a quadric that is everywhere, [`Quadric::everywhere`](super::Quadric::everywhere),
    /// with its cuts.
    Polyhedron(Box<FramedQuadric>),
    /// Flat facets.
    Mesh(Box<FramedMesh>),
    /// A sphere for the sphere processor.
    Sphere(Box<FramedSphere>),
    /// A cylinder with its two discs for the cylinder processor.
    Cylinder(Box<FramedCylinder>),
    /// A sphere as one non-planar facet.
    CurvedSphere(Box<FramedSphere>),
    /// A surface with one depth of second degree at each pixel, as one non-planar facet; its planes are perpendicular
    /// to the screen.
    CurvedFacet(Box<FramedQuadric>),
    /// Left out by the preparation because it is proven to be nowhere in the picture.
    Unseen(Arc<Unseen>),
}

/// An object that was left out of a frame because nothing of it is seen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unseen {
    /// Unique name.
    pub name: Box<str>,
    /// Index of the material.
    pub material: usize,
    /// Why.
    pub why: Absence,
}

/// How many objects of a scene were left out of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Absent {
    /// Behind nearer ones.
    pub hidden: usize,
    /// Beside the picture or behind the viewer.
    pub off_screen: usize,
}

impl Absent {
    /// Of these objects.
    pub fn of(objects: &[FramedObject]) -> Absent {
        let mut absent = Absent::default();
        for object in objects {
            match object {
                FramedObject::Unseen(unseen) if unseen.why == Absence::Hidden => absent.hidden += 1,
                FramedObject::Unseen(_) => absent.off_screen += 1,
                _ => {}
            }
        }
        absent
    }
}

/// Why nothing of an object is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Absence {
    /// Nearer objects hide it at every pixel.
    Hidden,
    /// It lies beside the picture or behind the viewer.
    OffScreen,
}

impl From<FramedQuadric> for FramedObject {
    fn from(object: FramedQuadric) -> FramedObject {
        FramedObject::Quadric(Box::new(object))
    }
}

impl FramedObject {
    /// Was it left out because nobody sees it?
    pub fn is_unseen(&self) -> bool {
        matches!(self, Self::Unseen(_))
    }

    fn name_and_material(&self) -> (&str, usize) {
        match self {
            Self::Unseen(unseen) => (&unseen.name, unseen.material),
            Self::Mesh(mesh) => (&mesh.name, mesh.material),
            Self::Sphere(sphere) | Self::CurvedSphere(sphere) => (&sphere.name, sphere.material),
            Self::Cylinder(cylinder) => (&cylinder.name, cylinder.material),
            Self::Quadric(q)
            | Self::Patch(q)
            | Self::FirstGeneration(q)
            | Self::Polyhedron(q)
            | Self::CurvedFacet(q) => (&q.name, q.material),
        }
    }

    /// Unique name.
    pub fn name(&self) -> &str {
        self.name_and_material().0
    }

    /// Index of the material.
    pub fn material(&self) -> usize {
        self.name_and_material().1
    }

    /// Name of the processor that draws it.
    pub fn processor(&self) -> &'static str {
        match self {
            Self::Unseen(_) => "none",
            Self::Quadric(_) => "quadric",
            Self::Patch(_) => "patch",
            Self::FirstGeneration(_) => "first_generation",
            Self::Polyhedron(_) => "polyhedron",
            Self::Mesh(_) => "facet",
            Self::Sphere(_) => "sphere",
            Self::Cylinder(_) => "cylinder",
            Self::CurvedSphere(_) | Self::CurvedFacet(_) => "curved_facet",
        }
    }

    /// The cut quadric of an object whose words are those of the quadric processor.
    pub fn quadric(&self) -> Option<&FramedQuadric> {
        match self {
            Self::Quadric(q) | Self::Patch(q) => Some(q),
            _ => None,
        }
    }

    /// The cut quadric whose shadow the object casts, if it is one of those that can cast any and is not told not to.
    pub fn caster(&self) -> Option<&FramedQuadric> {
        match self {
            Self::Quadric(q) | Self::Patch(q) | Self::Polyhedron(q) => q.casts_shadow.then_some(q),
            _ => None,
        }
    }

    /// Whether it keeps the light of sources with shadows off others.
    pub fn casts_shadow(&self) -> bool {
        match self {
            Self::Mesh(mesh) => mesh.casts_shadow,
            _ => self.caster().is_some(),
        }
    }

    /// The true object as a cut quadric; a mesh is none, and what is left out has none any more.
    pub fn cut_quadric(&self) -> Option<FramedQuadric> {
        match self {
            Self::Mesh(_) | Self::Unseen(_) => None,
            Self::Sphere(sphere) => Some(sphere.cut_quadric(Surface::Solid)),
            Self::CurvedSphere(sphere) => Some(sphere.cut_quadric(Surface::Patch)),
            Self::Cylinder(cylinder) => Some(cylinder.cut_quadric()),
            Self::Quadric(q)
            | Self::Patch(q)
            | Self::FirstGeneration(q)
            | Self::Polyhedron(q)
            | Self::CurvedFacet(q) => Some((**q).clone()),
        }
    }
}
