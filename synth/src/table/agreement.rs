//! Whether the page of the table and the file of its figures tell the same.

use super::rows::Section;
use super::{markdown, transistors};
use crate::baseline::{Baseline, BaselineRow};

/// What the page does not say as the baseline does; nothing if they agree.
pub fn disagreements(page: &str, baseline: &Baseline) -> Vec<String> {
    let mut problems = Vec::new();
    if !page.contains(&baseline.verilog) {
        problems.push(format!("the page has no digest {}", baseline.verilog));
    }
    let missing = baseline.rows.iter().filter_map(|row| {
        let wanted = line(row);
        let part = part(page, row);
        let is_there = part.lines().any(|line| line.starts_with(&wanted));
        (!is_there).then(|| format!("{} has no line `{wanted}`", row.target))
    });
    problems.extend(missing);
    let known = baseline.rows.iter();
    let lines = known.filter(|row| row.section != Section::Transistors);
    let (written, expected) = (measured_lines(page), lines.count());
    if written != expected {
        problems.push(format!(
            "{written} measured lines on the page, {expected} in the baseline"
        ));
    }
    problems
}

/// Lines of the page's tables of devices.
fn measured_lines(page: &str) -> usize {
    let transistors = format!("\n## {}\n", markdown::title(Section::Transistors));
    let devices = page.split(&transistors).next().unwrap_or_default();
    let lines = devices.lines();
    lines.filter(|line| line.starts_with("| `")).count()
}

/// The beginning of the row's line, with every figure of it.
fn line(row: &BaselineRow) -> String {
    match row.section {
        Section::Transistors => {
            let line = transistors::line(&row.unit, row.figures.transistors.unwrap_or_default());
            line.trim_end().to_owned()
        }
        section => {
            let name = markdown::name(section, &row.unit, &row.parameters);
            markdown::line_start(&name, row.latency, &row.figures)
        }
    }
}

/// The part of the page where the row is shown.
fn part<'a>(page: &'a str, row: &BaselineRow) -> &'a str {
    let section = after(page, "\n## ", markdown::title(row.section));
    match row.section {
        Section::Transistors => section,
        _ => after(section, "\n### ", &row.target),
    }
}

/// The text between a heading and the next of its level; empty without the heading.
fn after<'a>(text: &'a str, level: &str, title: &str) -> &'a str {
    let parts = text.split(level).skip(1);
    let found = parts.filter_map(|part| part.split_once('\n'));
    found
        .filter(|(heading, _)| *heading == title)
        .map(|(_, part)| part)
        .next()
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::super::tests::invented;
    use super::*;

    #[test]
    fn page_and_figures_of_one_table_agree() {
        let table = invented();
        let problems = disagreements(&table.markdown(), &Baseline::of(&table));
        assert_eq!(problems, Vec::<String>::new());
    }

    #[test]
    fn every_figure_that_differs_is_found() {
        let table = invented();
        let page = table.markdown();
        for index in 0..table.rows().len() {
            let mut baseline = Baseline::of(&table);
            let row = &mut baseline.rows[index];
            match row.section {
                Section::Transistors => row.figures.transistors = Some(1),
                _ => row.figures.carry = Some(1),
            }
            let problems = disagreements(&page, &baseline);
            assert_eq!(problems.len(), 1, "row {index}: {problems:?}");
        }
    }

    #[test]
    fn another_digest_and_a_row_too_few_are_found() {
        let table = invented();
        let page = table.markdown();
        let mut baseline = Baseline::of(&table);
        baseline.verilog = "4567".into();
        assert_eq!(disagreements(&page, &baseline).len(), 1);
        let mut baseline = Baseline::of(&table);
        baseline.rows.remove(0);
        assert_eq!(disagreements(&page, &baseline).len(), 1);
    }
}
