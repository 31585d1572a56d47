//! The list of proofs.

use super::job::{Design, Job, Method, decider_inputs, stage_words};
use imogene_contract::words::DEPTH_WORDS;
use imogene_contract::{Request, Unit};

/// Bits of a word where products are compared.
const PRODUCT: u32 = 4;

/// The format whose proofs run without `--full`.
const BASE: u32 = 24;

/// The text of a file of `verif/formal`.
macro_rules! property {
    ($file:literal) => {
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/formal/", $file))
    };
}

/// The properties of a file, with the reference that they speak of.
macro_rules! rows {
    ($file:literal) => {
        concat!(property!("root_reference.sv"), "\n", property!($file))
    };
}

type Text = &'static str;

/// Statements with a name, their properties, and the unit that these are bound to.
#[rustfmt::skip]
const STATED: &[(Text, Text, Text, Unit)] = &[
    ("square_root", "square_root, whole: after its latency square + remainder = radicand and remainder <= 2 root, square in ghost sums", property!("square_root.sv"), Unit::SquareRoot),
    ("square_root_rows", "square_root: every register stage is its rows of the reference, in every state that occurs; latency", rows!("square_root_rows.sv"), Unit::SquareRoot),
    ("non_restoring_rows", "square_root_non_restoring: every register stage, restored, is its rows of the reference; latency", rows!("non_restoring_rows.sv"), Unit::SquareRootNonRestoring),
    ("root_lemma", "reference row: remainder + square = prefix and remainder <= 2 root pass through, and the digit is right", property!("root_lemma.sv"), Unit::SquareRoot),
    ("root-integers", "the ghost square is root^2, and root^2 <= x < (root + 1)^2 follows", property!("root.smt2"), Unit::SquareRoot),
    ("pe2", "pe2: every register is its difference of the polynomial, in ghost sums, modulo 2^N", property!("pe2.sv"), Unit::Pe2),
    ("pe1", "pe1: value = c + ghost sum of b per line + ghost sum of a per pixel, modulo 2^N", property!("pe1.sv"), Unit::Pe1),
    ("pe1-integers", "the ghost sums of pe1 are a x and b y", property!("pe1.smt2"), Unit::Pe1),
    ("pe2-integers", "the ghost sums of pe2 have their closed forms and add up to the polynomial", property!("pe2.smt2"), Unit::Pe2),
    ("pe1-products", "pe1 against a x + b y + c with multipliers, narrowed", property!("pe1_products.sv"), Unit::Pe1),
    ("pe2-products", "pe2 against a x^2 + b y^2 + c x y + d x + e y + f with multipliers, narrowed", property!("pe2_products.sv"), Unit::Pe2),
    ("cut_plane", "cut_plane: holds exactly the depths that the half holds and the plane keeps, ordered or absent, latency 2", property!("cut_plane.sv"), Unit::CutPlane),
    ("cut_plane_order", "two cut planes leave the same depths in either order", property!("cut_plane_order.sv"), Unit::CutPlane),
    ("quadric_cut", "quadric_cut: the first depth that the object's class holds between the limits, the end of its piece, its face, latency 5", property!("quadric_cut.sv"), Unit::QuadricCut),
    ("raster_control-12", "raster_control: one pixel per clock in raster order from go to last, count = ghost sum of lines + x + 1", property!("raster_control.sv"), Unit::RasterControl),
    ("raster_control-3x3", "raster_control: width x height valid clocks per go, against the product, zones to 3 x 3", property!("raster_control_count.sv"), Unit::RasterControl),
    ("raster_control-integers", "the ghost sum of lines is y width, and the count at last is width x height", property!("raster_control.smt2"), Unit::RasterControl),
    ("quadric_processor", "quadric_processor: out_valid is valid, as many clocks later as its latency says; none lost, none made", property!("valid_path.sv"), Unit::QuadricProcessor),
    ("beam-m4-n3", "beam: valid is that of its raster control, as many clocks later as its latency says; none lost, none made", property!("beam_valid.sv"), Unit::Beam),
    ("visibility_node", "visibility_node: the input with the smaller {depth, id} goes on whole, latency 1", property!("visibility_node.sv"), Unit::VisibilityNode),
    ("decider", "decider: the smallest {depth, id} of all inputs, whole, ceil(log2 M) clocks later", property!("decider.sv"), Unit::Decider),
    ("tmds_encoder", "tmds_encoder: every word is decoded to its level or control, at most five transitions, ones less zeros -8 to 8", property!("tmds_encoder.sv"), Unit::TmdsEncoder),
];

/// A statement of this name about its unit at a depth word, by induction from one clock to the next.
fn stated(name: &str, word: u32) -> Job {
    let row = STATED.iter().find(|row| row.0 == name);
    let &(name, statement, properties, unit) = row.expect("a row of the table");
    Job {
        name: name.to_owned(),
        statement,
        method: Method::Induction(1),
        widths: String::new(),
        full: word != BASE,
        design: Design::Emitted(Request::of(unit, word)),
        properties,
        definitions: vec![],
        top: unit.name(),
    }
}

/// The same with other parameters of the unit.
fn set(mut job: Job, change: impl FnOnce(&mut Request)) -> Job {
    if let Design::Emitted(request) = &mut job.design {
        change(request);
    }
    job
}

/// The same with these widths and counts.
fn with(mut job: Job, definitions: &[(Text, u32)]) -> Job {
    let named = |(name, value): &(Text, u32)| format!("{name} = {value}");
    job.widths = definitions.iter().map(named).collect::<Vec<_>>().join(", ");
    let defined = definitions.iter();
    job.definitions = defined
        .map(|&(name, value)| (name, value.to_string()))
        .collect();
    job
}

