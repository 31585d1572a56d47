use imogene_files::{read, read_text};
use std::path::Path;

#[test]
fn files_up_to_the_limit_are_read_and_larger_ones_and_endless_ones_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file");
    std::fs::write(&path, "12345").unwrap();
    assert_eq!(read(&path, 5).unwrap(), b"12345");
    assert_eq!(read_text(&path, 5).unwrap(), "12345");
    for (path, limit, said) in [
        (path.as_path(), 4, "larger than 4 bytes"),
        (Path::new("/dev/zero"), 3 << 20, "larger than 3 MiB"),
        (folder.path(), 4, "a folder"),
    ] {
        let message = read(path, limit).unwrap_err().to_string();
        assert!(message.contains(said), "{message}");
    }
    std::fs::write(&path, b"ab\xff").unwrap();
    let message = read_text(&path, 5).unwrap_err().to_string();
    assert!(message.contains("byte 2"), "{message}");
}
