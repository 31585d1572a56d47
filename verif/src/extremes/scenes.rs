//! Extremes of whole scenes; each stands in `scenes/extremes/` under its name and can be drawn from there too.

use super::pictures::Pictures;
use super::{Case, Extreme};

/// What is done with a scene, its item, its name, what its picture must show, and what happens.
macro_rules! scene {
    ($case:ident, $item:literal, $name:literal, $($claim:expr,)? => $outcome:literal) => {
        Extreme {
            name: $name,
            item: $item,
            outcome: $outcome,
            case: Case::$case(
                include_str!(concat!("../../../scenes/extremes/", $name, ".toml")),
                $($claim)?
            ),
        }
    };
}

#[rustfmt::skip]
pub const CASES: &[Extreme] = &[
    scene!(Drawn, "17.1", "eye-on-quadric", |p| some("pixels of the shell", p.frame.covered()),
        => "With the eye on the shell the factor of z^2 is zero: the depth is one quotient and no root."),
    scene!(Modelled, "17.1", "eye-barely-outside", |p| count("covered pixels", p.frame.covered(), p.pixels()),
        => "A hundredth of a pixel from the surface one of two depths leaves every word, and f2 would need 79 bits: the depth is a quotient with a root in its denominator."),
    scene!(Modelled, "17.1", "eye-barely-inside", |p| count("covered pixels", p.frame.covered(), p.pixels()),
        => "The same from the other side."),
    scene!(Drawn, "17.1", "eye-inside-solid", |p| count("pixels of the cap", p.pixels_of_face(15), p.pixels()),
        => "The ball is open at the near end, which lies within it: a cap, face 15, at every pixel."),
    scene!(Drawn, "17.4", "behind-the-eye", |p| count("covered pixels", p.frame.covered(), 0),
        => "Nothing is drawn, and a note says that the whole object lies behind the viewer."),
    scene!(Drawn, "13.8", "axis-too-nearly-along-the-ray", |p| some("pixels of the rod", p.frame.covered()),
        => "The ends of the cylinder lie beyond the range that is asked for, and f2 would need 54 bits: the range grows by the power of two that it takes."),
    scene!(Drawn, "17.8", "paraboloid-along-its-axis", |p| some("pixels of the bowl", p.frame.covered()),
        => "In parallel projection each line of sight meets the paraboloid once: the depth is one quotient and no root."),
    scene!(Drawn, "17.2", "eye-on-apex", |p| count("covered pixels", p.frame.covered(), 0),
        => "Nothing is drawn: from its apex a cone is seen edge-on everywhere."),
    scene!(Drawn, "17.4", "through-the-near-end", |p| count("pixels of the cap", p.pixels_of_face(15), p.pixels()),
        => "The ball covers the screen but comes nearer than the near end that the file names: a flat cap, face 15, is drawn at the near end."),
    scene!(Drawn, "17.4", "to-infinity", |p| some("pixels of the cylinder", p.frame.covered()),
        => "An endless cylinder ends in the vanishing point: its depth goes to the far end, which counts as absent, and no point behind the eye is drawn."),
    scene!(Drawn, "17.8", "parabola-past-the-eye", |p| count("covered pixels", p.frame.covered(), p.pixels()),
        => "The bowl covers every pixel; the wall behind the eye, which the quadric has too, is not drawn."),
    scene!(Drawn, "13.8", "axis-almost-along-the-ray", |p| some("pixels of the rod", p.frame.covered()),
        => "A slope of 2^10 between f1 and the pixels still fits the linear word: the rod is drawn within its bounds."),
    scene!(Drawn, "13.8", "axis-along-the-ray", |p| count("pixels of the front cut", p.pixels_of_face(2), p.frame.covered()),
        => "Seen end-on the cylinder is a prism: present where f2 >= 0, all of it the front cut, face 2."),
    scene!(Drawn, "17.8", "paraboloid-along-its-axis-in-perspective", |p| some("pixels of the bowl", p.frame.covered()),
        => "In perspective only one line of sight is parallel to the axis, and the depth is a square root."),
    scene!(Drawn, "17.2", "f2-zero-everywhere", |p| count("covered pixels", p.frame.covered(), p.pixels()),
        => "A double plane: f2 is zero at every pixel, front and back coincide, and zero is inside, so every pixel is covered."),
    scene!(Drawn, "17.2", "apex-on-a-pixel", |p| p.id(32, 24).map(|_| ()).ok_or("the apex is missing".into()),
        => "At the apex f2 is zero and the pixel is covered; the normal has no direction there and is (0, 0, 0)."),
    scene!(Drawn, "17.2", "apex-between-pixels", |p| some("pixels of the cone", p.frame.covered()),
        => "The apex falls between the pixels: the cone is drawn as two parts, none of them wrong."),
    scene!(Drawn, "17.3", "f2-beyond-its-word", no_ghost,
        => "Beyond sqrt(2) D from the ball f2 passes -2^47 and its word comes back positive; the screen box keeps the object absent there."),
    scene!(Drawn, "17.4", "nearest-viewer", |p| some("pixels of the ball", p.frame.covered()),
        => "At 200 pixels from the viewer the depth word has 41 943 steps to the pixel."),
    scene!(Drawn, "17.4", "farthest-viewer", |p| count("covered pixels", p.frame.covered(), p.exactly_covered()),
        => "At 10 000 pixels from the viewer the depth word has 839 steps to the pixel; the silhouette is still exact."),
    scene!(Drawn, "17.5", "plane-through-the-eye", |p| half(p, 32),
        => "A plane that contains the eye has no depth: it is taken as a half-plane, and its own column stays."),
    scene!(Drawn, "17.5", "plane-nearly-through-the-eye", |p| half(p, 32),
        => "The depth of the plane would leave its word; its half-plane form is proven equal on every pixel and used."),
    scene!(Drawn, "17.5", "plane-too-steep", |p| half(p, 32),
        => "Drawn here because the box is small; a larger ball with the same cut is refused, as tests of the preparation show."),
    scene!(Drawn, "17.5", "plane-along-the-ray", |p| half(p, 32),
        => "Parallel to the lines of sight the plane is a half-plane: nothing is left of the other side."),
    scene!(Drawn, "17.5", "polar-plane", |p| count("pixels of the cut", p.pixels_of_face(2), p.frame.covered()),
        => "The plane through the silhouette has the depth f1 itself: only the flat face, face 2, is seen."),
    scene!(Drawn, "17.5", "tangent-plane-keeps-all", |p| count("pixels of the cut", p.pixels_of_face(2), 0),
        => "A tangent plane that keeps the ball changes nothing."),
    scene!(Drawn, "17.5", "tangent-plane-removes-all", at_most_a_point,
        => "What is left is one point, and it may be drawn or not: no pixel beside it is."),
    scene!(Drawn, "17.5", "plane-through-the-apex", |p| some("pixels of the cut", p.pixels_of_face(2)),
        => "The plane holds the apex: both sides of the cone are cut along their length."),
    scene!(Drawn, "17.5", "planes-without-thickness", |p| some("pixels of the disc", p.pixels_of_face(2) + p.pixels_of_face(3)),
        => "Two equal planes of opposite sense leave a disc: closed tests keep the points on both."),
    scene!(Drawn, "17.5", "planes-that-leave-nothing", |p| count("covered pixels", p.frame.covered(), 0),
        => "A hundredth of a pixel apart they leave nothing, and nothing is drawn."),
    scene!(Drawn, "17.5", "vanishing-line-in-the-box", |p| some("pixels of the ball", p.frame.covered()),
        => "On both sides of its vanishing line the depth of the plane runs over its word: it is clamped, keeps its sign, and cuts."),
    scene!(Drawn, "17.13", "shared-plane", |p| count("covered pixels", p.frame.covered(), p.exactly_covered()),
        => "The two halves leave no gap: every pixel that the whole ball would cover is covered, those of the seam by either half."),
    scene!(Drawn, "17.13", "coincident-patches", first_alone,
        => "Of two equal depths the smaller object index wins at every pixel, so the second object is nowhere seen."),
    scene!(Drawn, "17.7", "one-pixel", |p| count("covered pixels", p.frame.covered(), 1),
        => "A ball that holds one pixel centre draws one pixel."),
    scene!(Drawn, "17.7", "between-pixels", |p| count("covered pixels", p.frame.covered(), 0),
        => "A ball between the pixel centres draws none; a picture is sampled at the centres."),
    scene!(Drawn, "17.7", "whole-screen", |p| count("covered pixels", p.frame.covered(), p.pixels()),
        => "Every pixel is covered."),
    scene!(Drawn, "17.7", "off-the-screen", |p| count("covered pixels", p.frame.covered(), 0),
        => "Nothing is drawn, and that is no error."),
    scene!(Drawn, "17.7", "partly-left", |p| count("covered pixels", p.frame.covered(), p.exactly_covered()),
        => "The coefficients of the middle of the ball lie left of the first column; what is on the screen is exact."),
    scene!(Drawn, "13.8", "far-away-offset", |p| nearer(p, (24, 24), (72, 24)),
        => "The quadric is moved in exact fractions before its coefficients are formed, so 70 m of offset cost nothing and the larger ball is nearer."),
    scene!(Flagged, "17.9", "flat-as-a-leaf",
        => "Scaled by 1 : 10^6 the solid is thinner than a depth word and its f2 rounds to zero: hardware and golden model agree, but the picture is not the exact one, and check fails and names the object."),
    scene!(Drawn, "17.9", "mirrored", mirrored,
        => "A mirror exchanges left and right, not the kept and the removed side: column 32 - k equals column 32 + k."),
    scene!(Drawn, "17.8", "between-two-sheets", |p| count("covered pixels", p.frame.covered(), p.pixels()),
        => "The near sheet is drawn; the sheet behind the eye, the other root, is not."),
    scene!(Drawn, "17.8", "inside-where-f2-is-negative", no_hole,
        => "Around the axis f2 < 0 means wholly inside, not absent: the cap has no hole."),
    scene!(Drawn, "17.11", "long-line", |p| count("covered pixels", p.frame.covered(), p.pixels()),
        => "Across 1024 columns the coefficient errors add up to at most half a word a column from the middle, and the bounds hold."),
    scene!(Drawn, "17.14", "sixteen-lights", |p| some("pixels of the ball", p.frame.covered()),
        => "All sixteen sources are accepted; a seventeenth is refused with the limit."),
];

