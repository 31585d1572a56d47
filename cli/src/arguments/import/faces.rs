//! Options of `import` for face lists and STEP files.

use clap::Args;

/// Options of face lists and STEP files.
#[derive(Clone, Debug, Args)]
pub struct FaceOptions {
    /// Most that an approximated border may be off, in units of the list, or mm of a STEP file; 0 rejects what is not exact. A thousandth of the part's size by default.
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    pub max_deviation: Option<f64>,
    /// Compile each face by itself, also where a whole solid is one cut quadric.
    #[arg(long)]
    pub no_volumes: bool,
}

/// A finite number that is not negative.
fn length(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value >= 0.0 => Ok(value),
        _ => Err("a length, 0 or more, is needed".to_owned()),
    }
}
