//! The list of proofs.

use super::job::{Design, Job, Method, decider_inputs, stage_words};
use imogene_contract::words::DEPTH_WORDS;
use imogene_contract::{Request, Unit};

/// Bits of a word where products are compared.
const PRODUCT: usize = 4;

/// The text of a file of `verif/formal`.
macro_rules! property {
    ($file:literal) => {
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/formal/", $file))
    };
}

/// The format whose proofs run without `--full`.
const BASE: usize = 24;

type Text = &'static str;

/// A job bound to an emitted unit of the base format, by induction from one clock to the next.
fn job(name: impl Into<String>, statement: Text, properties: Text, unit: Unit) -> Job {
    Job {
        name: name.into(),
        statement,
        method: Method::Induction(1),
        widths: String::new(),
        full: false,
        design: Design::Emitted(Request::new(unit)),
        properties,
        definitions: Vec::new(),
        words: |_| Vec::new(),
        top: unit.name(),
    }
}

/// The same with these widths and counts.
fn with(job: Job, definitions: &[(&str, usize)]) -> Job {
    let named = definitions.iter();
    let named = named.map(|(name, value)| ((*name).to_owned(), value.to_string()));
    let definitions: Vec<_> = named.collect();
    let widths = definitions.iter();
    let widths = widths.map(|(name, value)| format!("{name} = {value}"));
    Job {
        widths: widths.collect::<Vec<_>>().join(", "),
        definitions,
        ..job
    }
}

fn integers(name: &str, statement: Text, text: Text) -> Job {
    Job {
        method: Method::Integers,
        design: Design::Text(text),
        widths: "any".into(),
        ..job(name, statement, "", Unit::Pe1)
    }
}

/// All proofs, those for `--full` included; the longest first.
pub fn jobs() -> Vec<Job> {
    let last = vec![tmds_encoder()];
    [roots(), elementary(), depths(), raster(), decision(), last].concat()
}

/// A job at a depth word, by induction over so many clocks; it is named after the first width.
fn at(word: u32, unit: Unit, clocks: usize, widths: &[(&str, usize)], job: Job) -> Job {
    Job {
        name: format!("{}-{}", job.name, widths[0].1),
        method: Method::Induction(clocks),
        design: Design::Emitted(Request::of(unit, word)),
        full: word as usize != BASE,
        ..with(job, widths)
    }
}

fn elementary() -> Vec<Job> {
    #[rustfmt::skip]
    let [pe1, pe1_products, pe2, pe2_products] = [
        job("pe1", "pe1: value = c + ghost sum of b per line + ghost sum of a per pixel, modulo 2^N", property!("pe1.sv"), Unit::Pe1),
        job("pe1-products", "pe1 against a x + b y + c with multipliers, narrowed", property!("pe1_products.sv"), Unit::Pe1),
        job("pe2", "pe2: every register is its difference of the polynomial, in ghost sums, modulo 2^N", property!("pe2.sv"), Unit::Pe2),
        job("pe2-products", "pe2 against a x^2 + b y^2 + c x y + d x + e y + f with multipliers, narrowed", property!("pe2_products.sv"), Unit::Pe2),
    ];
    #[rustfmt::skip]
    let others = [
        integers("pe1-integers", "the ghost sums of pe1 are a x and b y", property!("pe1.smt2")),
        integers("pe2-integers", "the ghost sums of pe2 have their closed forms and add up to the polynomial", property!("pe2.smt2")),
        products(pe1_products, Unit::Pe1, BASE + 2, 6),
        products(pe2_products, Unit::Pe2, 2 * BASE, 5),
    ];
    let n = |width: u32| [("N", width as usize)];
    let pe2 = DEPTH_WORDS.map(|word| at(word, Unit::Pe2, 1, &n(2 * word), pe2.clone()));
    let pe1 = DEPTH_WORDS.map(|word| at(word, Unit::Pe1, 1, &n(word + 2), pe1.clone()));
    [&pe2[..], &pe1, &others].concat()
}

