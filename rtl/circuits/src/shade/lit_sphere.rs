//! Shading by a table of the direction of the normal.

use super::shading_processor::{Shaded, ShadingLoad};
use super::sight::line_of_sight;
use super::words::{Eye, view_store};
use crate::arith::{Vector, reciprocal, shifted_by};
use crate::object::Normal;
use crate::raster::Pixel;
use crate::rows::numbered;
use crate::video::Colour;
use imogene_contract::shading::{
    ENTRY_LEVEL, LIT_SPHERE_LATENCY, NEAREST_DROPPED, NEAREST_LEVEL, TABLE_BITS, table_latency,
};
use imogene_contract::words::far_end;
use imogene_hdl::{
    Bits, Bundle, Int, Value, bundle, bundles, join, memory, module, net, ports, read_only_memory,
};

/// Bits of the place between two entries.
const BETWEEN: u32 = 7;
/// Bits of a coordinate of the map before it counts entries.
const COORDINATE: u32 = 16;
/// Bits of the length of a normal of full words, the sum of its components without their signs.
const LENGTH: u32 = 17;
/// Clock of a pixel at which its entries are asked for.
const ASKED: u32 = 27;

/// The tables of [`lit_sphere`] and of [`lit_sphere_nearest`].
#[derive(Clone, Debug)]
pub struct Tables {
    /// Bits of a coordinate: a table has `2^places` by `2^places` entries.
    pub places: u32,
    /// Their number.
    pub count: u32,
    /// The nearest entry is the colour.
    pub nearest: bool,
    /// Every entry, the first table first, line by line; none where they are loaded.
    pub entries: Vec<u64>,
}

bundles! {
    /// A visible point, all of whose lights are far away.
    SpherePoint(depth: u32, normal: u32) {
        valid: Bits(1) as "valid", "this clock carries a pixel";
        pixel: Pixel() as "", "pixel of the screen";
        depth: Int(depth) as "depth", "depth; 2^(W-1) - 1 is the background";
        table: Bits(8) as "table_number", "number of the table";
        normal: Normal(normal) as "", "vector of any length";
    }
}

/// The colour of every pixel, one pixel per clock, from a table of what its material sends back at each direction of
/// the normal: all lights and the viewer count as infinitely far. Which lights reach it says the number of the table.
/// Between the entries of the octahedral map colours are of first degree in each of the two triangles of a cell.
///
/// For the wires, both factors of every product come through registers of their own, which multipliers can have as
/// theirs. Latency 36. Words stay unchanged while pixels are inside. Section 8.4 of the architecture.
pub fn lit_sphere(at: &str, point: SpherePoint, load: ShadingLoad, tables: &Tables) -> Shaded {
    let inputs = (point, ("load", load));
    module("lit_sphere", at, inputs, |(point, load)| {
        let view = view_store("view_store", load.bus());
        let facing = facing("facing", point.pixel, point.normal, view.eye);
        let cell = map_cell("map_cell", facing, tables.places);
        let table = point.table.delayed_as("table_late", ASKED);
        let corners = corners("corners", cell, table, load, tables);
        let levels = ["red", "green", "blue"].iter().enumerate();
        let levels = levels.map(|(channel, name)| {
            let level = |entry: Bits| {
                let low = channel as u32 * ENTRY_LEVEL;
                entry.slice(low + ENTRY_LEVEL - 1, low)
            };
            let places = [cell.more, cell.less].map(|place| place.delay(3));
            let ends = [corners.near, corners.middle, corners.far].map(level);
            between(&format!("{name}_between"), ends, places)
        });
        let levels: Vec<Bits> = levels.collect();
        let own = Colour::of([levels[0], levels[1], levels[2]]);
        shown(point, own, view.background, LIT_SPHERE_LATENCY)
    })
}

