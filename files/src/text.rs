//! Numbers in sentences, and sentences in lines.

use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm, fill};

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
pub const COLUMNS: usize = 120;

/// Markdown prose on as many lines as it needs, the later ones behind `indent`.
pub fn wrapped(prose: &str, indent: &str) -> String {
    // A mark stays behind the word before it.
    let glued = prose.split(' ').map(|word| match is_mark(word) {
        true => format!("{GLUE}{word}"),
        false => format!(" {word}"),
    });
    let options = Options::new(COLUMNS)
        .subsequent_indent(indent)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit)
        .break_words(false);
    let text = glued.collect::<String>();
    fill(text.trim_start_matches([' ', GLUE]), options).replace(GLUE, " ")
}

/// A page of Markdown with its paragraphs and items in lines of prose; headings, tables and pictures stay as they are.
pub fn wrapped_page(page: &str) -> String {
    let (mut lines, mut prose) = (vec![], String::new());
    let end = |prose: &mut String, lines: &mut Vec<String>| {
        if !prose.is_empty() {
            let indent = if prose.starts_with("* ") { "  " } else { "" };
            lines.push(wrapped(&std::mem::take(prose), indent));
        }
    };
    for line in page.lines() {
        let is_prose = !line.is_empty() && !line.starts_with(['#', '|', '!']);
        if !is_prose || line.starts_with("* ") {
            end(&mut prose, &mut lines);
        }
        match (is_prose, prose.is_empty()) {
            (false, _) => lines.push(line.to_owned()),
            (true, true) => line.clone_into(&mut prose),
            (true, false) => prose = format!("{prose} {}", line.trim_start()),
        }
    }
    end(&mut prose, &mut lines);
    lines.join("\n") + "\n"
}

/// Stands for a space at which no line ends; no text has it.
const GLUE: char = '\u{1}';

/// Whether Markdown reads a word at the beginning of a line as a mark.
fn is_mark(word: &str) -> bool {
    let number = word.trim_end_matches(['.', ')']);
    let is_item = number.len() < word.len() && number.chars().all(|c| c.is_ascii_digit());
    is_item || word == "*" || word.starts_with(['-', '+', '#', '=', '>', '|'])
}
