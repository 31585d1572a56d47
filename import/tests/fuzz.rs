//! Random bytes and changed real files through every reader: no panic, no hang, no unbounded memory, and what is
//! malformed has a place in the file.
//!
//! Half a million random bytes for each reader, and 300 changed files of the collection; ten million and 5 000 under
//! `IMOGENE_FULL=1`, or as many files as `IMOGENE_FUZZ_CHANGES` says. `IMOGENE_FUZZ_FILES` names a folder of
//! further files to change, `IMOGENE_FUZZ_READERS=mmcif,bcif` some of the readers.

mod memory;

use imogene_import::faces::{self, FaceOptions};
use imogene_import::pdb::{self, Format};
use imogene_import::{ImportError, is_compressed, terrain, unpack};
use imogene_plan::description::MachineDescription;
use imogene_scene::SceneFile;
use memory::MOST;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use rayon::prelude::*;
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// Bytes of a random text.
const RANDOM_BYTES: usize = 500;
/// What counts as a hang; the slowest file takes a fraction of a second, but the computer may be busy with other
/// things.
const PATIENCE: Duration = Duration::from_secs(600);
/// Most memory at once, for two files at a time.
const MOST_MEMORY: usize = 1 << 30;

/// A reader's name, the endings of its files, and what it says of bytes, with the place if they are malformed.
type Reader = (&'static str, &'static str, fn(&[u8]) -> Outcome);

enum Outcome {
    Read,
    /// Line and column, from 1.
    Malformed(usize, usize),
    /// Well formed, and refused as a whole or by the name of a part.
    Refused,
}

const READERS: [Reader; 9] = [
    ("pdb", ".pdb .ent", |b| structure(b, Format::Pdb)),
    ("mmcif", ".cif .mmcif", |b| structure(b, Format::Mmcif)),
    ("bcif", ".bcif.gz .bcif", |b| structure(b, Format::Bcif)),
    ("gzip", ".pdb.gz .bcif.gz", |bytes| {
        let unpacked = unpack(bytes, MOST_UNPACKED, "a file");
        unpacked.map_or(Outcome::Refused, |unpacked| {
            assert!(unpacked.len() as u64 <= MOST_UNPACKED);
            Outcome::Read
        })
    }),
    ("faces", ".faces.toml", |bytes| {
        outcome(faces::read(bytes, "a file", &FaceOptions::default()))
    }),
    ("step", ".step .stp .p21", |bytes| {
        let options = FaceOptions::default();
        outcome(faces::read_step(bytes, "a file", &options, &|_| None))
    }),
    ("heights", ".heights .asc", |bytes| {
        let options = terrain::TerrainOptions::default();
        outcome(terrain::import(bytes, "a file", &options))
    }),
    ("scene", ".toml", |bytes| {
        of_text(bytes, |text| SceneFile::parse(text, "a file"))
    }),
    (
        "machine",
        "machines/beam-160x120.toml machines/zone-160x120.toml",
        |bytes| of_text(bytes, |text| MachineDescription::parse(text, "a file")),
    ),
];

/// Bytes that a changed file may be unpacked to.
const MOST_UNPACKED: u64 = 10_000_000;

/// Reads a structure as it stands, and its first assembly.
fn structure(bytes: &[u8], format: Format) -> Outcome {
    let read = |options: &pdb::Options| pdb::read(bytes, format, "a file", options);
    let plain = read(&pdb::Options {
        style: pdb::Style::BallAndStick,
        ..pdb::Options::default()
    });
    let assembly = read(&pdb::Options {
        assembly: Some("1".into()),
        ..pdb::Options::default()
    });
    match (outcome(plain), assembly.map_err(|error| error.error.place)) {
        (Outcome::Read, Err(Some(place))) => Outcome::Malformed(place.line, place.column),
        (plain, _) => plain,
    }
}

fn outcome(read: Result<imogene_import::Imported, ImportError>) -> Outcome {
    match read.map_err(|error| error.error.place) {
        Ok(imported) => {
            // What was read can be written.
            let toml = imported.scene.to_toml();
            toml.expect("a scene that can be written");
            Outcome::Read
        }
        Err(Some(place)) => Outcome::Malformed(place.line, place.column),
        Err(None) => Outcome::Refused,
    }
}

