//! Pages and tables.

use super::DrawError;
use minijinja::{Environment, Value};

/// A page from its template; `what` begins the message if it cannot be made.
pub fn rendered(what: &str, template: &str, values: Value) -> Result<String, DrawError> {
    let mut environment = Environment::new();
    // By its name the text is escaped.
    let page = environment.add_template("page.html", template);
    let page = page.and_then(|()| environment.get_template("page.html")?.render(values));
    page.map_err(|error| DrawError {
        what: what.into(),
        problem: format!("{error:#}"),
    })
}

/// A line of a Markdown table.
pub fn line<S: AsRef<str>>(cells: &[S]) -> String {
    let cells: Vec<&str> = cells.iter().map(AsRef::as_ref).collect();
    format!("| {} |\n", cells.join(" | "))
}
