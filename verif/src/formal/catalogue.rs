//! The list of proofs.

use super::job::{Design, Job, Method, Words};
use imogene_contract::words::DEPTH_WORDS;
use imogene_contract::{Request, Unit};

/// The format whose proofs run without `--full`.
const BASE: usize = 24;

/// Bits of a word where products are compared.
const PRODUCT: usize = 4;

/// The text of a file of `verif/formal`.
macro_rules! property {
    ($file:literal) => {
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/formal/", $file))
    };
}

mod root;

/// Names of all proofs, those for `--full` included.
pub fn names() -> Vec<String> {
    jobs().into_iter().map(|job| job.name).collect()
}

/// All proofs, those for `--full` included; the longest first.
pub fn jobs() -> Vec<Job> {
    let mut jobs = root::jobs();
    jobs.extend(elementary());
    jobs.extend(depths());
    jobs.extend(raster());
    jobs.extend(decision());
    jobs
}

/// A job bound to an emitted unit of the base format; the rest is set by the functions below.
fn job(name: String, statement: &'static str, properties: &'static str, unit: Unit) -> Job {
    Job {
        name,
        statement,
        method: Method::Induction { depth: 1 },
        widths: String::new(),
        full: false,
        design: Design::Emitted(Request::new(unit)),
        properties,
        definitions: Vec::new(),
        words: Words::None,
        top: unit.name(),
    }
}

fn depth_words() -> [usize; 5] {
    DEPTH_WORDS.map(|word| word as usize)
}

fn at_format(mut job: Job, depth_word: usize, definitions: &[(&str, usize)]) -> Job {
    if let Design::Emitted(request) = &mut job.design {
        request.depth_word = depth_word as u32;
    }
    job.full = depth_word != BASE;
    job.definitions = define(definitions);
    let widths: Vec<String> = definitions
        .iter()
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    job.widths = widths.join(", ");
    job
}

fn define(definitions: &[(&str, usize)]) -> Vec<(String, String)> {
    let pair = |(name, value): &(&str, usize)| ((*name).to_owned(), value.to_string());
    definitions.iter().map(pair).collect()
}

fn integers(name: &str, statement: &'static str, text: &'static str) -> Job {
    let mut job = job(name.to_owned(), statement, "", Unit::Pe1);
    job.method = Method::Integers;
    job.design = Design::Text(text);
    job.widths = "any".into();
    job
}

fn elementary() -> Vec<Job> {
    let mut jobs = Vec::new();
    for (word, n) in depth_words().map(|w| (w, 2 * w)) {
        let statement =
            "pe2: every register is its difference of the polynomial, in ghost sums, modulo 2^N";
        let pe2 = job(
            format!("pe2-{n}"),
            statement,
            property!("pe2.sv"),
            Unit::Pe2,
        );
        jobs.push(at_format(pe2, word, &[("N", n)]));
    }
    for (word, n) in depth_words().map(|w| (w, w + 2)) {
        let statement =
            "pe1: value = c + ghost sum of b per line + ghost sum of a per pixel, modulo 2^N";
        let pe1 = job(
            format!("pe1-{n}"),
            statement,
            property!("pe1.sv"),
            Unit::Pe1,
        );
        jobs.push(at_format(pe1, word, &[("N", n)]));
    }
    jobs.push(integers(
        "pe1-integers",
        "the ghost sums of pe1 are a x and b y",
        property!("pe1.smt2"),
    ));
    jobs.push(integers(
        "pe2-integers",
        "the ghost sums of pe2 have their closed forms and add up to the polynomial",
        property!("pe2.smt2"),
    ));
    let statement = "pe1 against a x + b y + c with multipliers, narrowed";
    let pe1 = job(
        "pe1-products".into(),
        statement,
        property!("pe1_products.sv"),
        Unit::Pe1,
    );
    jobs.push(products(pe1, BASE + 2, 6));
    let statement = "pe2 against a x^2 + b y^2 + c x y + d x + e y + f with multipliers, narrowed";
    let pe2 = job(
        "pe2-products".into(),
        statement,
        property!("pe2_products.sv"),
        Unit::Pe2,
    );
    jobs.push(products(pe2, 2 * BASE, 5));
    jobs
}

/// Narrowed to where a solver can multiply.
fn products(mut job: Job, width: usize, clocks: usize) -> Job {
    if let Design::Emitted(request) = job.design {
        job.design = Design::Narrowed(request, width, PRODUCT);
    }
    job.method = Method::Bounded { clocks };
    job.definitions = define(&[("N", PRODUCT)]);
    job.widths = format!("N = {PRODUCT}");
    job
}

