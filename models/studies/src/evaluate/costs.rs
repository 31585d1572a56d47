//! Weighted operations of every step of the preparation, each found by running it.
//!
//! The numbers that the steps are run with are of no meaning: no step asks a question whose answer changes its cost, except where a function says so.

use super::count::{Counted, Counter, weighted};
use super::work::facet::{self, Contour, Corners};
use super::work::lighting::{Colours, Place, light, power};
use super::work::{frame, quadric, zones};

const MATRIX: [[f64; 4]; 4] = [
    [2.0, -1.0, 3.0, 5.0],
    [0.5, 4.0, 1.0, -2.0],
    [7.0, 1.0, -3.0, 6.0],
    [1.0, 0.25, 2.0, 3.0],
];
/// A sphere seen from the side, after perspective.
const QUADRIC: [f64; 10] = [
    1.0, 1.0, 1.7, 0.0, 0.02, -0.01, -20.0, 10.0, -380.0, 80_500.0,
];
const PLANE: [f64; 4] = [2.0, -4.0, -8.0, 16.0];
/// Its middle corner is left of the long side, so that two sides are followed on the left: the longer case.
const CORNERS: [[f64; 3]; 3] = [[10.0, 2.0, 7.0], [1.0, 9.0, -3.0], [12.0, 20.0, 11.0]];

fn matrix(counter: &Counter) -> frame::Matrix<'_> {
    MATRIX.map(|row| counter.numbers(row))
}

fn corners(counter: &Counter) -> Corners<'_> {
    CORNERS.map(|corner| counter.numbers(corner))
}

fn quantities(counter: &Counter) -> [[Counted<'_>; 3]; 3] {
    [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]].map(|w| counter.numbers(w))
}

fn followed_contour(counter: &Counter) -> Contour<'_> {
    facet::contour(corners(counter)).expect("the corners have an area")
}

/// What a step costs beside what it needs: its own work less the work of `before`.
fn beside(work: impl FnOnce(&Counter), before: f64) -> f64 {
    weighted(work) - before
}

/// Changes of frame.
pub mod change {
    use super::*;

    /// The product of two matrices.
    pub fn product() -> f64 {
        weighted(|c| {
            frame::product(&matrix(c), &matrix(c));
        })
    }

    /// The same if both leave the last coordinate alone.
    pub fn affine_product() -> f64 {
        weighted(|c| {
            frame::affine_product(&matrix(c), &matrix(c));
        })
    }

    /// A homogeneous image of a point.
    pub fn point() -> f64 {
        weighted(|c| {
            frame::point(&matrix(c), c.numbers([1.0, 2.0, 3.0]));
        })
    }

    /// A direction.
    pub fn direction() -> f64 {
        weighted(|c| {
            frame::direction(&matrix(c), c.numbers([1.0, 2.0, 3.0]));
        })
    }

    /// A point from its homogeneous image.
    pub fn divide() -> f64 {
        weighted(|c| {
            frame::divided(c.numbers([1.0, 2.0, 3.0, 4.0]));
        })
    }

    /// A plane under the cofactors.
    pub fn plane() -> f64 {
        weighted(|c| {
            frame::plane(&matrix(c), c.numbers(PLANE));
        })
    }

    /// Both products of a quadric, entry by entry.
    pub fn quadric_in_full() -> f64 {
        weighted(|c| {
            frame::quadric_in_full(&matrix(c), c.numbers(QUADRIC));
        })
    }

    /// The same, of the second only the ten entries that differ.
    pub fn quadric() -> f64 {
        weighted(|c| {
            frame::quadric(&matrix(c), c.numbers(QUADRIC));
        })
    }

    /// All cofactors, one after the other.
    pub fn cofactors() -> f64 {
        weighted(|c| {
            frame::cofactors(&matrix(c));
        })
    }

    /// All cofactors from shared minors.
    pub fn cofactors_of_shared_minors() -> f64 {
        weighted(|c| {
            frame::cofactors_of_shared_minors(&matrix(c));
        })
    }

    /// The determinant where there are no cofactors yet.
    pub fn determinant_alone() -> f64 {
        weighted(|c| {
            frame::determinant_alone(&matrix(c));
        })
    }

    /// The determinant from the cofactors.
    pub fn determinant() -> f64 {
        weighted(|c| {
            frame::determinant(&matrix(c), &matrix(c));
        })
    }

