use imogene_rtl::emit::Port;
use imogene_synth::peer::source::{modules, ports_and_clock};
use imogene_synth::peer::{Peer, PeerError};

fn peer(clock: Option<&str>) -> Peer {
    Peer {
        top: "top".into(),
        clock: clock.map(str::to_owned),
        ..Peer::default()
    }
}

fn netlist(ports: &str) -> String {
    format!("{{\"modules\": {{\"top\": {{\"ports\": {{{ports}}}}}}}}}")
}

const CLOCK: &str = "\"clk\": {\"direction\": \"input\", \"bits\": [2]}";
const IN: &str = "\"a\": {\"direction\": \"input\", \"bits\": [3, 4]}";
const OUT: &str = "\"s\": {\"direction\": \"output\", \"bits\": [5], \"signed\": 1}";

fn read(clock: Option<&str>, ports: &[&str]) -> Result<(Vec<Port>, String), PeerError> {
    ports_and_clock(&peer(clock), &netlist(&ports.join(", ")))
}

#[test]
fn ports_are_read_and_the_clock_is_found() {
    let (ports, clock) = read(None, &[OUT, IN, CLOCK]).expect("a clocked module");
    assert_eq!(clock, "clk");
    let ports = ports.iter();
    let ports = ports.map(|port| (port.name.as_str(), port.width, port.signed));
    let ports: Vec<(&str, usize, bool)> = ports.collect();
    // In the order of their bits.
    assert_eq!(ports, [("clk", 1, false), ("a", 2, false), ("s", 1, true)]);
}

#[test]
fn a_clock_that_is_not_there_is_answered_with_the_ports() {
    for (clock, ports) in [
        (None, vec![IN, OUT]),
        (Some("a"), vec![CLOCK, IN, OUT]),
        (Some("s"), vec![CLOCK, IN, OUT]),
        (Some("ck"), vec![CLOCK, IN, OUT]),
    ] {
        let message = read(clock, &ports).expect_err("no clock").to_string();
        let wanted = clock.unwrap_or("`clk` or `clock`");
        for part in [wanted, "input a (2 bits)", "output s"] {
            assert!(message.contains(part), "{message}");
        }
    }
}

#[test]
fn a_module_without_data_or_with_an_inout_is_refused() {
    let message = |ports: &[&str]| read(None, ports).expect_err("refused").to_string();
    assert!(message(&[CLOCK, IN]).contains("no output"));
    assert!(message(&[CLOCK, OUT]).contains("no input"));
    let inout = "\"pad\": {\"direction\": \"inout\", \"bits\": [9]}";
    assert!(message(&[CLOCK, IN, OUT, inout]).contains("`pad`"));
}

#[test]
fn modules_are_read_from_their_list() {
    let listed = "\n2 modules:\n  add\n  other\n";
    assert_eq!(modules(listed), ["add", "other"]);
    assert!(modules("").is_empty());
}
