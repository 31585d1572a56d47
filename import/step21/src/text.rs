//! Strings as they are meant (ISO 10303-21, clause 6.4.3), and words of messages.

/// A string from what stands between its quotes; a directive that is not understood stays as it is.
pub fn decoded(bytes: &[u8]) -> String {
    let raw = String::from_utf8_lossy(bytes).replace("''", "'");
    let mut text = String::new();
    let mut rest = raw.as_str();
    while let Some(place) = rest.find('\\') {
        text.push_str(&rest[..place]);
        rest = &rest[place..];
        let (taken, characters) = directive(rest).unwrap_or((1, "\\".into()));
        text.push_str(&characters);
        rest = &rest[taken..];
    }
    text.push_str(rest);
    text.replace(char::is_control, " ")
}

/// `a torus`, `an EDGE_CURVE`: a name with its article.
pub fn with_article(name: &str) -> String {
    // A u at the start of the names in question is that of "uniform".
    let vowel = name.starts_with(['a', 'e', 'i', 'o', 'A', 'E', 'I', 'O']);
    format!("{} {name}", if vowel { "an" } else { "a" })
}

/// The start of a long word, for a message.
pub fn shortened(word: &str) -> String {
    const LONGEST: usize = 80;
    match word.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &word[..end]),
        None => word.to_owned(),
    }
}

/// A directive at the start of a text: its length and what it stands for.
fn directive(text: &str) -> Option<(usize, String)> {
    let hexadecimal = |digits: &str, width: usize| {
        let number = |group| u32::from_str_radix(std::str::from_utf8(group).ok()?, 16).ok();
        let groups = digits.as_bytes().chunks(width);
        groups.map(number).collect::<Option<Vec<u32>>>()
    };
    match text.as_bytes() {
        [b'\\', b'\\', ..] => return Some((2, "\\".into())),
        [b'\\', b'N' | b'F', b'\\', ..] => return Some((3, " ".into())),
        [b'\\', b'P', _, b'\\', ..] => return Some((4, String::new())),
        _ => {}
    }
    if let Some(rest) = text.strip_prefix("\\S\\") {
        let letter = rest.chars().next().filter(char::is_ascii)?;
        return Some((4, char::from_u32(u32::from(letter) + 128)?.into()));
    }
    for (start, width) in [("\\X2\\", 4), ("\\X4\\", 8)] {
        if let Some(rest) = text.strip_prefix(start) {
            let end = rest.find("\\X0\\")?;
            let units = hexadecimal(&rest[..end], width)?;
            let characters: Option<String> = if width == 4 {
                let units = units.iter().map(|unit| *unit as u16);
                char::decode_utf16(units).map(Result::ok).collect()
            } else {
                units.into_iter().map(char::from_u32).collect()
            };
            return Some((start.len() + end + 4, characters?));
        }
    }
    let code = text.strip_prefix("\\X\\")?.get(..2)?;
    Some((5, char::from_u32(hexadecimal(code, 2)?[0])?.into()))
}
