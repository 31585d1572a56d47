//! Words of messages.

/// `a torus`, `an EDGE_CURVE`: a name with its article.
pub fn with_article(name: &str) -> String {
    // A u at the start of the names in question is that of "uniform".
    let article = if name.starts_with(['a', 'e', 'i', 'o', 'A', 'E', 'I', 'O']) {
        "an"
    } else {
        "a"
    };
    format!("{article} {name}")
}