fn depths() -> Vec<Job> {
    let mut jobs = Vec::new();
    for w in depth_words() {
        let statement = "cut_plane: holds exactly the depths that the half holds and the plane keeps, ordered or absent, latency 1";
        let cut = property!("cut_plane.sv");
        let cut = job(format!("cut_plane-{w}"), statement, cut, Unit::CutPlane);
        jobs.push(at_format(cut, w, &[("W", w)]));

        let statement = "two cut planes leave the same depths in either order";
        let order = property!("cut_plane_order.sv");
        let mut order = job(
            format!("cut_plane_order-{w}"),
            statement,
            order,
            Unit::CutPlane,
        );
        order.top = "cut_plane_order";
        order.method = Method::Induction { depth: 2 };
        jobs.push(at_format(order, w, &[("W", w)]));

        let statement = "depth_interval: holds exactly the depths of the object's class, ordered or absent, latency 1";
        let interval = property!("depth_interval.sv");
        let interval = job(
            format!("depth_interval-{w}"),
            statement,
            interval,
            Unit::DepthInterval,
        );
        jobs.push(at_format(interval, w, &[("W", w), ("S", w + 2)]));

        let statement = "two_volume_merge: the half with the nearer front goes on whole, half A at a tie, latency 1";
        let merge = property!("two_volume_merge.sv");
        let merge = job(
            format!("two_volume_merge-{w}"),
            statement,
            merge,
            Unit::TwoVolumeMerge,
        );
        jobs.push(at_format(merge, w, &[("W", w)]));
    }
    jobs
}

fn raster() -> Vec<Job> {
    let statement = "raster_control: one pixel per clock in raster order from go to last, count = ghost sum of lines + x + 1";
    let control = property!("raster_control.sv");
    let mut control = job(
        "raster_control-12".into(),
        statement,
        control,
        Unit::RasterControl,
    );
    control.widths = "coordinates 12".into();

    let statement =
        "raster_control: width x height valid clocks per go, against the product, zones to 3 x 3";
    let count = property!("raster_control_count.sv");
    let mut count = job(
        "raster_control-3x3".into(),
        statement,
        count,
        Unit::RasterControl,
    );
    count.method = Method::Bounded { clocks: 22 };
    count.widths = "coordinates 12".into();

    let mut jobs = vec![
        control,
        count,
        integers(
            "raster_control-integers",
            "the ghost sum of lines is y width, and the count at last is width x height",
            property!("raster_control.smt2"),
        ),
    ];
    for (planes, rows) in [(3, 1), (0, 1), (12, 1), (3, 4), (1, 24)] {
        jobs.push(valid_path(planes, rows));
    }
    jobs.push(beam_valid());
    jobs
}

fn valid_path(planes: usize, rows_per_stage: usize) -> Job {
    let request = Request {
        planes: planes as u32,
        rows_per_stage: rows_per_stage as u32,
        ..Request::new(Unit::QuadricProcessor)
    };
    let latency = BASE.div_ceil(rows_per_stage) + planes + 7;
    let statement =
        "quadric_processor: out_valid is valid, L + N + 7 clocks later; none lost, none made";
    let name = format!("quadric_processor-n{planes}-r{rows_per_stage}");
    let path = property!("valid_path.sv");
    let path = job(name, statement, path, Unit::QuadricProcessor);
    let mut path = at_format(path, BASE, &[("LATENCY", latency)]);
    path.method = Method::Induction { depth: latency };
    path.design = Design::Emitted(request);
    path.top = "valid_path";
    path.full = (planes, rows_per_stage) != (3, 1);
    path
}

fn beam_valid() -> Job {
    let latency = BASE + 3 + 7 + 2;
    let statement = "beam: valid is that of its raster control, L + N + 7 + tree clocks later; none lost, none made";
    let beam = property!("beam_valid.sv");
    let beam = job("beam-m4-n3".into(), statement, beam, Unit::Beam);
    let mut beam = at_format(beam, BASE, &[("LATENCY", latency)]);
    beam.method = Method::Induction { depth: latency };
    beam.top = "beam_valid";
    beam
}

fn decision() -> Vec<Job> {
    let mut jobs = Vec::new();
    for w in depth_words() {
        let statement =
            "visibility_node: the input with the smaller {depth, id} goes on whole, latency 1";
        let node = property!("visibility_node.sv");
        let node = job(
            format!("visibility_node-{w}"),
            statement,
            node,
            Unit::VisibilityNode,
        );
        jobs.push(at_format(node, w, &[("W", w)]));
    }
    for inputs in [4, 2, 3, 5] {
        jobs.push(decider(inputs));
    }
    jobs
}

fn decider(inputs: usize) -> Job {
    let latency = inputs.next_power_of_two().ilog2() as usize;
    let statement =
        "decider: the smallest {depth, id} of all inputs, whole, ceil(log2 M) clocks later";
    let decider = property!("decider.sv");
    let decider = job(
        format!("decider-m{inputs}"),
        statement,
        decider,
        Unit::Decider,
    );
    let definitions = [("W", BASE), ("M", inputs), ("LATENCY", latency)];
    let mut decider = at_format(decider, BASE, &definitions);
    decider.design = Design::Emitted(Request {
        objects: inputs as u32,
        ..Request::new(Unit::Decider)
    });
    decider.method = Method::Induction { depth: latency };
    decider.words = Words::Inputs;
    decider.full = inputs != 4;
    decider
}
