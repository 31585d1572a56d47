//! Options of `import` for face lists and STEP files.

use clap::Args;

/// Options of face lists and STEP files.
#[derive(Clone, Debug, Args)]
pub struct FaceOptions {
    /// Most that an approximated border may be off, in units of the list, or mm of a STEP file, or in pixels of the
    /// scene's picture as in 0.5px; 0 rejects what is not exact. A thousandth of the part's size by default.
    #[arg(long, value_name = "LENGTH", value_parser = deviation)]
    pub max_deviation: Option<Deviation>,
    /// Compile each face by itself, also where a whole solid is one cut quadric.
    #[arg(long)]
    pub no_volumes: bool,
}

/// Most that something may be off.
#[derive(Clone, Copy, Debug)]
pub enum Deviation {
    /// In units of the scene.
    Length(f64),
    /// In pixels of the picture that the scene asks for.
    Pixels(f64),
}

/// A finite number that is not negative, with or without `px` behind it.
fn deviation(text: &str) -> Result<Deviation, String> {
    let (number, kind): (&str, fn(f64) -> Deviation) = match text.strip_suffix("px") {
        Some(number) => (number.trim_end(), Deviation::Pixels),
        None => (text, Deviation::Length),
    };
    match number.parse::<f64>() {
        Ok(value) if value.is_finite() && value >= 0.0 => Ok(kind(value)),
        _ => Err("a length, 0 or more, is needed, such as 0.01, or pixels as in 0.5px".to_owned()),
    }
}
