//! What points cost and how fast they are: synthesised where it matters, estimated elsewhere.

use super::TradeError;
use super::design::Design;
use super::point::{Cost, Point, Pricing, Run};
use super::report::{Trade, assemble};
use imogene_contract::RootForm;
use imogene_contract::words::quadratic;
use imogene_plan::description::MachineDescription;
use std::collections::{BTreeMap, BTreeSet};

const TOGETHER: usize = 16;

type Outcome = Result<(), TradeError>;

impl Run<'_> {
    /// All points with their costs. Some are synthesised, all others estimated from them; then, until there are no
    /// more, those that are on the front of speed, which move as they become known.
    pub(super) fn trade(&self, empty: &Trade, mut points: Vec<Point>) -> Result<Trade, TradeError> {
        let seeds = seeds(&points);
        self.find(&mut points, &seeds, Pricing::Synthesised)?;
        self.estimate(&mut points, &seeds)?;
        let on_front = match self.request.with_clock {
            true => Pricing::Routed,
            false => Pricing::Synthesised,
        };
        let mut known: BTreeSet<usize> = seeds.into_iter().collect();
        loop {
            let now = points.iter().enumerate();
            let now = now.map(|(index, point)| self.priced(point, known.contains(&index)));
            let trade = assemble(empty.clone(), now.collect());
            // Seeds have a cost, but no clock.
            let is_open = |index| !known.contains(&index) || self.lacks_clock(&points[index]);
            let is_wanted =
                |&index: &usize| trade.points[index].pareto.contains(&"speed") && is_open(index);
            let wanted: Vec<usize> = (0..points.len()).filter(is_wanted).collect();
            let before = points.clone();
            self.find(&mut points, &wanted, on_front)?;
            if known.is_superset(&wanted.iter().copied().collect()) && before == points {
                return Ok(trade);
            }
            known.extend(wanted);
        }
    }

    fn lacks_clock(&self, point: &Point) -> bool {
        let synthesised = point.cost_synthesised;
        self.request.with_clock && synthesised.is_some_and(|cost| cost.fmax_mhz.is_none())
    }

    /// Synthesises what is not known yet, or has no clock if one is asked for.
    fn find(&self, points: &mut [Point], wanted: &[usize], pricing: Pricing) -> Outcome {
        let has_all = |cost: Cost| !matches!(pricing, Pricing::Routed) || cost.fmax_mhz.is_some();
        let lacks = |&&index: &&usize| !points[index].cost_synthesised.is_some_and(has_all);
        let wanted: Vec<usize> = wanted.iter().filter(lacks).copied().collect();
        self.ask(points, &wanted, pricing)
    }

    /// Estimates what is not known yet from the synthesised points.
    fn estimate(&self, points: &mut [Point], seeds: &[usize]) -> Outcome {
        let known = seeds.iter().map(|&index| &points[index]);
        let known = known.filter(|point| point.cost_synthesised.is_some());
        let machines: Vec<_> = known.filter_map(|point| point.machine.clone()).collect();
        let lacks = |(index, point): (usize, &Point)| {
            let is_asked = !seeds.contains(&index) && point.cost_estimated.is_none();
            (point.machine.is_some() && is_asked).then_some(index)
        };
        let wanted: Vec<usize> = points.iter().enumerate().filter_map(lacks).collect();
        if machines.is_empty() {
            let mut refused = seeds.iter().map(|&index| &points[index].cost_refused);
            let refused = refused.find_map(Option::clone);
            for index in wanted {
                points[index].cost_refused.clone_from(&refused);
            }
            return Ok(());
        }
        self.ask(points, &wanted, Pricing::Estimated(&machines))
    }

    fn ask(&self, points: &mut [Point], wanted: &[usize], pricing: Pricing) -> Outcome {
        let has_machine = |at: &&usize| points[**at].machine.is_some();
        let wanted: Vec<usize> = wanted.iter().filter(has_machine).copied().collect();
        let together = match pricing {
            Pricing::Estimated(_) => wanted.len().max(1),
            _ => TOGETHER,
        };
        for wanted in wanted.chunks(together) {
            let machines = wanted.iter().filter_map(|&at| points[at].machine.clone());
            let costs = (self.request.costs)(&machines.collect::<Vec<_>>(), pricing);
            for (at, &index) in wanted.iter().enumerate() {
                let point = &mut points[index];
                point.cost_refused = costs.as_ref().err().cloned();
                let cost = costs.as_ref().ok().map(|costs| costs[at]);
                let place = match pricing {
                    Pricing::Estimated(_) => &mut point.cost_estimated,
                    _ => &mut point.cost_synthesised,
                };
                *place = cost.or(*place);
                self.keep(point)?;
            }
        }
        Ok(())
    }

    /// The point with its cost and its speed, at the clock that is known or else estimated.
    fn priced(&self, point: &Point, is_known: bool) -> Point {
        let synthesised = point.cost_synthesised.filter(|_| is_known);
        let cost = synthesised.or(point.cost_estimated);
        let (width, height) = self.request.size;
        let mhz = cost.and_then(|cost| cost.fmax_mhz).or(point.mhz_estimated);
        let frames = mhz.zip(point.clocks_per_frame);
        let frames = frames.map(|(mhz, clocks)| mhz * 1e6 / clocks as f64);
        Point {
            cost,
            cost_synthesised: synthesised,
            mhz,
            frames_per_second: frames,
            pixels_per_second: frames.map(|frames| frames * f64::from(width) * f64::from(height)),
            ..point.clone()
        }
    }
}