    /// The inverse from cofactors and determinant.
    pub fn inverse() -> f64 {
        weighted(|c| {
            frame::inverse(&matrix(c), c.number(2.0));
        })
    }

    /// A facet without the product of its matrices: three points, divided, and three normals.
    pub fn facet() -> f64 {
        3.0 * (point() + divide() + direction())
    }

    /// The matrices that a quadric needs: product, cofactors, determinant.
    pub fn quadric_matrices() -> f64 {
        product() + cofactors() + determinant()
    }

    /// The corners of a patch's tetrahedron.
    pub fn tetrahedron() -> f64 {
        4.0 * (point() + divide())
    }
}

/// Facets.
pub mod facets {
    use super::*;

    /// Set-up of contour following.
    pub fn contour() -> f64 {
        weighted(|c| {
            followed_contour(c);
        })
    }

    /// Set-up of the expressions.
    pub fn expressions() -> f64 {
        weighted(|c| {
            facet::expressions(corners(c));
        })
    }

    /// Three quantities for contour following.
    pub fn followed() -> f64 {
        beside(
            |c| {
                let contour = followed_contour(c);
                for w in quantities(c) {
                    facet::followed(&contour, w);
                }
            },
            contour(),
        )
    }

    /// Three quantities as expressions.
    pub fn expressed() -> f64 {
        beside(
            |c| {
                let corners = corners(c);
                let facet = facet::expressions(corners);
                for w in quantities(c) {
                    facet::expressed(&facet.shape, corners, w);
                }
            },
            expressions(),
        )
    }

    /// Whole numbers of contour following with three quantities.
    pub fn contour_words() -> f64 {
        beside(
            |c| {
                let [depth, quantity] = c.numbers([8388.0, 32_767.0]);
                facet::contour_words(&followed_contour(c), quantities(c), depth, quantity);
            },
            contour() + followed(),
        )
    }

    /// Whole numbers of the expressions with three quantities.
    pub fn expression_words() -> f64 {
        beside(
            |c| {
                let [depth, quantity] = c.numbers([8388.0, 32_767.0]);
                facet::expression_words(corners(c), quantities(c), depth, quantity);
            },
            expressions() + expressed(),
        )
    }

    /// Light at three corners; whether the source and the viewer are near, so that their directions are computed.
    pub fn lighting(source_is_near: bool, viewer_is_near: bool) -> f64 {
        weighted(|c| {
            let direction = c.numbers([0.0, 0.6, 0.8]);
            let place = |is_near| {
                if is_near {
                    Place::Near(direction)
                } else {
                    Place::Far(direction)
                }
            };
            let colours = Colours {
                ambient: direction,
                diffuse: direction,
                specular: direction,
                exponent: WORST_EXPONENT,
            };
            let point = c.numbers([0.0; 3]);
            for _ in 0..3 {
                let normal = c.numbers([0.1, 0.2, 0.9]);
                light(
                    point,
                    normal,
                    &place(source_is_near),
                    &place(viewer_is_near),
                    &colours,
                );
            }
        })
    }

    /// The exponent up to 128 whose power takes most products.
    pub const WORST_EXPONENT: u32 = 127;

    /// One power.
    pub fn one_power() -> f64 {
        weighted(|c| {
            power(c.number(0.9), WORST_EXPONENT);
        })
    }

    /// All of a facet with normals, as expressions, without the product of its matrices.
    pub fn phong_by_expressions() -> f64 {
        expressions() + expressed() + change::facet() + expression_words()
    }

    /// The same by contour following.
    pub fn phong_by_contour() -> f64 {
        contour() + followed() + change::facet() + contour_words()
    }
}

/// Quadrics and patches.
pub mod quadrics {
    use super::*;

    /// The expressions of the depth.
    pub fn depth() -> f64 {
        weighted(|c| {
            quadric::depth(c.numbers(QUADRIC));
        })
    }

    /// The expressions of the normal.
    pub fn normal() -> f64 {
        weighted(|c| {
            quadric::normal(
                c.numbers(QUADRIC),
                &c.numbers([1.0, 2.0, 3.0]),
                c.number(0.001),
            );
        })
    }

