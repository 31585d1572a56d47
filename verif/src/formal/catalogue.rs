//! The list of proofs.

use super::job::{Design, Job, Method, decider_inputs};
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

mod root;

/// The format whose proofs run without `--full`.
const BASE: usize = 24;

/// Widths and counts under the names that the properties give them.
type Definitions = Vec<(&'static str, usize)>;

/// A job bound to an emitted unit of the base format, by induction from one clock to the next.
fn job(
    name: impl Into<String>,
    statement: &'static str,
    properties: &'static str,
    unit: Unit,
) -> Job {
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
    let widths = definitions.iter();
    let widths = widths.map(|(name, value)| format!("{name} = {value}"));
    let named = definitions.iter();
    let named = named.map(|(name, value)| ((*name).to_owned(), value.to_string()));
    Job {
        widths: widths.collect::<Vec<_>>().join(", "),
        definitions: named.collect(),
        ..job
    }
}

fn integers(name: &str, statement: &'static str, text: &'static str) -> Job {
    Job {
        method: Method::Integers,
        design: Design::Text(text),
        widths: "any".into(),
        ..job(name, statement, "", Unit::Pe1)
    }
}

/// All proofs, those for `--full` included; the longest first.
pub fn jobs() -> Vec<Job> {
    let mut jobs = root::jobs();
    jobs.extend(elementary());
    jobs.extend(depths());
    jobs.extend(raster());
    jobs.extend(decision());
    jobs.push(tmds_encoder());
    jobs
}

/// A proof at every depth word. Its jobs are named after the first width.
struct Family {
    name: &'static str,
    unit: Unit,
    properties: &'static str,
    widths: fn(usize) -> Definitions,
    statement: &'static str,
}

impl Family {
    fn at(&self, depth_word: u32) -> Job {
        let widths = (self.widths)(depth_word as usize);
        let name = format!("{}-{}", self.name, widths[0].1);
        let job = job(name, self.statement, self.properties, self.unit);
        Job {
            design: Design::Emitted(Request::of(self.unit, depth_word)),
            full: depth_word as usize != BASE,
            ..with(job, &widths)
        }
    }
}

const PE1: Family = Family {
    name: "pe1",
    unit: Unit::Pe1,
    properties: property!("pe1.sv"),
    widths: |w| vec![("N", w + 2)],
    statement: "pe1: value = c + ghost sum of b per line + ghost sum of a per pixel, modulo 2^N",
};
const PE2: Family = Family {
    name: "pe2",
    unit: Unit::Pe2,
    properties: property!("pe2.sv"),
    widths: |w| vec![("N", 2 * w)],
    statement: "pe2: every register is its difference of the polynomial, in ghost sums, modulo 2^N",
};
const CUT_PLANE: Family = Family {
    name: "cut_plane",
    unit: Unit::CutPlane,
    properties: property!("cut_plane.sv"),
    widths: |w| vec![("W", w)],
    statement: "cut_plane: holds exactly the depths that the half holds and the plane keeps, ordered or absent, latency 2",
};
const CUT_PLANE_ORDER: Family = Family {
    name: "cut_plane_order",
    properties: property!("cut_plane_order.sv"),
    statement: "two cut planes leave the same depths in either order",
    ..CUT_PLANE
};
const QUADRIC_CUT: Family = Family {
    name: "quadric_cut",
    unit: Unit::QuadricCut,
    properties: property!("quadric_cut.sv"),
    statement: "quadric_cut: the first depth that the object's class holds between the limits, the end of its piece, its face, latency 5",
    widths: |w| vec![("W", w), ("S", w + 2)],
};
const VISIBILITY_NODE: Family = Family {
    name: "visibility_node",
    unit: Unit::VisibilityNode,
    properties: property!("visibility_node.sv"),
    statement: "visibility_node: the input with the smaller {depth, id} goes on whole, latency 1",
    ..CUT_PLANE
};

fn elementary() -> Vec<Job> {
    let families = [PE2, PE1].into_iter();
    let jobs = families.flat_map(|family| DEPTH_WORDS.map(|word| family.at(word)));
    let mut jobs: Vec<Job> = jobs.collect();
    let pe1 = job(
        "pe1-products",
        "pe1 against a x + b y + c with multipliers, narrowed",
        property!("pe1_products.sv"),
        Unit::Pe1,
    );
    let pe2 = job(
        "pe2-products",
        "pe2 against a x^2 + b y^2 + c x y + d x + e y + f with multipliers, narrowed",
        property!("pe2_products.sv"),
        Unit::Pe2,
    );
    jobs.extend([
        integers(
            "pe1-integers",
            "the ghost sums of pe1 are a x and b y",
            property!("pe1.smt2"),
        ),
        integers(
            "pe2-integers",
            "the ghost sums of pe2 have their closed forms and add up to the polynomial",
            property!("pe2.smt2"),
        ),
        products(pe1, Unit::Pe1, BASE + 2, 6),
        products(pe2, Unit::Pe2, 2 * BASE, 5),
    ]);
    jobs
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
    let at = |word: u32| {
        let order = Job {
            top: "cut_plane_order",
            method: Method::Induction(4),
            ..CUT_PLANE_ORDER.at(word)
        };
        let [cut, quadric] = [(CUT_PLANE, 2), (QUADRIC_CUT, 5)].map(|(family, latency)| Job {
            method: Method::Induction(latency),
            ..family.at(word)
        });
        [cut, order, quadric]
    };
    DEPTH_WORDS.into_iter().flat_map(at).collect()
}

fn raster() -> Vec<Job> {
    let control = |name: &str, statement, properties| Job {
        widths: "coordinates 12".into(),
        ..job(name, statement, properties, Unit::RasterControl)
    };
    let mut jobs = vec![
        control(
            "raster_control-12",
            "raster_control: one pixel per clock in raster order from go to last, count = ghost sum of lines + x + 1",
            property!("raster_control.sv"),
        ),
        Job {
            method: Method::Bounded(22),
            ..control(
                "raster_control-3x3",
                "raster_control: width x height valid clocks per go, against the product, zones to 3 x 3",
                property!("raster_control_count.sv"),
            )
        },
        integers(
            "raster_control-integers",
            "the ghost sum of lines is y width, and the count at last is width x height",
            property!("raster_control.smt2"),
        ),
    ];
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
    let path = job(
        format!("quadric_processor-n{planes}-r{rows_per_stage}"),
        "quadric_processor: out_valid is valid, as many clocks later as its latency says; none lost, none made",
        property!("valid_path.sv"),
        Unit::QuadricProcessor,
    );
    let tree = planes.next_power_of_two().ilog2() as usize;
    let latency = BASE.div_ceil(rows_per_stage) + 11 + tree.saturating_sub(2);
    Job {
        design: Design::Emitted(Request {
            planes: planes as u32,
            rows_per_stage: rows_per_stage as u32,
            ..Request::new(Unit::QuadricProcessor)
        }),
        top: "valid_path",
        full: (planes, rows_per_stage) != (3, 1),
        ..late(path, latency, &[])
    }
}

fn beam_valid() -> Job {
    let beam = job(
        "beam-m4-n3",
        "beam: valid is that of its raster control, as many clocks later as its latency says; none lost, none made",
        property!("beam_valid.sv"),
        Unit::Beam,
    );
    Job {
        top: "beam_valid",
        ..late(beam, BASE + 11 + 2, &[])
    }
}

fn tmds_encoder() -> Job {
    let encoder = job(
        "tmds_encoder",
        "tmds_encoder: every word is decoded to its level or control, at most five transitions, ones less zeros -8 to 8",
        property!("tmds_encoder.sv"),
        Unit::TmdsEncoder,
    );
    Job {
        widths: "word 10".into(),
        ..late(encoder, 3, &[])
    }
}

fn decision() -> Vec<Job> {
    let nodes = DEPTH_WORDS.map(|word| VISIBILITY_NODE.at(word));
    nodes.into_iter().chain([4, 2, 3, 5].map(decider)).collect()
}

fn decider(inputs: usize) -> Job {
    let decider = job(
        format!("decider-m{inputs}"),
        "decider: the smallest {depth, id} of all inputs, whole, ceil(log2 M) clocks later",
        property!("decider.sv"),
        Unit::Decider,
    );
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
