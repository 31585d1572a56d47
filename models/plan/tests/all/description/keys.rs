use imogene_plan::description::MachineDescription;
use imogene_plan::description::keys::keys;

/// The reader names all its keys where it refuses one that it does not know.
#[test]
fn all_keys_of_the_reader_are_here() {
    let refused = MachineDescription::parse("unknown = 1\n", "m.toml").unwrap_err();
    let said = refused.to_string();
    let (_, list) = said.split_once("expected one of ").unwrap();
    let read: Vec<&str> = list.split(", ").map(|key| key.trim_matches('`')).collect();
    assert_eq!(read, keys().map(|(key, _)| key));
}
