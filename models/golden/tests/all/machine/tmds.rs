use imogene_golden::machine::tmds::{CONTROL, Sent, TmdsEncoder, meaning, transitions};
use std::collections::HashSet;

/// Every state that any sequence of levels leads to.
fn states() -> Vec<TmdsEncoder> {
    let mut found = HashSet::from([TmdsEncoder::default()]);
    let mut open = vec![TmdsEncoder::default()];
    while let Some(state) = open.pop() {
        for level in 0..=255 {
            let mut next = state;
            next.word(Sent::Level(level));
            if found.insert(next) {
                open.push(next);
            }
        }
    }
    found.into_iter().collect()
}

/// The decoder of the standard: figure 3-6.
fn decoded(word: u16) -> u8 {
    let body = if word >> 9 & 1 == 1 { !word } else { word } & 0xff;
    let differs = body ^ body << 1;
    let is_xor = word >> 8 & 1 == 1;
    let level = if is_xor { differs } else { !differs };
    (level & 0xfe | body & 1) as u8
}

#[test]
fn every_level_is_decoded_from_every_state_and_the_disparity_is_bounded() {
    let states = states();
    assert!(states.iter().all(|state| state.disparity.abs() <= 8));
    assert!(states.len() > 5, "{states:?}");
    for state in states {
        for level in 0..=255 {
            let word = state.clone().word(Sent::Level(level));
            assert_eq!(decoded(word), level);
            assert_eq!(meaning(word), Some(Sent::Level(level)));
            // Eight bits of a chain have at most three transitions, the marks at most two more.
            assert!(transitions(word, 8) <= 3 && transitions(word, 10) <= 5);
            assert!(!CONTROL.contains(&word));
        }
    }
}

/// A receiver finds the words by the many transitions of the blanking.
#[test]
fn words_of_control_have_more_transitions_than_those_of_levels() {
    for (pair, word) in CONTROL.into_iter().enumerate() {
        assert!(transitions(word, 10) >= 7);
        assert_eq!(meaning(word), Some(Sent::Control(pair as u8)));
    }
}

#[test]
fn words_that_nobody_sends_mean_nothing() {
    let known = (0..1 << 10).filter(|&word| meaning(word).is_some());
    // 460 words of levels, as published, and four of control.
    assert_eq!(known.count(), 464);
}

/// Published words: black, white and a level of the middle, at the beginning of a line.
#[test]
fn the_first_words_of_a_line() {
    let word = |level| TmdsEncoder::default().word(Sent::Level(level));
    assert_eq!(word(0x00), 0x100);
    assert_eq!(word(0xff), 0x200);
    assert_eq!(word(0x10), 0x1f0);
}
