//! The Verilog of a peer: its files, its top module, its ports.

use crate::cache::digest;
use crate::error::SynthError;
use crate::harness::bits;
use crate::tools::Tool;
use crate::yosys;
use imogene_rtl::emit::{Direction, Port};
use serde_json::Value;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Names of a clock port that are looked for if none is given. Most bytes of a Verilog file.
const MAX_BYTES: u64 = 64 << 20;
const CLOCKS: [&str; 2] = ["clk", "clock"];

/// A design of another project, from files of the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Peer {
    /// Verilog files in the order they are read, `.v`, or `.sv` for SystemVerilog.
    pub files: Vec<PathBuf>,
    /// Top module.
    pub top: String,
    /// Clock port; `clk` or `clock` if not given.
    pub clock: Option<String>,
    /// Folders of included files.
    pub include: Vec<PathBuf>,
    /// Parameters of the top module and their values.
    pub parameters: Vec<(String, String)>,
}

/// Why a peer cannot be measured.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum PeerError {
    /// A file is not there.
    #[error("{path}: there is no such {kind}")]
    Missing {
        /// The path.
        path: String,
        /// File or folder.
        kind: &'static str,
    },
    /// A file is no Verilog by its name.
    #[error("{path}: a file of Verilog ends in .v, one of SystemVerilog in .sv")]
    Ending {
        /// The path.
        path: String,
    },
    /// A name or value cannot stand in a command of Yosys.
    #[error("`{text}` is no {what}: {accepted}")]
    Word {
        /// The text.
        text: String,
        /// What it should be.
        what: &'static str,
        /// What is accepted.
        accepted: &'static str,
    },
    /// No module has the name of the top.
    #[error("there is no module `{top}`; the files hold {}", list(modules))]
    Top {
        /// The name.
        top: String,
        /// The modules that there are.
        modules: Vec<String>,
    },
    /// No port is the clock.
    #[error(
        "`{top}` has no clock port {wanted} of one bit; `--clock PORT` names it; the ports are {}",
        list(ports)
    )]
    Clock {
        /// The top module.
        top: String,
        /// The names looked for.
        wanted: String,
        /// The ports that there are.
        ports: Vec<String>,
    },
    /// A port that no register can stand at.
    #[error("port `{port}` of `{top}` is an inout; a register harness needs inputs and outputs")]
    Inout {
        /// The top module.
        top: String,
        /// The port.
        port: String,
    },
    /// A design without data.
    #[error("`{top}` has no {direction} beside its clock: there is nothing to measure")]
    NoData {
        /// The top module.
        top: String,
        /// Input or output.
        direction: &'static str,
    },
    /// Yosys does not take the files.
    #[error("Yosys refuses the peer: {message}")]
    Refused {
        /// Its error.
        message: String,
    },
}

fn list(names: &[String]) -> String {
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}

impl Peer {
    /// Checks everything that needs no tool.
    pub(crate) fn check(&self) -> Result<(), PeerError> {
        for file in &self.files {
            let path = file.display().to_string();
            if !file.is_file() {
                return Err(PeerError::Missing { path, kind: "file" });
            }
            is_system_verilog(file)?;
            check_file_name(file)?;
        }
        if let Some(folder) = self.include.iter().find(|folder| !folder.is_dir()) {
            let (path, kind) = (folder.display().to_string(), "folder");
            return Err(PeerError::Missing { path, kind });
        }
        check_word(&self.top, "module", is_name)?;
        for (name, value) in &self.parameters {
            check_word(name, "parameter", is_name)?;
            check_word(value, "value", is_value)?;
        }
        Ok(())
    }
}

fn is_system_verilog(file: &Path) -> Result<bool, PeerError> {
    match file.extension().and_then(|ending| ending.to_str()) {
        Some("v") => Ok(false),
        Some("sv") => Ok(true),
        _ => Err(PeerError::Ending {
            path: file.display().to_string(),
        }),
    }
}

/// The name without its folder: it goes into a command of Yosys.
fn check_file_name(file: &Path) -> Result<(), PeerError> {
    let name = file.file_name().and_then(|name| name.to_str());
    check_word(name.unwrap_or_default(), "file name", is_value)
}

fn is_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_' || c == '$'
}

fn is_value(c: char) -> bool {
    is_name(c) || "'.+-".contains(c)
}