/// The colour of every pixel, one pixel per clock, from the entry of a table in whose square the direction of the
/// normal is. Column and line are quotients, a row of subtraction for each bit of them, without a multiplier.
///
/// Latency 12, and one clock for each bit of a coordinate. Words stay unchanged while pixels are inside. Section 8.4 of
/// the architecture.
pub fn lit_sphere_nearest(
    at: &str,
    point: SpherePoint,
    load: ShadingLoad,
    tables: &Tables,
) -> Shaded {
    let inputs = (point, ("load", load));
    module("lit_sphere_nearest", at, inputs, |(point, load)| {
        let latency = table_latency(tables.places, true);
        let view = view_store("view_store", load.bus());
        let (pixel, normal) = (point.pixel, point.normal);
        let square = map_square("map_square", pixel, normal, view.eye, tables.places);
        let table = point.table.delayed_as("table_late", latency - 3);
        let read = tables.place(table, join([square.line, square.column]));
        let words = 1 << (tables.number_bits() + 2 * tables.places);
        let width = 3 * NEAREST_LEVEL;
        let entry = match tables.entries.is_empty() {
            true => {
                let address = load.address.low(tables.number_bits() + 2 * tables.places);
                let write = (tables.is_written(load), address, load.data.low(width));
                memory("entries", words, write, read)
            }
            false => {
                let mut entries = tables.entries.clone();
                entries.resize(words, 0);
                read_only_memory("entries", width, entries, read)
            }
        };
        let entry = entry.reg().named("entry_read");
        let level =
            |channel: u32| entry.slice((channel + 1) * NEAREST_LEVEL - 1, channel * NEAREST_LEVEL);
        let own = Colour::of([0, 1, 2].map(level));
        shown(point, own, view.background, latency)
    })
}

/// The background where a point is as far as it can be, so many clocks after it. Latency 1 from the colours.
fn shown(point: SpherePoint, own: Colour, background: Colour, latency: u32) -> Shaded {
    let is_far = point.depth.is(far_end(point.depth.width()) as u64);
    let is_far = is_far.delayed_as("is_far", latency - 1);
    let [red, green, blue] = is_far.select(background, own).parts();
    Shaded {
        out_valid: point.valid.delayed_as("valid_late", latency),
        red: red.reg(),
        green: green.reg(),
        blue: blue.reg(),
    }
}

bundle! {
    /// The direction of a normal that looks towards the viewer, on the octahedral map of a half sphere.
    Facing() {
        length: Bits(LENGTH), "sum of the components without their signs, its first bit set";
        sum: Int(LENGTH + 1), "x + y in its unit";
        difference: Int(LENGTH + 1), "x - y in its unit";
    }

    /// The square of a table in which a direction is.
    Square(places) {
        column: Bits(places), "its column";
        line: Bits(places), "its line";
    }

    /// A cell of a table, and the place in it.
    Cell(places) {
        even_x: Bits(places - 1), "half of its column of even number";
        odd_x: Bits(places - 1), "half of its column of odd number";
        even_y: Bits(places - 1), "half of its line of even number";
        odd_y: Bits(places - 1), "half of its line of odd number";
        first: Bits(2), "its first column and its first line are odd";
        is_across: Bits(1), "the way to the far corner is across first, then down";
        more: Bits(BETWEEN), "the longer one of the ways across and down";
        less: Bits(BETWEEN), "the shorter one";
    }

    /// The entries between which a place lies.
    Corners(width) {
        near: Bits(width), "of the first column and line";
        middle: Bits(width), "of the corner on the side of the place";
        far: Bits(width), "of the last column and line";
    }
}

/// The direction of a normal: turned towards the viewer, and at a right angle to the axis of the view at most.
/// Latency 14.
fn facing(at: &str, pixel: Pixel, normal: Normal, eye: Eye) -> Facing {
    let inputs = (pixel, normal, eye);
    module("map_direction", at, inputs, |(pixel, normal, eye)| {
        let ray = line_of_sight(pixel, eye).1;
        let words = turned(normal.delayed(3), ray.delayed(1)).to_vec();
        let full = shifted_by(words, None, &[4, 3, 2, 1, 0]);
        Facing {
            length: full.words[0],
            sum: full.words[1].int(),
            difference: full.words[2].int(),
        }
    })
}

