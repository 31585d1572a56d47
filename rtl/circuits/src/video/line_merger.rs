//! The lines of graphics modules that draw side by side, one after the other.

use super::{COLOUR, colours_of_pairs};
use crate::rows::PerLane;
use imogene_hdl::{Bits, Value, bundles, join, memory, module, net};

bundles! {
    /// A pixel of every module, or several neighbours.
    ModuleStream {
        tvalid: Bits as "tvalid", "pixels of each module are there";
        tdata: PerLane<Bits> as "tdata", "their colours, those of the first module first";
        tuser: Bits as "tuser", "they are the first of a frame";
        tlast: Bits as "tlast", "they are the last of their lines";
    }

    /// A picture, line by line.
    Merged {
        s_tready: Bits as "s_tready", "the pixels are taken; low while both banks of lines are full";
        m_tvalid: Bits as "m_tvalid", "pixels are there; they stay until they are taken";
        m_tdata: PerLane<Bits> as "m_tdata", "their colours, the leftmost first";
        m_tuser: Bits as "m_tuser", "the first of a frame is among them";
        m_tlast: Bits as "m_tlast", "the last of a line is among them";
    }
}

/// What the merger is built for.
#[derive(Clone, Copy, Debug)]
pub struct Group {
    /// Modules whose lines come at once: a power of two.
    pub modules: u32,
    /// Clocks in which a line leaves, 2 at least.
    pub words: u64,
}

impl Group {
    fn place_bits(&self) -> u32 {
        (self.words - 1).ilog2() + 1
    }
}

/// Puts the lines of graphics modules, which come at once, one behind the other: that of the first module, of the
/// second and so on.
///
/// A line leaves with as many pixels on a clock as come from all modules: lines leave as fast as they come. Two banks
/// keep a line of every module each; one fills while the other is read. Latency 3 from the last pixel of lines to the
/// first that leaves: what a memory gives is registered before one of the modules is chosen. `docs/machines.md`.
pub fn line_merger(at: &str, lines: ModuleStream, ready: Bits, group: Group) -> Merged {
    let ready = ("m_tready", ready, "the receiver takes what leaves");
    let inputs = (("s", lines), ready);
    module("line_merger", at, inputs, |(lines, ready)| {
        // A bit for each bank.
        let of_bank = |when: Bits, bank: Bits| join([when & bank, when & !bank]);
        net! {
            let is_full = Bits::register(2);
            let writes_second = Bits::register(1);
            let phase = Bits::register(group.modules.ilog2());
            let write_place = Bits::register(group.place_bits());
            let is_ready = !writes_second.select(is_full.top(), is_full.low(1));
            let comes = lines.tvalid & is_ready;
            let is_whole = comes & phase.is(u64::from(group.modules) - 1);
            let ends = comes & lines.tlast;
            let is_first = lines.tuser.reg_when(comes & phase.is(0));
            let write_address = join([writes_second, write_place]);
        }
        let next_place = ends.select(Bits::new(0, write_place.width()), counted(write_place));
        phase.load_when(comes, counted(phase));
        write_place.load_when(is_whole, next_place);
        writes_second.load_when(ends, !writes_second);
        // The first words of a line can be read while its last one is written.
        net! {
            let is_filled = is_full | of_bank(ends, writes_second);
        }
        let read = reader(is_filled, ready, group);
        is_full.load(is_filled & !of_bank(read.empties, read.from_second));
        net! {
            let chosen_module = read.module.reg_when(read.moves);
        }
        let lines: Vec<Vec<Bits>> = lines_of_modules(&lines.tdata.0, comes, group);
        let leaving = (0..lines[0].len()).step_by(2).map(|pixel| {
            let kept = lines.iter().enumerate().map(|(module, line)| {
                let pair = join([line[pixel + 1], line[pixel]]);
                let word = match (module, pixel) {
                    (0, 0) => join([is_first, pair]),
                    _ => pair,
                };
                let write = (is_whole, write_address, word);
                let name = format!("line_{module}_from_{pixel}");
                let word = memory(&name, 2 << group.place_bits(), write, read.address);
                Value::named(word.reg_when(read.moves), &(name + "_kept"))
            });
            let kept: Vec<Bits> = kept.collect();
            let begins = kept[0].top() & chosen_module.is(0);
            let pairs = kept.into_iter().map(|word| word.low(2 * COLOUR));
            let pair = one_of(chosen_module, pairs.collect()).reg_when(read.leaves);
            (Value::named(pair, &format!("leaving_from_{pixel}")), begins)
        });
        let (leaving, begins): (Vec<Bits>, Vec<Bits>) = leaving.unzip();
        Merged {
            s_tready: is_ready,
            m_tvalid: read.is_there,
            m_tdata: colours_of_pairs(&leaving, 2 * leaving.len() as u32),
            m_tuser: begins[0].reg_when(read.leaves),
            m_tlast: read.ends_line,
        }
    })
}

