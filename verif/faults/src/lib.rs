//! Every small change of a circuit.
//!
//! A [`Site`] is where a circuit can be changed: the bits of a net, an operator, the enable of a register, what it
//! begins with. A design with [`Controls`] has registers that never load beside its own: with their values at
//! power-up it is the circuit as it was, and with another value in one of them it is a [`Mutant`]. So any engine runs
//! it, and one compilation serves every mutant of its sites, in every instance. A [`Judge`] proves that a mutant is no
//! mutant at all: what counts of its outputs is equal for every input, from every state that the circuit comes to.
//!
//! ```
//! use imogene_faults::{Contract, Controls, Judge, Known, Mutant, Verdict, sites};
//! use imogene_hdl::{Bits, Design, Value, module};
//!
//! let design = Design::of(|| {
//!     module("gate", "top", (("a", Bits::input(1)), ("b", Bits::input(1))), |(a, b)| {
//!         ("y", a & (a | b))
//!     });
//! });
//! let controls = Controls::new(&design, &sites(&design));
//! let judge = Judge::new(&controls, &Known::new(&design, &Contract::default()));
//! // `b` counts nothing: what is done to it cannot be seen.
//! let of_b = |mutant: &&Mutant| controls.describe(mutant).starts_with("b[0]");
//! let mutants = controls.mutants();
//! let verdict = judge.judge(&mutants.iter().find(of_b).unwrap().upsets);
//! assert_eq!(verdict, Verdict::Equivalent);
//! ```

mod alone;
mod controls;
mod facts;
mod fading;
mod flow;
mod frame;
mod gates;
mod held;
mod idle;
mod judge;
mod known;
mod phases;
mod rest;
mod sites;
mod solve;
mod unseen;

pub use alone::{Around, alone};
pub use controls::{Change, Controls, Key, Mutant, Upset};
pub use judge::Judge;
pub use known::{Contract, Known};
pub use sites::{Site, SiteKind, power_up, sites};
pub use solve::{CONFLICTS, Verdict};
