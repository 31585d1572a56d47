//! One sphere as one line of a scene file.

/// An entry of `objects`; four decimals, so that the text is the same whatever the last bits of sine and cosine are.
pub fn sphere(name: &str, material: &str, radius: f64, centre: [f64; 3]) -> String {
    // Adding zero turns -0.0 into 0.0.
    let [x, y, z] = centre.map(|v| (v * 1e4).round() / 1e4 + 0.0);
    format!(
        "  {{ name = \"{name}\", kind = \"sphere\", radius = {radius}, material = \"{material}\", place = [{{ translate = [{x}, {y}, {z}] }}] }},\n"
    )
}
