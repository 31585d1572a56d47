//! The evaluation as text and as a page.

use super::EvaluateError;
use super::plot::{duplication_plot, operations_plot};
use super::row::{Evaluation, Group, Row, number};
use crate::kit::page::{rendered, text};
use minijinja::value::Serde;
use serde_json::{Value, json};

const INTRODUCTION: &str = "Every cost table of the two sources beside our own counts: Nyiri 1994, chapter 5 and the sections it builds on, and where it is named, Chaillou 1991, chapter IV. *Printed* is what the source prints; \
*corrected* is its own sum or formula done again where the print does not hold; *ours* is counted by running code and never typed in. The difference is that to the corrected value, else to the printed one. \
What is printed and not counted is at the end, with the reason.";
fn cells(row: &Row) -> [String; 8] {
    let or_dash = |value: Option<String>| value.unwrap_or_else(|| "-".into());
    let printed = match row.printed.text.as_str() {
        "nothing" => "-",
        text => text,
    };
    let percent = row.percent.map(|v| match v.abs() < 0.5 {
        true => "0 %".to_owned(),
        false => format!("{v:+.0} %"),
    });
    let difference = row.difference.map(|v| match v {
        v if v.abs() < 5e-4 => "0".to_owned(),
        v if v > 0.0 => format!("+{}", number(v)),
        v => number(v),
    });
    [
        row.name.clone(),
        printed.to_owned(),
        or_dash(row.corrected.map(number)),
        number(row.ours),
        row.unit.clone(),
        or_dash(difference.zip(percent).map(|(d, p)| format!("{d} ({p})"))),
        row.section.clone(),
        row.why.clone(),
    ]
}

fn values(evaluation: &Evaluation) -> Value {
    let row = |row: &Row| json!({ "cells": cells(row), "corrected": row.corrected.is_some(), "size": size(row) });
    let group = |group: &Group| {
        let rows: Vec<Value> = group.rows.iter().map(row).collect();
        json!({ "name": group.name, "title": group.title, "about": group.about, "rows": rows })
    };
    json!({
        "introduction": INTRODUCTION,
        "head": ["what", "printed", "corrected", "ours", "unit", "difference", "section", "why"],
        "groups": evaluation.groups.iter().map(group).collect::<Vec<Value>>(),
        "omitted": evaluation.omitted,
    })
}

/// All tables as Markdown.
pub fn markdown(evaluation: &Evaluation) -> Result<String, EvaluateError> {
    let template = include_str!("page/evaluation.md");
    Ok(text("cannot tell of it", template, values(evaluation))?)
}

/// The page: one file with everything in it.
pub fn page(evaluation: &Evaluation, version: &str) -> Result<String, EvaluateError> {
    let mut values = values(evaluation);
    values["version"] = json!(version);
    values["plots"] = json!([duplication_plot()?, operations_plot(evaluation)?]);
    values["style"] = json!(include_str!("page/evaluation.css"));
    let template = include_str!("page/evaluation.html");
    let values = minijinja::Value::from(Serde(values));
    Ok(rendered("the page cannot be made", template, values)?)
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
