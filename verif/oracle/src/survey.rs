//! What becomes of many scenes: refusals, failed checks, and differences of golden and traced picture.

use crate::ordinary::scene_text;
use crate::run::{Compared, Outcome, run};
use imogene_analysis::bounds::{CheckReport, check};
use imogene_golden::format::Format;
use imogene_scene::SceneFile;
use rayon::prelude::*;
use serde::Serialize;

/// One scene of a survey with which something is not as it should be.
#[derive(Clone, Debug, Serialize)]
pub struct Finding {
    /// Its number in the sequence of the seed.
    pub number: u64,
    /// What was found.
    pub what: String,
}

/// What became of the scenes.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Survey {
    /// Seed of the sequence.
    pub seed: u64,
    /// Scenes looked at.
    pub scenes: u64,
    /// Pixels compared with the tracer.
    pub pixels: usize,
    /// Pixels of transparent objects that were compared.
    pub transparent: usize,
    /// Pixels whose colours were compared.
    pub colours: usize,
    /// Pixels that differ and that the check announces, or that are tied or in the band.
    pub announced: usize,
    /// Scenes that the preparation refuses, with the reason.
    pub refused: Vec<Finding>,
    /// Scenes that the check fails, with the number of their pixels that rounding leaves open.
    pub check_fails: Vec<Finding>,
    /// Scenes in which golden and traced picture differ where they must not.
    pub differing: Vec<Finding>,
}

/// A drawn scene and what the check says of it, or why it is refused.
type Fate = Result<(Box<Compared>, CheckReport), String>;

/// Looks at the first `scenes` ordinary scenes of a seed; `done` is called once for each, from any thread.
pub fn survey(seed: u64, scenes: u64, format: Format, done: impl Fn() + Sync) -> Survey {
    let fates = (0..scenes).into_par_iter().map(|number| {
        let fate = fate(&scene_text(seed, number), format);
        done();
        fate
    });
    let fates: Vec<Fate> = fates.collect();
    let mut survey = Survey {
        seed,
        scenes,
        ..Survey::default()
    };
    for (number, fate) in (0..).zip(fates) {
        survey.add(number, fate);
    }
    survey
}

fn fate(text: &str, format: Format) -> Fate {
    let scene = SceneFile::parse(text, "scene").map_err(|e| e.to_string())?;
    let (width, height) = (scene.image.width, scene.image.height);
    let outcome = run(&scene, width, height, format, &|_| ());
    match outcome.map_err(|e| e.to_string())? {
        Outcome::Refused(reason) => Err(reason),
        Outcome::Compared(compared) => {
            let report = check(&compared.scene.0, &compared.scene.1);
            Ok((compared, report))
        }
    }
}

impl Survey {
    fn add(&mut self, number: u64, fate: Fate) {
        let finding = |what: String| Finding { number, what };
        let (compared, report) = match fate {
            Err(reason) => return self.refused.push(finding(reason)),
            Ok(drawn) => drawn,
        };
        let c = &compared.comparison;
        self.pixels += c.pixels;
        self.transparent += c.transparent;
        self.colours += c.colours;
        self.announced += c.announced + c.tied + c.differences_inside;
        let wrong = c.announced + c.differences_outside + c.differences_inside;
        if !report.ok {
            let open = report.undecided_pixels;
            let what = format!("{open} pixels undecided, {wrong} differ from the traced picture");
            self.check_fails.push(finding(what));
        }
        if !c.holds() {
            self.differing.push(finding(format!(
                "{} pixels show another face, {} depths and {} colours are beyond their bound",
                c.differences_outside, c.depths_beyond_bound, c.colours_beyond_bound
            )));
        }
    }
}