/// Points from which all others are estimated: of every form the narrowest, the middle and the widest.
fn seeds(points: &[Point]) -> Vec<usize> {
    let mut forms: BTreeMap<_, Vec<(Design, usize)>> = BTreeMap::new();
    for (index, point) in points.iter().enumerate() {
        if point.machine.is_some() {
            let Design { accuracy, .. } = point.design;
            let tables = (accuracy.table_side, accuracy.nearest_entry);
            let words = (accuracy.normal, accuracy.catalogue, tables);
            let root = (accuracy.root_form, point.design.rows_per_stage);
            let pixels = (accuracy.supersampling, point.design.pixels_per_clock);
            let form = (point.design.zones.is_some(), pixels, words, root);
            forms.entry(form).or_default().push((point.design, index));
        }
    }
    let chosen = forms.into_values().flat_map(|mut form| {
        form.sort_unstable();
        let last = form.len() - 1;
        [0, last / 2, last].map(|place| form[place].1)
    });
    chosen.collect::<BTreeSet<usize>>().into_iter().collect()
}

/// Nanoseconds of a unit placed and routed alone: so many, and for each bit of its word or each light.
type Delay = [f64; 2];

/// One row of the root network, beside the registers; the first number for each.
const ROOT_ROW: Delay = [2.9, 0.035];
/// Registers around the rows of a stage.
const REGISTERS: f64 = 1.2;
/// A root of lines or parabolas, and about as much the shift before one of leading digits: `square_root_linear` of 16
/// and of 24 digits, 66.6 and 56.5 MHz.
const POLYNOMIAL: Delay = [9.6, 0.335];
/// Sums of the polynomials of second degree: PE2 of accumulators of 24, 32, 48 and 64 bits, 4.77 to 6.15 ns.
const QUADRATIC: Delay = [3.95, 0.0345];
/// What compares depths, the slowest that takes one: `decider` of 16 and of 24 bits, 5.13 and 5.5 ns.
const COMPARED: Delay = [4.4, 0.046];
/// The shading processor for each of its lights: placed and routed with one, 155.0 MHz, and with two, 153.0 MHz.
const SHADING: Delay = [6.36, 0.09];
/// Lit-sphere shading between entries and by the nearest one, 180.0 and 164.5 MHz.
const BETWEEN: f64 = 5.56;
const NEAREST: f64 = 6.08;

fn delay([fixed, bit]: Delay, bits: u32) -> f64 {
    fixed + bit * f64::from(bits)
}

/// The clock of a machine in MHz on ECP5, speed grade 6; none for other devices.
pub(super) fn clock(machine: &MachineDescription, target: &str) -> Option<f64> {
    let words = machine.words();
    let rows = f64::from(machine.rows_per_stage);
    let rows_of_stage = REGISTERS + rows * delay(ROOT_ROW, words.root);
    let polynomial = delay(POLYNOMIAL, words.root);
    let root = match words.root_form {
        RootForm::Restoring | RootForm::NonRestoring | RootForm::Iterative => rows_of_stage,
        RootForm::Linear(_) | RootForm::Quadratic(_) => polynomial,
        RootForm::Leading(_) => rows_of_stage.max(polynomial),
    };
    let shading = match (machine.lights, machine.lit_sphere) {
        (0, None) => 0.0,
        (0, Some(form)) if form.nearest => NEAREST,
        (0, Some(_)) => BETWEEN,
        (lights, _) => delay(SHADING, lights as u32),
    };
    let delays = [
        root,
        delay(QUADRATIC, quadratic(words.root) + words.guard_quadratic),
        delay(COMPARED, words.depth),
        shading,
    ];
    let slowest = delays.into_iter().fold(0.0, f64::max);
    target.starts_with("ecp5").then_some(1000.0 / slowest)
}