/// Column and line of a direction in tables of this size: how far its sum and its difference are from the first corner,
/// in parts of two lengths. Latency 9, and one clock for each of their bits.
fn map_square(at: &str, pixel: Pixel, normal: Normal, eye: Eye, places: u32) -> Square {
    let inputs = (pixel, normal, eye);
    module("map_square", at, inputs, |(pixel, normal, eye)| {
        let ray = line_of_sight(pixel, eye).1;
        let ray = ray.map(|part| part.high(part.width() - NEAREST_DROPPED));
        // Along parallel lines z is any number above 0: the sign of the normal alone counts.
        let along = join([
            ray.z.high(ray.z.width() - 1).bits(),
            ray.z.bit(0) | !eye.perspective,
        ]);
        let ray = Vector {
            z: along.int().reg(),
            ..ray
        };
        let [length, sum, difference] = turned(normal.delayed(2), ray);
        let none = Bits::new(0, places);
        let from_corner = |number: Bits| (number + length.extend(number.width())).reg();
        net! {
            let column_rest = from_corner(sum);
            let line_rest = from_corner(difference);
        }
        let mut column = join([column_rest, none]);
        let mut line = join([line_rest, none]);
        let mut length = length.reg().named("length_late");
        for row in 0..places {
            column = map_row(&format!("column_row_{row}"), column, length);
            line = map_row(&format!("line_row_{row}"), line, length);
            length = length.reg();
        }
        Square {
            column: column.low(places),
            line: line.low(places),
        }
    })
}

/// One bit of a quotient: what is left of a number in the high bits, the bits before in the low ones. Latency 1.
fn map_row(at: &str, number: Bits, length: Bits) -> Bits {
    let inputs = ports!(number, length);
    module("map_row", at, inputs, |(number, length)| {
        let places = number.width() - length.width() - 1;
        net! {
            let rest = number.high(length.width() + 1);
            let digit = !rest.less(length.extend(rest.width()));
            let smaller = rest - length.extend(rest.width());
        }
        let left = digit.select(smaller, rest).low(length.width());
        let digits = number.low(places - 1);
        let further = join([left, Bits::new(0, 1), digits, digit]).reg();
        ("further", further)
    })
}

/// Of a normal that is turned towards the viewer: its length, the sum of its components without their signs, of which z
/// counts where it looks towards the viewer; x + y; and x - y. Latency 6.
fn turned(normal: Normal, ray: Vector) -> [Bits; 3] {
    let long = normal.nx.width() + 1;
    let [x, y, z] = normal.delayed(3).parts();
    net! {
        let product_x = (normal.nx * ray.x).reg();
        let product_y = (normal.ny * ray.y).reg();
        let product_z = (normal.nz * ray.z).reg();
    }
    // A product of a and b bits is at most 2^(a + b - 2): three have one bit more.
    let wide = |product: Int| product.extend(product.width() + 1);
    net! {
        let flat_sum = (wide(product_x) + wide(product_y)).reg();
        let deep_part = wide(product_z).reg();
        let both = (flat_sum + deep_part).reg();
    }
    let size = |part: Int| {
        let wide = part.extend(long);
        let size = part.is_negative().select(Int::new(0, long) - wide, wide);
        size.bits().low(long - 1)
    };
    let one_more = |part: Int| part.extend(long + 1);
    net! {
        let is_turned = Int::new(0, both.width()).less(both).reg();
        let size_x = size(x).reg();
        let size_y = size(y).reg();
        let size_z = size(z).reg();
        let is_away = Int::new(0, z.width()).less(z).reg();
        let is_near = z.is_negative().reg();
        let plain_sum = (one_more(x) + one_more(y)).reg();
        let plain_difference = (one_more(x) - one_more(y)).reg();
    }
    let towards_viewer = |part: Int| is_turned.select(Int::new(0, long + 1) - part, part).reg();
    let flat = Bits::new(0, long - 1);
    net! {
        let flat_length = (size_x.extend(long) + size_y.extend(long)).reg();
        let towards = is_turned.select(is_away, is_near).select(size_z, flat).reg();
        let sum = towards_viewer(plain_sum);
        let difference = towards_viewer(plain_difference);
        let length = (flat_length + towards.extend(long)).reg();
        let late_sum = sum.reg();
        let late_difference = difference.reg();
    }
    [length, late_sum.bits(), late_difference.bits()]
}

