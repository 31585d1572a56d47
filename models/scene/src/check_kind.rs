//! The checks of what an object's kind and its processor ask for.

use super::check::{Checked, check_direction, check_numbers};
use super::error::SceneError;
use super::file::{Camera, Mesh, Object, Processor, Shape, Surface};
use super::mesh::face;
use super::round::{keeps_spheres, makes_circular_cylinder};
use super::tetrahedron::implicit;
use super::transform::Transform;
use imogene_algebra::rational::from_decimal;
use imogene_golden::object::curved_facet::MAX_SIDES;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::collections::HashSet;

/// Refuses an object whose numbers are in order and whose kind or processor cannot be had with them.
pub(super) fn check_kind(place: &str, object: &Object, camera: &Camera) -> Checked {
    match &object.shape {
        Shape::Polyhedron => check_polyhedron(place, object),
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

fn wrong_processor(place: &str, object: &Object, problem: &str, accepted: &str) -> SceneError {
    let name = object.processor.map_or("", Processor::name);
    SceneError::value(
        format!("{place}, processor"),
        format!("\"{name}\" {problem}"),
        accepted,
    )
}

fn without_choice(place: &str, object: &Object, owner: &str) -> Checked {
    match object.processor {
        None => Ok(()),
        Some(_) => Err(wrong_processor(
            place,
            object,
            &format!("does not draw {owner}, which has a processor of its own"),
            "no `processor` is needed",
        )),
    }
}

fn check_polyhedron(place: &str, object: &Object) -> Checked {
    without_choice(place, object, "a polyhedron")?;
    if object.cuts.is_empty() {
        return Err(SceneError::value(
            format!("{place}, cuts"),
            "a polyhedron without cuts has no face",
            "1 to 12 cuts, the planes of its faces, are needed",
        ));
    }
    Ok(())
}

fn check_mesh(place: &str, object: &Object, mesh: &Mesh) -> Checked {
    without_choice(place, object, "a mesh")?;
    refuse_cuts(place, object, "a mesh cannot be cut")?;
    let count = mesh.vertices.len();
    if count < 3 {
        return Err(SceneError::value(
            format!("{place}, vertices"),
            format!("vertices: {count}, which make no facet"),
            "at least three are needed",
        ));
    }
    if mesh.faces.is_empty() {
        return Err(SceneError::value(
            format!("{place}, faces"),
            "the mesh has no face",
            "at least one [i, j, k] or [i, j, k, l] is needed",
        ));
    }
    for (index, vertex) in mesh.vertices.iter().enumerate() {
        check_numbers(&format!("{place}, vertices[{index}]"), vertex)?;
    }
    if !mesh.normals.is_empty() && mesh.normals.len() != count {
        return Err(SceneError::value(
            format!("{place}, normals"),
            format!("{} normals for {count} vertices", mesh.normals.len()),
            "one normal for each vertex is needed, or no `normals` for flat facets",
        ));
    }
    for (index, normal) in mesh.normals.iter().enumerate() {
        check_direction(&format!("{place}, normals[{index}]"), *normal)?;
    }
    let vertices: Vec<[BigRational; 3]> =
        mesh.vertices.iter().map(|v| v.map(from_decimal)).collect();
    for (index, corners) in mesh.faces.iter().enumerate() {
        check_face(&format!("{place}, faces[{index}]"), corners, &vertices)?;
    }
    Ok(())
}

fn check_face(place: &str, corners: &[usize], vertices: &[[BigRational; 3]]) -> Checked {
    let refuse = |problem: String, accepted: &str| {
        Err(SceneError::value(
            place,
            format!("{corners:?} {problem}"),
            accepted,
        ))
    };
    if !(3..=4).contains(&corners.len()) {
        return refuse(
            format!("has {} corners", corners.len()),
            "a face has three or four",
        );
    }
    if let Some(index) = corners.iter().find(|index| **index >= vertices.len()) {
        return refuse(
            format!("names vertex {index}"),
            &format!("the mesh has vertices 0 to {}", vertices.len() - 1),
        );
    }
    if corners.iter().collect::<HashSet<_>>().len() < corners.len() {
        return refuse(
            "names a vertex twice".into(),
            "different vertices are needed",
        );
    }
    if face(vertices, corners).is_none() {
        return refuse(
            "has no area: its corners lie in a line, or its sides cross".into(),
            "corners that go round an area are needed",
        );
    }
    Ok(())
}

fn check_tetrahedron(
    place: &str,
    object: &Object,
    corners: &[[f64; 3]; 4],
    weights: &[f64; 10],
) -> Checked {
    refuse_cuts(
        place,
        object,
        "the faces of the tetrahedron are the cuts of this kind",
    )?;
    for (index, corner) in corners.iter().enumerate() {
        check_numbers(&format!("{place}, corners[{index}]"), corner)?;
    }
    check_numbers(&format!("{place}, weights"), weights)?;
    if !matches!(
        object.processor,
        None | Some(Processor::Patch | Processor::Quadric)
    ) {
        return Err(wrong_processor(
            place,
            object,
            "does not draw a tetrahedral patch",
            "\"patch\" (default) and \"quadric\" do",
        ));
    }
    let Some((quadric, _)) = implicit(corners, weights) else {
        return Err(SceneError::value(
            format!("{place}, corners"),
            "the four corners lie in one plane",
            "corners of a tetrahedron with a volume are needed",
        ));
    };
    if quadric.coefficients()[..6].iter().all(|v| v.is_zero()) {
        return Err(SceneError::value(
            format!("{place}, weights"),
            "the weights make a plane, or nothing",
            "weights whose patch is of second degree are needed",
        ));
    }
    Ok(())
}

fn refuse_cuts(place: &str, object: &Object, problem: &str) -> Checked {
    if object.cuts.is_empty() {
        return Ok(());
    }
    Err(SceneError::value(
        format!("{place}, cuts"),
        problem,
        "no `cuts` are possible",
    ))
}

fn require_mode(place: &str, object: &Object, wanted: Surface) -> Checked {
    if object.mode == wanted {
        return Ok(());
    }
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
    Err(wrong_processor(place, object, problem, accepted))
}

fn require_parallel_view(place: &str, object: &Object, camera: &Camera) -> Checked {
    match camera {
        Camera::Orthographic { .. } => Ok(()),
        Camera::Perspective { .. } => Err(wrong_processor(
            place,
            object,
            "does not draw in perspective",
            "`kind = \"orthographic\"` in `[camera]`, or the processor \"quadric\", would be accepted",
        )),
    }
}

fn check_first_generation(place: &str, object: &Object) -> Checked {
    let accepted =
        "exactly two parallel cuts, with normals that point away from each other, are needed";
    let refuse = |problem: String| {
        Err(SceneError::value(
            format!("{place}, cuts"),
            problem,
            accepted,
        ))
    };
    let [one, other] = object.cuts.as_slice() else {
        return refuse(format!(
            "{} cuts, and the processor \"first_generation\" has two planes",
            object.cuts.len()
        ));
    };
    let [u, v] = [one, other].map(|cut| cut.normal.map(from_decimal));
    let parallel = (0..3).all(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &u[i] * &v[j] == &u[j] * &v[i]
    });
    let along: BigRational = u.iter().zip(&v).map(|(a, b)| a * b).sum();
    if !parallel || !along.is_negative() {
        return refuse("the two cuts are not parallel with opposite normals".into());
    }
    Ok(())
}

fn check_paraboloid(place: &str, object: &Object) -> Checked {
    require_mode(place, object, Surface::Solid)?;
    let placed = Transform::placement(&object.place);
    match object.shape {
        Shape::Sphere { .. } => {
            refuse_cuts(
                place,
                object,
                "the processor \"paraboloid\" does not cut a sphere",
            )?;
            require_round(
                place,
                keeps_spheres(&placed),
                "sphere",
                "no longer a sphere",
            )
        }
        Shape::EllipticCylinder { radii } => {
            check_discs(place, object)?;
            let round = makes_circular_cylinder(&placed, radii);
            require_round(place, round, "cylinder", "not a right circular cylinder")
        }
        _ => Err(wrong_processor(
            place,
            object,
            "draws spheres and circular cylinders only",
            "`kind = \"sphere\"` or `kind = \"elliptic_cylinder\"`, or the processor \"quadric\", would be accepted",
        )),
    }
}

fn require_round(place: &str, round: bool, what: &str, problem: &str) -> Checked {
    if round {
        return Ok(());
    }
    Err(SceneError::value(
        format!("{place}, place"),
        format!("the {what} is {problem} after these steps"),
        "scales that keep it round, or the processor \"quadric\", would be accepted",
    ))
}

/// Both ends of a cylinder: two cuts across the y axis, the lower one downwards.
fn check_discs(place: &str, object: &Object) -> Checked {
    let refuse = |problem: String| {
        Err(SceneError::value(
            format!("{place}, cuts"),
            problem,
            "exactly two cuts with normals [0, 1, 0] and, below it, [0, -1, 0] are needed",
        ))
    };
    let [one, other] = object.cuts.as_slice() else {
        return refuse(format!(
            "{} cuts, and the processor \"paraboloid\" draws a cylinder with its two ends",
            object.cuts.len()
        ));
    };
    let across = |normal: [f64; 3]| normal[0] == 0.0 && normal[2] == 0.0;
    if !across(one.normal) || !across(other.normal) || one.normal[1] * other.normal[1] >= 0.0 {
        return refuse("the two cuts are not the two ends across the axis of the cylinder".into());
    }
    let (upper, lower) = if one.normal[1] > 0.0 {
        (one, other)
    } else {
        (other, one)
    };
    if upper.point[1] <= lower.point[1] {
        return refuse("the two cuts leave nothing of the cylinder".into());
    }
    Ok(())
}

fn check_curved_facet(place: &str, object: &Object) -> Checked {
    require_mode(place, object, Surface::Patch)?;
    if let Shape::Sphere { .. } = object.shape {
        refuse_cuts(
            place,
            object,
            "the processor \"curved_facet\" draws a sphere whole, its outline is its only side",
        )?;
        let round = keeps_spheres(&Transform::placement(&object.place));
        return require_round(place, round, "sphere", "no longer a sphere");
    }
    if object.cuts.len() > MAX_SIDES {
        return Err(SceneError::value(
            format!("{place}, cuts"),
            format!("{} cuts", object.cuts.len()),
            format!("the processor \"curved_facet\" has at most {MAX_SIDES} sides"),
        ));
    }
    Ok(())
}
