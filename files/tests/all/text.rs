use imogene_files::text::{COLUMNS, counted, wrapped, wrapped_page};

#[test]
fn prose_of_a_page_is_wrapped_and_nothing_else() {
    let long = "word ".repeat(40);
    let (long, table) = (long.trim_end(), format!("| {} |", "cell ".repeat(40)));
    let page = format!("# {long}\n\n{long}\nand more.\n\n* one\n* {long}\n  behind\n\n{table}\n");
    let text = wrapped_page(&page);
    let is_wide = |line: &&str| line.len() > COLUMNS;
    let wide: Vec<&str> = text.lines().filter(is_wide).collect();
    assert_eq!(wide, [&format!("# {long}"), &table]);
    let words = |text: &str| {
        text.split_whitespace()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(words(&text), words(&page));
    assert!(
        text.contains("\n* one\n* word") && text.contains("\n  word"),
        "{text}"
    );
    assert_eq!(wrapped_page(&text), text);
}

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
