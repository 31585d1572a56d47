//! Readers of height grids: ESRI ASCII grids, and plain rows of numbers.

use super::grid::{HeightGrid, MAX_NODES};
use crate::error::{Error, Result, text};
use crate::kind::{KEYS, is_grid_keyword};
use crate::kit::decimal;

/// Largest magnitude of a height or a distance.
const MAX_NUMBER: f64 = 1e8;

/// Reads a grid of either format. A text that begins with a keyword of the header is an ESRI ASCII grid.
pub fn read(bytes: &[u8]) -> Result<HeightGrid> {
    let reader = Reader(text(bytes, "a grid of heights is plain text")?);
    let grid = match reader.words().next().is_some_and(is_grid_keyword) {
        true => reader.esri()?,
        false => reader.plain()?,
    };
    if grid.heights.iter().all(Option::is_none) {
        let accepted = "the four corners of at least one cell are needed";
        return Err(Error::whole("no node has a height", accepted));
    }
    Ok(grid)
}

/// The header of an ESRI ASCII grid so far; index as in [`KEYS`].
type Header = [Option<f64>; KEYS.len()];

struct Reader<'a>(&'a str);

impl<'a> Reader<'a> {
    /// What is wrong at a word, which is a piece of the text.
    fn malformed(&self, word: &str, problem: impl ToString, accepted: &str) -> Error {
        let at = word.as_ptr() as usize - self.0.as_ptr() as usize;
        Error::at(self.0.as_bytes(), at, problem, accepted)
    }

    fn refused(&self, word: &str, problem: &str, accepted: &str) -> Error {
        self.malformed(word, format!("{} {problem}", shown(word)), accepted)
    }

    fn words(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        self.0.lines().flat_map(words)
    }

    fn number(&self, word: &str, what: &str) -> Result<f64> {
        let value = decimal(word.as_bytes(), b"+-.eE").filter(|v| v.abs() <= MAX_NUMBER);
        let accepted = "a decimal number of magnitude up to 1e8 is expected";
        value.ok_or_else(|| self.refused(word, &format!("is no {what}"), accepted))
    }

    fn distance(&self, word: &str) -> Result<f64> {
        let value = self.number(word, "distance of two nodes")?;
        if value > 0.0 {
            return Ok(value);
        }
        let problem = format!("a distance of two nodes of {}", shown(word));
        Err(self.malformed(word, problem, "it must be greater than zero"))
    }

