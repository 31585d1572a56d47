//! The words that many atoms of a file share, each kept once: names of atoms, residues and chains.

use indexmap::IndexSet;

/// A word of [`Words`]; the default is the empty one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Word(u32);

impl Word {
    pub fn is_empty(self) -> bool {
        self == Word::default()
    }
}

pub struct Words(IndexSet<Box<str>>);

impl Default for Words {
    fn default() -> Self {
        Words(IndexSet::from(["".into()]))
    }
}

impl Words {
    /// The word of a text, kept if it is new.
    pub fn keep(&mut self, text: &str) -> Word {
        self.find(text).unwrap_or_else(|| {
            let (place, _) = self.0.insert_full(text.into());
            Word(u32::try_from(place).expect("fewer words than bytes of a file"))
        })
    }

    /// The word of a text as a file has it: what is not text, and control characters, become `?`.
    pub fn keep_bytes(&mut self, bytes: &[u8]) -> Word {
        match std::str::from_utf8(bytes) {
            Ok(text) if !text.contains(char::is_control) => self.keep(text),
            _ => self.keep(&plain(bytes)),
        }
    }

    /// The word of a text, if it is known.
    pub fn find(&self, text: &str) -> Option<Word> {
        self.0.get_index_of(text).map(|place| Word(place as u32))
    }

    pub fn text(&self, word: Word) -> &str {
        &self.0[word.0 as usize]
    }
}

/// A word that an atom often has in common with the one before, and the bytes that it was read from.
#[derive(Default)]
pub struct Repeated(Vec<u8>, Word);

impl Repeated {
    /// The word of some bytes, read from them if they are not the same again.
    pub fn of(&mut self, bytes: &[u8], read: impl FnOnce() -> Word) -> Word {
        if self.0 != bytes {
            *self = Repeated(bytes.to_vec(), read());
        }
        self.1
    }
}

/// Text for people: what is no text, and control characters, are written as `?`.
pub fn plain(bytes: &[u8]) -> String {
    let is_odd = |c: char| c.is_control() || c == char::REPLACEMENT_CHARACTER;
    String::from_utf8_lossy(bytes).replace(is_odd, "?")
}

/// Some names for a message, and how many more there are.
pub fn listed(names: impl IntoIterator<Item = impl Into<String>>) -> String {
    const SHOWN: usize = 20;
    let mut names: Vec<String> = names.into_iter().map(Into::into).collect();
    if names.len() > SHOWN {
        let more = names.len() - SHOWN;
        names.truncate(SHOWN);
        names.push(format!("{more} more"));
    }
    names.join(", ")
}
