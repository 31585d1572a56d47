//! The multipliers of an iCE40 UltraPlus in Verilog of its bitstream, which `icebox_vlog` leaves out: cells SB_MAC16,
//! from the nets that it names and from the bits of their tiles, which the database of IceStorm knows.

use crate::error::BoardError;
use imogene_tools::read;
use std::collections::HashMap;
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

/// Verilog of a bitstream, with a cell for each multiplier whose product something reads.
///
/// # Errors
///
/// When the database is missing.
pub(crate) fn with_multipliers(verilog: &str, unpacked: &str) -> Result<String, BoardError> {
    Ok(added(verilog, unpacked, &read(Path::new(DATABASE))?))
}

/// The same with the text of the database.
pub fn added(verilog: &str, unpacked: &str, database: &str) -> String {
    let nets = nets(verilog);
    let bits = configuration_bits(database);
    let tiles = tiles(unpacked);
    let heads = database.match_indices(".extra_cell ");
    let cells = heads.filter_map(|(start, _)| {
        let mut lines = database[start..].lines();
        let head = lines.next()?;
        let cell: Vec<_> = lines.map_while(port).collect();
        let place = head.split(' ').nth(1)?;
        let line = head.split(' ').nth(2)?;
        head.ends_with(" MAC16").then(|| {
            instance(
                &format!("mac16_{place}_{line}"),
                &cell,
                &nets,
                (&bits, &tiles),
            )
        })?
    });
    let cells: String = cells.collect();
    let kept = verilog.lines().filter(|line| !line.starts_with("/* DSP"));
    let text = kept.map(|line| format!("{line}\n")).collect::<String>();
    text.replacen("endmodule", &format!("{cells}endmodule"), 1)
}

/// The cell of a multiplier, if a net has a bit of its product.
fn instance(
    name: &str,
    cell: &[(&str, Tile, &str)],
    nets: &HashMap<(Tile, &str), &str>,
    (bits, tiles): (&HashMap<&str, [usize; 2]>, &HashMap<Tile, Vec<&str>>),
) -> Option<String> {
    let net = |port: &str| {
        let (_, tile, wire) = cell.iter().find(|(name, ..)| *name == port)?;
        nets.get(&(*tile, *wire)).copied()
    };
    let product = (0..32).find_map(|bit| net(&format!("O_{bit}")));
    product?;
    let bus = |(bus, width): (&str, u32)| {
        let bit = |bit: u32| match (bus, net(&format!("{bus}_{bit}"))) {
            (_, Some(net)) => net.to_owned(),
            ("O", None) => format!("{name}_o_{bit}"),
            (_, None) => "1'b0".to_owned(),
        };
        let bits: Vec<String> = (0..width).rev().map(bit).collect();
        format!(".{bus}({{{}}})", bits.join(", "))
    };
    let is_single = |port: &&str| !port.contains('_') && !["CI", "CO"].contains(port);
    let ports = cell.iter().map(|(port, ..)| *port).filter(is_single);
    let single = ports.map(|port| {
        let none = if port == ENABLE { "1'b1" } else { "1'b0" };
        format!(".{port}({})", net(port).unwrap_or(none))
    });
    let ports: Vec<String> = BUSES.into_iter().map(bus).chain(single).collect();
    let set = |(parameter, tile, wire): &(&str, Tile, &str)| {
        let [row, column] = bits.get(wire)?;
        let is_set = tiles.get(tile)?.get(*row)?.as_bytes().get(*column)? == &b'1';
        let (name, place) = match parameter.strip_suffix("_1") {
            Some(name) => (name, 1),
            None => (parameter.strip_suffix("_0").unwrap_or(parameter), 0),
        };
        Some((name.to_owned(), u32::from(is_set) << place))
    };
    let mut parameters: Vec<(String, u32)> = vec![];
    for (name, value) in cell.iter().filter_map(set) {
        match parameters.iter_mut().find(|(other, _)| *other == name) {
            Some((_, word)) => *word |= value,
            None => parameters.push((name, value)),
        }
    }
    let parameters = parameters.into_iter().map(|(name, word)| {
        let width = if name.contains("SELECT") || name.contains("LOWERINPUT") {
            2
        } else {
            1
        };
        format!(".{name}({width}'d{word})")
    });
    let parameters: Vec<String> = parameters.collect();
    let wires: Vec<String> = (0..32)
        .filter(|bit| net(&format!("O_{bit}")).is_none())
        .map(|bit| format!("{name}_o_{bit}"))
        .collect();
    let declared = match wires.is_empty() {
        true => String::new(),
        false => format!("wire {};\n", wires.join(", ")),
    };
    Some(format!(
        "{declared}{CELL} #({}) {name} ({});\n",
        parameters.join(", "),
        ports.join(", ")
    ))
}

/// A line of a cell in the database: a port or a parameter, its tile, and the wire or the bit there.
fn port(line: &str) -> Option<(&str, Tile, &str)> {
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
        let declared = ["wire ", "reg "]
            .iter()
            .find_map(|kind| line.strip_prefix(kind));
        if let Some(name) = declared {
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
fn configuration_bits(database: &str) -> HashMap<&str, [usize; 2]> {
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
fn tiles(unpacked: &str) -> HashMap<Tile, Vec<&str>> {
    let heads = [".dsp", ".ipcon_tile"].map(|head| unpacked.match_indices(head));
    let heads = heads.into_iter().flatten();
    heads
        .filter_map(|(start, _)| {
            let mut lines = unpacked[start..].lines();
            let mut words = lines.next()?.split(' ').skip(1);
            let tile = [words.next()?.parse().ok()?, words.next()?.parse().ok()?];
            let rows = lines.take_while(|line| !line.is_empty());
            Some((tile, rows.collect()))
        })
        .collect()
}