/// Narrowed to where a solver can multiply.
fn products(job: Job, unit: Unit, width: usize, clocks: usize) -> Job {
    Job {
        design: Design::Narrowed(Request::new(unit), width, PRODUCT),
        method: Method::Bounded(clocks),
        ..with(job, &[("N", PRODUCT)])
    }
}

fn depths() -> Vec<Job> {
    let cut = "cut_plane: holds exactly the depths that the half holds and the plane keeps, ordered or absent, latency 2";
    let order = "two cut planes leave the same depths in either order";
    let quadric = "quadric_cut: the first depth that the object's class holds between the limits, the end of its piece, its face, latency 5";
    let of_word = |word: u32| {
        let widths = [("W", word as usize), ("S", word as usize + 2)];
        let cut = job("cut_plane", cut, property!("cut_plane.sv"), Unit::CutPlane);
        let properties = property!("cut_plane_order.sv");
        let order = Job {
            top: "cut_plane_order",
            ..job("cut_plane_order", order, properties, Unit::CutPlane)
        };
        let properties = property!("quadric_cut.sv");
        let quadric = job("quadric_cut", quadric, properties, Unit::QuadricCut);
        [
            at(word, Unit::CutPlane, 2, &widths[..1], cut),
            at(word, Unit::CutPlane, 4, &widths[..1], order),
            at(word, Unit::QuadricCut, 5, &widths, quadric),
        ]
    };
    DEPTH_WORDS.into_iter().flat_map(of_word).collect()
}

fn raster() -> Vec<Job> {
    let control = |name: &str, statement, properties| Job {
        widths: "coordinates 12".into(),
        ..job(name, statement, properties, Unit::RasterControl)
    };
    #[rustfmt::skip]
    let mut jobs = vec![
        control("raster_control-12", "raster_control: one pixel per clock in raster order from go to last, count = ghost sum of lines + x + 1", property!("raster_control.sv")),
        control("raster_control-3x3", "raster_control: width x height valid clocks per go, against the product, zones to 3 x 3", property!("raster_control_count.sv")),
        integers("raster_control-integers", "the ghost sum of lines is y width, and the count at last is width x height", property!("raster_control.smt2")),
    ];
    jobs[1].method = Method::Bounded(22);
    jobs.extend([(3, 1), (0, 1), (12, 1), (3, 4), (1, 24)].map(valid_path));
    jobs.push(beam_valid());
    jobs
}

/// A job about a latency, which is also the depth of its induction.
fn late(job: Job, latency: usize, definitions: &[(&str, usize)]) -> Job {
    let definitions = [definitions, &[("LATENCY", latency)]].concat();
    Job {
        method: Method::Induction(latency),
        ..with(job, &definitions)
    }
}

fn valid_path((planes, rows_per_stage): (usize, usize)) -> Job {
    let (unit, properties) = (Unit::QuadricProcessor, property!("valid_path.sv"));
    let name = format!("quadric_processor-n{planes}-r{rows_per_stage}");
    let statement = "quadric_processor: out_valid is valid, as many clocks later as its latency says; none lost, none made";
    let path = job(name, statement, properties, unit);
    let tree = planes.next_power_of_two().ilog2() as usize;
    let latency = BASE.div_ceil(rows_per_stage) + 11 + tree.saturating_sub(2);
    Job {
        design: Design::Emitted(Request {
            planes: planes as u32,
            rows_per_stage: rows_per_stage as u32,
            ..Request::new(unit)
        }),
        top: "valid_path",
        full: (planes, rows_per_stage) != (3, 1),
        ..late(path, latency, &[])
    }
}

fn beam_valid() -> Job {
    let statement = "beam: valid is that of its raster control, as many clocks later as its latency says; none lost, none made";
    let properties = property!("beam_valid.sv");
    let beam = job("beam-m4-n3", statement, properties, Unit::Beam);
    Job {
        top: "beam_valid",
        ..late(beam, BASE + 11 + 2, &[])
    }
}

fn tmds_encoder() -> Job {
    let statement = "tmds_encoder: every word is decoded to its level or control, at most five transitions, ones less zeros -8 to 8";
    let properties = property!("tmds_encoder.sv");
    let encoder = job("tmds_encoder", statement, properties, Unit::TmdsEncoder);
    Job {
        widths: "word 10".into(),
        ..late(encoder, 3, &[])
    }
}

