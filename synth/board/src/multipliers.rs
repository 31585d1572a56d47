//! The multipliers of an iCE40 UltraPlus in Verilog of its bitstream, which `icebox_vlog` leaves out: cells SB_MAC16,
//! from the nets that it names and from the bits of their tiles, which the database of IceStorm knows.

use crate::error::BoardError;
use imogene_tools::read;
use std::collections::{BTreeMap, HashMap};
use std::path::Path;

/// The database of the part, beside the programs of IceStorm.
const DATABASE: &str = "/usr/share/fpga-icestorm/chipdb/chipdb-5k.txt";
/// The cell, as Yosys models it.
pub(crate) const CELL: &str = "SB_MAC16";
/// Its buses, and their bits.
const BUSES: [(&str, u32); 5] = [("A", 16), ("B", 16), ("C", 16), ("D", 16), ("O", 32)];
/// A port that nothing drives takes part.
const ENABLE: &str = "CE";

/// Column and line of a tile.
type Tile = [u16; 2];
/// A line of a cell in the database: a port or a parameter, its tile, and the wire or the bit there.
type Line<'a> = (&'a str, Tile, &'a str);

/// What is known of a part beside its cells.
struct Tiles<'a> {
    /// The nets of wires.
    nets: HashMap<(Tile, &'a str), &'a str>,
    /// Row and column of each configuration bit.
    places: HashMap<&'a str, [usize; 2]>,
    /// The rows of bits.
    rows: HashMap<Tile, Vec<&'a str>>,
}

/// Verilog of a bitstream, with a cell for each multiplier whose product something reads. Fails when the database is
/// missing.
pub(crate) fn with_multipliers(verilog: &str, unpacked: &str) -> Result<String, BoardError> {
    Ok(added(verilog, unpacked, &read(Path::new(DATABASE))?))
}

/// The same with the text of the database.
pub fn added(verilog: &str, unpacked: &str, database: &str) -> String {
    let tiles = Tiles {
        nets: nets(verilog),
        places: places(database),
        rows: rows(unpacked),
    };
    let heads = database.match_indices(".extra_cell ");
    let cells = heads.filter_map(|(start, _)| {
        let mut lines = database[start..].lines();
        let head: Vec<&str> = lines.next()?.split(' ').collect();
        let [_, column, line, _, "MAC16"] = head[..] else {
            return None;
        };
        let cell: Vec<Line> = lines.map_while(cell_line).collect();
        tiles.instance(&format!("mac16_{column}_{line}"), &cell)
    });
    let cells: String = cells.collect();
    let kept = verilog.lines().filter(|line| !line.starts_with("/* DSP"));
    let text = kept.map(|line| format!("{line}\n")).collect::<String>();
    text.replacen("endmodule", &format!("{cells}endmodule"), 1)
}

