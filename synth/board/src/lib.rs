//! Boards: their grammar, clocks, top levels, bitstreams, and what their pins show (`docs/boards.md`).
//!
//! ```
//! use imogene_board::{Board, Pll};
//! use num_rational::Ratio;
//!
//! let board = Board::named("ulx3s-85")?;
//! let pll = Pll::of(&board, 25_175_000)?;
//! // 25 MHz / 7 x 141 / 20, 0.014 % above the clock of the mode.
//! assert_eq!(pll.pixel_hertz, Ratio::new(176_250_000, 7));
//! # Ok::<(), imogene_board::BoardError>(())
//! ```
#![warn(missing_docs)]

mod count;
mod description;
mod error;
mod flow;
pub mod multipliers;
pub mod netlist;
mod page;
mod pll;
mod screen;
mod simulate;
mod stays;
mod tile;
mod tmds;
mod top;
mod witness;

pub use count::count;
pub use description::{Board, BoardMode, Clock, Family, Part, Tiles, Video};
pub use error::BoardError;
pub use flow::{Built, ClockReport, Routed, find_tools, is_crowded, route, unplaced};
pub use page::{core_file, page};
pub use pll::{Dividers, Pll};
pub use screen::{Screen, ScreenError, Shown, Tick};
pub use simulate::{Pins, simulate, simulate_gates};
pub use stays::stays;
pub use tile::cells::{Library, Mapped, cell_delays};
pub use tile::layout::{Layout, LayoutTexts, lay_out, layout, with_short_names};
pub use tile::{About, Tile};
pub use tmds::{Channels, Decoder, TmdsError};
pub use top::{Display, MODELS, Sources, sources};
pub use witness::{declared_once, unpack, with_pad, witness};
