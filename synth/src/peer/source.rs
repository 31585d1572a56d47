//! The Verilog of a peer: its files, its top module, its ports.

use super::design::{Peer, is_system_verilog};
use crate::cache::digest;
use crate::error::{PeerError, SynthError};
use crate::harness::bits;
use crate::tools::Tool;
use crate::yosys;
use imogene_rtl::emit::{Direction, Port};
use imogene_tools::{FileError, read, write};
use serde_json::Value;
use std::path::Path;

/// Most bytes of a Verilog file.
const MAX_BYTES: u64 = 64 << 20;
/// Names of a clock port that are looked for if none is given.
const CLOCKS: [&str; 2] = ["clk", "clock"];

/// The files of a peer, copied into the folder of a bench: the packaged Yosys sees no others.
pub(super) struct Source<'a> {
    peer: &'a Peer,
    folder: &'a Path,
    /// Commands that read them and set the parameters.
    pub read: String,
    /// Digest of all files.
    pub digest: String,
}

impl<'a> Source<'a> {
    pub fn new(peer: &'a Peer, folder: &'a Path) -> Result<Self, SynthError> {
        let mut include = String::new();
        for (index, from) in peer.include.iter().enumerate() {
            copy_folder(from, &folder.join(format!("include{index}")))?;
            include += &format!(" -Iinclude{index}");
        }
        let mut all = String::new();
        let mut commands = Vec::new();
        for (index, file) in peer.files.iter().enumerate() {
            let text = imogene_files::read_text(file, MAX_BYTES).map_err(FileError::at(file))?;
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            let own = format!("file{index}");
            std::fs::create_dir_all(folder.join(&own)).map_err(FileError::at(folder))?;
            write(&folder.join(format!("{own}/{name}")), &text)?;
            let sv = if is_system_verilog(file)? { " -sv" } else { "" };
            commands.push(format!("read_verilog{sv}{include} {own}/{name}"));
            all += &text;
        }
        commands.push(format!("tee -q -o {MODULES} ls"));
        if !peer.parameters.is_empty() {
            let set = |(name, value): &(String, String)| format!(" -set {name} {value}");
            let set: String = peer.parameters.iter().map(set).collect();
            // A module with parameters set is called by them once the hierarchy is known; it gets its own name back.
            let top = &peer.top;
            commands.push(format!(
                "chparam{set} {top}; hierarchy -check -top {top}; rename -top {top}"
            ));
        }
        Ok(Self {
            peer,
            folder,
            read: commands.join("; "),
            digest: digest(&all),
        })
    }

    /// Ports of the top module, and which of them is the clock.
    pub fn ports(&self, yosys: &Tool) -> Result<(Vec<Port>, String), SynthError> {
        let script = format!(
            "{}; hierarchy -check -top {}; proc; write_json {PORTS}",
            self.read, self.peer.top
        );
        yosys::run(yosys, self.folder, &script).map_err(|error| match error {
            SynthError::Tool { message, .. } => self.refusal(&message).into(),
            error => error,
        })?;
        let text = read(&self.folder.join(PORTS))?;
        Ok(ports_and_clock(self.peer, &text)?)
    }

    fn refusal(&self, message: &str) -> PeerError {
        let listed = std::fs::read_to_string(self.folder.join(MODULES));
        let modules = modules(&listed.unwrap_or_default());
        if !modules.is_empty() && !modules.contains(&self.peer.top) {
            return PeerError::Top(self.peer.top.clone(), modules);
        }
        let mut lines = message.lines().rev();
        let line = lines.find(|line| line.contains("ERROR"));
        PeerError::Refused(line.unwrap_or(message).to_owned())
    }
}

/// Files of the folder: the modules before the hierarchy is known, and the netlist that tells the ports.
const MODULES: &str = "modules.txt";
const PORTS: &str = "ports.json";

