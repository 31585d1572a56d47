//! A unit with its parameters: legal values, latency, error, and the command line that emits it.

use crate::formula::evaluate;
use crate::parameters::{PARAMETERS, Parameter, with_parameters};
use crate::root_form::RootForm;
use crate::shading::TABLE_BITS;
use crate::unit::{OBJECT_ROOT, Unit};
use crate::words::{MOST_DEPTH, MOST_OBJECTS};
use std::fmt::Write;
use thiserror::Error;

/// Why a request is refused.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum RequestError {
    /// A parameter is out of its legal range.
    #[error("{parameter} = {value} is out of range; legal values are {least} to {most}")]
    Range {
        /// The parameter.
        parameter: &'static str,
        /// The value asked for.
        value: usize,
        /// Least legal value.
        least: u32,
        /// Greatest legal value.
        most: u32,
    },
    /// The unit has no such parameter.
    #[error(
        "the unit `{unit}` has no parameter `{parameter}`; `imogene units` lists what each has"
    )]
    Foreign {
        /// The parameter.
        parameter: &'static str,
        /// The unit.
        unit: &'static str,
    },
    /// A root of many clocks where a pixel comes on every clock.
    #[error(
        "the root form iterative takes a clock for each digit of a pixel; accepted in a single processor, and in a beam machine that streams its picture, one pixel at a time"
    )]
    Serial,
    /// No unit has this name.
    #[error("there is no unit `{name}`; the units are {}", names())]
    Unit {
        /// The name asked for.
        name: String,
    },
    /// A prefix that no identifier can begin with.
    #[error(
        "prefix `{prefix}` begins no portable name of a module; legal prefixes begin with a letter and go on with letters, digits and single underscores"
    )]
    Prefix {
        /// The prefix asked for.
        prefix: String,
    },
}

fn names() -> String {
    let names: Vec<_> = Unit::ALL.iter().map(|unit| unit.name()).collect();
    names.join(", ")
}

impl Unit {
    /// The unit of a name.
    ///
    /// # Errors
    ///
    /// When there is none; the error lists the names.
    pub fn from_name(name: &str) -> Result<Unit, RequestError> {
        let found = Unit::ALL.into_iter().find(|unit| unit.name() == name);
        found.ok_or_else(|| RequestError::Unit {
            name: name.to_owned(),
        })
    }
}

impl RootForm {
    /// Clocks of a root of so many digits, as the record of the unit states them.
    pub fn latency(self, digits: u32, rows_per_stage: u32) -> u32 {
        self.request(digits, rows_per_stage).latency() as u32
    }

    fn request(self, digits: u32, rows_per_stage: u32) -> Request {
        let (row, number) = self.row();
        Request {
            rows_per_stage,
            digits: number,
            corrections: number,
            ..Request::of(row.1, digits)
        }
    }
}

macro_rules! request {
    ($($name:ident: $option:literal $symbol:literal $field:ident, $least:literal to $most:expr, $default:expr, $meaning:literal;)*) => {
        /// A unit with its parameters; those that the unit does not have mean nothing.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub struct Request {
            /// The unit.
            pub unit: Unit,
            /// Depth word `W` of the format.
            pub depth_word: u32,
            /// Form of the root, of units that hold an object's.
            pub root_form: RootForm,
            $(#[doc = $meaning] pub $field: u32,)*
        }

        impl Request {
            /// A unit with its default parameters.
            pub fn of(unit: Unit, depth_word: u32) -> Request {
                let mut request = Request {
                    unit,
                    depth_word,
                    root_form: RootForm::default(),
                    $($field: 0),*
                };
                for parameter in PARAMETERS.iter().chain(unit.record().parameters) {
                    *request.place(parameter) = parameter.default.unwrap_or(depth_word / 2);
                }
                request
            }

            fn place(&mut self, parameter: &Parameter) -> &mut u32 {
                match parameter.option {
                    $($option => &mut self.$field,)*
                    other => unreachable!("{other} is in the table"),
                }
            }
        }
    };
}

with_parameters!(request);

impl Request {
    /// The value of a parameter.
    pub fn get(&self, parameter: &Parameter) -> u32 {
        let mut own = *self;
        *own.place(parameter)
    }

    /// A unit at the base format 24, with its default parameters.
    pub fn new(unit: Unit) -> Request {
        Request::of(unit, 24)
    }