/// Readers of text: a file that is not text is refused before them.
fn of_text<T, E: Display>(bytes: &[u8], read: impl Fn(&str) -> Result<T, E>) -> Outcome {
    let text = String::from_utf8_lossy(bytes);
    let Err(error) = read(&text) else {
        return Outcome::Read;
    };
    let message = error.to_string();
    let mut numbers = message.strip_prefix("a file:").unwrap_or("").splitn(3, ':');
    let mut number = || numbers.next().and_then(|n| n.parse().ok());
    match (number(), number()) {
        (Some(line), Some(column)) => Outcome::Malformed(line, column),
        _ => Outcome::Refused,
    }
}

/// Files that a reader is for.
fn files_of((reader, endings, _): &Reader) -> Vec<Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = ["scenes", "parts", "machines", "import/tests/data"];
    let mut folders = folders.map(|name| root.join(name)).to_vec();
    folders.extend(std::env::var_os("IMOGENE_FUZZ_FILES").map(PathBuf::from));
    let mut files = vec![];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            let name = path.to_string_lossy().replace('\\', "/").to_lowercase();
            if path.is_dir() {
                folders.push(path);
            } else if endings.split(' ').any(|ending| name.ends_with(ending)) {
                files.push(path);
            }
        }
    }
    files.sort();
    let read = |path: &PathBuf| {
        let bytes = std::fs::read(path).expect("a file");
        if is_compressed(&bytes) && *reader != "gzip" {
            unpack(&bytes, MOST_UNPACKED, "a file").expect("a whole file")
        } else {
            bytes
        }
    };
    files.iter().map(read).collect()
}

struct Dice(ChaCha8Rng);

impl Dice {
    fn below(&mut self, end: usize) -> usize {
        self.0.next_u64() as usize % end.max(1)
    }

    fn bytes(&mut self, count: usize) -> Vec<u8> {
        let mut bytes = vec![0; count];
        self.0.fill_bytes(&mut bytes);
        bytes
    }

    /// A file with one to eight other bytes, of which a binary format's reader sees more than of one that is cut.
    fn spoilt(&mut self, files: &[Vec<u8>]) -> Vec<u8> {
        let mut bytes = files[self.below(files.len())].clone();
        for _ in 0..=self.below(8) {
            let place = self.below(bytes.len());
            bytes[place] = self.0.next_u64() as u8;
        }
        bytes
    }

    /// A file with one to eight changes.
    fn changed(&mut self, files: &[Vec<u8>]) -> Vec<u8> {
        let mut bytes = files[self.below(files.len())].clone();
        // Most files are shortened to a part of themselves, so that more of them can be tried.
        if bytes.len() > 20_000 && self.below(8) > 0 {
            let from = self.below(bytes.len() - 10_000);
            bytes = bytes[from..from + 10_000].to_vec();
        }
        for _ in 0..=self.below(8) {
            self.change(&mut bytes, files);
        }
        bytes
    }

    fn change(&mut self, bytes: &mut Vec<u8>, files: &[Vec<u8>]) {
        const WORDS: &str =
            "nan|inf|-1|0|1e308|-1e-308|99999999999999999999|\"|[[|]|\n|\r\n|\u{e9}|=";
        let at = self.below(bytes.len() + 1);
        let to = (at + self.below(40)).min(bytes.len());
        match self.below(8) {
            0 if !bytes.is_empty() => {
                let place = at.min(bytes.len() - 1);
                bytes[place] ^= 1 << self.below(8);
            }
            1 => bytes.truncate(at),
            2 => drop(bytes.drain(at..to)),
            3 => {
                let words: Vec<&str> = WORDS.split('|').collect();
                let word = words[self.below(words.len())].bytes();
                bytes.splice(at..to.min(at + 6), word);
            }
            4 => {
                let copy = bytes[at..to].to_vec();
                bytes.splice(at..at, copy);
            }
            5 => {
                let count = self.below(8);
                let random = self.bytes(count);
                bytes.splice(at..at, random);
            }
            6 => {
                let other = &files[self.below(files.len())];
                let from = self.below(other.len());
                let part = other[from..(from + 400).min(other.len())].to_vec();
                bytes.splice(at..at, part);
            }
            _ => {
                // Another digit is a number of another size, or a name that is not there.
                let near = at..bytes.len().min(at + 400);
                let digits = near.filter(|&place| bytes[place].is_ascii_digit());
                let digits: Vec<usize> = digits.collect();
                if !digits.is_empty() {
                    let place = digits[self.below(digits.len())];
                    bytes[place] = b'0' + self.below(10) as u8;
                }
            }
        }
    }
}