fn decision() -> Vec<Job> {
    let statement =
        "visibility_node: the input with the smaller {depth, id} goes on whole, latency 1";
    let (unit, properties) = (Unit::VisibilityNode, property!("visibility_node.sv"));
    let node = |word: u32| {
        let node = job("visibility_node", statement, properties, unit);
        at(word, unit, 1, &[("W", word as usize)], node)
    };
    let nodes = DEPTH_WORDS.map(node);
    nodes.into_iter().chain([4, 2, 3, 5].map(decider)).collect()
}

fn decider(inputs: usize) -> Job {
    let name = format!("decider-m{inputs}");
    let statement =
        "decider: the smallest {depth, id} of all inputs, whole, ceil(log2 M) clocks later";
    let decider = job(name, statement, property!("decider.sv"), Unit::Decider);
    let latency = inputs.next_power_of_two().ilog2() as usize;
    Job {
        design: Design::Emitted(Request {
            objects: inputs as u32,
            ..Request::new(Unit::Decider)
        }),
        words: decider_inputs,
        full: inputs != 4,
        ..late(decider, latency, &[("W", BASE), ("M", inputs)])
    }
}

/// The properties of a file, with the reference that they speak of.
macro_rules! rows {
    ($file:literal) => {
        concat!(property!("root_reference.sv"), "\n", property!($file))
    };
}

/// The whole networks first: they take longest.
fn roots() -> Vec<Job> {
    let mut jobs = Vec::new();
    let statement = "square_root, whole: after its latency square + remainder = radicand and remainder <= 2 root, square in ghost sums";
    for word in [16, 24] {
        let properties = property!("square_root.sv");
        let mut whole = network("square_root", statement, properties, (word, 1));
        whole.full = true;
        jobs.push(whole);
    }
    let statement = "square_root: every register stage is its rows of the reference, in every state that occurs; latency";
    for size in [(24, 1), (32, 1), (16, 1), (20, 1), (28, 1), (24, 2)] {
        let properties = rows!("square_root_rows.sv");
        let mut stages = network("square_root_rows", statement, properties, size);
        stages.full = size != (BASE, 1);
        jobs.push(stages);
    }
    jobs.push(non_restoring());
    jobs.extend([8, 16, 24, 32, 64].map(lemma));
    let statement = "the ghost square is root^2, and root^2 <= x < (root + 1)^2 follows";
    jobs.push(integers("root-integers", statement, property!("root.smt2")));
    jobs
}

fn lemma(k: usize) -> Job {
    let (name, properties) = (format!("root_lemma-{k}"), property!("root_lemma.sv"));
    let statement = "reference row: remainder + square = prefix and remainder <= 2 root pass through, and the digit is right";
    let lemma = job(name, statement, properties, Unit::SquareRoot);
    Job {
        design: Design::Text(property!("root_reference.sv")),
        method: Method::Bounded(1),
        top: "root_lemma",
        ..with(lemma, &[("K", k)])
    }
}

fn network(name: &str, statement: Text, properties: Text, (word, rows): (usize, usize)) -> Job {
    let name = format!("{name}-{word}-r{rows}");
    Job {
        design: Design::Emitted(Request {
            rows_per_stage: rows as u32,
            ..Request::of(Unit::SquareRoot, word as u32)
        }),
        words: stage_words,
        widths: format!("K = {word}, F = {}, R = {rows}", 2 * word),
        ..job(name, statement, properties, Unit::SquareRoot)
    }
}

fn non_restoring() -> Job {
    let statement = "square_root_non_restoring: every register stage, restored, is its rows of the reference; latency";
    let properties = rows!("non_restoring_rows.sv");
    Job {
        design: Design::Emitted(Request::new(Unit::SquareRootNonRestoring)),
        top: Unit::SquareRootNonRestoring.name(),
        full: true,
        ..network("non_restoring_rows", statement, properties, (BASE, 1))
    }
}