    /// Whole numbers of the depth.
    pub fn depth_words() -> f64 {
        beside(
            |c| {
                let depth = quadric::depth(c.numbers(QUADRIC)).expect("it has a depth");
                let [scale, square] = c.numbers([8388.0, 7e7]);
                quadric::depth_words(&depth, scale, square);
            },
            depth(),
        )
    }

    /// Whole numbers of the normal, with the search of its greatest component.
    pub fn normal_words() -> f64 {
        beside(
            |c| {
                let q = c.numbers(QUADRIC);
                let depth = quadric::depth(q).expect("it has a depth");
                let normal = quadric::normal(q, &depth.f1, c.number(0.001));
                let root = quadric::greatest_f2(&depth.f2).root();
                let window = c.numbers([-70.0, -90.0, 180.0, 170.0]);
                let greatest = quadric::greatest_normal(&normal, root, window);
                quadric::normal_words(&normal, greatest, c.number(0.001));
            },
            depth() + normal(),
        )
    }

    /// The expression of a plane.
    pub fn plane() -> f64 {
        weighted(|c| {
            quadric::plane(c.numbers(PLANE), c.number(8388.0), c.number(16e6));
        })
    }

    /// Its whole numbers.
    pub fn plane_words() -> f64 {
        weighted(|c| {
            quadric::plane_words(c.numbers([1.0, 2.0, 3.0]), c.number(8388.0));
        })
    }

    /// Its constant normal, in whole numbers.
    pub fn plane_normal() -> f64 {
        weighted(|c| {
            quadric::constant_normal(c.numbers([1.0, 2.0, 3.0]));
        })
    }

    /// Length of a normal made 1.
    pub fn normalisation() -> f64 {
        weighted(|c| {
            frame::normalised(c.numbers([1.0, 2.0, 3.0]));
        })
    }

    /// Depth and normal with their words.
    pub fn surface() -> f64 {
        depth() + normal() + depth_words() + normal_words()
    }

    /// Of a quadric with three planes, after the change of frame.
    pub fn solid() -> f64 {
        surface() + 3.0 * (plane() + plane_words() + plane_normal())
    }

    /// Of a patch with four planes, which need no normal.
    pub fn patch() -> f64 {
        surface() + 4.0 * (plane() + plane_words())
    }

    /// All of a quadric with three planes, without its matrices.
    pub fn solid_in_all() -> f64 {
        change::quadric() + 3.0 * change::plane() + solid()
    }

    /// All of a patch, without its matrices.
    pub fn patch_in_all() -> f64 {
        change::quadric() + change::tetrahedron() + patch()
    }
}

/// Zones.
pub mod zoning {
    use super::*;

    /// Corners of a box with sides along no axis of the screen: all of them are apart, six are on the outline.
    const CUBE: [[f64; 2]; 8] = [
        [0.0, 0.0],
        [40.0, 9.0],
        [13.0, 30.0],
        [53.0, 39.0],
        [17.0, -6.0],
        [57.0, 3.0],
        [30.0, 24.0],
        [70.0, 33.0],
    ];
    /// Corners of a tetrahedron, all of them on the outline.
    const TETRAHEDRON: [[f64; 2]; 4] = [[0.0, 0.0], [40.0, 9.0], [13.0, 30.0], [53.0, 39.0]];

