//! Names of objects: what a chemist calls the atom, made unique.

use super::structure::Atom;
use super::words::{Word, Words};
use std::collections::{HashMap, HashSet};

/// Names given so far.
#[derive(Default)]
pub struct Names {
    taken: HashSet<String>,
    repeats: HashMap<String, usize>,
}

impl Names {
    /// The name itself, or with the least number behind it that makes it unique.
    pub fn unique(&mut self, name: String) -> String {
        if self.taken.insert(name.clone()) {
            return name;
        }
        let repeats = self.repeats.entry(name.clone()).or_insert(1);
        loop {
            *repeats += 1;
            let other = format!("{name} ({repeats})");
            if self.taken.insert(other.clone()) {
                return other;
            }
        }
    }

    /// `A/17/CA`: chain, residue number, atom; with the alternate behind it if there is one, the model in front if
    /// there are several, and the serial number if another atom has the same.
    pub fn of_atom(&mut self, atom: &Atom, words: &Words, model: Option<i64>) -> String {
        let or_dash = |text: String| {
            if text.is_empty() {
                "-".to_owned()
            } else {
                text
            }
        };
        let text = |word: Word| or_dash(words.text(word).to_owned());
        let mut name = [atom.chain, atom.number, atom.name].map(text).join("/");
        if !atom.alternate.is_empty() {
            name = format!("{name}.{}", words.text(atom.alternate));
        }
        if let Some(model) = model {
            name = format!("{model}/{name}");
        }
        if self.taken.contains(&name) {
            name = format!("{name} #{}", or_dash(atom.serial.text(words)));
        }
        self.unique(name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_never_repeat() {
        let mut names = Names::default();
        let given = ["a", "a", "a (2)", "a", "b", "a (2)"].map(|n| names.unique(n.into()));
        assert_eq!(
            given,
            ["a", "a (2)", "a (2) (2)", "a (3)", "b", "a (2) (3)"]
        );
    }
}
