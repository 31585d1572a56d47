//! What the keys of all tables of a scene file have in common: switches, arrays of a fixed length, and the messages on
//! keys that a kind needs or has not.

use serde::de::{self, Deserializer, SeqAccess};
use serde::{Deserialize, Serialize};

/// Default of a switch that is on unless the author turns it off.
pub(crate) fn yes() -> bool {
    true
}

/// A switch left at that default is not written.
pub(crate) fn is_yes(value: &bool) -> bool {
    *value
}

/// A switch left off is not written.
pub(crate) fn is_no(value: &bool) -> bool {
    !*value
}

pub(crate) fn white() -> [f64; 3] {
    [1.0; 3]
}

pub(crate) fn upwards() -> [f64; 3] {
    [0.0, 1.0, 0.0]
}

pub(crate) fn require<T>(value: Option<T>, owner: &str, wanted: &str) -> Result<T, String> {
    value.ok_or_else(|| format!("{owner} needs {wanted}"))
}

/// Refuses the first key that is present and not taken.
pub(crate) fn refuse_keys<'a>(
    keys: impl IntoIterator<Item = (&'a str, bool)>,
    owner: &str,
    wanted: &str,
) -> Result<(), String> {
    match keys.into_iter().find(|(_, present)| *present) {
        Some((key, _)) => Err(format!("{owner} has no `{key}`; it takes {wanted}")),
        None => Ok(()),
    }
}

pub(crate) fn fixed<const N: usize>(
    values: Option<Vec<f64>>,
    owner: &str,
    wanted: &str,
) -> Result<[f64; N], String> {
    let found = |v: Vec<f64>| format!("{owner} needs {wanted}; found {} numbers", v.len());
    require(values, owner, wanted)?.try_into().map_err(found)
}

/// Three numbers that may be left out.
#[derive(Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Three(#[serde(deserialize_with = "numbers")] pub [f64; 3]);

/// Reads an array of exactly `N` numbers; the array type alone would let a surplus number pass unseen.
pub(crate) fn numbers<'de, D: Deserializer<'de>, const N: usize>(
    input: D,
) -> Result<[f64; N], D::Error> {
    let values = Vec::<f64>::deserialize(input)?;
    values.try_into().map_err(|values: Vec<f64>| {
        let wanted = format!("[{}], {N} numbers,", vec!["0.0"; N].join(", "));
        miscounted(&values, &wanted)
    })
}

/// Reads three numbers that stand where another form is also possible.
pub(crate) fn three_of<'de, A: SeqAccess<'de>>(
    mut sequence: A,
    wanted: &str,
) -> Result<[f64; 3], A::Error> {
    let mut values = Vec::new();
    while let Some(value) = sequence.next_element()? {
        values.push(value);
    }
    let three = values.try_into();
    three.map_err(|values: Vec<f64>| miscounted(&values, wanted))
}

fn miscounted<E: de::Error>(values: &[f64], wanted: &str) -> E {
    let count = values.len();
    E::custom(format!("{count} numbers found; {wanted} would be accepted"))
}
