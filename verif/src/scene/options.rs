//! How a scene is co-simulated.

use crate::waveform::WaveformRequest;
use std::fmt;
use std::str::FromStr;

/// A wrong bit in one coefficient word of the hardware, to see that the co-simulation finds it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Slot.
    pub object: u8,
    /// Load address.
    pub address: u8,
    /// Bit of the word.
    pub bit: u8,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.object, self.address, self.bit)
    }
}

impl FromStr for Fault {
    type Err = String;

    fn from_str(text: &str) -> Result<Fault, String> {
        let numbers: Option<Vec<u8>> = text.split(':').map(|part| part.parse().ok()).collect();
        match numbers.as_deref() {
            Some(&[object, address, bit]) => Ok(Fault {
                object,
                address,
                bit,
            }),
            _ => Err("expected OBJECT:ADDRESS:BIT, three numbers below 256, such as 0:2:5".into()),
        }
    }
}

/// How to run.
#[derive(Clone, Debug)]
pub struct Options {
    /// Rows of the root network per register stage.
    pub rows_per_stage: usize,
    /// Threads, each with an engine of its own.
    pub threads: usize,
    /// Waveforms of the band in which the window begins.
    pub trace: Option<WaveformRequest>,
    /// Slot whose inside they show.
    pub traced: usize,
    /// Fault put into the hardware.
    pub fault: Option<Fault>,
}

impl Options {
    /// A run without waveforms and faults.
    pub fn plain(rows_per_stage: usize, threads: usize) -> Options {
        Options {
            rows_per_stage,
            threads,
            trace: None,
            traced: 0,
            fault: None,
        }
    }
}