/// The cell of a direction in tables of this size. Latency 13.
fn map_cell(at: &str, facing: Facing, places: u32) -> Cell {
    module("map_cell", at, facing, |facing| {
        let part = reciprocal("reciprocal", facing.length.low(COORDINATE));
        let part = part.reg().named("part_late");
        let place = |name: &str, number: Int| {
            let late = number.delayed_as(&format!("{name}_late"), 8);
            let product = (late * part).reg().named(&format!("{name}_product"));
            // A component is at most the length, so the product is at most 2^33: the top bit is its sign again.
            let middle = Int::new(1 << (COORDINATE - 1), COORDINATE + 2);
            let moved = product.slice(2 * COORDINATE + 2, LENGTH).int() + middle;
            let moved = moved.reg().named(&format!("{name}_moved"));
            let last = Bits::new((1 << COORDINATE) - 1, COORDINATE);
            let kept = moved
                .bit(COORDINATE)
                .select(last, moved.bits().low(COORDINATE));
            let none = Bits::new(0, COORDINATE);
            let kept = moved.is_negative().select(none, kept).reg();
            let kept = kept
                .named(&format!("{name}_kept"))
                .extend(COORDINATE + places);
            let counted = (kept.left(places) - kept).reg();
            counted.named(&format!("{name}_counted"))
        };
        let (x, y) = (place("x", facing.sum), place("y", facing.difference));
        let [columns, lines] = [x, y].map(|place| place.high(places));
        let [across, down] = [x, y].map(|place| place.slice(COORDINATE - 1, COORDINATE - BETWEEN));
        let odd = |number: Bits| number.high(places - 1);
        let even = |number: Bits| odd(number) + number.low(1).extend(places - 1);
        net! { let is_across = !across.less(down); }
        Cell {
            even_x: even(columns).reg(),
            odd_x: odd(columns).reg(),
            even_y: even(lines).reg(),
            odd_y: odd(lines).reg(),
            first: join([lines.low(1), columns.low(1)]).reg(),
            is_across: is_across.reg(),
            more: is_across.select(across, down).reg(),
            less: is_across.select(down, across).reg(),
        }
    })
}

/// The entries of three corners of a cell, from four memories: of even and odd columns in even and odd lines.
/// Latency 3.
fn corners(at: &str, cell: Cell, table: Bits, load: ShadingLoad, tables: &Tables) -> Corners {
    let inputs = (cell, ("table_number", table), ("load", load));
    module("map_entries", at, inputs, |(cell, table, load)| {
        let columns = [cell.even_x, cell.odd_x];
        let lines = [cell.even_y, cell.odd_y];
        let banks = numbered("entries", 0..4u32).map(|(name, bank)| {
            let (line, column) = (lines[(bank >> 1) as usize], columns[(bank & 1) as usize]);
            let read = tables.place(table, join([line, column]));
            let entry = match tables.entries.is_empty() {
                true => {
                    let write = tables.write(load, bank);
                    memory(&name, tables.words(), write, read)
                }
                false => read_only_memory(&name, 3 * ENTRY_LEVEL, tables.bank(bank), read),
            };
            entry.reg().named(&format!("{name}_read"))
        });
        let banks: Vec<Bits> = banks.collect();
        net! {
            let first = cell.first.delay(2);
            let is_across = cell.is_across.delay(2);
            let beside = first ^ is_across.select(Bits::new(1, 2), Bits::new(2, 2));
        }
        let entry = |number: Bits| {
            let line = |first: usize| number.bit(0).select(banks[first + 1], banks[first]);
            number.bit(1).select(line(2), line(0)).reg()
        };
        Corners {
            near: entry(first),
            middle: entry(beside),
            far: entry(!first),
        }
    })
}