    /// A unit by its name at a depth word, with the values that somebody gave for options, the others by default.
    ///
    /// # Errors
    ///
    /// When no unit is called so, when it does not have a parameter that was given, or when a value is out of its
    /// range.
    pub fn given(
        name: &str,
        depth_word: u32,
        values: &[(&'static str, Option<u32>)],
    ) -> Result<Request, RequestError> {
        let unit = Unit::from_name(name)?;
        let mut request = Request::of(unit, depth_word);
        for (option, value) in values {
            let Some(value) = *value else { continue };
            let mut parameters = unit.record().parameters.iter();
            let parameter = parameters.find(|parameter| parameter.option == *option);
            let parameter = parameter.ok_or(RequestError::Foreign {
                parameter: option,
                unit: unit.name(),
            })?;
            *request.place(parameter) = value;
        }
        request.check()?;
        Ok(request)
    }

    /// The same with another form of the root.
    ///
    /// # Errors
    ///
    /// When the unit holds no root of an object, or the form takes no root of this depth word.
    pub fn with_root_form(self, root_form: RootForm) -> Result<Request, RequestError> {
        let request = Request { root_form, ..self };
        request.check()?;
        Ok(request)
    }

    /// Checks every parameter against its legal range.
    ///
    /// # Errors
    ///
    /// When one is out of it.
    pub fn check(&self) -> Result<(), RequestError> {
        let word = self.depth_word as usize;
        in_range("format", word, self.unit.least_word(), MOST_DEPTH)?;
        // Of a scene, parameters reach units that do not have them.
        let own = self.unit.record().parameters;
        let foreign = PARAMETERS
            .iter()
            .filter(|other| !self.unit.has(other.option));
        for parameter in own.iter().chain(foreign) {
            let most = parameter.most.unwrap_or(self.depth_word);
            let value = self.get(parameter) as usize;
            in_range(parameter.option, value, parameter.least, most)?;
        }
        if !self.root_form.is_usual() && !self.unit.has_object_root() {
            return Err(RequestError::Foreign {
                parameter: "root-form",
                unit: self.unit.name(),
            });
        }
        if let Some((word, bits, least, most)) = self.root_form.refused(self.depth_word) {
            in_range(word, bits as usize, least, most)?;
        }
        if self.unit == Unit::Beam && self.root_form.clocks(self.depth_word) > 1 {
            return Err(RequestError::Serial);
        }
        if self.unit == Unit::CardDecider {
            let inputs = (self.objects * self.cards) as usize;
            in_range("objects times cards", inputs, 1, MOST_OBJECTS)?;
        }
        if self.unit == Unit::ShadingProcessor {
            in_range("suns", self.suns as usize, 0, self.lights)?;
        }
        if matches!(self.unit, Unit::LitSphere | Unit::LitSphereNearest) {
            let most = 1 << (TABLE_BITS - 2 * self.table_places);
            in_range("tables", self.tables as usize, 1, most)?;
        }
        Ok(())
    }

    /// The value of a symbol: the depth word, or a parameter of the unit.
    fn value(&self, symbol: &str) -> i64 {
        let mut parameters = self.unit.record().parameters.iter();
        let found = parameters.find(|parameter| parameter.symbol == symbol);
        match (found, symbol) {
            (Some(parameter), _) => self.get(parameter).into(),
            (None, "W") => self.depth_word.into(),
            _ => panic!("{} has no parameter '{symbol}'", self.unit.name()),
        }
    }

    /// Options of the command line and their values.
    pub fn options(&self) -> Vec<(&'static str, u32)> {
        let of = |parameter: &Parameter| (parameter.option, self.get(parameter));
        self.unit.record().parameters.iter().map(of).collect()
    }

    /// Latency in clocks.
    pub fn latency(&self) -> usize {
        let clocks = evaluate(&self.latency_formula(), &|symbol| self.value(symbol));
        clocks as usize
    }

    /// The formula of the latency: that of the record, with the clocks of the root where it has another form.
    pub fn latency_formula(&self) -> String {
        let formula = self.unit.record().latency;
        if self.root_form.is_usual() {
            return formula.to_owned();
        }
        let root = self.root_form.latency(self.depth_word, self.rows_per_stage);
        formula.replace(OBJECT_ROOT, &format!("{root} +"))
    }

    /// How far a result is from what the unit computes, and how far its root is from the true one if that is not exact.
    pub fn error(&self) -> String {
        let own = self.stated_error();
        if self.root_form.is_exact() {
            return own;
        }
        let root = self.root_form.request(self.depth_word, self.rows_per_stage);
        format!("{own}; root, {}", root.stated_error())
    }

    fn stated_error(&self) -> String {
        let mut parts = self.unit.record().error.split(['{', '}']);
        let mut text = parts.next().unwrap_or_default().to_owned();
        while let (Some(place), Some(rest)) = (parts.next(), parts.next()) {
            text += &self.filled(place);
            text += rest;
        }
        text
    }

    /// What stands for a place in braces.
    fn filled(&self, place: &str) -> String {
        let value = |formula| evaluate(formula, &|symbol| self.value(symbol));
        match place.split_once(": ") {
            Some((formula, list)) => {
                let mut list = list.split(", ");
                let found = list.nth(value(formula) as usize);
                found.expect("one for each value").to_owned()
            }
            None => value(place).to_string(),
        }
    }

    /// The command line that makes the same text.
    pub fn command(&self) -> String {
        self.command_with_prefix("")
    }

    /// The command line that makes the same text with a prefix before the names of modules; none if it is empty.
    pub fn command_with_prefix(&self, prefix: &str) -> String {
        let mut command = format!("imogene emit {} {}", self.unit.name(), self.arguments());
        if !prefix.is_empty() {
            let _ = write!(command, " --prefix {prefix}");
        }
        command + " --out DIR"
    }

    /// Format and parameters as on the command line.
    pub fn arguments(&self) -> String {
        let mut text = format!("--format {}", self.depth_word);
        if !self.root_form.is_usual() {
            let _ = write!(text, " --root-form {}", self.root_form);
        }
        for (option, value) in self.options() {
            let _ = write!(text, " --{option} {value}");
        }
        text
    }
}

/// Refuses a value that is out of its range.
///
/// # Errors
///
/// With the parameter, the value and the range.
pub fn in_range(
    parameter: &'static str,
    value: usize,
    least: u32,
    most: u32,
) -> Result<(), RequestError> {
    match (least as usize..=most as usize).contains(&value) {
        true => Ok(()),
        false => Err(RequestError::Range {
            parameter,
            value,
            least,
            most,
        }),
    }
}
