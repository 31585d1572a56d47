//! Pages and tables.

use super::DrawError;
use imogene_files::text::{counted, wrapped};
use minijinja::syntax::SyntaxConfig;
use minijinja::value::Serde;
use minijinja::{Environment, Error, ErrorKind, UndefinedBehavior, Value};
use serde::Serialize;

/// A page of HTML from its template; `what` begins the message if it cannot be made.
pub fn rendered(what: &str, template: &str, values: Value) -> Result<String, DrawError> {
    let mut environment = Environment::new();
    // By its name the text is escaped.
    let page = environment.add_template("page.html", template);
    let page = page.and_then(|()| environment.get_template("page.html")?.render(values));
    page.map_err(failed(what))
}

fn failed(what: &str) -> impl Fn(Error) -> DrawError {
    move |error| DrawError(what.into(), format!("{error:#}"))
}

/// A text from its template, over values by their keys in JSON; `what` begins the message if it cannot be made.
///
/// A line of statements alone leaves no line behind. Numbers are printed by the filters [`fixed`], [`power`], `digits`
/// and `figure`; `counted` says how many there are of something, and `wrapped` breaks prose into lines.
pub fn text(what: &str, template: &str, values: impl Serialize) -> Result<String, DrawError> {
    let mut syntax = SyntaxConfig::builder();
    syntax.trim_blocks(true).lstrip_blocks(true);
    let syntax = syntax.keep_trailing_newline(true).build();
    let mut environment = Environment::new();
    environment.set_syntax(syntax.map_err(failed(what))?);
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.add_filter("fixed", fixed);
    environment.add_filter("power", power);
    environment.add_filter("figure", |value: &Value| printed(value, figure));
    environment.add_filter("digits", |value: &Value, count: i32| {
        printed(value, |value| digits(value, count))
    });
    environment.add_filter("counted", |count: u64, one: &str| counted(count, one));
    environment.add_filter("wrapped", |prose: &str, indent: Option<&str>| {
        wrapped(prose, indent.unwrap_or_default())
    });
    let text = environment.render_str(template, Serde(values));
    text.map_err(failed(what))
}

/// A report with what stands in its text alone.
pub fn with(report: impl Serialize, others: serde_json::Value) -> impl Serialize {
    #[derive(Serialize)]
    struct With<T> {
        #[serde(flatten)]
        report: T,
        #[serde(flatten)]
        others: serde_json::Value,
    }
    With { report, others }
}

/// A number with so many digits after the point, or as many as it has; a dash if it is none.
pub fn fixed(value: &Value, digits: Option<usize>) -> Result<String, Error> {
    printed(value, |number| match digits {
        Some(digits) => format!("{number:.digits$}"),
        None => number.to_string(),
    })
}

/// A number with a power of ten, and so many digits after the point.
pub fn power(value: &Value, digits: usize) -> Result<String, Error> {
    printed(value, |number| format!("{number:.digits$e}"))
}

fn printed(value: &Value, print: impl FnOnce(f64) -> String) -> Result<String, Error> {
    if value.is_undefined() {
        return Err(Error::from(ErrorKind::UndefinedError));
    }
    if value.is_none() {
        return Ok("-".into());
    }
    f64::try_from(value.clone()).map(print)
}

fn digits(value: f64, count: i32) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let decimals = (count - 1 - value.abs().log10().floor() as i32).max(0) as usize;
    format!("{value:.decimals$}")
}

/// Three significant digits; an exponent where the number would be long.
fn figure(value: f64) -> String {
    match value.abs() {
        size if !size.is_finite() => "none".into(),
        size if size == 0.0 || (1e-3..1e5).contains(&size) => digits(value, 3),
        _ => format!("{value:.2e}"),
    }
}