fn check_word(text: &str, what: &'static str, is_legal: fn(char) -> bool) -> Result<(), PeerError> {
    if !text.is_empty() && !text.starts_with('-') && text.chars().all(is_legal) {
        return Ok(());
    }
    let accepted = if is_legal('.') {
        "letters, digits, _ $ ' . + -, not - first"
    } else {
        "letters, digits, _ $"
    };
    Err(PeerError::Word {
        text: text.to_owned(),
        what,
        accepted,
    })
}

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
            let text = imogene_files::read_text(file, MAX_BYTES).map_err(SynthError::file(file))?;
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            let own = format!("file{index}");
            std::fs::create_dir_all(folder.join(&own)).map_err(SynthError::file(folder))?;
            crate::flow::write(folder, &format!("{own}/{name}"), &text)?;
            let sv = if is_system_verilog(file)? { " -sv" } else { "" };
            commands.push(format!("read_verilog{sv}{include} {own}/{name}"));
            all += &text;
        }
        commands.push(format!("tee -q -o {MODULES} ls"));
        if !peer.parameters.is_empty() {
            let set = peer.parameters.iter();
            let set: String = set
                .map(|(name, value)| format!(" -set {name} {value}"))
                .collect();
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
        let outcome = yosys::run(yosys, self.folder, &script);
        let listed = std::fs::read_to_string(self.folder.join(MODULES));
        let modules = modules(&listed.unwrap_or_default());
        match outcome {
            Err(SynthError::Tool { message, .. }) => Err(self.refusal(&message, modules).into()),
            Err(error) => Err(error),
            Ok(()) => {
                let path = self.folder.join(PORTS);
                let text = std::fs::read_to_string(&path).map_err(SynthError::file(&path))?;
                Ok(ports_and_clock(self.peer, &text)?)
            }
        }
    }

    fn refusal(&self, message: &str, modules: Vec<String>) -> PeerError {
        let is_read = !modules.is_empty();
        let top = self.peer.top.clone();
        if is_read && !modules.contains(&top) {
            return PeerError::Top { top, modules };
        }
        let mut lines = message.lines().rev();
        let line = lines.find(|line| line.contains("ERROR"));
        PeerError::Refused {
            message: line.unwrap_or(message).to_owned(),
        }
    }
}

/// Files of the folder: the modules before the hierarchy is known, and the netlist that tells the ports.
const MODULES: &str = "modules.txt";
const PORTS: &str = "ports.json";

/// The names in what `ls` prints: a heading, and every module on a line of its own.
fn modules(listed: &str) -> Vec<String> {
    let names = listed.lines().filter_map(|line| line.strip_prefix("  "));
    names.map(|name| name.trim().to_owned()).collect()
}

/// Reads the ports of the top module from a netlist of Yosys.
fn ports_and_clock(peer: &Peer, netlist: &str) -> Result<(Vec<Port>, String), PeerError> {
    let refused = |message: String| PeerError::Refused { message };
    let netlist: Value =
        serde_json::from_str(netlist).map_err(|error| refused(format!("its netlist: {error}")))?;
    let top = peer.top.clone();
    let ports = netlist["modules"][&peer.top]["ports"]
        .as_object()
        .ok_or_else(|| refused(format!("its netlist has no ports of `{top}`")))?;
    // Yosys numbers bits in the order of the ports, which the keys of the document have lost.
    let mut ports: Vec<(&String, &Value)> = ports.iter().collect();
    ports.sort_by_key(|(_, port)| port["bits"][0].as_u64());
    let ports: Vec<Port> = ports
        .into_iter()
        .map(|(name, port)| parse_port(&top, name, port))
        .collect::<Result<_, _>>()?;
    let clock = find_clock(peer, &ports)?;
    let data: Vec<&Port> = ports.iter().filter(|port| port.name != clock).collect();
    for (direction, name) in [(Direction::In, "input"), (Direction::Out, "output")] {
        if bits(&data, direction) == 0 {
            return Err(PeerError::NoData {
                top,
                direction: name,
            });
        }
    }
    Ok((ports, clock))
}

