//! Numbers in sentences, and sentences in lines.

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

/// Columns of a line of prose at most.
const COLUMNS: usize = 120;

/// Markdown prose on as many lines as it needs, the later ones behind `indent`.
pub fn wrapped(prose: &str, indent: &str) -> String {
    let mut words: Vec<String> = Vec::new();
    for word in prose.split(' ') {
        match words.last_mut() {
            Some(before) if is_mark(word) => *before += &format!(" {word}"),
            _ => words.push(word.to_owned()),
        }
    }
    let mut text = String::new();
    let mut column = 0;
    for word in words {
        let length = word.chars().count();
        if column > 0 && column + 1 + length > COLUMNS {
            text += &format!("\n{indent}");
            column = indent.len();
        } else if column > 0 {
            text.push(' ');
            column += 1;
        }
        text += &word;
        column += length;
    }
    text
}

/// Whether Markdown reads a word at the beginning of a line as a mark.
fn is_mark(word: &str) -> bool {
    let number = word.trim_end_matches(['.', ')']);
    let is_item = number.len() < word.len() && number.chars().all(|c| c.is_ascii_digit());
    is_item || word == "*" || word.starts_with(['-', '+', '#', '=', '>', '|'])
}

#[cfg(test)]
mod tests {
    use super::{COLUMNS, counted, wrapped};

    #[test]
    fn lines_are_full_and_none_begins_with_a_mark() {
        let prose = "of lines and of words ".repeat(50) + "+ 1";
        let text = wrapped(&prose, "  ");
        assert_eq!(text.replace("\n ", ""), prose);
        let lengths: Vec<usize> = text.lines().map(str::len).collect();
        let (_, full) = lengths.split_last().expect("a line");
        let mut full = full.iter();
        assert!(full.all(|length| (COLUMNS - 5..=COLUMNS).contains(length)));
        for mark in ["+", "-1", "12.", "#", "*"] {
            let prose = format!("{} word {mark}", "x".repeat(COLUMNS - 6));
            let text = wrapped(&prose, "");
            assert!(text.ends_with(&format!("\nword {mark}")), "{text}");
        }
    }

    #[test]
    fn one_is_singular() {
        assert_eq!(counted(1u32, "pixel"), "1 pixel");
        assert_eq!(counted(0usize, "pixel"), "0 pixels");
        assert_eq!(counted(2u64, "pass"), "2 passes");
        assert_eq!(counted(1u64, "mismatch"), "1 mismatch");
        assert_eq!(counted(3u64, "mismatch"), "3 mismatches");
    }
}