    fn points<'c>(counter: &'c Counter, list: &[[f64; 2]]) -> Vec<[Counted<'c>; 2]> {
        list.iter().map(|p| counter.numbers(*p)).collect()
    }

    fn presort(list: &[[f64; 2]]) -> f64 {
        weighted(|c| {
            zones::zones(zones::box_of(&points(c, list)), c.number(1.0 / 128.0));
        })
    }

    /// Zones of a facet's box.
    pub fn facet() -> f64 {
        presort(&CUBE[..3])
    }

    /// Zones of a patch, from the corners of its tetrahedron, which are there.
    pub fn patch() -> f64 {
        presort(&TETRAHEDRON)
    }

    /// Zones of a quadric from the corners of a box in space, which go through the change of frame.
    pub fn quadric_by_corners() -> f64 {
        8.0 * (change::point() + change::divide()) + presort(&CUBE)
    }

    /// Zones of a quadric from the tangents of its outline, which is there.
    pub fn quadric_by_outline() -> f64 {
        weighted(|c| {
            let q = c.numbers(QUADRIC);
            let depth = quadric::depth(q).expect("it has a depth");
            let window = zones::box_of_outline(&depth.f2);
            zones::zones(window, c.number(1.0 / 128.0));
        }) - quadrics::depth()
    }

    /// Two corners of the box in space are joined if they differ in one bit of their index.
    fn is_edge(i: usize, j: usize) -> bool {
        (i ^ j).is_power_of_two()
    }

    /// Sides of the outline of a patch's tetrahedron.
    pub fn patch_outline() -> f64 {
        weighted(|c| {
            zones::outline(&points(c, &TETRAHEDRON));
        })
    }

    /// Sides of the outline of a quadric's box.
    pub fn quadric_outline() -> f64 {
        weighted(|c| {
            zones::outline_of(&points(c, &CUBE), is_edge);
        })
    }

    fn corner(list: &[[f64; 2]], is_edge: fn(usize, usize) -> bool) -> f64 {
        beside(
            |c| {
                let sides = zones::outline_of(&points(c, list), is_edge);
                facet::is_inside(&sides, c.number(5.0), c.number(6.0));
            },
            weighted(|c| {
                zones::outline_of(&points(c, list), is_edge);
            }),
        )
    }

    /// A zone's corner against a facet's sides.
    pub fn facet_corner() -> f64 {
        corner(&CUBE[..3], |_, _| true)
    }

    /// Against a tetrahedron's outline.
    pub fn patch_corner() -> f64 {
        corner(&TETRAHEDRON, |_, _| true)
    }

    /// Against a box's outline.
    pub fn quadric_corner() -> f64 {
        corner(&CUBE, is_edge)
    }

    /// A first-degree expression moved to another zone.
    pub fn moved_line() -> f64 {
        weighted(|c| {
            let [k, l] = c.numbers([128.0, 256.0]);
            zones::moved_line(&c.numbers([1.0, 2.0, 3.0]), k, l);
        })
    }

    /// The same without products: the side of a zone is a power of two, so they are shifts.
    pub fn moved_line_by_shifts() -> f64 {
        moved(|c| {
            let [k, l] = c.numbers([128.0, 256.0]);
            zones::moved_line(&c.numbers([1.0, 2.0, 3.0]), k, l);
        })
    }

    /// A second-degree expression moved to another zone.
    pub fn moved_conic() -> f64 {
        weighted(|c| {
            let [k, l] = c.numbers([128.0, 256.0]);
            zones::moved_conic(&c.numbers([1.0; 6]), k, l);
        })
    }

    /// The same without products.
    pub fn moved_conic_by_shifts() -> f64 {
        moved(|c| {
            let [k, l] = c.numbers([128.0, 256.0]);
            zones::moved_conic(&c.numbers([1.0; 6]), k, l);
        })
    }

    fn moved(work: impl FnOnce(&Counter)) -> f64 {
        super::super::count::cost(work).additions as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counts that follow from the size of the matrices alone.
    #[test]
    fn products_cost_what_their_sizes_say() {
        assert_eq!(change::product(), 16.0 * (4.0 + 3.0));
        assert_eq!(change::affine_product(), 12.0 * 5.0 + 3.0);
        assert_eq!(change::point(), 4.0 * 6.0);
        assert_eq!(change::direction(), 3.0 * 5.0);
        assert_eq!(change::divide(), 8.0 + 3.0);
        assert_eq!(change::plane(), 4.0 * 7.0);
        assert_eq!(change::quadric_in_full(), 2.0 * 112.0);
        assert_eq!(change::quadric(), 112.0 + 10.0 * 7.0);
        assert_eq!(change::cofactors(), 16.0 * 14.0);
        assert_eq!(
            change::cofactors_of_shared_minors(),
            12.0 * 3.0 + 16.0 * 5.0
        );
        assert_eq!(change::determinant(), 7.0);
        assert_eq!(change::determinant_alone(), 4.0 * 14.0 + 7.0);
        assert_eq!(change::inverse(), 8.0 + 16.0);
        assert_eq!(quadrics::normalisation(), 5.0 + 8.0 + 8.0 + 3.0);
    }

    #[test]
    fn outlines_have_the_sides_that_their_corners_are_tested_against() {
        assert_eq!(zoning::facet_corner(), 3.0 * 5.0);
        assert_eq!(zoning::patch_corner(), 4.0 * 5.0);
        assert_eq!(zoning::quadric_corner(), 6.0 * 5.0);
    }
}
