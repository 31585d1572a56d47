//! What stands between a machine and the connectors of a board.

use super::description::{Description, bit, late};
use crate::stimulus::{each, mapped, word};
use crate::subject::{Stimuli, Subject};
use imogene_golden::machine::sequencer::{SceneSequencer, Word};
use imogene_golden::machine::tmds::{Sent, TmdsEncoder, TmdsSerialiser};
use proptest::prelude::*;

/// Bits of an address of the memory of a scene.
const SEQUENCE: u32 = 12;

pub(super) fn tmds_encoder() -> Description {
    Description::new(lines, || {
        let (mut encoder, mut words) = (TmdsEncoder::default(), late(3));
        move |i: &[i64]| {
            let sent = match bit(i[0]) {
                true => Sent::Level(i[1] as u8),
                false => Sent::Control(i[2] as u8),
            };
            vec![words.push(i64::from(encoder.word(sent)))]
        }
    })
}

/// Runs of pixels and of blanking; levels anew on every clock or alike for a while, as in a picture.
fn lines(subject: &Subject, clocks: usize) -> Stimuli {
    let run = (any::<bool>(), any::<bool>(), 1usize..60);
    let words = each(subject.inputs[1..].iter().map(word).collect(), clocks);
    mapped(
        (proptest::collection::vec(run, clocks), words),
        move |(runs, words)| {
            let each = runs.into_iter();
            let flags = each.flat_map(|(de, alike, length)| {
                (0..length).map(move |place| (de, alike && place > 0))
            });
            let mut level = 0;
            let each = flags.zip(words).map(|((de, alike), word)| {
                level = if alike { level } else { word[0] };
                vec![de.into(), level, word[1]]
            });
            each.take(clocks).collect()
        },
    )
}

pub(super) fn tmds_serialiser() -> Description {
    Description::new(turns, || {
        let mut serialiser = TmdsSerialiser::default();
        move |i: &[i64]| vec![Some(serialiser.clock(bit(i[0]), i[1] as u16).into())]
    })
}

/// Words that stand for five clocks, now and then for more; before the first, clocks without one.
fn turns(subject: &Subject, clocks: usize) -> Stimuli {
    let length = prop_oneof![6 => Just(5usize), 1 => 5usize..12];
    let words: Vec<_> = subject.inputs[1..].iter().map(word).collect();
    let idle = vec![0; subject.inputs.len()];
    let words = proptest::collection::vec((length, words), clocks);
    mapped((0..9usize, words), move |(before, list)| {
        let each = list.into_iter().enumerate();
        let each = each.flat_map(|(index, (length, words))| {
            let inputs = [vec![(index as i64 + 1) % 2], words].concat();
            std::iter::repeat_n(inputs, length)
        });
        let before = std::iter::repeat_n(idle.clone(), before);
        before.chain(each).take(clocks).collect()
    })
}

pub(super) fn scene_sequencer() -> Description {
    Description::new(stalls, || {
        let mut sequencer = SceneSequencer::default();
        move |i: &[i64]| {
            let word = Word {
                last: bit(i[0]),
                ends: bit(i[1]),
            };
            let said = sequencer.clock(word, i[2] as u8, bit(i[3]));
            vec![Some(said.valid.into()), Some(said.address.into())]
        }
    })
    // A word takes two clocks or more, and is sent twice where an image stays.
    .reached_in(8 << SEQUENCE)
}

/// A receiver that stalls now and then, long memories and images among short ones, short stays and long ones.
fn stalls(subject: &Subject, clocks: usize) -> Stimuli {
    let lengths = || prop_oneof![Just(1u32), Just(5), Just(1000), Just(1 << SEQUENCE)];
    let stays = prop_oneof![Just(0i64), Just(1), word(&subject.inputs[2])];
    let of_length = move |(words, image, stays): (u32, u32, i64)| {
        let one_of = |count| prop_oneof![2 * count - 1 => Just(0i64), 1 => Just(1)].boxed();
        let ready = prop_oneof![3 => Just(1i64), 1 => Just(0)].boxed();
        let inputs = vec![one_of(words), one_of(image), Just(stays).boxed(), ready];
        each(inputs, clocks)
    };
    let of = (lengths(), lengths(), stays);
    of.prop_flat_map(of_length).boxed()
}
