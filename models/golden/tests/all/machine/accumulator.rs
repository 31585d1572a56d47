use imogene_golden::machine::accumulator::{Accumulator, PassPixel};

#[test]
fn means_are_rounded_to_the_nearest() {
    for (values, expected) in [
        ([0, 0, 0, 1], 0),
        ([0, 0, 1, 1], 1),
        ([255, 255, 255, 254], 255),
        ([255, 255, 254, 254], 255),
        ([255, 254, 254, 254], 254),
    ] {
        let mut sums = Accumulator::new(1);
        let means = [0, 1, 2, 3].map(|pass| {
            let pixel = PassPixel {
                address: 0,
                first: pass == 0,
                last: pass == 3,
                colour: [values[pass]; 3],
            };
            sums.add(&pixel, 4)
        });
        assert_eq!(means, [None, None, None, Some([expected; 3])]);
    }
}