/// The names in what `ls` prints: a heading, and every module on a line of its own.
pub fn modules(listed: &str) -> Vec<String> {
    let names = listed.lines().filter_map(|line| line.strip_prefix("  "));
    names.map(|name| name.trim().to_owned()).collect()
}

/// Reads the ports of the top module from a netlist of Yosys, and which of them is the clock. Fails when it is no
/// netlist of that module, the module has no such clock, no input or no output, or has an inout.
pub fn ports_and_clock(peer: &Peer, netlist: &str) -> Result<(Vec<Port>, String), PeerError> {
    let netlist: Value = serde_json::from_str(netlist)
        .map_err(|error| PeerError::Refused(format!("its netlist: {error}")))?;
    let top = peer.top.clone();
    let ports = netlist["modules"][&peer.top]["ports"]
        .as_object()
        .ok_or_else(|| PeerError::Refused(format!("its netlist has no ports of `{top}`")))?;
    // Yosys numbers bits in the order of the ports, which the keys of the document have lost.
    let mut ports: Vec<(&String, &Value)> = ports.iter().collect();
    ports.sort_by_key(|(_, port)| port["bits"][0].as_u64());
    let ports = ports.into_iter();
    let ports = ports.map(|(name, port)| parse_port(&top, name, port));
    let ports: Vec<Port> = ports.collect::<Result<_, _>>()?;
    let clock = find_clock(peer, &ports)?;
    let data: Vec<&Port> = ports.iter().filter(|port| port.name != clock).collect();
    for direction in [Direction::In, Direction::Out] {
        if bits(&data, direction) == 0 {
            return Err(PeerError::NoData(top, direction.keyword()));
        }
    }
    Ok((ports, clock))
}

fn parse_port(top: &str, name: &str, port: &Value) -> Result<Port, PeerError> {
    let direction = match port["direction"].as_str() {
        Some("input") => Direction::In,
        Some("output") => Direction::Out,
        _ => return Err(PeerError::Inout(name.to_owned(), top.to_owned())),
    };
    Ok(Port {
        meaning: String::new(),
        name: name.to_owned(),
        direction,
        width: port["bits"].as_array().map_or(0, Vec::len),
        signed: port["signed"] == 1,
    })
}

fn find_clock(peer: &Peer, ports: &[Port]) -> Result<String, PeerError> {
    let wanted: Vec<&str> = match &peer.clock {
        Some(clock) => vec![clock],
        None => CLOCKS.to_vec(),
    };
    let is_clock = |port: &&Port| {
        port.direction == Direction::In && port.width == 1 && wanted.contains(&&*port.name)
    };
    let found = ports.iter().find(is_clock);
    found.map(|port| port.name.clone()).ok_or_else(|| {
        let names: Vec<String> = wanted.iter().map(|name| format!("`{name}`")).collect();
        PeerError::Clock {
            top: peer.top.clone(),
            wanted: names.join(" or "),
            ports: ports.iter().map(describe).collect(),
        }
    })
}

fn describe(port: &Port) -> String {
    let direction = port.direction.keyword();
    match port.width {
        1 => format!("{direction} {}", port.name),
        width => format!("{direction} {} ({width} bits)", port.name),
    }
}

/// Copies a folder with what is below it, for Yosys to include from.
fn copy_folder(from: &Path, to: &Path) -> Result<(), SynthError> {
    std::fs::create_dir_all(to).map_err(FileError::at(to))?;
    for entry in std::fs::read_dir(from).map_err(FileError::at(from))? {
        let entry = entry.map_err(FileError::at(from))?;
        let (path, name) = (entry.path(), entry.file_name());
        let kind = entry.file_type().map_err(FileError::at(&path))?;
        if name.to_string_lossy().starts_with('.') {
            continue;
        }
        if kind.is_dir() {
            copy_folder(&path, &to.join(name))?;
        } else if path.is_file() {
            std::fs::copy(&path, to.join(name)).map_err(FileError::at(&path))?;
        }
    }
    Ok(())
}
