//! What no program is made of.

use imogene_compiled::Program;
use imogene_hdl::{Bits, Design, Value, module};
use std::panic::catch_unwind;

fn refusal(design: impl Fn() -> Design + std::panic::UnwindSafe, points: &[&str]) -> String {
    let points: Vec<String> = points.iter().map(|point| point.to_string()).collect();
    let problem = catch_unwind(move || Program::new(&design(), &points));
    let problem = problem.err().expect("a refusal");
    *problem.downcast().expect("a message")
}

#[test]
fn a_loop_without_a_register_is_refused_by_name() {
    let ring = || {
        Design::of(|| {
            module("ring", "top", ("x", Bits::input(4)), |x| {
                let value = Bits::forward(4);
                let next = (value + x).named("next");
                value.drive(next);
                ("value", value)
            });
        })
    };
    let wanted = "value `next` of ring depends on itself within one clock";
    assert_eq!(refusal(ring, &[]), wanted);
}

#[test]
fn a_point_that_is_not_there_is_refused_by_name() {
    let delay = || {
        Design::of(|| {
            module("delay", "top", ("x", Bits::input(4)), |x| ("late", x.reg()));
        })
    };
    assert_eq!(refusal(delay, &["late", "later"]), "no point `later`");
}
