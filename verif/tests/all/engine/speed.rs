use imogene_contract::{Request, Unit};
use imogene_verif::engine::speed::{Drive, Entrant, Speed, Work, measure, stimuli};
use imogene_verif::subject::LANES;
use imogene_verif::unit::subject;
use std::time::Duration;

/// Lines of the frame that are driven.
const LINES: usize = 2;

#[test]
fn every_kind_of_work_is_measured_and_the_first_engine_has_ratio_one() {
    let pe1 = || Ok(subject(&Request::new(Unit::Pe1))?);
    let engines = [1, LANES].map(|lanes| Entrant::new(lanes, pe1).expect("a legal subject"));
    for drive in [Drive::Frame, Drive::Random] {
        let stimuli = stimuli(&engines, drive);
        check(&measure(&engines, &stimuli, Duration::from_millis(30)).expect("a trace"));
    }
}

fn check(speeds: &[Speed]) {
    assert_eq!(speeds.len(), 6);
    for pair in speeds.chunks(2) {
        let lanes = (pair[0].lanes, pair[1].lanes);
        assert_eq!((pair[0].ratio, lanes), (1.0, (1, LANES)));
        assert!(pair[0].clocks_per_second > 0.0 && pair[1].ratio > 0.0);
        assert!(pair[0].first_clock_seconds > 0.0);
        let has_bytes = pair[0].vcd_bytes_per_clock.is_some_and(|bytes| bytes > 1.0);
        assert_eq!(has_bytes, pair[0].work == Work::Waveforms);
    }
}

#[test]
fn a_frame_begins_each_line_once() {
    let pe1 = || Ok(subject(&Request::new(Unit::Pe1))?);
    let engine = Entrant::new(1, pe1).expect("a legal subject");
    let stimuli = stimuli(&[engine], Drive::Frame);
    let [frame] = stimuli.as_slice() else {
        panic!("one stimulus, not {}", stimuli.len())
    };
    assert_eq!(frame.len(), 640 * LINES);
    assert_eq!(frame.iter().filter(|i| i[1] == 1).count(), 1);
    assert_eq!(frame.iter().filter(|i| i[2] == 1).count(), LINES - 1);
}
