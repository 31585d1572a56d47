//! What is stated of a unit, and what golden models have in common.

use crate::signal::{Delay, Signal};
use crate::subject::{Inputs, Maker, Stimulus, Subject};
use imogene_contract::Request;
use imogene_hdl::{Direction, Module, PortRecord};
use imogene_rtl::emit::design;

pub(super) fn signals(top: &Module, direction: Direction) -> Vec<Signal> {
    let ports = top.ports_of(direction);
    let signal = |port: &PortRecord| Signal {
        name: port.name.clone(),
        width: port.width,
        signed: port.signed,
    };
    ports.map(signal).collect()
}

/// The inputs of a unit.
pub(super) fn inputs(request: &Request) -> Vec<Signal> {
    signals(
        &design(request).expect("a legal request").top,
        Direction::In,
    )
}

/// Golden model and stimulus of a unit; ports and hardware are those of its circuit.
pub(super) struct Description {
    /// Takes the inputs and gives the outputs in the order of the ports.
    pub(super) golden: Maker,
    pub(super) stimulus: Stimulus,
}

impl Description {
    /// A golden model that `start` makes afresh, as a function of the inputs of a clock.
    pub(super) fn new<G: FnMut(&[i64]) -> Vec<Option<i64>> + Send + 'static>(
        stimulus: Stimulus,
        start: impl Fn() -> G + Sync + 'static,
    ) -> Description {
        Description {
            golden: Box::new(move || Box::new(start())),
            stimulus,
        }
    }
}

/// A port value as a bit.
pub(super) fn bit(value: i64) -> bool {
    value != 0
}

/// All outputs of a result, or none of them before there is one.
pub(super) fn stated<const N: usize>(result: Option<[i64; N]>) -> Vec<Option<i64>> {
    result.map_or(vec![None; N], |values| values.map(Some).to_vec())
}

/// What a golden model with a fixed latency states: results come out `latency` edges after their inputs went in.
pub(super) struct Late<T>(Delay<T>);

impl<T> Late<T> {
    pub(super) fn new(latency: usize) -> Late<T> {
        Late(Delay::new(latency - 1))
    }

    pub(super) fn push(&mut self, result: T) -> Option<T> {
        self.0.push(result)
    }
}

/// A golden processor that the flags on the first three ports drive over a zone.
pub(super) struct Scanned<P>(Option<P>);

impl<P> Default for Scanned<P> {
    fn default() -> Scanned<P> {
        Scanned(None)
    }
}

impl<P> Scanned<P> {
    /// The processor on a clock with a pixel, once a zone has begun.
    pub(super) fn at(
        &mut self,
        flags: &[i64],
        start: impl FnOnce() -> P,
        line_step: impl FnOnce(&mut P),
    ) -> Option<&mut P> {
        if !bit(flags[0]) {
            return None;
        }
        if bit(flags[1]) {
            self.0 = Some(start());
        } else if bit(flags[2]) {
            self.0.as_mut().map(line_step);
        }
        self.0.as_mut()
    }
}

/// The value of the last pixel of a processor that the flags drive.
pub(super) fn last_pixel<P>(
    start: impl Fn(&[i64]) -> P,
    line_step: fn(&mut P),
    pixel: impl Fn(&mut P) -> i64,
) -> impl FnMut(&[i64]) -> Option<i64> {
    let (mut zone, mut value) = (Scanned::default(), None);
    move |i| {
        if bit(i[0]) {
            value = zone.at(i, || start(i), line_step).map(&pixel);
        }
        value
    }
}

/// A stimulus of raster flags on the first three ports and words on the others.
pub(super) fn any_raster(
    subject: &Subject,
    clocks: usize,
) -> proptest::strategy::BoxedStrategy<Vec<Inputs>> {
    crate::stimulus::raster(&subject.inputs, clocks)
}
