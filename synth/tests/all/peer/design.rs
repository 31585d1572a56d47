use imogene_synth::peer::Peer;
use std::path::PathBuf;

#[test]
fn what_is_not_there_or_no_verilog_is_refused_before_any_tool_runs() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = |name: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, "").expect("a file");
        path
    };
    let with = |path: PathBuf| Peer {
        files: vec![path],
        top: "top".into(),
        ..Peer::default()
    };
    let refusal = |peer: Peer| peer.check().expect_err("refused").to_string();
    assert!(refusal(with(folder.path().join("no.v"))).contains("no such file"));
    assert!(refusal(with(file("a.vhd"))).contains(".sv"));
    assert!(refusal(with(file("a b.v"))).contains("`a b.v`"));
    let legal = with(file("a.sv"));
    legal.check().expect("a legal peer");
    let mut bad = legal.clone();
    bad.include = vec![folder.path().join("headers")];
    assert!(refusal(bad).contains("no such folder"));
    let mut bad = legal.clone();
    bad.top = "a; shell".into();
    assert!(refusal(bad).contains("`a; shell`"));
    let mut bad = legal;
    bad.parameters = vec![("W".into(), "8; exec".into())];
    assert!(refusal(bad).contains("`8; exec`"));
}
