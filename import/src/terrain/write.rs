//! A random field as the text of a file of heights.

use super::random_field::{Field, FieldOptions};
use std::fmt::Write;

/// The text: a comment that says how it was made, the distance of nodes and the rows. Heights are rounded to a
/// thousandth.
pub fn heights_text(field: &Field, options: &FieldOptions, step: f64) -> String {
    let FieldOptions {
        levels,
        smoothness,
        relief,
        seed,
    } = options;
    let mut text = format!(
        "# imogene terrain --levels {levels} --roughness {smoothness} --relief {relief} --seed {seed}\nstep {step} {step}\n"
    );
    for row in field.heights.chunks(field.side) {
        for (index, height) in row.iter().enumerate() {
            let gap = if index > 0 { " " } else { "" };
            // A rounded number prints without the digits of its error; -0 prints as 0.
            let rounded = (height * 1000.0).round() / 1000.0 + 0.0;
            write!(text, "{gap}{rounded}").expect("strings can be written");
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terrain::random_field::field;
    use crate::terrain::read;

    #[test]
    fn the_reader_reads_what_is_written() {
        let options = FieldOptions {
            levels: 4,
            smoothness: 0.5,
            relief: 10.0,
            seed: 5,
        };
        let made = field(&options).unwrap();
        let grid = read(heights_text(&made, &options, 2.5).as_bytes(), "made").unwrap();
        assert_eq!((grid.columns, grid.rows, grid.step), (17, 17, [2.5, 2.5]));
        for (read, made) in grid.heights.iter().zip(&made.heights) {
            assert!((read.unwrap() - made).abs() <= 0.000_5 + 1e-9);
        }
    }
}
