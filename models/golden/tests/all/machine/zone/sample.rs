use imogene_golden::machine::zone::sample::Sample;

#[test]
fn bits_come_back_as_their_sample() {
    for of in [1, 2, 4] {
        let all: Vec<Sample> = Sample::all(of).collect();
        assert_eq!(all.len(), (of * of) as usize);
        assert!(all[0].is_first() && all[all.len() - 1].is_last());
        for sample in all {
            assert_eq!(Sample::of_bits(sample.bits(), of), Some(sample));
        }
    }
    let second = Sample::all(2).nth(1).expect("four of them");
    assert_eq!(Sample::of_bits(second.bits() | 8, 2), None);
    assert_eq!(Sample::of_bits(second.bits(), 1), None);
}
