//! The checks of what an object's kind and its processor ask for.

use super::camera::Camera;
use super::error::SceneError;
use super::limits::{Checked, check_direction, check_numbers, unless};
use super::mesh::face;
use super::object::Object;
use super::paraboloids::{keeps_spheres, makes_circular_cylinder};
use super::quadric::Quadric;
use super::shape::{Mesh, Processor, Shape, Surface};
use super::transform::Transform;
use imogene_algebra::rational::from_decimal;
use imogene_algebra::vector::{cross, dot};
use imogene_contract::words::MOST_SIDES;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::collections::HashSet;
use std::fmt::Arguments;

/// Refuses an object whose numbers are in order and whose kind or processor cannot be had with them.
pub(super) fn check_kind(place: Arguments, object: &Object, camera: &Camera) -> Checked {
    match &object.shape {
        Shape::Polyhedron => {
            without_choice(place, object, "a polyhedron")?;
            let key = format_args!("{place}, cuts");
            let problem = "a polyhedron without cuts has no face";
            let accepted = "1 to 12 cuts, the planes of its faces, are needed";
            unless(!object.cuts.is_empty(), key, problem, accepted)
        }
        Shape::Mesh(mesh) => check_mesh(place, object, mesh),
        Shape::TetrahedronPatch { corners, weights } => {
            check_tetrahedron(place, object, corners, weights)
        }
        _ => Ok(()),
    }?;
    match object.drawn_by() {
        None | Some(Processor::Quadric) => Ok(()),
        Some(Processor::Patch) => require_mode(place, object, Surface::Patch),
        Some(Processor::FirstGeneration) => check_first_generation(place, object),
        Some(Processor::Paraboloid) => {
            require_parallel_view(place, object, camera)?;
            check_paraboloid(place, object)
        }
        Some(Processor::CurvedFacet) => {
            require_parallel_view(place, object, camera)?;
            check_curved_facet(place, object)
        }
    }
}

/// Refuses the processor that was asked for unless it would do.
fn require_processor(
    does: bool,
    (place, object): (Arguments, &Object),
    problem: &str,
    accepted: &str,
) -> Checked {
    if does {
        return Ok(());
    }
    let name = toml::Value::try_from(object.processor).expect("a processor that was asked for");
    let (key, problem) = (
        format_args!("{place}, processor"),
        format_args!("{name} {problem}"),
    );
    Err(SceneError::value(key, problem, accepted))
}

fn without_choice(place: Arguments, object: &Object, owner: &str) -> Checked {
    let problem = format!("does not draw {owner}, which has a processor of its own");
    let (is_none, at) = (object.processor.is_none(), (place, object));
    require_processor(is_none, at, &problem, "no `processor` is needed")
}

fn check_mesh(place: Arguments, object: &Object, mesh: &Mesh) -> Checked {
    without_choice(place, object, "a mesh")?;
    refuse_cuts(place, object, "a mesh cannot be cut")?;
    let count = mesh.vertices.len();
    let key = format_args!("{place}, vertices");
    let problem = format_args!("vertices: {count}, which make no facet");
    unless(count >= 3, key, problem, "at least three are needed")?;
    let key = format_args!("{place}, faces");
    let (has_faces, problem) = (!mesh.faces.is_empty(), "the mesh has no face");
    let accepted = "at least one [i, j, k] or [i, j, k, l] is needed";
    unless(has_faces, key, problem, accepted)?;
    for (index, vertex) in mesh.vertices.iter().enumerate() {
        check_numbers(format_args!("{place}, vertices[{index}]"), vertex)?;
    }
    let normals = mesh.normals.len();
    let key = format_args!("{place}, normals");
    let problem = format_args!("{normals} normals for {count} vertices");
    let accepted = "one normal for each vertex is needed, or no `normals` for flat facets";
    unless(normals == 0 || normals == count, key, problem, accepted)?;
    for (index, normal) in mesh.normals.iter().enumerate() {
        check_direction(format_args!("{place}, normals[{index}]"), *normal)?;
    }
    let vertices = mesh.vertices.iter().map(|v| v.map(from_decimal));
    let vertices: Vec<[BigRational; 3]> = vertices.collect();
    let mut faces = mesh.faces.iter().enumerate();
    faces.try_for_each(|(index, corners)| {
        check_face(format_args!("{place}, faces[{index}]"), corners, &vertices)
    })
}

