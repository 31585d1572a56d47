//! Tiles of a shared chip, and the project that its template asks for.

pub(crate) mod cells;
pub(crate) mod layout;

use crate::description::Board;
use crate::error::BoardError;
use imogene_contract::tile::TileWords;
use imogene_contract::video::Span;
use imogene_rtl::emit::emit_tile;
use minijinja::value::Serde;
use minijinja::{Environment, Value, context};

/// The texts of a project, by their places in it.
const PROJECT: [(&str, &str); 6] = [
    ("info.yaml", include_str!("tile/info.yaml")),
    ("src/config.json", include_str!("tile/config.json")),
    ("docs/info.md", include_str!("tile/info.md")),
    ("test/Makefile", include_str!("tile/Makefile")),
    ("test/tb.v", include_str!("tile/tb.v")),
    ("test/test.py", include_str!("tile/test.py")),
];

/// What a project says of itself.
#[derive(Clone, Debug)]
pub struct About {
    /// Name of the scene: letters, digits and `_`.
    pub name: String,
    /// Title of the scene.
    pub title: String,
    /// The command that makes the project.
    pub command: String,
    /// Golden frames beside its test.
    pub frames: usize,
}

/// A tile.
#[derive(Clone, Debug)]
pub struct Tile {
    /// Name of its top module.
    pub top: String,
    /// All Verilog, the top module last.
    pub verilog: String,
    /// The other files of the project, without pictures.
    pub files: Vec<(&'static str, String)>,
    /// The tile with its reset as the top level of a board, for [`simulate`](crate::simulate).
    pub bench: String,
}

impl Tile {
    /// The tile of these words. Fails when a text cannot be made of its template. Panics when the board has no tiles.
    pub fn new(board: &Board, words: &TileWords, about: &About) -> Result<Tile, BoardError> {
        let top = format!("tt_um_imogene_{}", about.name);
        let prefix = format!("{}_", about.name);
        let emitted = emit_tile(words, &prefix, &about.command);
        let values = values(board, words, about, &top);
        let text = |template: &str| rendered(template, &values);
        let files = PROJECT.map(|(place, template)| Ok((place, text(template)?)));
        let project = text(include_str!("tile/project.v"))?;
        Ok(Tile {
            verilog: format!("{}\n{project}", emitted.bundle()),
            files: files.into_iter().collect::<Result<_, BoardError>>()?,
            bench: text(include_str!("tile/bench.v"))?,
            top,
        })
    }
}

/// All that the templates ask for.
fn values(board: &Board, words: &TileWords, about: &About, top: &str) -> Value {
    let tiles = board.tiles.as_ref().expect("a board of tiles");
    let pins = board.video.pins();
    let index = |name: &str| {
        let found = pins.iter().find(|(own, _)| own == name);
        found.and_then(|(_, pin)| output(pin))
    };
    let colours = ["red", "green", "blue"].map(|colour| {
        let bits = (0..board.video.bits().unwrap_or(0)).map(|bit| format!("{colour}_{bit}"));
        bits.filter_map(|name| index(&name)).collect::<Vec<usize>>()
    });
    let [hsync, vsync] = ["hsync", "vsync"].map(index);
    let names: Vec<String> = pins.iter().map(|(name, _)| name.clone()).collect();
    let of_output = |at: usize| {
        let found = pins.iter().find(|(_, pin)| output(pin) == Some(at));
        found.map_or("", |(name, _)| name)
    };
    let outputs = [0, 1, 2, 3, 4, 5, 6, 7].map(|at| of_output(at).to_owned());
    let span = |span: Span| {
        context! { active => span.active, total => span.total(), sync => span.sync, back => span.back }
    };
    let hertz = board.clock.hertz;
    context! {
        top, names, outputs, colours, hertz, pins => Value::from(Serde(&pins)),
        prefix => format!("{}_", about.name), title => &about.title, command => &about.command,
        frames => about.frames, tiles => &tiles.size, planes => words.planes.len(),
        width => words.window[0], height => words.window[1],
        mhz => hertz as f64 / 1e6, period => format!("{:.2}", 1e9 / hertz as f64),
        picoseconds => 2 * (500_000_000_000 / hertz),
        line => span(words.mode.line), frame => span(words.mode.frame),
        hsync_level => u8::from(words.mode.hsync_high), vsync_level => u8::from(words.mode.vsync_high),
        hsync_pin => hsync, vsync_pin => vsync,
    }
}

/// Which of the outputs a pin is.
fn output(pin: &str) -> Option<usize> {
    let index = pin.strip_prefix("uo_out[")?.strip_suffix(']')?;
    index.parse().ok().filter(|index| *index < 8)
}

/// A template with its values; a line break ends it.
pub(crate) fn rendered(template: &str, values: &Value) -> Result<String, BoardError> {
    let text = Environment::new().render_str(template, values)?;
    Ok(text.trim_end().to_owned() + "\n")
}