    fn esri(&self) -> Result<HeightGrid> {
        let mut all = self.words().peekable();
        let mut header: Header = [None; KEYS.len()];
        while let Some(word) = all.next_if(|word| word.starts_with(char::is_alphabetic)) {
            let key = self.key(word, &header)?;
            let value = all.next().ok_or_else(|| {
                let problem = format!("{} without a value", KEYS[key]);
                self.malformed(word, problem, "`KEYWORD VALUE` is expected")
            })?;
            header[key] = Some(self.header_value(key, value)?);
        }
        let (columns, rows) = (self.count(&header, 0)?, self.count(&header, 1)?);
        let step = self.esri_step(&header)?;
        if columns.saturating_mul(rows) > MAX_NODES {
            let accepted = format!("at most {MAX_NODES} are read");
            return Err(Error::whole(format!("{columns} x {rows} nodes"), accepted));
        }
        let mut heights = Vec::with_capacity(columns * rows);
        let mut last = &self.0[..0];
        for word in all {
            last = word;
            if heights.len() == columns * rows {
                let problem = format!("more than {columns} x {rows} heights");
                return Err(self.malformed(last, problem, "`ncols` times `nrows` are expected"));
            }
            // The mark of missing data may be of any magnitude.
            let is_known = header[9].is_none() || word.parse::<f64>().ok() != header[9];
            heights.push(is_known.then(|| self.number(word, "height")).transpose()?);
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

    fn key(&self, word: &str, header: &Header) -> Result<usize> {
        let name = word.to_lowercase();
        let accepted = "ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx and dy) and NODATA_value are expected once each";
        match KEYS.iter().position(|key| *key == name) {
            Some(key) if header[key].is_none() => Ok(key),
            Some(_) => Err(self.malformed(word, format!("{name} for the second time"), accepted)),
            None => Err(self.refused(word, "is no keyword of the header and no height", accepted)),
        }
    }

    fn header_value(&self, key: usize, word: &str) -> Result<f64> {
        match KEYS[key] {
            "ncols" | "nrows" => {
                let count = word.parse::<u32>().ok().filter(|n| *n >= 2);
                let accepted = format!("2 to {MAX_NODES} nodes in all are expected");
                let refused = || self.refused(word, "is no number of nodes", &accepted);
                count.map(f64::from).ok_or_else(refused)
            }
            "cellsize" | "dx" | "dy" => self.distance(word),
            // Missing data is often marked by the least number of a format; the place on the globe is not used.
            _ => {
                let value = word.parse::<f64>().ok().filter(|v| v.is_finite());
                value.ok_or_else(|| self.refused(word, "is no number", "a number is expected"))
            }
        }
    }

    fn count(&self, header: &Header, key: usize) -> Result<usize> {
        let problem = || format!("the header has no {}", KEYS[key]);
        let value = header[key].map(|n| n as usize);
        value.ok_or_else(|| Error::whole(problem(), "`ncols N` and `nrows N` are needed"))
    }

    fn esri_step(&self, header: &Header) -> Result<[f64; 2]> {
        match (header[6], header[7], header[8]) {
            (Some(size), None, None) => Ok([size, size]),
            (None, Some(dx), Some(dy)) => Ok([dx, dy]),
            _ => Err(Error::whole(
                "the header does not say once how far the nodes are apart",
                "`cellsize N`, or `dx N` and `dy N`, are needed",
            )),
        }
    }

    fn plain(&self) -> Result<HeightGrid> {
        let mut step = None;
        let mut heights: Vec<Option<f64>> = vec![];
        let (mut columns, mut rows) = (0, 0);
        for line in self.0.lines() {
            let mut row = words(line).peekable();
            if let Some(first) = row.next_if_eq(&"step") {
                if step.is_some() || rows > 0 {
                    let accepted = "one line `step EAST SOUTH` before the first row is expected";
                    return Err(self.malformed(first, "`step` out of place", accepted));
                }
                step = Some(self.plain_step(first, row)?);
                continue;
            }
            let Some(mut end) = row.peek().copied() else {
                continue;
            };
            let before = heights.len();
            for word in row {
                end = word;
                let known = (word != "-").then(|| self.number(word, "height"));
                heights.push(known.transpose()?);
                if heights.len() > MAX_NODES {
                    let accepted = format!("at most {MAX_NODES} are read");
                    return Err(Error::whole("too many heights", &accepted));
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
            let problem = format!("{rows} rows of {columns} heights");
            let accepted = "at least 2 rows of 2 are needed, a row on each line (or the header of an ESRI ASCII grid)";
            return Err(Error::whole(problem, accepted));
        }
        Ok(HeightGrid {
            columns,
            rows,
            step: step.unwrap_or([1.0, 1.0]),
            heights,
        })
    }

    fn plain_step(&self, first: &str, mut rest: impl Iterator<Item = &'a str>) -> Result<[f64; 2]> {
        let accepted = "`step EAST SOUTH`, two distances of nodes, is expected";
        let missing = || self.malformed(first, "a distance is missing", accepted);
        let mut next = || self.distance(rest.next().ok_or_else(missing)?);
        let step = [next()?, next()?];
        match rest.next() {
            None => Ok(step),
            Some(word) => Err(self.refused(word, "too many", accepted)),
        }
    }
}

/// The words of a line; what follows a `#` is left out.
fn words(line: &str) -> impl Iterator<Item = &str> {
    let code = line.split('#').next().unwrap_or_default();
    code.split_whitespace()
}

/// A word for a message: at most a few characters of it.
fn shown(word: &str) -> String {
    match word.char_indices().nth(24) {
        Some((end, _)) => format!("`{}..`", &word[..end]),
        None => format!("`{word}`"),
    }
}
