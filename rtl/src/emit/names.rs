//! Names and indices: from rust-hdl's paths to plain identifiers.

use super::EmitError;
use rust_hdl::core::prelude::VerilogLiteral;

/// Width and value of a literal, whose fields rust-hdl only prints.
pub fn literal(literal: &VerilogLiteral) -> (usize, u64) {
    let text = format!("{literal:x}");
    let (width, digits) = text
        .split_once("'h")
        .expect("a literal prints as width'hdigits");
    let width = width.parse().expect("a width is decimal");
    (
        width,
        u64::from_str_radix(digits, 16).expect("no word has more than 64 bits"),
    )
}

/// The identifier of a signal of a block. Element `i` of an array `plane_a` becomes `plane_i_a`.
pub fn signal(name: &str) -> String {
    match name.split_once('$') {
        Some((array, index)) => match array.split_once('_') {
            Some((group, member)) => format!("{group}_{index}_{member}"),
            None => format!("{array}_{index}"),
        },
        None => name.to_owned(),
    }
}

/// The identifier of a sub-block: element `i` of `rows` becomes `rows_i`.
pub fn instance(name: &str) -> String {
    name.replace('$', "_")
}

/// The reserved words of Verilog-2005, SystemVerilog-2012 and VHDL-93, one a line.
const RESERVED: &str = include_str!("../../hdl/src/reserved_words.txt");

/// Refuses an identifier that a Verilog or VHDL tool would refuse.
pub fn check_identifier(name: &str) -> Result<(), EmitError> {
    let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    if plain && !RESERVED.lines().any(|word| word == name) {
        Ok(())
    } else {
        Err(EmitError::block(name, "is no portable identifier"))
    }
}

/// Refuses what cannot stand before the name of a module: also VHDL begins identifiers with a letter and knows no two underscores in a row.
pub fn check_prefix(prefix: &str) -> Result<(), EmitError> {
    let begins = prefix.starts_with(|c: char| c.is_ascii_alphabetic());
    let plain = prefix
        .chars()
        .all(|c| c.is_ascii_alphanumeric() || c == '_');
    if begins && plain && !prefix.contains("__") {
        Ok(())
    } else {
        Err(EmitError::Prefix {
            prefix: prefix.to_owned(),
        })
    }
}

/// Replaces every `[index]` of a path by `$value`. `lookup` gives the value of a loop variable or constant.
pub fn resolve(path: &str, lookup: &dyn Fn(&str) -> Option<u64>) -> Result<String, EmitError> {
    // The kernel macro breaks long paths into lines.
    let path: String = path.split_whitespace().collect();
    let path = path.trim_start_matches('.').trim_end_matches("$next");
    let mut resolved = String::new();
    let mut rest = path;
    while let Some(open) = rest.find('[') {
        let length = bracketed(&rest[open..])
            .ok_or_else(|| EmitError::block(path, "has an open bracket"))?;
        let index = Index {
            text: &rest[open + 1..open + length - 1],
            lookup,
        }
        .value()?;
        resolved += &rest[..open];
        resolved += &format!("${index}");
        rest = &rest[open + length..];
    }
    Ok(resolved + rest)
}

/// Length of the bracketed text at the beginning of `text`.
fn bracketed(text: &str) -> Option<usize> {
    let mut depth = 0;
    for (place, c) in text.char_indices() {
        match c {
            '[' => depth += 1,
            ']' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(place + 1);
        }
    }
    None
}

/// An index: numbers, loop variables and constants, joined by `+`, `-` and `*`.
struct Index<'a> {
    text: &'a str,
    lookup: &'a dyn Fn(&str) -> Option<u64>,
}

impl Index<'_> {
    fn value(&self) -> Result<i64, EmitError> {
        let (sum, rest) = self.sum(self.text)?;
        if rest.is_empty() {
            Ok(sum)
        } else {
            Err(self.refused())
        }
    }

    fn refused(&self) -> EmitError {
        EmitError::block(self.text, "is no index the emitter can resolve")
    }

    fn sum<'t>(&self, text: &'t str) -> Result<(i64, &'t str), EmitError> {
        let (mut value, mut rest) = self.product(text)?;
        while let Some(sign) = rest.chars().next().filter(|c| matches!(c, '+' | '-')) {
            let (term, after) = self.product(&rest[1..])?;
            value += if sign == '+' { term } else { -term };
            rest = after;
        }
        Ok((value, rest))
    }

    fn product<'t>(&self, text: &'t str) -> Result<(i64, &'t str), EmitError> {
        let (mut value, mut rest) = self.factor(text)?;
        while let Some(after) = rest.strip_prefix('*') {
            let (factor, after) = self.factor(after)?;
            value *= factor;
            rest = after;
        }
        Ok((value, rest))
    }

    fn factor<'t>(&self, text: &'t str) -> Result<(i64, &'t str), EmitError> {
        if let Some(inner) = text.strip_prefix('(') {
            let (value, rest) = self.sum(inner)?;
            return Ok((value, rest.strip_prefix(')').ok_or_else(|| self.refused())?));
        }
        let (atom, rest) = text.split_at(atom_length(text));
        let name = atom.trim_end_matches("$index()").trim_end_matches("$val()");
        let value = name
            .parse()
            .ok()
            .or_else(|| (self.lookup)(name))
            .ok_or_else(|| self.refused())?;
        Ok((value as i64, rest))
    }
}

/// Length of the name or number at the beginning of an index.
fn atom_length(text: &str) -> usize {
    let mut length = 0;
    while length < text.len() {
        let rest = &text[length..];
        let c = rest.as_bytes()[0];
        if rest.starts_with("()") {
            length += 2;
        } else if c == b'[' {
            length += bracketed(rest).unwrap_or(rest.len());
        } else if c.is_ascii_alphanumeric() || c == b'_' || c == b'$' {
            length += 1;
        } else {
            break;
        }
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_are_resolved() {
        let lookup = |name: &str| match name {
            "i" => Some(3),
            "j" => Some(1),
            "table[i]" => Some(9),
            _ => None,
        };
        let resolved = |path| resolve(path, &lookup).unwrap();
        assert_eq!(resolved("rows[i-1]$root$next"), "rows$2$root");
        assert_eq!(resolved("a[2*i+1]$b[j]"), "a$7$b$1");
        assert_eq!(resolved("a[table[i]$val()$index()]"), "a$9");
        assert_eq!(resolved("a[2*(i-j)]"), "a$4");
        assert!(resolve("a[k]", &lookup).is_err());
    }

    #[test]
    fn array_elements_get_readable_names() {
        assert_eq!(signal("plane_nx$2"), "plane_2_nx");
        assert_eq!(signal("f1_a"), "f1_a");
        assert_eq!(instance("rows$2"), "rows_2");
    }
}