/// All proofs, those for `--full` included; the longest first.
pub fn jobs() -> Vec<Job> {
    let mut encoder = late(stated("tmds_encoder", BASE), 3, &[]);
    encoder.widths = "word 10".into();
    let last = vec![encoder];
    [roots(), elementary(), depths(), raster(), decision(), last].concat()
}

/// A statement at a depth word, by induction over so many clocks; it is named after the first width.
fn at(word: u32, name: &str, clocks: usize, widths: &[(Text, u32)]) -> Job {
    Job {
        name: format!("{name}-{}", widths[0].1),
        method: Method::Induction(clocks),
        ..with(stated(name, word), widths)
    }
}

/// A statement about a latency, which is also the depth of its induction.
fn late(job: Job, latency: u32, definitions: &[(Text, u32)]) -> Job {
    let definitions = [definitions, &[("LATENCY", latency)]].concat();
    Job {
        method: Method::Induction(latency as usize),
        ..with(job, &definitions)
    }
}

fn integers(name: &str) -> Job {
    let job = stated(name, BASE);
    Job {
        method: Method::Integers,
        design: Design::Text(job.properties),
        widths: "any".into(),
        ..job
    }
}

/// Narrowed to where a solver can multiply.
fn products(name: &str, unit: Unit, width: u32, clocks: usize) -> Job {
    Job {
        design: Design::Narrowed(Request::new(unit), width, PRODUCT),
        method: Method::Bounded(clocks),
        ..with(stated(name, BASE), &[("N", PRODUCT)])
    }
}

fn elementary() -> Vec<Job> {
    let pe2 = DEPTH_WORDS.map(|word| at(word, "pe2", 1, &[("N", 2 * word)]));
    let pe1 = DEPTH_WORDS.map(|word| at(word, "pe1", 1, &[("N", word + 2)]));
    let others = [
        integers("pe1-integers"),
        integers("pe2-integers"),
        products("pe1-products", Unit::Pe1, BASE + 2, 6),
        products("pe2-products", Unit::Pe2, 2 * BASE, 5),
    ];
    [&pe2[..], &pe1, &others].concat()
}

fn depths() -> Vec<Job> {
    let of_word = |word: u32| {
        let widths = [("W", word), ("S", word + 2)];
        let cut = at(word, "cut_plane", 2, &widths[..1]);
        let mut order = at(word, "cut_plane_order", 4, &widths[..1]);
        order.top = "cut_plane_order";
        [cut, order, at(word, "quadric_cut", 5, &widths)]
    };
    DEPTH_WORDS.into_iter().flat_map(of_word).collect()
}

fn raster() -> Vec<Job> {
    let names = ["raster_control-12", "raster_control-3x3"];
    let mut jobs = names.map(|name| stated(name, BASE)).to_vec();
    (jobs.iter_mut()).for_each(|job| job.widths = "coordinates 12".into());
    jobs[1].method = Method::Bounded(22);
    jobs.push(integers("raster_control-integers"));
    jobs.extend([(3, 1), (0, 1), (12, 1), (3, 4), (1, 24)].map(valid_path));
    let mut beam = late(stated("beam-m4-n3", BASE), BASE + 11 + 2, &[]);
    beam.top = "beam_valid";
    jobs.push(beam);
    jobs
}

fn valid_path((planes, rows): (u32, u32)) -> Job {
    let path = set(stated("quadric_processor", BASE), |request| {
        (request.planes, request.rows_per_stage) = (planes, rows);
    });
    let tree = planes.next_power_of_two().ilog2();
    let latency = BASE.div_ceil(rows) + 11 + tree.saturating_sub(2);
    Job {
        name: format!("quadric_processor-n{planes}-r{rows}"),
        top: "valid_path",
        full: (planes, rows) != (3, 1),
        ..late(path, latency, &[])
    }
}

fn decision() -> Vec<Job> {
    let node = |word| at(word, "visibility_node", 1, &[("W", word)]);
    let nodes = DEPTH_WORDS.into_iter().map(node);
    nodes.chain([4, 2, 3, 5].map(decider)).collect()
}

fn decider(inputs: u32) -> Job {
    let decider = set(stated("decider", BASE), |request| request.objects = inputs);
    let latency = inputs.next_power_of_two().ilog2();
    let mut decider = late(decider, latency, &[("W", BASE), ("M", inputs)]);
    decider.definitions.extend(decider_inputs(inputs));
    Job {
        name: format!("decider-m{inputs}"),
        full: inputs != 4,
        ..decider
    }
}

/// The whole networks first: they take longest.
fn roots() -> Vec<Job> {
    let mut jobs = [16, BASE]
        .map(|word| network("square_root", (word, 1), true))
        .to_vec();
    let sizes = [(BASE, 1), (32, 1), (16, 1), (20, 1), (28, 1), (BASE, 2)];
    jobs.extend(sizes.map(|size| network("square_root_rows", size, size != (BASE, 1))));
    jobs.push(network("non_restoring_rows", (BASE, 1), true));
    jobs.extend([8, 16, 24, 32, 64].map(lemma));
    jobs.push(integers("root-integers"));
    jobs
}

fn lemma(k: u32) -> Job {
    Job {
        name: format!("root_lemma-{k}"),
        design: Design::Text(property!("root_reference.sv")),
        method: Method::Bounded(1),
        top: "root_lemma",
        ..with(stated("root_lemma", BASE), &[("K", k)])
    }
}

fn network(name: &str, (word, rows): (u32, u32), full: bool) -> Job {
    Job {
        name: format!("{name}-{word}-r{rows}"),
        definitions: stage_words(word, rows),
        widths: format!("K = {word}, F = {}, R = {rows}", 2 * word),
        full,
        ..set(stated(name, word), |request| request.rows_per_stage = rows)
    }
}
