//! Arguments of `render` for a picture that several workers draw.

use clap::Args;
use imogene_plan::split::Division;

/// Arguments of a divided picture.
#[derive(Clone, Copy, Debug, Args)]
pub struct Split {
    /// Divide the screen among workers that know nothing of each other: zones:WxH, or lines:N for N groups of
    /// interleaved lines (model golden).
    #[arg(long, value_name = "zones:WxH|lines:N", conflicts_with = "zone")]
    pub split: Option<Division>,
    /// Workers of a divided screen, 1 to 1024; worker i of N has the pieces i, i + N, i + 2 N, .. [default: one for
    /// each core].
    #[arg(long, value_name = "N", requires = "split", value_parser = clap::value_parser!(u16).range(1..=1_024))]
    pub workers: Option<u16>,
}
