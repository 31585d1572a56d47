use imogene_board::{Channels, Decoder, Tick, TmdsError};
use imogene_golden::machine::tmds::{Sent, TmdsEncoder};

/// Bits of a word.
const WORD: usize = 10;

/// The pins for what three channels are given.
fn pins(given: &[[Sent; 3]]) -> Vec<u8> {
    let mut senders = [TmdsEncoder::default(); 3];
    let mut samples = vec![0; 7];
    for sent in given {
        let words = [0, 1, 2].map(|channel| senders[channel].word(sent[channel]));
        samples.extend((0..10).map(|place| {
            let bits = words.iter().enumerate();
            let bits = bits.fold(0, |all, (channel, word)| {
                all | (((word >> place) & 1) as u8) << channel
            });
            bits | if place < 5 { 8 } else { 0 }
        }));
    }
    samples
}

fn decode(samples: &[u8]) -> Result<(Vec<Tick>, Channels), TmdsError> {
    let (mut decoder, mut ticks) = (Decoder::default(), vec![]);
    for &sample in samples {
        ticks.extend(decoder.see(sample)?);
    }
    Ok((ticks, decoder.found()?))
}

const BLANK: [Sent; 3] = [Sent::Control(1), Sent::Control(0), Sent::Control(0)];

fn pixel(colour: [u8; 3]) -> [Sent; 3] {
    let [red, green, blue] = colour;
    [blue, green, red].map(Sent::Level)
}

#[test]
fn pixels_are_found_again() {
    let [one, other] = [[1, 2, 3], [250, 0, 255]].map(pixel);
    let (ticks, found) = decode(&pins(&[BLANK, one, other, BLANK])).expect("channels");
    let colours: Vec<_> = ticks.iter().map(|tick| tick.colour).collect();
    assert_eq!(colours[1..3], [[1, 2, 3], [250, 0, 255]]);
    assert!(ticks.iter().all(|tick| tick.hsync && !tick.vsync));
    assert_eq!(found.words, 4);
}

#[test]
fn a_bit_that_is_turned_over_is_found_in_every_place() {
    let sound = pins(&[BLANK, pixel([0x55; 3]), pixel([7; 3]), BLANK]);
    let begin = 7 + WORD;
    for place in begin..sound.len() {
        for channel in 0..4 {
            let mut broken = sound.clone();
            broken[place] ^= 1 << channel;
            assert_ne!(decode(&broken), decode(&sound), "bit {place} of {channel}");
        }
    }
}

#[test]
fn channels_that_are_apart_are_refused() {
    let mixed = [Sent::Control(0), Sent::Level(0), Sent::Level(0)];
    let error = decode(&pins(&[BLANK, mixed])).expect_err("one channel is blank");
    assert!(error.to_string().contains("disagree in word 1"), "{error}");
    assert_eq!(decode(&[0; 40]), Err(TmdsError::NoClock));
}
