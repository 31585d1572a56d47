//! Arguments of waveforms.

use clap::Args;
use imogene_verif::waveform::file::save_path;
use imogene_verif::waveform::{Place, WaveformRequest, WindowStart};
use std::path::PathBuf;

/// Which waveforms of a run are written.
#[derive(Clone, Debug, Args)]
pub struct Waves {
    /// Waveforms of hardware and golden model, with a GTKWave save file beside them: FST if the name ends in .fst, and
    /// VCD otherwise.
    #[arg(long, value_name = "FILE.vcd|FILE.fst")]
    pub vcd: Option<PathBuf>,
    /// Where they begin in the picture: X,Y of a pixel, line:Y, frame:N (a machine's frames count from 1; without one,
    /// the first that shows a scene), or frame:N,X,Y or frame:N,line:Y. If not given: of a scene the middle line of the
    /// traced object, of a machine with a screen the first clock.
    #[arg(long, value_name = "PLACE", requires = "vcd")]
    pub vcd_from: Option<Place>,
    /// Clocks of the waveforms; those around the first mismatch come in addition.
    #[arg(long, default_value_t = 2_000, value_name = "N", requires = "vcd")]
    pub vcd_clocks: u64,
    /// Keep waveforms around the first mismatch alone.
    #[arg(long, requires = "vcd", conflicts_with_all = ["vcd_from", "vcd_clocks"])]
    pub vcd_at_mismatch: bool,
    /// Nets inside the machine as well, by their paths in the Verilog, such as processors_0.quadric.near_sum; the path
    /// of an instance is all nets in it and below, and all is every net. The built-in engine shows them.
    #[arg(long, value_name = "PATH,..", requires = "vcd", value_delimiter = ',')]
    pub vcd_nets: Vec<String>,
}

impl Waves {
    /// What a run is asked for.
    pub fn request(&self) -> Option<WaveformRequest> {
        self.vcd.as_ref().map(|_| WaveformRequest {
            from: match (self.vcd_from, self.vcd_at_mismatch) {
                (_, true) => WindowStart::Mismatch,
                (Some(place), _) => WindowStart::At(place),
                (None, _) => WindowStart::Usual,
            },
            clocks: self.vcd_clocks,
            nets: self.vcd_nets.clone(),
        })
    }

    /// The files that may be written.
    pub fn files(&self) -> Vec<PathBuf> {
        let files = self.vcd.iter();
        let files = files.flat_map(|path| [path.clone(), save_path(path)]);
        files.collect()
    }
}
