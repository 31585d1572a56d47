//! Units of a representation (ISO 10303-41, clause 21).

use step21::{Args, Entity, Exchange, Kind, Result};

/// Most conversions of a unit by another.
const LONGEST_CHAIN: usize = 8;

/// What the numbers of a representation mean.
#[derive(Clone, Copy, Debug)]
pub struct Context {
    /// Millimetres in a unit of length.
    pub length: f64,
    /// Radians in a unit of plane angle.
    pub angle: f64,
    /// What the file takes for the same place, millimetres.
    pub uncertainty: f64,
    /// The greatest difference of two coordinates of the file along an axis, millimetres.
    pub extent: f64,
    /// The last digit of its coordinates, millimetres; 0 if all have so few decimals that they may be exact.
    pub precision: f64,
}

/// Most that a file may take for the same place, millimetres: more would hide what does not fit.
const MOST_UNCERTAIN: f64 = 0.01;

/// The context that a representation of a file names, if it does.
pub fn context(entity: Option<Entity>, file: Context) -> Result<Context> {
    let mut context = file;
    let args = |name| entity.and_then(|entity| entity.find(&[name]));
    if let Some(args) = args("GLOBAL_UNIT_ASSIGNED_CONTEXT") {
        for unit in args.entities(0)? {
            context.length = unit_of(unit, LENGTH, 0)?.unwrap_or(context.length);
            context.angle = unit_of(unit, ANGLE, 0)?.unwrap_or(context.angle);
        }
    }
    if let Some(args) = args("GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT") {
        for measure in args.entities(0)? {
            let args = measure.need(&["UNCERTAINTY_MEASURE_WITH_UNIT"])?;
            if let Some(length) = unit_of(args.entity(1)?, LENGTH, 0)? {
                let value = (args.number(0)? * length).clamp(0.0, MOST_UNCERTAIN);
                context.uncertainty = context.uncertainty.max(value);
            }
        }
    }
    context.extent *= context.length;
    context.precision *= context.length;
    Ok(context)
}

/// A kind of unit: its part, its name in the SI, and the power of ten from that to what is returned.
type Quantity = (&'static str, &'static str, i32);

const LENGTH: Quantity = ("LENGTH_UNIT", "METRE", 3);
const ANGLE: Quantity = ("PLANE_ANGLE_UNIT", "RADIAN", 0);

/// How many millimetres or radians a unit is; `None` if it is one of another quantity.
fn unit_of(entity: Entity, quantity: Quantity, chain: usize) -> Result<Option<f64>> {
    if entity.find(&[quantity.0]).is_none() {
        return Ok(None);
    }
    if let Some(args) = entity.find(&["SI_UNIT"]) {
        return si_unit(&args, quantity).map(Some);
    }
    let args = entity.need(&["SI_UNIT", "CONVERSION_BASED_UNIT"])?;
    if chain == LONGEST_CHAIN {
        let accepted = format!("at most {LONGEST_CHAIN} conversions are possible");
        return Err(args.error("it is defined by itself, or by too many others", accepted));
    }
    let measures = [
        "LENGTH_MEASURE_WITH_UNIT",
        "PLANE_ANGLE_MEASURE_WITH_UNIT",
        "MEASURE_WITH_UNIT",
    ];
    let Some(measure) = args.entity(1)?.find(&measures) else {
        let accepted = "a LENGTH_MEASURE_WITH_UNIT or a PLANE_ANGLE_MEASURE_WITH_UNIT is needed";
        return Err(args.error("it has no measure", accepted));
    };
    let factor = measure.number(0)?;
    let Some(base) = unit_of(measure.entity(1)?, quantity, chain + 1)? else {
        let problem = "its unit is of another quantity";
        return Err(measure.error(problem, format!("a {} is needed", quantity.0)));
    };
    let value = factor * base;
    if !(1e-9..=1e9).contains(&value) {
        let accepted = "a factor above 0 is needed, 1e-9 to 1e9 mm or radians";
        return Err(measure.error(format!("{factor} of its unit is out of range"), accepted));
    }
    Ok(Some(value))
}

fn si_unit(args: &Args, (part, name, own_power): Quantity) -> Result<f64> {
    // As a part of a complex entity it has its own two parameters, alone also that of `NAMED_UNIT`.
    let first = if args.record.values.len() > 2 { 1 } else { 0 };
    if args.word(first + 1)? != Some(name) {
        let problem = format!("it is no unit of a {part}");
        return Err(args.error(problem, format!("`.{name}.` is needed")));
    }
    let prefix = args.word(first)?.unwrap_or("");
    let Some((_, power)) = PREFIXES.iter().find(|(name, _)| *name == prefix) else {
        let problem = format!("`.{prefix}.` is no prefix of this program");
        return Err(args.error(problem, "`.NANO.` to `.KILO.` are possible, and `$`"));
    };
    // A power of ten divides exactly where it would not multiply so.
    let power = power + own_power;
    let ten = 10_f64.powi(power.abs());
    Ok(if power < 0 { 1.0 / ten } else { ten })
}

const PREFIXES: [(&str, i32); 9] = [
    ("", 0),
    ("KILO", 3),
    ("HECTO", 2),
    ("DECA", 1),
    ("DECI", -1),
    ("CENTI", -2),
    ("MILLI", -3),
    ("MICRO", -6),
    ("NANO", -9),
];

/// Fewer decimals than this are taken for exact: a round number says nothing of how numbers are rounded.
const FEWEST_DECIMALS: usize = 5;

impl Context {
    /// Of a file without units: lengths are millimetres and angles radians.
    pub fn of(file: &Exchange) -> Context {
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        let mut most = 0;
        for point in file.all(&["CARTESIAN_POINT"]).filter(|p| !p.entity.complex) {
            for ([low, high], value) in bounds.iter_mut().zip(point.list(1).unwrap_or_default()) {
                if let Kind::Number(value, _) = value.kind {
                    (*low, *high) = (low.min(value), high.max(value));
                }
            }
            let text = &file.bytes[point.entity.at..];
            let end = text.iter().position(|b| *b == b';').unwrap_or(text.len());
            most = most.max(decimals(&text[..end]));
        }
        let extents = bounds.map(|[low, high]| high - low);
        let digits = Some(most).filter(|most| *most >= FEWEST_DECIMALS);
        Context {
            length: 1.0,
            angle: 1.0,
            uncertainty: 0.0,
            extent: extents.into_iter().fold(0.0, f64::max),
            precision: digits.map_or(0.0, |most| 10_f64.powi(-(most as i32))),
        }
    }
}

/// The most decimals in a text of coordinates; those of numbers with an exponent say nothing.
fn decimals(text: &[u8]) -> usize {
    let after = text.split(|byte| *byte == b'.').skip(1);
    let digits = after.map(|after| {
        let digits = after.iter().take_while(|b| b.is_ascii_digit()).count();
        let exponent = matches!(after.get(digits), Some(b'E' | b'e'));
        if exponent { 0 } else { digits }
    });
    digits.max().unwrap_or(0)
}
