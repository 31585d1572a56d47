use imogene_tools::{Kept, digest};

#[test]
fn a_digest_tells_parts_apart() {
    assert_ne!(digest(["ab", "c"]), digest(["a", "bc"]));
    assert_eq!(digest(["ab", "c"]), digest(["ab", "c"]));
}

#[test]
fn what_is_kept_is_found_by_all_that_it_depends_on() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let place = |text: &str| Kept::new(Some(folder.path().join("cache")), &["1", text]);
    assert_eq!(place("a").load::<u64>(), None);
    for value in [5u64, 6] {
        place("a").store(&value).expect("a file");
        assert_eq!(place("a").load(), Some(value));
    }
    assert_eq!(place("b").load::<u64>(), None);
}
