//! How far the shading processor is from its formula, and what each bit of its widths is worth.

mod case;
mod exact;
mod lit_sphere;

use super::trial::random::{Random, in_pieces};
pub use case::{Case, sequence};
use imogene_golden::machine::shader::{LEVEL_FRACTION, Shader, ShaderWidths};
pub use lit_sphere::{LevelErrors, SphereErrors, sphere_errors};
use serde::Serialize;
use std::ops::Range;

/// Cases that are drawn, and improved, one after another by one thread.
const BATCH: u64 = 1 << 12;
/// Steps of the search from the worst case of a batch.
const STEPS: u64 = 1 << 11;

/// Errors of many cases against the formula on the same words.
#[derive(Clone, Debug, Default, Serialize)]
pub struct ShadingErrors {
    /// Random cases.
    pub cases: u64,
    /// Cases of the search that followed from the worst of them.
    pub searched: u64,
    /// Levels of 8 bits compared, three of each random case.
    pub levels: u64,
    /// Random levels that differ.
    pub differing: u64,
    /// Levels, of the search too, that differ by more than one.
    pub beyond: u64,
    /// Greatest difference of a level of 8 bits.
    pub greatest: u8,
    /// Greatest error before rounding, in levels: among random cases.
    pub random_error: f64,
    /// The same with the search.
    pub error: f64,
    /// The case of that error.
    #[serde(skip)]
    pub worst: Option<Case>,
}

impl ShadingErrors {
    fn merge(mut self, other: ShadingErrors) -> ShadingErrors {
        self.cases += other.cases;
        self.searched += other.searched;
        self.levels += other.levels;
        self.differing += other.differing;
        self.beyond += other.beyond;
        self.greatest = self.greatest.max(other.greatest);
        self.random_error = self.random_error.max(other.random_error);
        if other.error > self.error {
            self.error = other.error;
            self.worst = other.worst;
        }
        self
    }

    /// Takes a case in; its error before rounding.
    fn compare(&mut self, case: &Case, shader: &Shader, counted: bool) -> f64 {
        let shader = shader.reloaded(&case.words);
        let exact = exact::levels(&case.words, &case.pixel);
        let found = shader.levels(&case.pixel);
        let found = found.expect("the pixel shows an object");
        let colour = shader.pixel(&case.pixel);
        let mut worst: f64 = 0.0;
        for k in 0..3 {
            let level = found[k] as f64 / f64::from(1 << LEVEL_FRACTION);
            worst = worst.max((level.min(255.0) - exact[k].min(255.0)).abs());
            let difference = colour[k].abs_diff(exact[k].min(255.0).round() as u8);
            self.greatest = self.greatest.max(difference);
            self.beyond += u64::from(difference > 1);
            if counted {
                self.levels += 1;
                self.differing += u64::from(difference > 0);
            }
        }
        if worst > self.error {
            self.error = worst;
            self.worst = Some(case.clone());
        }
        worst
    }

    fn batch(shader: &Shader, seed: u64, cases: Range<u64>) -> ShadingErrors {
        let batch = cases.start / BATCH;
        let mut errors = ShadingErrors {
            cases: cases.end - cases.start,
            ..ShadingErrors::default()
        };
        for number in cases {
            let mut random = Random::of_case(seed, number);
            let case = Case::draw(&mut random);
            errors.compare(&case, shader, true);
        }
        errors.random_error = errors.error;
        let mut random = Random::of_case(!seed, batch);
        for _ in 0..STEPS * errors.cases / BATCH {
            let Some(worst) = &errors.worst else { break };
            let case = worst.near(&mut random);
            errors.compare(&case, shader, false);
            errors.searched += 1;
        }
        errors
    }
}

/// Compares random cases, and a search from the worst of each batch; `done` is told of cases as they pass.
pub fn errors(
    widths: &ShaderWidths,
    cases: u64,
    seed: u64,
    done: impl Fn(u64) + Sync,
) -> ShadingErrors {
    let shader = Shader::with_widths(&Default::default(), widths);
    let batch = |cases| ShadingErrors::batch(&shader, seed, cases);
    let batches = in_pieces(cases, BATCH, done, batch).into_iter();
    batches.fold(ShadingErrors::default(), ShadingErrors::merge)
}
