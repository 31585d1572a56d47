//! Readers of height grids: ESRI ASCII grids, and plain rows of numbers.

use super::grid::{HeightGrid, MAX_NODES};
use crate::error::{decoded, unusable};
use crate::kind::{KEYS, is_grid_keyword};
use crate::{ImportError, Place, Result};

/// Largest magnitude of a height or a distance.
const MAX_NUMBER: f64 = 1e8;

/// Reads a grid of either format; `file` is the name that messages give it. A text that begins with a keyword of the
/// header is an ESRI ASCII grid.
pub fn read(bytes: &[u8], file: &str) -> Result<HeightGrid> {
    let text = decoded(bytes, file, "a grid of heights is plain text")?;
    let reader = Reader { file, text };
    let first = reader.words().next();
    let grid = match first.is_some_and(|word| is_grid_keyword(word.text)) {
        true => reader.esri()?,
        false => reader.plain()?,
    };
    if grid.heights.iter().all(Option::is_none) {
        let accepted = "the four corners of at least one cell are needed";
        return Err(unusable(file, "no node has a height", accepted));
    }
    Ok(grid)
}

struct Reader<'a> {
    file: &'a str,
    text: &'a str,
}

/// The header of an ESRI ASCII grid so far; index as in [`KEYS`].
type Header = [Option<f64>; KEYS.len()];

impl<'a> Reader<'a> {
    fn malformed(&self, place: Place, problem: impl ToString, accepted: &str) -> ImportError {
        ImportError::new(self.file, Some(place), problem, accepted)
    }

    fn refused(&self, word: Word, problem: &str, accepted: &str) -> ImportError {
        let problem = format!("{} {problem}", shown(word.text));
        self.malformed(word.place, problem, accepted)
    }

    /// Every word of the text.
    fn words(&self) -> impl Iterator<Item = Word<'a>> + use<'a> {
        let lines = self.text.lines().enumerate();
        lines.flat_map(|(index, line)| words(line, index + 1))
    }

    fn number(&self, word: Word, what: &str) -> Result<f64> {
        let plain = |b: u8| b.is_ascii_digit() || b"+-.eE".contains(&b);
        let value = word.text.parse::<f64>().ok();
        let value = value.filter(|v| word.text.bytes().all(plain) && v.abs() <= MAX_NUMBER);
        let accepted = "a decimal number of magnitude up to 1e8 is expected";
        value.ok_or_else(|| self.refused(word, &format!("is no {what}"), accepted))
    }

    fn positive(&self, word: Word, what: &str) -> Result<f64> {
        let value = self.number(word, what)?;
        if value > 0.0 {
            return Ok(value);
        }
        let problem = format!("a {what} of {}", shown(word.text));
        Err(self.malformed(word.place, problem, "it must be greater than zero"))
    }

    fn esri(&self) -> Result<HeightGrid> {
        let mut all = self.words().peekable();
        let mut header: Header = [None; KEYS.len()];
        while let Some(word) = all.peek().copied() {
            if !word.text.starts_with(|c: char| c.is_alphabetic()) {
                break;
            }
            all.next();
            let key = self.key(word, &header)?;
            let value = all.next().ok_or_else(|| {
                let problem = format!("{} without a value", KEYS[key]);
                self.malformed(word.place, problem, "`KEYWORD VALUE` is expected")
            })?;
            header[key] = Some(self.header_value(key, value)?);
        }
        let (columns, rows) = (self.count(&header, 0)?, self.count(&header, 1)?);
        let step = self.esri_step(&header)?;
        if columns.saturating_mul(rows) > MAX_NODES {
            let accepted = format!("at most {MAX_NODES} are read");
            return Err(unusable(
                self.file,
                format!("{columns} x {rows} nodes"),
                &accepted,
            ));
        }
        let mut heights = Vec::with_capacity(columns * rows);
        let mut last = Place { line: 1, column: 1 };
        for word in all {
            last = word.place;
            if heights.len() == columns * rows {
                let problem = format!("more than {columns} x {rows} heights");
                return Err(self.malformed(last, problem, "`ncols` times `nrows` are expected"));
            }
            // The mark of missing data may be of any magnitude.
            let is_known = header[9].is_none() || word.text.parse::<f64>().ok() != header[9];
            let known = is_known.then(|| self.number(word, "height"));
            heights.push(known.transpose()?);
        }
        let count = heights.len();
        if count < columns * rows {
            let problem = format!("the file ends after {count} of {columns} x {rows} heights");
            return Err(self.malformed(last, problem, "`ncols` times `nrows` are expected"));
        }
        Ok(HeightGrid {
            columns,
            rows,
            step,
            heights,
        })
    }

    fn key(&self, word: Word, header: &Header) -> Result<usize> {
        let name = word.text.to_lowercase();
        let accepted = "ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx and dy) and NODATA_value are expected once each";
        match KEYS.iter().position(|key| *key == name) {
            Some(key) if header[key].is_none() => Ok(key),
            Some(_) => {
                let problem = format!("{name} for the second time");
                Err(self.malformed(word.place, problem, accepted))
            }
            None => Err(self.refused(word, "is no keyword of the header and no height", accepted)),
        }
    }