fn parse_port(top: &str, name: &str, port: &Value) -> Result<Port, PeerError> {
    let direction = match port["direction"].as_str() {
        Some("input") => Direction::In,
        Some("output") => Direction::Out,
        _ => {
            return Err(PeerError::Inout {
                top: top.to_owned(),
                port: name.to_owned(),
            });
        }
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
    std::fs::create_dir_all(to).map_err(SynthError::file(to))?;
    for entry in std::fs::read_dir(from).map_err(SynthError::file(from))? {
        let entry = entry.map_err(SynthError::file(from))?;
        let (path, name) = (entry.path(), entry.file_name());
        let kind = entry.file_type().map_err(SynthError::file(&path))?;
        if name.to_string_lossy().starts_with('.') {
            continue;
        }
        if kind.is_dir() {
            copy_folder(&path, &to.join(name))?;
        } else if path.is_file() {
            std::fs::copy(&path, to.join(name)).map_err(SynthError::file(&path))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn peer(clock: Option<&str>) -> Peer {
        Peer {
            files: Vec::new(),
            top: "top".into(),
            clock: clock.map(str::to_owned),
            include: Vec::new(),
            parameters: Vec::new(),
        }
    }

    fn netlist(ports: &str) -> String {
        format!("{{\"modules\": {{\"top\": {{\"ports\": {{{ports}}}}}}}}}")
    }

    const CLOCK: &str = "\"clk\": {\"direction\": \"input\", \"bits\": [2]}";
    const IN: &str = "\"a\": {\"direction\": \"input\", \"bits\": [3, 4]}";
    const OUT: &str = "\"s\": {\"direction\": \"output\", \"bits\": [5], \"signed\": 1}";

    fn read(clock: Option<&str>, ports: &[&str]) -> Result<(Vec<Port>, String), PeerError> {
        ports_and_clock(&peer(clock), &netlist(&ports.join(", ")))
    }

    #[test]
    fn ports_are_read_and_the_clock_is_found() {
        let (ports, clock) = read(None, &[OUT, IN, CLOCK]).expect("a clocked module");
        assert_eq!(clock, "clk");
        let ports: Vec<(&str, usize, bool)> = ports
            .iter()
            .map(|port| (port.name.as_str(), port.width, port.signed))
            .collect();
        // In the order of their bits.
        assert_eq!(ports, [("clk", 1, false), ("a", 2, false), ("s", 1, true)]);
    }

    #[test]
    fn a_clock_that_is_not_there_is_answered_with_the_ports() {
        for (clock, ports) in [
            (None, vec![IN, OUT]),
            (Some("a"), vec![CLOCK, IN, OUT]),
            (Some("s"), vec![CLOCK, IN, OUT]),
            (Some("ck"), vec![CLOCK, IN, OUT]),
        ] {
            let message = read(clock, &ports).expect_err("no clock").to_string();
            for part in [
                clock.unwrap_or("`clk` or `clock`"),
                "input a (2 bits)",
                "output s",
            ] {
                assert!(message.contains(part), "{message}");
            }
        }
    }

    #[test]
    fn a_module_without_data_or_with_an_inout_is_refused() {
        let message = |ports: &[&str]| read(None, ports).expect_err("refused").to_string();
        assert!(message(&[CLOCK, IN]).contains("no output"));
        assert!(message(&[CLOCK, OUT]).contains("no input"));
        let inout = "\"pad\": {\"direction\": \"inout\", \"bits\": [9]}";
        assert!(message(&[CLOCK, IN, OUT, inout]).contains("`pad`"));
    }

    #[test]
    fn modules_are_read_from_their_list() {
        let listed = "\n2 modules:\n  add\n  other\n";
        assert_eq!(modules(listed), ["add", "other"]);
        assert!(modules("").is_empty());
    }

    #[test]
    fn what_is_not_there_or_no_verilog_is_refused_before_any_tool_runs() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let file = |name: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, "").expect("a file");
            path
        };
        let with = |path: PathBuf| {
            let mut peer = peer(None);
            peer.files = vec![path];
            peer
        };
        let refusal = |peer: Peer| peer.check().expect_err("refused").to_string();
        assert!(refusal(with(folder.path().join("no.v"))).contains("no such file"));
        assert!(refusal(with(file("a.vhd"))).contains(".sv"));
        assert!(refusal(with(file("a b.v"))).contains("`a b.v`"));
        let legal = with(file("a.sv"));
        legal.check().expect("a legal peer");
        let mut bad = legal.clone();
        bad.include = vec![folder.path().join("headers")];
        assert!(refusal(bad).contains("no such folder"));
        let mut bad = legal.clone();
        bad.top = "a; shell".into();
        assert!(refusal(bad).contains("`a; shell`"));
        let mut bad = legal;
        bad.parameters = vec![("W".into(), "8; exec".into())];
        assert!(refusal(bad).contains("`8; exec`"));
    }
}