/// Of each module so many pixels of its line as leave on a clock: those that come and those before them.
fn lines_of_modules(pixels: &[Bits], comes: Bits, group: Group) -> Vec<Vec<Bits>> {
    let lanes = pixels.len() / group.modules as usize;
    let lines = pixels.chunks(lanes).enumerate();
    let lines = lines.map(|(module, now)| {
        let mut line = now.to_vec();
        for age in 1..group.modules {
            let older = line[..lanes].iter().enumerate().map(|(lane, pixel)| {
                let name = format!("pixel_{module}_{lane}_before_{age}");
                Value::named(pixel.reg_when(comes), &name)
            });
            line = older.chain(line.iter().copied()).collect();
        }
        line
    });
    lines.collect()
}

/// One of a power of two of words by its number.
fn one_of(number: Bits, words: Vec<Bits>) -> Bits {
    let halved = |level: Vec<Bits>, bit: u32| {
        let is_odd = number.slice(bit, bit);
        let pairs = level.chunks(2);
        pairs.map(|pair| is_odd.select(pair[1], pair[0])).collect()
    };
    (0..number.width()).fold(words, halved)[0]
}

/// One more.
fn counted(count: Bits) -> Bits {
    count + Bits::new(1, count.width())
}

/// What is read, and what it is.
struct Reader {
    /// Where the memories read.
    address: Bits,
    /// What they have read goes to its registers.
    moves: Bits,
    /// It is of this module, of a line of this bank, and the last of all of them.
    module: Bits,
    from_second: Bits,
    empties: Bits,
    /// What is in the registers goes to the output.
    leaves: Bits,
    /// What is at the output: something, the end of a line.
    is_there: Bits,
    ends_line: Bits,
}

/// Reads the lines of a bank that is filled, module by module, as the receiver takes them.
fn reader(is_filled: Bits, ready: Bits, group: Group) -> Reader {
    net! {
        let from_second = Bits::register(1);
        let read_module = Bits::register(group.modules.ilog2());
        let read_place = Bits::register(group.place_bits());
        let is_read = Bits::register(1);
        let is_kept = Bits::register(1);
        let is_there = Bits::register(1);
        let leaves = is_kept & (ready | !is_there);
        let moves = is_read & (leaves | !is_kept);
        let at_end = read_place.is(group.words - 1);
        let line_ends = moves & at_end;
        let empties = line_ends & read_module.is(u64::from(group.modules) - 1);
        let begun = at_end.select(Bits::new(0, read_place.width()), counted(read_place));
        let next_place = moves.select(begun, read_place);
        let next_second = from_second ^ empties;
    }
    read_place.load(next_place);
    read_module.load_when(line_ends, counted(read_module));
    from_second.load(next_second);
    is_read.load(next_second.select(is_filled.top(), is_filled.low(1)));
    is_kept.load_when(leaves | moves, moves);
    is_there.load_when(ready | leaves, leaves);
    Reader {
        address: Value::named(join([next_second, next_place]), "read_address"),
        moves,
        module: read_module,
        from_second,
        empties,
        leaves,
        is_there,
        ends_line: at_end.reg_when(moves).reg_when(leaves),
    }
}
