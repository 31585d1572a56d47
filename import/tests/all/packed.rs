//! What is packed: files compressed with gzip, and the encodings of BinaryCIF.

use crate::common::cases::cases;
use crate::common::says;
use crate::common::structure::{names, places};
use flate2::Compression;
use flate2::write::GzEncoder;
use imogene_import::pdb::{self, Format, Options};
use imogene_import::{Imported, is_compressed, unpack};
use rmpv::Value;
use std::io::Write;

fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(vec![], Compression::best());
    encoder.write_all(bytes).expect("memory");
    encoder.finish().expect("memory")
}

#[test]
fn what_is_unpacked_has_a_limit() {
    let zeros = packed(&[0; 1_000_000]);
    assert!(is_compressed(&zeros) && zeros.len() < 2_000);
    let whole = unpack(&zeros, 1_000_000, "f").expect("whole");
    assert_eq!(whole.len(), 1_000_000);
    let refused = |bytes, limit| unpack(bytes, limit, "f").unwrap_err();
    let many = refused(&zeros, 999_999);
    says(many, "f: it unpacks to more than 999999 bytes");
    let cut = refused(&zeros[..900], 1_000_000);
    says(cut, "f: it cannot be unpacked");
    let two = [packed(b"one "), packed(b"two")].concat();
    assert_eq!(unpack(&two, 100, "f").expect("two members"), b"one two");
}

fn map(pairs: &[(&str, Value)]) -> Value {
    let pair = |(key, value): &(&str, Value)| ((*key).into(), value.clone());
    Value::Map(pairs.iter().map(pair).collect())
}

/// An encoding of a kind, with its other keys.
fn encoding(kind: &str, keys: &[(&str, Value)]) -> Value {
    map(&[&[("kind", kind.into())], keys].concat())
}

fn bytes_of(kind: i64) -> Value {
    encoding("ByteArray", &[("type", kind.into())])
}

/// Bytes, and the encodings that they went through.
fn data(bytes: &[u8], encodings: &[Value]) -> Value {
    let encodings = encodings.to_vec().into();
    map(&[("data", bytes.into()), ("encoding", encodings)])
}

/// A file with so many atoms, whose columns are given or are zeros.
fn read(rows: usize, given: &[(&str, Value)]) -> Result<Imported, String> {
    let zeros = |name: &&str| given.iter().all(|(own, _)| own != name);
    let zeros = ["Cartn_x", "Cartn_y", "Cartn_z"].into_iter().filter(zeros);
    let zeros = zeros.map(|name| (name, data(&vec![0; rows], &[bytes_of(4)])));
    let column = |(name, data)| map(&[("name", Value::from(name)), ("data", data)]);
    let columns: Vec<Value> = given.iter().cloned().chain(zeros).map(column).collect();
    let atoms = map(&[
        ("name", "_atom_site".into()),
        ("rowCount", rows.into()),
        ("columns", columns.into()),
    ]);
    let tables = vec![atoms].into();
    let block = map(&[("header", "X".into()), ("categories", tables)]);
    let file = map(&[("dataBlocks", vec![block].into())]);
    let mut bytes = vec![];
    rmpv::encode::write_value(&mut bytes, &file).expect("memory");
    let read = pdb::read(&bytes, Format::Bcif, "f.bcif", &Options::default());
    read.map_err(|error| error.to_string())
}

/// The examples of the format's description, as the x of atoms.
#[test]
fn the_examples_of_the_description_are_decoded() {
    // Each encoding takes those of these keys that it knows.
    let keys = [
        ("srcSize", 6.into()),
        ("origin", 1000.into()),
        ("factor", 100.into()),
        ("min", 1.into()),
        ("max", 2.into()),
        ("numSteps", 3.into()),
        ("byteCount", 1.into()),
        ("isUnsigned", Value::Boolean(false)),
    ];
    let table = "
RunLength | 1 3 2 1 3 2 | 1 1 1 2 3 3
Delta | 0 3 2 1 | 1000 1003 1005 1006
FixedPoint | 120 123 12 | 1.2 1.23 0.12
IntervalQuantization | 0 0 1 2 2 1 | 1 1 1.5 2 2 1.5
IntegerPacking | 1 2 -3 127 1 -128 -1 127 0 | 1 2 -3 128 -129 127
";
    let decoded = |bytes: &[u8], encodings: &[Value], expected: &[f64]| {
        let column = ("Cartn_x", data(bytes, encodings));
        let imported = read(expected.len(), &[column]).expect("readable");
        let xs: Vec<f64> = places(&imported).iter().map(|place| place[0]).collect();
        assert_eq!(xs, expected, "{encodings:?}");
    };
    for [kind, numbers, expected] in cases(table) {
        let byte = |text: &str| text.parse::<i8>().expect(text) as u8;
        let bytes: Vec<u8> = numbers.split(' ').map(byte).collect();
        let expected: Vec<f64> = expected.split(' ').map(|x| x.parse().expect(x)).collect();
        decoded(&bytes, &[encoding(&kind, &keys), bytes_of(1)], &expected);
    }
    // The shortest decimal of a short number.
    decoded(&[0xcd, 0xcc, 0x9d, 0x41], &[bytes_of(32)], &[19.725]);
}

#[test]
fn texts_are_decoded() {
    let keys = [
        ("dataEncoding", Value::Array(vec![bytes_of(1)])),
        ("stringData", "CAB".into()),
        ("offsetEncoding", Value::Array(vec![bytes_of(4)])),
        ("offsets", Value::Binary(vec![0, 1, 3])),
    ];
    let texts = encoding("StringArray", &keys);
    let column = ("label_atom_id", data(&[0, 1, 0, 255], &[texts]));
    let imported = read(4, &[column]).expect("readable");
    assert_eq!(names(&imported), ["-/-/C", "-/-/AB", "-/-/C #-", "-/-/-"]);
}

#[test]
fn a_short_file_does_not_fill_the_memory() {
    let refused = |size: i64, runs: &[i32], why: &str| {
        let run = encoding("RunLength", &[("srcSize", size.into())]);
        let bytes: Vec<u8> = runs.iter().flat_map(|n| n.to_le_bytes()).collect();
        let error = read(6, &[("Cartn_x", data(&bytes, &[run, bytes_of(3)]))]).unwrap_err();
        says(error, why);
    };
    refused(1 << 40, &[1, i32::MAX], "more values than");
    refused(6, &[1, 7], "its runs are longer than it");
    refused(6, &[1, -1], "its runs are longer than it");
}
