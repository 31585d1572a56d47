//! Named cases at extremes of numbers and geometry, each with a stated result (sections 17 and 13.8 of the source).
//!
//! A scene runs through the hardware, which must equal the golden machine on every clock, and its picture must be the
//! exact one at every pixel that the words decide, with every depth within its proven bound; then the statement of the
//! case itself is checked. A scene that cannot be drawn must be refused with a message that says why. A unit runs over
//! a stimulus written for the case.

mod pictures;
mod scenes;
mod units;

use crate::engine::Engine;
use crate::report::Report;
use crate::scene::{self, CosimError, Options, slots};
use crate::subject::{Inputs, Subject};
use crate::unit::subject;
use imogene_contract::{Request, Unit};
use imogene_golden::format::Format;
use imogene_prepare::{Framing, PreparedScene, prepare};
use imogene_scene::{FramedScene, SceneFile};
use pictures::Pictures;
use serde::Serialize;

/// What a picture must show.
type Claim = fn(&Pictures) -> Result<(), String>;

/// What is run, and what must come of it.
enum Case {
    /// A scene that is drawn, and what its picture must show.
    Drawn(&'static str, Claim),
    /// A scene that the golden machine draws by a processor without hardware, and what its picture must show.
    Modelled(&'static str, Claim),
    /// A scene that is drawn, but of which the check says that its silhouette has no bound.
    Flagged(&'static str),
    /// A stimulus of a unit.
    Unit(Unit, fn(&Subject) -> Vec<Inputs>),
}

/// A named case.
pub struct Extreme {
    /// Name, without `extremes/`.
    pub name: &'static str,
    /// Item of the list of extremes: of section 17, or 13.8.
    pub item: &'static str,
    /// What happens, and why that is right.
    pub outcome: &'static str,
    case: Case,
}

const fn driven(
    item: &'static str,
    name: &'static str,
    unit: Unit,
    stimulus: fn(&Subject) -> Vec<Inputs>,
    outcome: &'static str,
) -> Extreme {
    Extreme {
        name,
        item,
        outcome,
        case: Case::Unit(unit, stimulus),
    }
}

/// What came of a case.
#[derive(Clone, Debug, Serialize)]
pub struct Finding {
    /// Name, with `extremes/`.
    pub name: String,
    /// What had to happen.
    pub outcome: &'static str,
    /// It happened.
    pub held: bool,
    /// The refusal that came, or what went wrong.
    pub detail: String,
    /// The co-simulation, if one ran.
    pub cosimulation: Option<Report>,
}

/// All cases.
pub fn all() -> impl Iterator<Item = &'static Extreme> {
    scenes::CASES.iter().chain(units::CASES)
}

/// A case by its name, without `extremes/`.
pub fn find(name: &str) -> Option<&'static Extreme> {
    all().find(|extreme| extreme.name == name)
}

impl Extreme {
    /// Runs the case.
    pub fn run(&self) -> Finding {
        let mut cosimulation = None;
        let result = self.result(&mut cosimulation);
        Finding {
            name: format!("extremes/{}", self.name),
            outcome: self.outcome,
            held: result.is_ok(),
            detail: result.unwrap_or_else(|detail| detail),
            cosimulation,
        }
    }

    fn result(&self, cosimulation: &mut Option<Report>) -> Result<String, String> {
        match &self.case {
            Case::Drawn(text, claim) => {
                let pictures = self.draw(text, cosimulation)?;
                pictures.agree().and_then(|()| claim(&pictures))?;
                Ok(String::new())
            }
            Case::Modelled(text, claim) => {
                let (framed, prepared) = self.prepared(text)?;
                let frame = prepared.frame(|| ());
                let pictures = Pictures::new(framed, prepared, frame);
                pictures.agree().and_then(|()| claim(&pictures))?;
                Ok("drawn by the golden model alone: the processor has no hardware".into())
            }
            Case::Flagged(text) => self.draw(text, cosimulation)?.unbounded(),
            Case::Unit(unit, stimulus) => {
                let subject = subject(&Request::new(*unit)).expect("its defaults are legal");
                let (report, _) = subject.run(&stimulus(&subject), false);
                agreement(cosimulation.insert(report))?;
                Ok(String::new())
            }
        }
    }

    fn prepared(&self, text: &str) -> Result<(FramedScene, PreparedScene), String> {
        let file = SceneFile::parse(text, self.name).map_err(|e| e.to_string())?;
        let framed = file.frame(file.image.width, file.image.height);
        let framed = framed.map_err(|e| e.to_string())?;
        let prepared = prepare(&framed, Format::BASE).map_err(|e| e.to_string())?;
        Ok((framed, prepared))
    }

    /// Draws with the hardware, which must agree with the golden machine.
    fn draw(&self, text: &str, cosimulation: &mut Option<Report>) -> Result<Pictures, String> {
        let (framed, prepared) = self.prepared(text)?;
        let options = Options::plain(1, 2);
        let outcome = match scene::run(&prepared, &options, Engine::BuiltIn, || ()) {
            // Each processor by itself.
            Err(CosimError::Processor(_)) => slots::run(&prepared, 1, Engine::BuiltIn, |_| ()),
            of_machine => of_machine,
        };
        let (mut report, frame) = outcome.map_err(|e| e.to_string())?;
        report.subject = format!("extremes/{}", self.name);
        report.reproduce = format!("imogene cosim extremes/{}", self.name);
        agreement(cosimulation.insert(report))?;
        Ok(Pictures::new(framed, prepared, frame))
    }
}

fn agreement(report: &Report) -> Result<(), String> {
    match report.first_mismatches.first() {
        Some(first) => Err(first.to_string()),
        None if report.passed() => Ok(()),
        None => Err("nothing was compared".into()),
    }
}