/// The level at a place between three corners, rounded. Latency 5: the differences, the factors, the products, their
/// sum, the level.
fn between(at: &str, [near, middle, far]: [Bits; 3], [more, less]: [Bits; 2]) -> Bits {
    let inputs = ports!(near, middle, far, more, less);
    module(
        "sphere_level",
        at,
        inputs,
        |(near, middle, far, more, less)| {
            const SUM: u32 = ENTRY_LEVEL + BETWEEN + 2;
            let wide = |level: Bits| level.extend(ENTRY_LEVEL + 1).int();
            let place = |place: Bits| place.extend(BETWEEN + 1).int();
            net! {
                let rise = (wide(middle) - wide(near)).reg();
                let rest = (wide(far) - wide(middle)).reg();
                let rise_late = rise.reg();
                let rest_late = rest.reg();
                let more_late = more.delay(2);
                let less_late = less.delay(2);
                let first_part = (rise_late * place(more_late)).reg();
                let second_part = (rest_late * place(less_late)).reg();
                let risen = (first_part + second_part).reg();
                let near_late = near.delay(4).extend(SUM).left(BETWEEN) + Bits::new(1 << (BETWEEN + 1), SUM);
                let level = (near_late + risen.extend(SUM).bits()).reg();
            }
            ("level", level.slice(BETWEEN + ENTRY_LEVEL - 1, BETWEEN + 2))
        },
    )
}

impl Tables {
    /// Bits of the number of a table.
    fn number_bits(&self) -> u32 {
        self.count.next_power_of_two().ilog2()
    }

    /// Entries in each of the four memories.
    fn words(&self) -> usize {
        1 << (self.number_bits() + 2 * (self.places - 1))
    }

    /// The place of an entry in its memory.
    fn place(&self, table: Bits, entry: Bits) -> Bits {
        match self.number_bits() {
            0 => entry,
            bits => join([table.low(bits), entry]),
        }
    }

    /// What is written into one of the four memories.
    fn write(&self, load: ShadingLoad, bank: u32) -> (Bits, Bits, Bits) {
        let places = self.places;
        let address = load.address;
        let half = |first: u32| address.slice(first + places - 1, first + 1);
        let is_own =
            address.bit(0).is(u64::from(bank & 1)) & address.bit(places).is(u64::from(bank >> 1));
        let table = address.slice(TABLE_BITS - 1, 2 * places);
        let place = self.place(table, join([half(places), half(0)]));
        (
            self.is_written(load) & is_own,
            place,
            load.data.low(3 * ENTRY_LEVEL),
        )
    }

    /// An entry of a table is loaded.
    fn is_written(&self, load: ShadingLoad) -> Bits {
        let used = self.number_bits() + 2 * self.places;
        match TABLE_BITS - used {
            0 => load.valid & load.address.bit(TABLE_BITS),
            free => load.valid & load.address.slice(TABLE_BITS, used).is(1 << free),
        }
    }

    /// The entries of one of the four memories.
    fn bank(&self, bank: u32) -> Vec<u64> {
        let places = self.places;
        let words = self.words() as u32;
        let half = |word: u32| word & ((1 << (places - 1)) - 1);
        let entry = |word: u32| {
            let column = 2 * half(word) + (bank & 1);
            let line = 2 * half(word >> (places - 1)) + (bank >> 1);
            let table = word >> (2 * (places - 1));
            let entry = (table << places | line) << places | column;
            self.entries.get(entry as usize).copied().unwrap_or(0)
        };
        (0..words).map(entry).collect()
    }
}