    fn header_value(&self, key: usize, word: Word) -> Result<f64> {
        match KEYS[key] {
            "ncols" | "nrows" => {
                let count = word.text.parse::<u32>().ok().filter(|n| *n >= 2);
                let accepted = format!("2 to {MAX_NODES} nodes in all are expected");
                let refused = || self.refused(word, "is no number of nodes", &accepted);
                count.map(f64::from).ok_or_else(refused)
            }
            "cellsize" | "dx" | "dy" => self.positive(word, "distance of two nodes"),
            // Missing data is often marked by the least number of a format, beyond every height; the place on the
            // globe is not used.
            _ => {
                let value = word.text.parse::<f64>().ok().filter(|v| v.is_finite());
                value.ok_or_else(|| self.refused(word, "is no number", "a number is expected"))
            }
        }
    }

    fn count(&self, header: &Header, key: usize) -> Result<usize> {
        let problem = || format!("the header has no {}", KEYS[key]);
        let value = header[key].map(|n| n as usize);
        value.ok_or_else(|| unusable(self.file, problem(), "`ncols N` and `nrows N` are needed"))
    }

    fn esri_step(&self, header: &Header) -> Result<[f64; 2]> {
        match (header[6], header[7], header[8]) {
            (Some(size), None, None) => Ok([size, size]),
            (None, Some(dx), Some(dy)) => Ok([dx, dy]),
            _ => Err(unusable(
                self.file,
                "the header does not say once how far the nodes are apart",
                "`cellsize N`, or `dx N` and `dy N`, are needed",
            )),
        }
    }

    fn plain(&self) -> Result<HeightGrid> {
        let mut step = None;
        let mut heights: Vec<Option<f64>> = vec![];
        let (mut columns, mut rows) = (0, 0);
        for (index, line) in self.text.lines().enumerate() {
            let mut row = words(line, index + 1).peekable();
            let Some(first) = row.peek().copied() else {
                continue;
            };
            if first.text == "step" {
                if step.is_some() || rows > 0 {
                    let accepted = "one line `step EAST SOUTH` before the first row is expected";
                    return Err(self.malformed(first.place, "`step` out of place", accepted));
                }
                step = Some(self.plain_step(row.skip(1), first.place)?);
                continue;
            }
            let before = heights.len();
            let mut end = first.place;
            for word in row {
                end = word.place;
                let known = (word.text != "-").then(|| self.number(word, "height"));
                heights.push(known.transpose()?);
                if heights.len() > MAX_NODES {
                    let accepted = format!("at most {MAX_NODES} are read");
                    return Err(unusable(self.file, "too many heights", &accepted));
                }
            }
            let count = heights.len() - before;
            if rows > 0 && count != columns {
                let problem = format!("a row of {count} heights after rows of {columns}");
                let accepted = "every row has the same number of heights";
                return Err(self.malformed(end, problem, accepted));
            }
            (columns, rows) = (count, rows + 1);
        }
        if columns < 2 || rows < 2 {
            return Err(unusable(
                self.file,
                format!("{rows} rows of {columns} heights"),
                "at least 2 rows of 2 are needed, a row on each line (or the header of an ESRI ASCII grid)",
            ));
        }
        Ok(HeightGrid {
            columns,
            rows,
            step: step.unwrap_or([1.0, 1.0]),
            heights,
        })
    }

    fn plain_step<'w>(
        &self,
        mut values: impl Iterator<Item = Word<'w>>,
        place: Place,
    ) -> Result<[f64; 2]> {
        let accepted = "`step EAST SOUTH`, two distances of nodes, is expected";
        let missing = || self.malformed(place, "a distance is missing", accepted);
        let mut next =
            || self.positive(values.next().ok_or_else(missing)?, "distance of two nodes");
        let step = [next()?, next()?];
        match values.next() {
            None => Ok(step),
            Some(word) => Err(self.refused(word, "too many", accepted)),
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct Word<'a> {
    text: &'a str,
    place: Place,
}

/// The words of a line, from 1; what follows a `#` is left out.
fn words(line: &str, number: usize) -> impl Iterator<Item = Word<'_>> {
    let code = line.split('#').next().unwrap_or_default();
    let (mut rest, mut column) = (code, 1);
    std::iter::from_fn(move || {
        let start = rest.find(|c: char| !c.is_whitespace())?;
        column += rest[..start].chars().count();
        rest = &rest[start..];
        let length = rest.find(char::is_whitespace).unwrap_or(rest.len());
        let word = Word {
            text: &rest[..length],
            place: Place {
                line: number,
                column,
            },
        };
        column += word.text.chars().count();
        rest = &rest[length..];
        Some(word)
    })
}

/// A word for a message: at most a few characters of it.
fn shown(word: &str) -> String {
    match word.char_indices().nth(24) {
        Some((end, _)) => format!("`{}..`", &word[..end]),
        None => format!("`{word}`"),
    }
}
