//! The bitstream as a witness: what it unpacks to, and Verilog that is made of it.

use crate::description::{Board, Family};
use crate::error::BoardError;
use crate::flow::{Routed, failed, packed_text};
use crate::top::{MODELS, Sources, TOP};
use imogene_synth::tools::Tool;
use imogene_synth::{Target, cell_models};
use imogene_tools::{Program, write};
use std::path::Path;

const BITSTREAM: &str = "witness.bit";
const UNPACKED: &str = "unpacked.text";

/// The program of IceStorm that makes Verilog of an unpacked bitstream.
const ICEBOX: Program = Program {
    name: "icebox_vlog",
    package: "fpga-icestorm",
};

/// Cells that Verilog of a bitstream instantiates.
const RAM: &str = "SB_RAM40_4K";

/// Unpacks a bitstream in a folder, and packs it again: the same bits have to come out. Of an iCE40 what was unpacked
/// is turned back into Verilog with the models of its cells, for [`simulate`](crate::simulate).
///
/// # Errors
///
/// When a tool is missing or fails, or other bits come out.
///
/// # Panics
///
/// When the board has no part.
pub fn witness(
    board: &Board,
    sources: &Sources,
    routed: &Routed,
    folder: &Path,
) -> Result<Option<[String; 2]>, BoardError> {
    let part = board.part.as_ref().expect("a board with a part");
    let path = folder.join(BITSTREAM);
    std::fs::write(&path, &routed.bitstream).map_err(imogene_tools::FileError::at(&path))?;
    let unpacker = Tool::beside(part.router(), part.packers()[2])?;
    let outcome = unpacker.run(&[BITSTREAM, UNPACKED], folder)?;
    outcome.map_err(|said| failed(&unpacker, &said))?;
    let again = packed_text(part, UNPACKED, folder)?;
    if again != routed.bitstream {
        let apart = again.iter().zip(&routed.bitstream).filter(|(a, b)| a != b);
        return Err(BoardError::Bitstream(format!(
            "the bitstream of {} bytes, unpacked and packed again, has {} bytes, of which {} differ",
            routed.bitstream.len(),
            again.len(),
            apart.count()
        )));
    }
    if part.family != Family::Ice40 {
        return Ok(None);
    }
    let (_, constraints) = sources.constraints.as_ref().expect("constraints of a part");
    write(&folder.join("pins.pcf"), constraints)?;
    let arguments = [
        "-s",
        "-n",
        TOP,
        "-p",
        "pins.pcf",
        "-d",
        &part.package,
        UNPACKED,
    ];
    let verilog = ICEBOX.run(arguments, folder)?;
    let models = cell_models(&[RAM], Target::Ice40Hx8k)? + MODELS;
    Ok(Some([verilog, models]))
}
