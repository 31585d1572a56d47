//! What is packed: files compressed with gzip, and the encodings of BinaryCIF.

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
    let refused = |bytes, limit| unpack(bytes, limit, "f").unwrap_err().to_string();
    let many = refused(&zeros, 999_999);
    assert!(many.starts_with("f: it unpacks to more than 999999 bytes"));
    assert!(refused(&zeros[..900], 1_000_000).starts_with("f: it cannot be unpacked"));
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
    map(&[
        ("data", Value::Binary(bytes.to_vec())),
        ("encoding", Value::Array(encodings.to_vec())),
    ])
}

/// A file with so many atoms, whose columns are given or are zeros.
fn read(rows: usize, given: &[(&str, Value)]) -> Result<Imported, String> {
    let zeros = |name: &&str| given.iter().all(|(own, _)| own != name);
    let zeros = ["Cartn_x", "Cartn_y", "Cartn_z"].into_iter().filter(zeros);
    let zeros = zeros.map(|name| (name, data(&vec![0; rows], &[bytes_of(4)])));
    let column = |(name, data)| map(&[("name", Value::from(name)), ("data", data)]);
    let columns = given.iter().cloned().chain(zeros).map(column).collect();
    let atoms = map(&[
        ("name", "_atom_site".into()),
        ("rowCount", rows.into()),
        ("columns", Value::Array(columns)),
    ]);
    let block = map(&[
        ("header", "X".into()),
        ("categories", Value::Array(vec![atoms])),
    ]);
    let file = map(&[("dataBlocks", Value::Array(vec![block]))]);
    let mut bytes = vec![];
    rmpv::encode::write_value(&mut bytes, &file).expect("memory");
    let read = pdb::read(&bytes, Format::Bcif, "f.bcif", &Options::default());
    read.map_err(|error| error.to_string())
}

/// The examples of the format's description, as the x of atoms.
#[test]
fn the_examples_of_the_description_are_decoded() {
    let small = |numbers: &[i8]| -> Vec<u8> { numbers.iter().map(|n| *n as u8).collect() };
    let size = |count: i64| ("srcSize", Value::from(count));
    let signed = [
        ("byteCount", 1.into()),
        ("isUnsigned", Value::Boolean(false)),
        size(6),
    ];
    let quantized = [("min", 1.into()), ("max", 2.into()), ("numSteps", 3.into())];
    let cases: [(Vec<u8>, Value, &[f64]); 6] = [
        (
            small(&[1, 3, 2, 1, 3, 2]),
            encoding("RunLength", &[size(6)]),
            &[1.0, 1.0, 1.0, 2.0, 3.0, 3.0],
        ),
        (
            small(&[0, 3, 2, 1]),
            encoding("Delta", &[("origin", 1000.into())]),
            &[1000.0, 1003.0, 1005.0, 1006.0],
        ),
        (
            small(&[120, 123, 12]),
            encoding("FixedPoint", &[("factor", 100.into())]),
            &[1.2, 1.23, 0.12],
        ),
        (
            small(&[0, 0, 1, 2, 2, 1]),
            encoding("IntervalQuantization", &quantized),
            &[1.0, 1.0, 1.5, 2.0, 2.0, 1.5],
        ),
        (
            small(&[1, 2, -3, 127, 1, -128, -1, 127, 0]),
            encoding("IntegerPacking", &signed),
            &[1.0, 2.0, -3.0, 128.0, -129.0, 127.0],
        ),
        // The shortest decimal of a short number.
        (vec![0xcd, 0xcc, 0x9d, 0x41], bytes_of(32), &[19.725]),
    ];
    for (bytes, own, expected) in cases {
        let is_last = own == bytes_of(32);
        let encodings = match is_last {
            true => vec![own.clone()],
            false => vec![own.clone(), bytes_of(1)],
        };
        let column = ("Cartn_x", data(&bytes, &encodings));
        let imported = read(expected.len(), &[column]).unwrap_or_else(|e| panic!("{own}: {e}"));
        let places = crate::common::structure::places(&imported);
        let xs: Vec<f64> = places.iter().map(|place| place[0]).collect();
        assert_eq!(xs, expected, "{own}");
    }
}

#[test]
fn texts_are_decoded() {
    let texts = encoding(
        "StringArray",
        &[
            ("dataEncoding", Value::Array(vec![bytes_of(1)])),
            ("stringData", "CAB".into()),
            ("offsetEncoding", Value::Array(vec![bytes_of(4)])),
            ("offsets", Value::Binary(vec![0, 1, 3])),
        ],
    );
    let column = ("label_atom_id", data(&[0, 1, 0, 255], &[texts]));
    let imported = read(4, &[column]).expect("readable");
    let names = crate::common::structure::names(&imported);
    assert_eq!(names, ["-/-/C", "-/-/AB", "-/-/C #-", "-/-/-"]);
}

#[test]
fn a_short_file_does_not_fill_the_memory() {
    let refused = |size: i64, runs: &[i32], says: &str| {
        let run = encoding("RunLength", &[("srcSize", size.into())]);
        let bytes: Vec<u8> = runs.iter().flat_map(|n| n.to_le_bytes()).collect();
        let error = read(6, &[("Cartn_x", data(&bytes, &[run, bytes_of(3)]))]).unwrap_err();
        assert!(error.contains(says), "{error}");
    };
    refused(1 << 40, &[1, i32::MAX], "more values than");
    refused(6, &[1, 7], "its runs are longer than it");
    refused(6, &[1, -1], "its runs are longer than it");
}
