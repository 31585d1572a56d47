//! The bitstream as a witness: what it unpacks to, and Verilog that is made of it.

use crate::description::{Board, Family, Part};
use crate::error::BoardError;
use crate::flow::{Built, packed_text};
use crate::multipliers::{CELL, with_multipliers};
use crate::netlist::routed_models;
use crate::top::{MODELS, Sources, TOP};
use imogene_synth::tools::Tool;
use imogene_synth::{Target, cell_models};
use imogene_tools::{FileError, Program, read, scratch, write};
use std::path::Path;

const BITSTREAM: &str = "witness.bit";
const UNPACKED: &str = "unpacked.text";

/// The program of IceStorm that makes Verilog of an unpacked bitstream.
const ICEBOX: Program = Program::new("icebox_vlog", "fpga-icestorm");

/// Cells that Verilog of a bitstream instantiates.
const RAM: &str = "SB_RAM40_4K";

/// Cells that Verilog of a bitstream of a Gowin instantiates beside those of [`MODELS`].
const GOWIN_CELLS: [&str; 8] = [
    "LUT4",
    "MUX2",
    "DFFE",
    "DFFSE",
    "DFFRE",
    "DFFPE",
    "DFFCE",
    "RAM16SDP4",
];
/// Reads a bitstream of a Gowin.
const READER: &str = include_str!("top/gowin_reader.py");

/// Unpacks a bitstream, and packs it again: the same bits have to come out. What was unpacked, as text; of a Gowin it
/// is Verilog, which no packer reads. Fails when a tool is missing or fails, or other bits come out. Panics when the
/// board has no part that is placed and routed here.
pub fn unpack(board: &Board, sources: &Sources, bitstream: &[u8]) -> Result<String, BoardError> {
    let (part, tools) = board.routed();
    let folder = scratch()?;
    let folder = folder.path();
    let path = folder.join(BITSTREAM);
    std::fs::write(&path, bitstream).map_err(FileError::at(&path))?;
    let unpacker = tools.unpacker()?;
    if part.family == Family::Gowin {
        return read_gowin(part, sources, &unpacker, folder);
    }
    unpacker.run(&[BITSTREAM, UNPACKED], folder)?;
    let again = packed_text(board, UNPACKED, folder)?;
    if again != bitstream {
        let apart = again.iter().zip(bitstream).filter(|(a, b)| a != b);
        return Err(BoardError::Bitstream(format!(
            "the bitstream of {} bytes, unpacked and packed again, has {} bytes, of which {} differ",
            bitstream.len(),
            again.len(),
            apart.count()
        )));
    }
    Ok(read(&folder.join(UNPACKED))?)
}

/// Verilog of a bitstream in the folder, by the library behind its unpacker.
fn read_gowin(
    part: &Part,
    sources: &Sources,
    unpacker: &Tool,
    folder: &Path,
) -> Result<String, BoardError> {
    let (_, constraints) = sources.constraints.as_ref().expect("constraints of a part");
    write(&folder.join("pins.cst"), constraints)?;
    write(&folder.join("reader.py"), READER)?;
    let mut python = unpacker.clone();
    python.path = unpacker.path.with_file_name("python3");
    let [device, number] = [&part.device, &part.package].map(String::as_str);
    let arguments = ["reader.py", device, number, BITSTREAM, "pins.cst", UNPACKED];
    python.run(&arguments, folder)?;
    let verilog = read(&folder.join(UNPACKED))?;
    // No model knows them.
    for key in ["IDIV_SEL", "FBDIV_SEL", "ODIV_SEL", "DIV_MODE"] {
        let [wanted, found] = [&sources.verilog, &verilog].map(|text| value(text, key));
        if wanted != found {
            return Err(BoardError::Bitstream(format!(
                "{key} of the clocks is {found} in the bitstream and {wanted} in its sources"
            )));
        }
    }
    Ok(verilog)
}

