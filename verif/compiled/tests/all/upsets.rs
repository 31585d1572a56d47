//! A register that holds another word at power-up.

use imogene_compiled::{Program, Simulation};
use imogene_hdl::{Bits, Design, Value, module};
use std::sync::Arc;

/// Two registers one behind the other: another word in the first is gone after two clocks, wherever in memory the
/// words of each instance begin.
#[test]
fn another_word_is_gone_when_all_registers_took_new_ones() {
    let design = Design::of(|| {
        module("delay", "top", ("x", Bits::input(4)), |x| {
            ("late", x.reg().reg())
        });
    });
    let program = Arc::new(Program::new(&design, &[]));
    let instances: Vec<[Simulation; 2]> = (0..40)
        .map(|_| [(); 2].map(|()| Simulation::new(&program)))
        .collect();
    for [mut good, mut bad] in instances {
        assert!(good.is_like(&bad));
        bad.upset(0, 0, 9);
        let likes = [(); 2].map(|()| {
            good.clock();
            bad.clock();
            good.is_like(&bad)
        });
        assert_eq!(likes, [false, true]);
    }
}
