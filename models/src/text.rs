//! Numbers in sentences.

/// A number and what is counted: `1 pixel`, `2 pixels`, `0 mismatches`.
pub fn counted(count: impl TryInto<u64>, one: &str) -> String {
    // Counts are never negative, and none is longer than 64 bits.
    let count = count.try_into().unwrap_or(u64::MAX);
    let end = match count {
        1 => "",
        _ if ["s", "x", "ch", "sh"].iter().any(|end| one.ends_with(end)) => "es",
        _ => "s",
    };
    format!("{count} {one}{end}")
}

#[cfg(test)]
mod tests {
    use super::counted;

    #[test]
    fn one_is_singular() {
        assert_eq!(counted(1u32, "pixel"), "1 pixel");
        assert_eq!(counted(0usize, "pixel"), "0 pixels");
        assert_eq!(counted(2u64, "pass"), "2 passes");
        assert_eq!(counted(1u64, "mismatch"), "1 mismatch");
        assert_eq!(counted(3u64, "mismatch"), "3 mismatches");
    }
}
