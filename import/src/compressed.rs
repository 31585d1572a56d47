//! Files compressed with gzip.

use crate::error::{Result, unusable};
use flate2::read::MultiGzDecoder;
use std::io::Read;

/// Whether bytes begin as gzip's do.
pub fn is_compressed(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1f, 0x8b])
}

/// What was compressed, if it takes at most so many bytes; several members are one file. `file` is the name that
/// messages give it.
pub fn unpack(bytes: &[u8], limit: u64, file: &str) -> Result<Vec<u8>> {
    let mut unpacked = vec![];
    let mut decoder = MultiGzDecoder::new(bytes).take(limit + 1);
    let count = decoder.read_to_end(&mut unpacked).map_err(|error| {
        let accepted = "a whole file compressed with gzip would be accepted";
        unusable(file, format!("it cannot be unpacked ({error})"), accepted)
    })?;
    if count as u64 > limit {
        let problem = format!("it unpacks to more than {limit} bytes");
        let accepted = format!("up to {limit} bytes would be accepted");
        return Err(unusable(file, problem, accepted));
    }
    Ok(unpacked)
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::Compression;
    use flate2::write::GzEncoder;
    use std::io::Write;

    fn packed(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(vec![], Compression::best());
        encoder.write_all(bytes).expect("memory");
        encoder.finish().expect("memory")
    }

    #[test]
    fn what_is_unpacked_has_a_limit() {
        let zeros = packed(&[0; 1_000_000]);
        assert!(is_compressed(&zeros) && zeros.len() < 2_000);
        let whole = unpack(&zeros, 1_000_000, "f").expect("whole");
        assert_eq!(whole.len(), 1_000_000);
        let refused = |bytes, limit| unpack(bytes, limit, "f").unwrap_err().to_string();
        let many = refused(&zeros, 999_999);
        assert!(many.starts_with("f: it unpacks to more than 999999 bytes"));
        assert!(refused(&zeros[..900], 1_000_000).starts_with("f: it cannot be unpacked"));
        let two = [packed(b"one "), packed(b"two")].concat();
        assert_eq!(unpack(&two, 100, "f").expect("two members"), b"one two");
    }
}
