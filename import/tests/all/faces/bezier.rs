use imogene_import::faces::bezier::{Patch, Pole, pieces};
use imogene_import::faces::vector::distance;

/// `x = u^2 v, y = u + v, z = 1` with weight `1 + u` over the unit square; poles by their polar forms.
fn example() -> Patch {
    let value = |[a, b]: [f64; 2], v: f64| {
        // Polar in u of u^2, u, 1 + u.
        let (square, mean) = (a * b, 0.5 * (a + b));
        [square * v, mean + v, 1.0, 1.0 + mean]
    };
    let pairs = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let poles = pairs.map(|pair| [value(pair, 0.0), value(pair, 1.0)]);
    Patch {
        degrees: [2, 1],
        poles: poles.concat(),
    }
}

#[test]
fn patches_and_products_are_the_polynomials_they_are_made_of() {
    let patch = example();
    let x = patch.polynomial([1.0, 0.0, 0.0, 0.0]);
    let y = patch.polynomial([0.0, 1.0, 0.0, 0.0]);
    let product = x.times(&y);
    for k in 0..25 {
        let (u, v) = (f64::from(k % 5) / 4.0, f64::from(k / 5) / 4.0);
        let w = 1.0 + u;
        let (p, [du, _]) = patch.at(u, v);
        assert!(distance(p, [u * u * v / w, (u + v) / w, 1.0 / w]) < 1e-14);
        let slope = (2.0 * u * v * w - u * u * v) / (w * w);
        assert!((du[0] - slope).abs() < 1e-13);
        assert!((u * u * v * (u + v)).abs() <= product.bound() + 1e-15);
    }
    // The greatest value, at u = v = 1, is a coefficient.
    assert!((product.bound() - 2.0).abs() < 1e-14);
}

#[test]
fn pieces_join_and_are_the_curve() {
    // u^2 over knots 0, 1, 3 by its polar form.
    let knots = [0.0, 0.0, 0.0, 1.0, 3.0, 3.0, 3.0];
    let pole = |k: usize| [knots[k + 1] * knots[k + 2], 0.0, 0.0, 1.0];
    let poles: Vec<Pole> = (0..4).map(pole).collect();
    let pieces = pieces(2, &knots, &poles).into_iter();
    let xs = pieces.map(|piece| piece.iter().map(|pole| pole[0]).collect());
    let xs: Vec<Vec<f64>> = xs.collect();
    assert_eq!(xs, [[0.0, 0.0, 1.0], [1.0, 3.0, 9.0]]);
}
