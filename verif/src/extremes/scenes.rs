//! Extremes of whole scenes; each stands in `scenes/extremes/` under its name and can be drawn from there too.

use super::pictures::Pictures;
use super::{Case, Extreme};

macro_rules! text {
    ($name:literal) => {
        include_str!(concat!("../../../scenes/extremes/", $name, ".toml"))
    };
}

pub const CASES: &[Extreme] = &[
    Extreme {
        name: "eye-on-quadric",
        item: "17.1",
        outcome: "With the eye on the shell the factor of z^2 is zero: the depth is one quotient and no root, by the quotient processor of the golden model.",
        case: Case::Modelled {
            text: text!("eye-on-quadric"),
            claim: |p| some("pixels of the shell", p.frame.covered()),
        },
    },
    Extreme {
        name: "eye-barely-outside",
        item: "17.1",
        outcome: "A hundredth of a pixel from the surface one of two depths leaves every word, and f2 would need 79 bits: the depth is a quotient with a root in its denominator.",
        case: Case::Modelled {
            text: text!("eye-barely-outside"),
            claim: |p| count("covered pixels", p.frame.covered(), p.pixels()),
        },
    },
    Extreme {
        name: "eye-barely-inside",
        item: "17.1",
        outcome: "The same from the other side.",
        case: Case::Modelled {
            text: text!("eye-barely-inside"),
            claim: |p| count("covered pixels", p.frame.covered(), p.pixels()),
        },
    },
    Extreme {
        name: "eye-inside-solid",
        item: "17.1",
        outcome: "The ball is open at the near end, which lies within it: a cap, face 15, at every pixel.",
        case: Case::Drawn {
            text: text!("eye-inside-solid"),
            claim: |p| count("pixels of the cap", p.pixels_of_face(15), p.pixels()),
        },
    },
    Extreme {
        name: "behind-the-eye",
        item: "17.4",
        outcome: "Nothing is drawn, and a note says that the whole object lies behind the viewer.",
        case: Case::Drawn {
            text: text!("behind-the-eye"),
            claim: |p| count("covered pixels", p.frame.covered(), 0),
        },
    },
    Extreme {
        name: "axis-too-nearly-along-the-ray",
        item: "13.8",
        outcome: "The ends of the cylinder lie beyond the range that is asked for, and f2 would need 54 bits: the range grows by the power of two that it takes.",
        case: Case::Drawn {
            text: text!("axis-too-nearly-along-the-ray"),
            claim: |p| some("pixels of the rod", p.frame.covered()),
        },
    },
    Extreme {
        name: "paraboloid-along-its-axis",
        item: "17.8",
        outcome: "In parallel projection each line of sight meets the paraboloid once: the depth is one quotient and no root, by the quotient processor of the golden model.",
        case: Case::Modelled {
            text: text!("paraboloid-along-its-axis"),
            claim: |p| some("pixels of the bowl", p.frame.covered()),
        },
    },
    Extreme {
        name: "eye-on-apex",
        item: "17.2",
        outcome: "Nothing is drawn: from its apex a cone is seen edge-on everywhere.",
        case: Case::Drawn {
            text: text!("eye-on-apex"),
            claim: |p| count("covered pixels", p.frame.covered(), 0),
        },
    },
    Extreme {
        name: "through-the-near-end",
        item: "17.4",
        outcome: "The ball covers the screen but comes nearer than the near end that the file names: a flat cap, face 15, is drawn at the near end.",
        case: Case::Drawn {
            text: text!("through-the-near-end"),
            claim: |p| count("pixels of the cap", p.pixels_of_face(15), p.pixels()),
        },
    },
    Extreme {
        name: "to-infinity",
        item: "17.4",
        outcome: "An endless cylinder ends in the vanishing point: its depth goes to the far end, which counts as absent, and no point behind the eye is drawn.",
        case: Case::Drawn {
            text: text!("to-infinity"),
            claim: |p| some("pixels of the cylinder", p.frame.covered()),
        },
    },
    Extreme {
        name: "parabola-past-the-eye",
        item: "17.8",
        outcome: "The bowl covers every pixel; the wall behind the eye, which the quadric has too, is not drawn.",
        case: Case::Drawn {
            text: text!("parabola-past-the-eye"),
            claim: |p| count("covered pixels", p.frame.covered(), p.pixels()),
        },
    },
    Extreme {
        name: "axis-almost-along-the-ray",
        item: "13.8",
        outcome: "A slope of 2^10 between f1 and the pixels still fits the linear word: the rod is drawn within its bounds.",
        case: Case::Drawn {
            text: text!("axis-almost-along-the-ray"),
            claim: |p| some("pixels of the rod", p.frame.covered()),
        },
    },
    Extreme {
        name: "axis-along-the-ray",
        item: "13.8",
        outcome: "Seen end-on the cylinder is a prism: present where f2 >= 0, all of it the front cut, face 2.",
        case: Case::Drawn {
            text: text!("axis-along-the-ray"),
            claim: |p| {
                count(
                    "pixels of the front cut",
                    p.pixels_of_face(2),
                    p.frame.covered(),
                )
            },
        },
    },
    Extreme {
        name: "paraboloid-along-its-axis-in-perspective",
        item: "17.8",
        outcome: "In perspective only one line of sight is parallel to the axis, and the depth is a square root.",
        case: Case::Drawn {
            text: text!("paraboloid-along-its-axis-in-perspective"),
            claim: |p| some("pixels of the bowl", p.frame.covered()),
        },
    },
    Extreme {
        name: "f2-zero-everywhere",
        item: "17.2",
        outcome: "A double plane: f2 is zero at every pixel, front and back coincide, and zero is inside, so every pixel is covered.",
        case: Case::Drawn {
            text: text!("f2-zero-everywhere"),
            claim: |p| count("covered pixels", p.frame.covered(), p.pixels()),
        },
    },
    Extreme {
        name: "apex-on-a-pixel",
        item: "17.2",
        outcome: "At the apex f2 is zero and the pixel is covered; the normal has no direction there and is (0, 0, 0).",
        case: Case::Drawn {
            text: text!("apex-on-a-pixel"),
            claim: |p| match p.id(32, 24) {
                Some(_) => Ok(()),
                None => Err("the apex is missing".into()),
            },
        },
    },
    Extreme {
        name: "apex-between-pixels",
        item: "17.2",
        outcome: "The apex falls between the pixels: the cone is drawn as two parts, none of them wrong.",
        case: Case::Drawn {
            text: text!("apex-between-pixels"),
            claim: |p| some("pixels of the cone", p.frame.covered()),
        },
    },
    Extreme {
        name: "f2-beyond-its-word",
        item: "17.3",
        outcome: "Beyond sqrt(2) D from the ball f2 passes -2^47 and its word comes back positive; the screen box keeps the object absent there.",
        case: Case::Drawn {
            text: text!("f2-beyond-its-word"),
            claim: |p| match (0..p.frame.height)
                .flat_map(|y| (320..720).map(move |x| (x, y)))
                .find(|&(x, y)| p.id(x, y).is_some())
            {
                Some(place) => Err(format!("a ghost at {place:?}")),
                None => some("pixels of the ball", p.frame.covered()),
            },
        },
    },
    Extreme {
        name: "nearest-viewer",
        item: "17.4",
        outcome: "At 200 pixels from the viewer the depth word has 41 943 steps to the pixel.",
        case: Case::Drawn {
            text: text!("nearest-viewer"),
            claim: |p| some("pixels of the ball", p.frame.covered()),
        },
    },
    Extreme {
        name: "farthest-viewer",
        item: "17.4",
        outcome: "At 10 000 pixels from the viewer the depth word has 839 steps to the pixel; the silhouette is still exact.",
        case: Case::Drawn {
            text: text!("farthest-viewer"),
            claim: |p| count("covered pixels", p.frame.covered(), p.exactly_covered()),
        },
    },
    Extreme {
        name: "plane-through-the-eye",
        item: "17.5",
        outcome: "A plane that contains the eye has no depth: it is taken as a half-plane, and its own column stays.",
        case: Case::Drawn {
            text: text!("plane-through-the-eye"),
            claim: |p| half(p, 32),
        },
    },
    Extreme {
        name: "plane-nearly-through-the-eye",
        item: "17.5",
        outcome: "The depth of the plane would leave its word; its half-plane form is proven equal on every pixel and used.",
        case: Case::Drawn {
            text: text!("plane-nearly-through-the-eye"),
            claim: |p| half(p, 32),
        },
    },
    Extreme {
        name: "plane-too-steep",
        item: "17.5",
        outcome: "Drawn here because the box is small; a larger ball with the same cut is refused, as tests of the preparation show.",
        case: Case::Drawn {
            text: text!("plane-too-steep"),
            claim: |p| half(p, 32),
        },
    },
    Extreme {
        name: "plane-along-the-ray",
        item: "17.5",
        outcome: "Parallel to the lines of sight the plane is a half-plane: nothing is left of the other side.",
        case: Case::Drawn {
            text: text!("plane-along-the-ray"),
            claim: |p| half(p, 32),
        },
    },
    Extreme {
        name: "polar-plane",
        item: "17.5",
        outcome: "The plane through the silhouette has the depth f1 itself: only the flat face, face 2, is seen.",
        case: Case::Drawn {
            text: text!("polar-plane"),
            claim: |p| count("pixels of the cut", p.pixels_of_face(2), p.frame.covered()),
        },
    },
    Extreme {
        name: "tangent-plane-keeps-all",
        item: "17.5",
        outcome: "A tangent plane that keeps the ball changes nothing.",
        case: Case::Drawn {
            text: text!("tangent-plane-keeps-all"),
            claim: |p| count("pixels of the cut", p.pixels_of_face(2), 0),
        },
    },
    Extreme {
        name: "tangent-plane-removes-all",
        item: "17.5",
        outcome: "What is left is one point, and it may be drawn or not: no pixel beside it is.",
        case: Case::Drawn {
            text: text!("tangent-plane-removes-all"),
            claim: |p| match p.frame.covered() {
                0 | 1 => Ok(()),
                more => Err(format!("{more} pixels of one point")),
            },
        },
    },
    Extreme {
        name: "plane-through-the-apex",
        item: "17.5",
        outcome: "The plane holds the apex: both sides of the cone are cut along their length.",
        case: Case::Drawn {
            text: text!("plane-through-the-apex"),
            claim: |p| some("pixels of the cut", p.pixels_of_face(2)),
        },
    },
    Extreme {
        name: "planes-without-thickness",
        item: "17.5",
        outcome: "Two equal planes of opposite sense leave a disc: closed tests keep the points on both.",
        case: Case::Drawn {
            text: text!("planes-without-thickness"),
            claim: |p| {
                some(
                    "pixels of the disc",
                    p.pixels_of_face(2) + p.pixels_of_face(3),
                )
            },
        },
    },
    Extreme {
        name: "planes-that-leave-nothing",
        item: "17.5",
        outcome: "A hundredth of a pixel apart they leave nothing, and nothing is drawn.",
        case: Case::Drawn {
            text: text!("planes-that-leave-nothing"),
            claim: |p| count("covered pixels", p.frame.covered(), 0),
        },
    },
    Extreme {
        name: "vanishing-line-in-the-box",
        item: "17.5",
        outcome: "On both sides of its vanishing line the depth of the plane runs over its word: it is clamped, keeps its sign, and cuts.",
        case: Case::Drawn {
            text: text!("vanishing-line-in-the-box"),
            claim: |p| some("pixels of the ball", p.frame.covered()),
        },
    },
    Extreme {
        name: "shared-plane",
        item: "17.13",
        outcome: "The two halves leave no gap: every pixel that the whole ball would cover is covered, those of the seam by either half.",
        case: Case::Drawn {
            text: text!("shared-plane"),
            claim: |p| count("covered pixels", p.frame.covered(), p.exactly_covered()),
        },
    },
    Extreme {
        name: "coincident-patches",
        item: "17.13",
        outcome: "Of two equal depths the smaller object index wins at every pixel, so the second object is nowhere seen.",
        case: Case::Drawn {
            text: text!("coincident-patches"),
            claim: |p| {
                count("pixels of the second", p.pixels_of(1), 0)
                    .and_then(|()| some("pixels of the first", p.pixels_of(0)))
            },
        },
    },
    Extreme {
        name: "one-pixel",
        item: "17.7",
        outcome: "A ball that holds one pixel centre draws one pixel.",
        case: Case::Drawn {
            text: text!("one-pixel"),
            claim: |p| count("covered pixels", p.frame.covered(), 1),
        },
    },
    Extreme {
        name: "between-pixels",
        item: "17.7",
        outcome: "A ball between the pixel centres draws none; a picture is sampled at the centres.",
        case: Case::Drawn {
            text: text!("between-pixels"),
            claim: |p| count("covered pixels", p.frame.covered(), 0),
        },
    },
    Extreme {
        name: "whole-screen",
        item: "17.7",
        outcome: "Every pixel is covered.",
        case: Case::Drawn {
            text: text!("whole-screen"),
            claim: |p| count("covered pixels", p.frame.covered(), p.pixels()),
        },
    },
    Extreme {
        name: "off-the-screen",
        item: "17.7",
        outcome: "Nothing is drawn, and that is no error.",
        case: Case::Drawn {
            text: text!("off-the-screen"),
            claim: |p| count("covered pixels", p.frame.covered(), 0),
        },
    },
    Extreme {
        name: "partly-left",
        item: "17.7",
        outcome: "The coefficients of the middle of the ball lie left of the first column; what is on the screen is exact.",
        case: Case::Drawn {
            text: text!("partly-left"),
            claim: |p| count("covered pixels", p.frame.covered(), p.exactly_covered()),
        },
    },
    Extreme {
        name: "far-away-offset",
        item: "13.8",
        outcome: "The quadric is moved in exact fractions before its coefficients are formed, so 70 m of offset cost nothing and the larger ball is nearer.",
        case: Case::Drawn {
            text: text!("far-away-offset"),
            claim: |p| nearer(p, (24, 24), (72, 24)),
        },
    },
    Extreme {
        name: "flat-as-a-leaf",
        item: "17.9",
        outcome: "Scaled by 1 : 10^6 the solid is thinner than a depth word and its f2 rounds to zero: hardware and golden model agree, but the picture is not the exact one, and check fails and names the object.",
        case: Case::Flagged {
            text: text!("flat-as-a-leaf"),
        },
    },
    Extreme {
        name: "mirrored",
        item: "17.9",
        outcome: "A mirror exchanges left and right, not the kept and the removed side: column 32 - k equals column 32 + k.",
        case: Case::Drawn {
            text: text!("mirrored"),
            claim: mirrored,
        },
    },
    Extreme {
        name: "between-two-sheets",
        item: "17.8",
        outcome: "The near sheet is drawn; the sheet behind the eye, the other root, is not.",
        case: Case::Drawn {
            text: text!("between-two-sheets"),
            claim: |p| count("covered pixels", p.frame.covered(), p.pixels()),
        },
    },
    Extreme {
        name: "inside-where-f2-is-negative",
        item: "17.8",
        outcome: "Around the axis f2 < 0 means wholly inside, not absent: the cap has no hole.",
        case: Case::Drawn {
            text: text!("inside-where-f2-is-negative"),
            claim: |p| match p.id(32, 24) {
                Some(_) => count("pixels of the cap", p.pixels_of_face(2), p.frame.covered()),
                None => Err("there is a hole".into()),
            },
        },
    },
    Extreme {
        name: "long-line",
        item: "17.11",
        outcome: "Across 1024 columns the coefficient errors add up to at most half a word a column from the middle, and the bounds hold.",
        case: Case::Drawn {
            text: text!("long-line"),
            claim: |p| count("covered pixels", p.frame.covered(), p.pixels()),
        },
    },
    Extreme {
        name: "sixteen-lights",
        item: "17.14",
        outcome: "All sixteen sources are accepted; a seventeenth is refused with the limit.",
        case: Case::Drawn {
            text: text!("sixteen-lights"),
            claim: |p| some("pixels of the ball", p.frame.covered()),
        },
    },
];

fn count(what: &str, found: usize, expected: usize) -> Result<(), String> {
    if found == expected {
        Ok(())
    } else {
        Err(format!("{found} {what}, expected {expected}"))
    }
}

fn some(what: &str, found: usize) -> Result<(), String> {
    if found > 0 {
        Ok(())
    } else {
        Err(format!("no {what}"))
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
    if depth(one) < depth(other) {
        Ok(())
    } else {
        Err(format!(
            "depth {} at {one:?}, {} at {other:?}",
            depth(one),
            depth(other)
        ))
    }
}

fn mirrored(p: &Pictures) -> Result<(), String> {
    let middle = p.frame.width / 2;
    let depth = |x: usize, y: usize| p.frame.depth[y * p.frame.width + x];
    for y in 0..p.frame.height {
        for k in 1..middle {
            if depth(middle - k, y) != depth(middle + k, y) {
                return Err(format!(
                    "line {y}: columns {} and {} differ",
                    middle - k,
                    middle + k
                ));
            }
        }
    }
    some("pixels", p.frame.covered())
}