fn check_face(place: Arguments, corners: &[usize], vertices: &[[BigRational; 3]]) -> Checked {
    let (problem, accepted) = if !(3..=4).contains(&corners.len()) {
        let problem = format!("has {} corners", corners.len());
        (problem, "a face has three or four".to_owned())
    } else if let Some(index) = corners.iter().find(|index| **index >= vertices.len()) {
        let accepted = format!("the mesh has vertices 0 to {}", vertices.len() - 1);
        (format!("names vertex {index}"), accepted)
    } else if corners.iter().collect::<HashSet<_>>().len() < corners.len() {
        let accepted = "different vertices are needed";
        ("names a vertex twice".into(), accepted.into())
    } else if face(vertices, corners).is_none() {
        (
            "has no area: its corners lie in a line, or its sides cross".into(),
            "corners that go round an area are needed".into(),
        )
    } else {
        return Ok(());
    };
    let problem = format!("{corners:?} {problem}");
    Err(SceneError::value(place, problem, accepted))
}

fn check_tetrahedron(
    place: Arguments,
    object: &Object,
    corners: &[[f64; 3]; 4],
    weights: &[f64; 10],
) -> Checked {
    let problem = "the faces of the tetrahedron are the cuts of this kind";
    refuse_cuts(place, object, problem)?;
    for (index, corner) in corners.iter().enumerate() {
        check_numbers(format_args!("{place}, corners[{index}]"), corner)?;
    }
    check_numbers(format_args!("{place}, weights"), weights)?;
    let drawn_by = object.drawn_by();
    let does = matches!(drawn_by, Some(Processor::Patch | Processor::Quadric));
    let problem = "does not draw a tetrahedral patch";
    let accepted = "\"patch\" (default) and \"quadric\" do";
    require_processor(does, (place, object), problem, accepted)?;
    let Some(quadric) = Quadric::from_shape(&object.shape) else {
        let problem = "the four corners lie in one plane";
        let accepted = "corners of a tetrahedron with a volume are needed";
        let place = format_args!("{place}, corners");
        return Err(SceneError::value(place, problem, accepted));
    };
    let is_plane = quadric.coefficients()[..6].iter().all(|v| v.is_zero());
    let key = format_args!("{place}, weights");
    let problem = "the weights make a plane, or nothing";
    let accepted = "weights whose patch is of second degree are needed";
    unless(!is_plane, key, problem, accepted)
}

fn refuse_cuts(place: Arguments, object: &Object, problem: &str) -> Checked {
    let key = format_args!("{place}, cuts");
    let accepted = "no `cuts` are possible";
    unless(object.cuts.is_empty(), key, problem, accepted)
}

fn require_mode(place: Arguments, object: &Object, wanted: Surface) -> Checked {
    let (problem, accepted) = match wanted {
        Surface::Patch => (
            "draws surfaces, and this object is a solid",
            "`mode = \"patch\"`, or the processor \"quadric\", would be accepted",
        ),
        Surface::Solid => (
            "draws solids, and this object is a patch",
            "`mode = \"solid\"`, or the processor \"quadric\", would be accepted",
        ),
    };
    require_processor(object.mode == wanted, (place, object), problem, accepted)
}

fn require_parallel_view(place: Arguments, object: &Object, camera: &Camera) -> Checked {
    require_processor(
        !camera.is_perspective(),
        (place, object),
        "does not draw in perspective",
        "`kind = \"orthographic\"` in `[camera]`, or the processor \"quadric\", would be accepted",
    )
}

