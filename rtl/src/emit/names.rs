//! Names of modules.

use imogene_contract::RequestError;

/// Refuses what cannot stand before the name of a module: also VHDL begins identifiers with a letter and knows no two
/// underscores in a row.
pub fn check_prefix(prefix: &str) -> Result<(), RequestError> {
    let begins = prefix.starts_with(|c: char| c.is_ascii_alphabetic());
    let plain = prefix
        .chars()
        .all(|c| c.is_ascii_alphanumeric() || c == '_');
    if begins && plain && !prefix.contains("__") {
        Ok(())
    } else {
        Err(RequestError::Prefix {
            prefix: prefix.to_owned(),
        })
    }
}

/// The same of a prefix that may be empty.
pub fn check_optional(prefix: &str) -> Result<(), RequestError> {
    match prefix.is_empty() {
        true => Ok(()),
        false => check_prefix(prefix),
    }
}
