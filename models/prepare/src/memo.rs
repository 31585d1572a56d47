//! What is found once and asked for again.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::Mutex;

/// Values by their keys.
pub struct Memo<K, V>(Mutex<HashMap<K, V>>);

/// The same where there are few, which take no more room than they need.
pub struct Few<K, V>(Mutex<Vec<(K, V)>>);

impl<K, V> Default for Memo<K, V> {
    fn default() -> Self {
        Memo(Mutex::default())
    }
}

impl<K, V> Default for Few<K, V> {
    fn default() -> Self {
        Few(Mutex::default())
    }
}

const NONE_WITHIN: &str = "no search ends within";

impl<K: Eq + Hash, V: Clone> Memo<K, V> {
    pub fn get(&self, key: K, find: impl FnOnce() -> V) -> V {
        let values = || self.0.lock().expect(NONE_WITHIN);
        let known = values().get(&key).cloned();
        known.unwrap_or_else(|| {
            let value = find();
            values().insert(key, value.clone());
            value
        })
    }
}

impl<K: PartialEq, V: Clone> Few<K, V> {
    pub fn get(&self, key: K, find: impl FnOnce() -> V) -> V {
        let values = || self.0.lock().expect(NONE_WITHIN);
        let known = |(known, value): &(K, V)| (*known == key).then(|| value.clone());
        let known = values().iter().find_map(known);
        known.unwrap_or_else(|| {
            let value = find();
            let mut values = values();
            values.reserve_exact(1);
            values.push((key, value.clone()));
            value
        })
    }
}