fn check_first_generation(place: Arguments, object: &Object) -> Checked {
    let problem = match object.cuts.as_slice() {
        [one, other] => {
            let [u, v] = [one, other].map(|cut| cut.normal.map(from_decimal));
            let parallel = cross(&u, &v).iter().all(Zero::is_zero);
            if parallel && dot(&u, &v).is_negative() {
                return Ok(());
            }
            "the two cuts are not parallel with opposite normals".into()
        }
        cuts => format!(
            "{} cuts, and the processor \"first_generation\" has two planes",
            cuts.len()
        ),
    };
    let accepted =
        "exactly two parallel cuts, with normals that point away from each other, are needed";
    let place = format_args!("{place}, cuts");
    Err(SceneError::value(place, problem, accepted))
}

fn check_paraboloid(place: Arguments, object: &Object) -> Checked {
    require_mode(place, object, Surface::Solid)?;
    let placed = Transform::placement(&object.place);
    match object.shape {
        Shape::Sphere { .. } => {
            let problem = "the processor \"paraboloid\" does not cut a sphere";
            refuse_cuts(place, object, problem)?;
            let round = keeps_spheres(&placed);
            require_round(place, round, "sphere is no longer a sphere")
        }
        Shape::EllipticCylinder(radii) => {
            check_discs(place, object)?;
            let round = makes_circular_cylinder(&placed, radii);
            require_round(place, round, "cylinder is not a right circular cylinder")
        }
        _ => require_processor(
            false,
            (place, object),
            "draws spheres and circular cylinders only",
            "`kind = \"sphere\"` or `kind = \"elliptic_cylinder\"`, or the processor \"quadric\", would be accepted",
        ),
    }
}

fn require_round(place: Arguments, round: bool, problem: &str) -> Checked {
    let key = format_args!("{place}, place");
    let problem = format_args!("the {problem} after these steps");
    let accepted = "scales that keep it round, or the processor \"quadric\", would be accepted";
    unless(round, key, problem, accepted)
}

/// Both ends of a cylinder: two cuts across the y axis, the lower one downwards.
fn check_discs(place: Arguments, object: &Object) -> Checked {
    let across = |normal: [f64; 3]| normal[0] == 0.0 && normal[2] == 0.0;
    let problem = match object.cuts.as_slice() {
        [one, other] => {
            let (upper, lower) = match one.normal[1] > 0.0 {
                true => (one, other),
                false => (other, one),
            };
            let is_opposite = one.normal[1] * other.normal[1] < 0.0;
            if !across(one.normal) || !across(other.normal) || !is_opposite {
                "the two cuts are not the two ends across the axis of the cylinder".into()
            } else if upper.point[1] <= lower.point[1] {
                "the two cuts leave nothing of the cylinder".into()
            } else {
                return Ok(());
            }
        }
        cuts => format!(
            "{} cuts, and the processor \"paraboloid\" draws a cylinder with its two ends",
            cuts.len()
        ),
    };
    let accepted = "exactly two cuts with normals [0, 1, 0] and, below it, [0, -1, 0] are needed";
    let place = format_args!("{place}, cuts");
    Err(SceneError::value(place, problem, accepted))
}

fn check_curved_facet(place: Arguments, object: &Object) -> Checked {
    require_mode(place, object, Surface::Patch)?;
    if let Shape::Sphere { .. } = object.shape {
        let problem =
            "the processor \"curved_facet\" draws a sphere whole, its outline is its only side";
        refuse_cuts(place, object, problem)?;
        let round = keeps_spheres(&Transform::placement(&object.place));
        return require_round(place, round, "sphere is no longer a sphere");
    }
    let count = object.cuts.len();
    let (key, problem) = (format_args!("{place}, cuts"), format_args!("{count} cuts"));
    let accepted = format_args!("the processor \"curved_facet\" has at most {MOST_SIDES} sides");
    unless(count <= MOST_SIDES as usize, key, problem, accepted)
}
