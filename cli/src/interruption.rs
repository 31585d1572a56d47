//! Signals that tell the process to end.

use crate::arguments::Command;
use crate::output;
use imogene_files::end_process;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::iterator::Signals;

/// Clears away and ends the process when it is interrupted or terminated, with 128 and the signal's number as shells
/// do.
pub fn watch(command: &Command) {
    let note = match command {
        Command::Trade(_) => {
            "the points that were finished are kept; the same command goes on from there"
        }
        _ => "no output of this run is left half-written",
    };
    // Without the handler the signals end the process as they always do.
    let Ok(mut signals) = Signals::new([SIGINT, SIGTERM]) else {
        return;
    };
    std::thread::spawn(move || {
        if let Some(signal) = signals.forever().next() {
            output::complain(format!("interrupted: {note}"));
            end_process(128 + signal);
        }
    });
}