impl Tiles<'_> {
    /// The cell of a multiplier, if a net has a bit of its product.
    fn instance(&self, name: &str, cell: &[Line]) -> Option<String> {
        let net = |port: &str| {
            let (_, tile, wire) = cell.iter().find(|(name, ..)| *name == port)?;
            self.nets.get(&(*tile, *wire)).copied()
        };
        (0..32).find_map(|bit| net(&format!("O_{bit}")))?;
        let bus = |(bus, width): (&str, u32)| {
            let bit = |bit: u32| match (bus, net(&format!("{bus}_{bit}"))) {
                (_, Some(net)) => net.to_owned(),
                ("O", None) => format!("{name}_open[{bit}]"),
                (_, None) => "1'b0".to_owned(),
            };
            let bits: Vec<String> = (0..width).rev().map(bit).collect();
            format!(".{bus}({{{}}})", bits.join(", "))
        };
        // Bits of buses and parameters have an underscore; no carry goes from cell to cell.
        let is_single = |port: &&str| !port.contains('_') && !["CI", "CO"].contains(port);
        let ports = cell.iter().map(|(port, ..)| *port).filter(is_single);
        let single = ports.map(|port| {
            let none = if port == ENABLE { "1'b1" } else { "1'b0" };
            format!(".{port}({})", net(port).unwrap_or(none))
        });
        let ports: Vec<String> = BUSES.into_iter().map(bus).chain(single).collect();
        let (parameters, ports) = (self.parameters(cell), ports.join(", "));
        Some(format!(
            "wire [31:0] {name}_open;\n{CELL} #({parameters}) {name} ({ports});\n"
        ))
    }

    /// The parameters of a cell, of one bit or of two, whose names then end with a number in the database.
    fn parameters(&self, cell: &[Line]) -> String {
        let bit = |(parameter, tile, wire): &Line| {
            let [row, column] = self.places.get(wire)?;
            let row = self.rows.get(tile)?.get(*row)?;
            let is_set = row.as_bytes().get(*column)? == &b'1';
            let (name, place) = match parameter.strip_suffix("_1") {
                Some(name) => (name, 1),
                None => (parameter.strip_suffix("_0").unwrap_or(parameter), 0),
            };
            Some((name.to_owned(), u32::from(is_set) << place))
        };
        let mut words: BTreeMap<String, u32> = BTreeMap::new();
        for (name, bit) in cell.iter().filter_map(bit) {
            *words.entry(name).or_default() |= bit;
        }
        let words = words.iter().map(|(name, word)| format!(".{name}({word})"));
        words.collect::<Vec<_>>().join(", ")
    }
}

fn cell_line(line: &str) -> Option<Line<'_>> {
    let mut words = line.split(' ');
    let name = words.next().filter(|name| !name.is_empty())?;
    let tile = [words.next()?.parse().ok()?, words.next()?.parse().ok()?];
    Some((name, tile, words.next()?))
}

/// The nets of the wires of tiles: comments behind the declaration of a net name its wires.
fn nets(verilog: &str) -> HashMap<(Tile, &str), &str> {
    let mut net = "";
    let mut found = HashMap::new();
    for line in verilog.lines() {
        let mut kinds = ["wire ", "reg "].iter();
        if let Some(name) = kinds.find_map(|kind| line.strip_prefix(kind)) {
            net = name.split([' ', ';']).next().unwrap_or(name);
        } else if let Some(wire) = line.strip_prefix("// (") {
            let mut parts = wire.trim_end_matches("')").splitn(3, ", ");
            let mut number = || parts.next().and_then(|part| part.parse().ok());
            if let (Some(x), Some(y)) = (number(), number())
                && let Some(wire) = parts.next()
            {
                found.insert(([x, y], wire.trim_start_matches('\'')), net);
            }
        }
    }
    found
}

/// Row and column of each configuration bit of a tile of a multiplier.
fn places(database: &str) -> HashMap<&str, [usize; 2]> {
    let start = database.find(".dsp0_tile_bits").unwrap_or(database.len());
    let lines = database[start..].lines().skip(1);
    let lines = lines.take_while(|line| !line.starts_with('.'));
    let bit = |line| {
        let (name, place) = str::strip_prefix(line, "IpConfig.")?.split_once(" B")?;
        let (row, column) = place.strip_suffix(']')?.split_once('[')?;
        Some((name, [row.parse().ok()?, column.parse().ok()?]))
    };
    lines.filter_map(bit).collect()
}

/// The rows of bits of each tile that has some of a multiplier.
fn rows(unpacked: &str) -> HashMap<Tile, Vec<&str>> {
    let tile = |(start, _): (usize, &str)| {
        let mut lines = unpacked[start..].lines();
        let mut words = lines.next()?.split(' ').skip(1);
        let tile = [words.next()?.parse().ok()?, words.next()?.parse().ok()?];
        Some((tile, lines.take_while(|line| !line.is_empty()).collect()))
    };
    let heads = [".dsp", ".ipcon_tile"].map(|head| unpacked.match_indices(head));
    heads.into_iter().flatten().filter_map(tile).collect()
}