fn no_ghost(p: &Pictures) -> Result<(), String> {
    let mut places = (0..p.frame.height).flat_map(|y| (320..720).map(move |x| (x, y)));
    match places.find(|&(x, y)| p.id(x, y).is_some()) {
        Some(place) => Err(format!("a ghost at {place:?}")),
        None => some("pixels of the ball", p.frame.covered()),
    }
}

fn at_most_a_point(p: &Pictures) -> Result<(), String> {
    match p.frame.covered() {
        0 | 1 => Ok(()),
        more => Err(format!("{more} pixels of one point")),
    }
}

fn first_alone(p: &Pictures) -> Result<(), String> {
    count("pixels of the second", p.pixels_of(1), 0)?;
    some("pixels of the first", p.pixels_of(0))
}

fn no_hole(p: &Pictures) -> Result<(), String> {
    p.id(32, 24).ok_or("there is a hole")?;
    count("pixels of the cap", p.pixels_of_face(2), p.frame.covered())
}

fn count(what: &str, found: usize, expected: usize) -> Result<(), String> {
    match found == expected {
        true => Ok(()),
        false => Err(format!("{found} {what}, expected {expected}")),
    }
}

fn some(what: &str, found: usize) -> Result<(), String> {
    match found {
        0 => Err(format!("no {what}")),
        _ => Ok(()),
    }
}

/// The ball is there up to a column and nowhere behind it.
fn half(p: &Pictures, last: usize) -> Result<(), String> {
    let middle = p.frame.height / 2;
    match (p.id(last, middle), p.id(last + 1, middle)) {
        (Some(_), None) => Ok(()),
        found => Err(format!("columns {last} and {}: {found:?}", last + 1)),
    }
}

fn nearer(p: &Pictures, one: (usize, usize), other: (usize, usize)) -> Result<(), String> {
    let depth = |(x, y): (usize, usize)| p.frame.depth[y * p.frame.width + x];
    match (depth(one), depth(other)) {
        (near, far) if near < far => Ok(()),
        (near, far) => Err(format!("depth {near} at {one:?}, {far} at {other:?}")),
    }
}

fn mirrored(p: &Pictures) -> Result<(), String> {
    let middle = p.frame.width / 2;
    let depth = |x: usize, y: usize| p.frame.depth[y * p.frame.width + x];
    for y in 0..p.frame.height {
        for k in 1..middle {
            let (left, right) = (middle - k, middle + k);
            if depth(left, y) != depth(right, y) {
                return Err(format!("line {y}: columns {left} and {right} differ"));
            }
        }
    }
    some("pixels", p.frame.covered())
}
