//! Words that many atoms share, each kept once: names of atoms, residues and chains.

use std::collections::HashMap;

/// A word of [`Words`]; the default is the empty one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Word(u32);

impl Word {
    /// No text.
    pub const EMPTY: Word = Word(0);

    /// Whether there is no text.
    pub fn is_empty(self) -> bool {
        self == Word::EMPTY
    }
}

/// All words of a structure.
#[derive(Debug)]
pub struct Words {
    texts: Vec<Box<str>>,
    places: HashMap<Box<str>, Word>,
}

impl Default for Words {
    fn default() -> Self {
        let mut words = Words {
            texts: vec![],
            places: HashMap::new(),
        };
        words.keep("");
        words
    }
}

impl Words {
    /// The word of a text, kept if it is new.
    pub fn keep(&mut self, text: &str) -> Word {
        if let Some(word) = self.places.get(text) {
            return *word;
        }
        let word = Word(u32::try_from(self.texts.len()).expect("fewer words than bytes of a file"));
        self.texts.push(text.into());
        self.places.insert(text.into(), word);
        word
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
        self.places.get(text).copied()
    }

    /// Its text.
    pub fn text(&self, word: Word) -> &str {
        &self.texts[word.0 as usize]
    }
}

/// Text for people: what is no text, and control characters, are written as `?`.
pub fn plain(bytes: &[u8]) -> String {
    let plain = |c: char| {
        if c.is_control() || c == char::REPLACEMENT_CHARACTER {
            '?'
        } else {
            c
        }
    };
    String::from_utf8_lossy(bytes).chars().map(plain).collect()
}

/// The number that a file gives an atom. Most are whole numbers; hybrid-36, hexadecimal and starred ones are words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Serial {
    /// Decimal, without leading zeros.
    Number(u32),
    /// Anything else.
    Word(Word),
}

impl Serial {
    /// From its text.
    pub fn of(text: &[u8], words: &mut Words) -> Serial {
        let decimal = |text: &[u8]| {
            let whole = !text.is_empty() && text.len() <= 9 && text.iter().all(u8::is_ascii_digit);
            let number = |n: u32, c: &u8| 10 * n + u32::from(c - b'0');
            (whole && (text[0] != b'0' || text.len() == 1)).then(|| text.iter().fold(0, number))
        };
        match decimal(text) {
            Some(number) => Serial::Number(number),
            None => Serial::Word(words.keep_bytes(text)),
        }
    }

    /// As it was written.
    pub fn text(self, words: &Words) -> String {
        match self {
            Serial::Number(number) => number.to_string(),
            Serial::Word(word) => words.text(word).to_owned(),
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_serial_numbers_are_written_back() {
        let mut words = Words::default();
        assert!(words.keep("").is_empty());
        let word = words.keep_bytes("caf\u{e9}".as_bytes());
        assert_eq!(words.keep("caf\u{e9}"), word);
        assert_eq!(words.text(word), "caf\u{e9}");
        let odd = words.keep_bytes(b"a\x01\xff");
        assert_eq!((words.text(odd), words.find("none")), ("a??", None));
        // The last of them is empty.
        for text in "0 1 999999999 9999999999 007 A0000 ***** ".split(' ') {
            let serial = Serial::of(text.as_bytes(), &mut words);
            assert_eq!(serial.text(&words), text);
        }
        assert_eq!(Serial::of(b"12", &mut words), Serial::Number(12));
    }
}