#[derive(Clone, Copy, Debug, Default)]
struct Count {
    read: usize,
    malformed: usize,
    refused: usize,
    slowest: Duration,
}

impl Count {
    fn with(mut self, other: Count) -> Count {
        self.read += other.read;
        self.malformed += other.malformed;
        self.refused += other.refused;
        self.slowest = self.slowest.max(other.slowest);
        self
    }
}

fn try_one((name, _, read): &Reader, bytes: &[u8], seed: u64) -> Count {
    let started = Instant::now();
    let outcome = read(bytes);
    let slowest = started.elapsed();
    assert!(slowest < PATIENCE, "{name}, seed {seed}: {slowest:?}");
    let mut count = Count {
        slowest,
        ..Count::default()
    };
    match outcome {
        Outcome::Read => count.read = 1,
        Outcome::Refused => count.refused = 1,
        Outcome::Malformed(line, column) => {
            let ends = bytes.iter().filter(|byte| b"\n\r".contains(byte));
            let is_there =
                (1..=ends.count() + 1).contains(&line) && (1..=bytes.len() + 1).contains(&column);
            assert!(is_there, "{name}, seed {seed}: {line}:{column}");
            count.malformed = 1;
        }
    }
    count
}

fn run(reader: &Reader, cases: u64, make: impl Fn(&mut Dice) -> Vec<u8> + Sync) -> Count {
    let one = |seed: u64| {
        let bytes = make(&mut Dice(ChaCha8Rng::seed_from_u64(seed)));
        try_one(reader, &bytes, seed)
    };
    let counts = (0..cases).into_par_iter().map(one);
    counts.reduce(Count::default, Count::with)
}

#[test]
fn readers_survive_anything() {
    let is_full = std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1");
    let changed = match std::env::var("IMOGENE_FUZZ_CHANGES") {
        Ok(number) => number.parse().expect("IMOGENE_FUZZ_CHANGES is a number"),
        Err(_) if is_full => 5_000,
        Err(_) => 300,
    };
    let texts = if is_full { 20_000 } else { 500 };
    let only = std::env::var("IMOGENE_FUZZ_READERS").ok();
    let is_asked = |reader: &&Reader| {
        let asked = only.as_ref();
        asked.is_none_or(|only| only.split(',').any(|name| name == reader.0))
    };
    for reader in READERS.iter().filter(is_asked) {
        let name = reader.0;
        let random = run(reader, texts, |dice| dice.bytes(RANDOM_BYTES));
        println!("{name}: random bytes: {random:?}");
        assert_eq!(random.read, 0, "{name}");
        let files = files_of(reader);
        assert!(!files.is_empty(), "no files for {name}");
        for (place, file) in files.iter().enumerate() {
            try_one(reader, file, place as u64);
        }
        // Bytes have no lines: what is wrong in them is named by its category or not at all.
        let is_binary = matches!(name, "bcif" | "gzip");
        let count = run(reader, changed, |dice| match dice.below(4) {
            1.. if is_binary => dice.spoilt(&files),
            _ => dice.changed(&files),
        });
        let files = files.len();
        println!("{name}: {changed} changes of {files} files: {count:?}");
        let wrong = [count.malformed, count.refused][usize::from(is_binary)];
        assert!(wrong > changed as usize / 10 && count.read > 0, "{name}");
    }
    let most = MOST.load(Ordering::Relaxed);
    println!("{} MB of memory at once", most >> 20);
    assert!(most < MOST_MEMORY, "{most} bytes at once");
}
