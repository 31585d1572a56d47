//! What the keys of all tables of a scene file have in common: switches, arrays of a fixed length, and the messages on
//! keys that a kind needs or has not.

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{self, Deserializer, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// Default of a switch that is on unless the author turns it off.
pub(crate) fn yes() -> bool {
    true
}

/// A switch left at that default is not written.
pub(crate) fn is_yes(value: &bool) -> bool {
    *value
}

/// Default of a number that is whole.
pub fn number<T: From<u8>, const N: u8>() -> T {
    N.into()
}

/// What is as it would be without its key is not written.
pub fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
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

/// The names of keys, and whether each of them is there.
macro_rules! present {
    ($keys:expr; $($key:ident),+) => {
        [$((stringify!($key), $keys.$key.is_some())),+]
    };
}
pub(crate) use present;

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
#[derive(Clone, Copy, Deserialize)]
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

/// Reads a text or a table, so that what is wrong in a table is told, and not that it is no text; `wanted` says what
/// both are.
pub fn text_or_table<'de, D: Deserializer<'de>, T: Deserialize<'de>, V>(
    input: D,
    wanted: &'static str,
    text: fn(String) -> V,
    table: fn(T) -> V,
) -> Result<V, D::Error> {
    struct Either<T, V>(&'static str, fn(String) -> V, fn(T) -> V);

    impl<'de, T: Deserialize<'de>, V> Visitor<'de> for Either<T, V> {
        type Value = V;

        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            f.write_str(self.0)
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<V, E> {
            Ok(self.1(text.to_owned()))
        }

        fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<V, A::Error> {
            T::deserialize(MapAccessDeserializer::new(map)).map(self.2)
        }
    }

    input.deserialize_any(Either(wanted, text, table))
}
