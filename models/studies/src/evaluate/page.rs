//! The evaluation as text and as a page.

use super::EvaluateError;
use super::plot::{duplication_plot, operations_plot};
use super::row::{Evaluation, Row, number};
use crate::kit::page::{line, rendered};
use imogene_files::text::wrapped;
use minijinja::context;
use minijinja::value::Serde;
use serde_json::{Value, json};

const TEMPLATE: &str = include_str!("page/evaluation.html");
const STYLE: &str = include_str!("page/evaluation.css");

/// The command that makes the page of the documentation.
const COMMAND: &str = "imogene evaluate --out DIR";

const INTRODUCTION: &str = "Every cost table of the two sources beside our own counts: Nyiri 1994, chapter 5 and the sections it builds on, and where it is named, Chaillou 1991, chapter IV. *Printed* is what the source prints; \
*corrected* is its own sum or formula done again where the print does not hold; *ours* is counted by running code and never typed in. The difference is that to the corrected value, else to the printed one. \
What is printed and not counted is at the end, with the reason.";
fn cells(row: &Row) -> [String; 8] {
    let or_dash = |value: Option<String>| value.unwrap_or_else(|| "-".into());
    let printed = match row.printed.text.as_str() {
        "nothing" => "-".to_owned(),
        text => text.to_owned(),
    };
    let signed = |value: f64| match value {
        v if v > 0.0 => format!("+{}", number(v)),
        v => number(v),
    };
    let percent = row.percent.map(|v| match v.abs() {
        size if size < 0.5 => "0 %".to_owned(),
        _ => format!("{v:+.0} %"),
    });
    let difference = row.difference.map(|v| match v.abs() {
        size if size < 5e-4 => "0".to_owned(),
        _ => signed(v),
    });
    [
        row.name.clone(),
        printed,
        or_dash(row.corrected.map(number)),
        number(row.ours),
        row.unit.clone(),
        or_dash(difference.zip(percent).map(|(d, p)| format!("{d} ({p})"))),
        row.section.clone(),
        row.why.clone(),
    ]
}

const HEAD: [&str; 8] = [
    "what",
    "printed",
    "corrected",
    "ours",
    "unit",
    "difference",
    "section",
    "why",
];

/// All tables as Markdown.
pub fn markdown(evaluation: &Evaluation) -> String {
    let mut text = format!(
        "# Evaluation: the cost tables of the sources counted again\n\n{}\n\nMade by `{COMMAND}`. Do not edit.\n",
        wrapped(INTRODUCTION, "")
    );
    text += "\n![Zones that a box touches](images/duplication.svg)\n\n![Operations to prepare an object](images/operations.svg)\n";
    for group in &evaluation.groups {
        text += &format!(
            "\n## {}\n\n{}\n\n{}|---|---:|---:|---:|---|---:|---|---|\n",
            group.title,
            wrapped(&group.about, ""),
            line(&HEAD)
        );
        text.extend(group.rows.iter().map(|row| line(&cells(row))));
    }
    text +=
        "\n## Printed and not counted\n\n| what | section | printed | why |\n|---|---|---|---|\n";
    let omitted = evaluation.omitted.iter();
    text.extend(omitted.map(|one| line(&[&one.name, &one.section, &one.printed, &one.why])));
    text
}

/// The page: one file with everything in it.
pub fn page(evaluation: &Evaluation, version: &str) -> Result<String, EvaluateError> {
    let plots = [duplication_plot()?, operations_plot(evaluation)?];
    let groups = evaluation.groups.iter().map(|group| {
        let rows = group.rows.iter().map(|row| {
            json!({ "cells": cells(row), "corrected": row.corrected.is_some(), "size": size(row) })
        });
        let rows: Vec<Value> = rows.collect();
        json!({ "name": group.name, "title": group.title, "about": group.about, "rows": rows })
    });
    let rows = evaluation.groups.iter().map(|group| group.rows.len());
    let values = context! {
        groups => Serde(groups.collect::<Vec<Value>>()),
        omitted => Serde(&evaluation.omitted),
        introduction => INTRODUCTION.replace('*', ""),
        head => HEAD,
        rows => rows.sum::<usize>(),
        version,
        plots,
        style => STYLE,
    };
    Ok(rendered("the page cannot be made", TEMPLATE, values)?)
}

/// How far ours is from the source: the name of a style.
fn size(row: &Row) -> &'static str {
    match row.percent.map(f64::abs) {
        None => "none",
        Some(percent) if percent < 0.05 => "same",
        Some(percent) if percent <= 10.0 => "near",
        Some(_) => "far",
    }
}
