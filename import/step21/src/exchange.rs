//! A file that has been taken apart.

use super::error::{Error, Result};
use super::parser::Parser;
use super::value::{Instance, Record};
use std::collections::HashMap;

/// A file that has been taken apart.
#[derive(Debug)]
pub struct Exchange<'a> {
    /// Its bytes: ASCII, apart from what stands in strings and comments.
    pub bytes: &'a [u8],
    /// Records of the header.
    pub header: Vec<Record<'a>>,
    /// Entities in their order.
    pub instances: Vec<Instance<'a>>,
    /// Their places by their numbers.
    pub(crate) index: HashMap<u64, usize>,
}

impl<'a> Exchange<'a> {
    /// Takes a file apart.
    pub fn parse(bytes: &'a [u8]) -> Result<Self> {
        let (header, instances, index) = Parser::read(bytes)?;
        if instances.is_empty() {
            let accepted = "a data section with a solid is needed";
            return Err(Error::whole("the file has no entities", accepted));
        }
        Ok(Exchange {
            bytes,
            header,
            instances,
            index,
        })
    }
}
