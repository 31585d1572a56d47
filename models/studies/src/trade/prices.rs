//! What points cost and how fast they are: synthesised where it matters, estimated elsewhere.

use super::TradeError;
use super::design::Design;
use super::point::{Cost, Point, Pricing, Store};
use super::report::{Trade, assemble};
use imogene_plan::description::MachineDescription;
use std::collections::{BTreeMap, BTreeSet};

/// Machines that are synthesised at once, and kept before the next ones.
const TOGETHER: usize = 16;

type Outcome = Result<(), TradeError>;

impl Store<'_> {
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
        let wanted = wanted.iter().copied();
        let wanted: Vec<usize> = wanted.filter(|&at| points[at].machine.is_some()).collect();
        let together = match pricing {
            Pricing::Estimated(_) => wanted.len().max(1),
            _ => TOGETHER,
        };
        for wanted in wanted.chunks(together) {
            let machines = wanted.iter().filter_map(|&at| points[at].machine.clone());
            let machines: Vec<MachineDescription> = machines.collect();
            let costs = (self.request.costs)(&machines, pricing);
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
            let accuracy = point.design.accuracy;
            let samples = accuracy.supersampling;
            let tables = (accuracy.table_side, accuracy.nearest_entry);
            let words = (accuracy.normal, accuracy.catalogue, tables);
            let root = (accuracy.root_form, point.design.rows_per_stage);
            let lanes = point.design.pixels_per_clock;
            let form = (point.design.zones.is_some(), lanes, samples, words, root);
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
