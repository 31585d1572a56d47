use imogene_files::memory::{field, free_memory};

#[test]
fn fields_are_found_and_words_are_no_numbers() {
    let text =
        "VmPeak:\t 9 kB\nVmSize:\t  1234 kB\nMax address space   unlimited  unlimited  bytes\n";
    assert_eq!(field(text, "VmSize:"), Some(1234));
    assert_eq!(field(text, "Max address space"), None);
    assert_eq!(field(text, "Anon"), None);
}

#[test]
fn this_machine_has_some_memory() {
    assert!(free_memory().is_none_or(|bytes| bytes > 1 << 20));
}
