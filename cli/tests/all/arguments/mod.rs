mod frames;

use imogene::arguments::bytes;

#[test]
fn sizes_have_units() {
    assert_eq!(bytes("3"), Ok(3));
    assert_eq!(bytes("2k"), Ok(2048));
    assert_eq!(bytes("512M"), Ok(512 << 20));
    assert_eq!(bytes("2G"), Ok(2 << 30));
    let wrong = "G 0 0M -1 1.5G 2T 2GB 99999999999G é";
    for text in wrong.split(' ').chain([""]) {
        assert!(bytes(text).is_err(), "{text}");
    }
}
