//! Lanes: each is an instance of its own.

use imogene_hdl::{Bits, Design, Direction, Int, Port, Simulator, Value, join, memory, module};
use proptest::prelude::*;

const LANES: usize = 8;

/// Every kind of operation, a register that is held, a memory.
fn design() -> Design {
    Design::of(|| {
        let words = (("x", Bits::input(40)), ("y", Bits::input(40)));
        let numbers = (("a", Int::input(30)), ("b", Int::input(30)));
        let ports = (("write", Bits::input(1)), words, numbers);
        module("all", "top", ports, |(write, words, numbers)| {
            let ((x, y), (a, b)) = (words, numbers);
            let sums = vec![x + y, x - y, x & y, x | y, x ^ y, !x];
            let shifts = vec![x.left_by(y.low(6)), x.right_by(y.low(6))];
            let signed = vec![a * b, a.right_by(y.low(5)).extend(60), a.extend(60)];
            let flags = vec![x.equals(y), x.less(y), a.less(b)];
            let chosen = x.less(y).select(x, y).reg_when(write);
            let kept = memory("kept", 8, (write, x.low(3), y), y.low(3));
            let joined = join([x.bit(3), y.low(39)]);
            let state = vec![chosen, kept, chosen + kept, joined];
            let words = (("sum", sums), ("shift", shifts), ("state", state));
            (words, (("signed", signed), ("flag", flags)))
        });
    })
}

proptest! {
    /// Inputs change in some lanes and some clocks only.
    #[test]
    fn a_lane_is_an_instance_of_its_own(
        stimulus in prop::collection::vec((0..LANES, 0usize..5, any::<u64>(), any::<bool>()), 1..200),
    ) {
        let design = design();
        let mut singles = [(); LANES].map(|()| Simulator::new(&design));
        let mut lanes: Simulator<LANES> = Simulator::in_lanes(&design);
        let ports = |direction| -> Vec<Port> {
            let names = design.top.ports_of(direction).map(|port| &port.name);
            names.map(|name| singles[0].port(name)).collect()
        };
        let (inputs, outputs) = (ports(Direction::In), ports(Direction::Out));
        for (lane, input, value, is_clock) in stimulus {
            singles[lane].set(inputs[input], value);
            lanes.set_lane(lane, inputs[input], value);
            if is_clock {
                singles.iter_mut().for_each(Simulator::clock);
                lanes.clock();
            }
            for (lane, single) in singles.iter_mut().enumerate() {
                for output in &outputs {
                    prop_assert_eq!(lanes.get_lane(lane, *output), single.get(*output));
                }
            }
        }
    }
}