/// The value of the only parameter of a name.
fn value<'a>(verilog: &'a str, key: &str) -> &'a str {
    let rest = verilog.split_once(&format!(".{key}("));
    let value = rest.and_then(|(_, rest)| Some(rest.split_once(')')?.0));
    value.unwrap_or_default()
}

/// Verilog of a board and the models of its cells for [`simulate`](crate::simulate): of an iCE40 made of what was
/// unpacked, of a Gowin that itself, of an ECP5 the routed netlist. Fails when a tool is missing or fails, or there is
/// no model of a cell. Panics when the board has no part.
pub fn witness(
    board: &Board,
    sources: &Sources,
    built: &Built,
    unpacked: &str,
) -> Result<[String; 2], BoardError> {
    match &built.netlist {
        Some(Ok(netlist)) => return Ok([netlist.clone(), routed_models()?]),
        Some(Err(problem)) => return Err(BoardError::NoModel(problem.clone())),
        None => (),
    }
    let part = board.part.as_ref().expect("a board with a part");
    if part.family == Family::Gowin {
        let models = cell_models(&GOWIN_CELLS, Target::Gowin)? + MODELS;
        return Ok([unpacked.to_owned(), models]);
    }
    let folder = scratch()?;
    let folder = folder.path();
    write(&folder.join(UNPACKED), unpacked)?;
    let (_, constraints) = sources.constraints.as_ref().expect("constraints of a part");
    write(&folder.join("pins.pcf"), constraints)?;
    let arguments = ["-n", TOP, "-p", "pins.pcf", "-d", &part.package, UNPACKED];
    let mut verilog = ICEBOX.run(arguments, folder)?;
    let mut cells = vec![RAM];
    if part.has_multipliers() {
        verilog = with_multipliers(&verilog, unpacked)?;
        cells.push(CELL);
    }
    if board.clock.pad {
        verilog = with_pad(&verilog);
    }
    let models = cell_models(&cells, Target::Ice40Hx8k)? + MODELS;
    Ok([declared_once(&verilog), models])
}

/// The same Verilog with the pin of the clock at the pad of its PLL, which `icebox_vlog` leaves open.
pub fn with_pad(verilog: &str) -> String {
    const PAD: &str = ".PACKAGEPIN(";
    let Some((before, after)) = verilog.split_once(PAD) else {
        return verilog.to_owned();
    };
    let rest = after.split_once(')').map_or(after, |(_, rest)| rest);
    format!("{before}{PAD}clock){rest}")
}

/// The same Verilog without the second declarations of its ports, which a list of ports with directions does not allow;
/// a port that is a register is one in the list, and starts at 0 as all of them.
pub fn declared_once(verilog: &str) -> String {
    let is_head = |line: &&str| line.starts_with("module ");
    let head = verilog.lines().find(is_head).unwrap_or_default();
    let ports = head.trim_end_matches(");").split(['(', ',']).skip(1);
    let ports = ports.filter_map(|port| port.split_whitespace().last());
    let ports: Vec<&str> = ports.collect();
    let (mut text, mut registers) = (String::new(), vec![]);
    for line in verilog.lines() {
        let mut kinds = ["wire ", "reg "].into_iter();
        let Some(kind) = kinds.find(|kind| line.starts_with(kind) && line.ends_with(';')) else {
            text += &format!("{line}\n");
            continue;
        };
        let names = line[kind.len()..line.len() - 1].split(", ");
        let is_port = |name: &&str| {
            let mut words = name.split(' ');
            words.next().is_some_and(|name| ports.contains(&name))
        };
        let (again, own): (Vec<&str>, Vec<&str>) = names.partition(is_port);
        if kind == "reg " {
            registers.extend(again.iter().filter_map(|name| name.split(' ').next()));
        }
        if !own.is_empty() {
            text += &format!("{kind}{};\n", own.join(", "));
        }
    }
    let mut declared = head.to_owned();
    for port in registers {
        for end in [',', ')'] {
            let register = format!("output reg {port} = 0{end}");
            declared = declared.replace(&format!("output {port}{end}"), &register);
        }
    }
    text.replacen(head, &declared, 1)
}
