//! The boards, and their clocks against the tools' own: those under `IMOGENE_FULL=1` alone, with the tools of
//! `scripts/setup --synth --boards`.

use imogene_board::{Board, BoardError, Pll, is_crowded, unplaced};
use imogene_synth::tools::{NEXTPNR_ECP5, NEXTPNR_GOWIN, NEXTPNR_ICE40, Tool};
use std::process::Command;

const VGA: u64 = 25_175_000;

#[test]
fn every_board_has_a_clock_near_to_that_of_its_first_mode() {
    for name in Board::names() {
        let board = Board::named(name).expect("a board");
        assert_eq!(board.name, name);
        let pll = Pll::of(&board, VGA).expect("a clock");
        let deviation = pll.deviation_percent();
        assert!(deviation.abs() < 0.6, "{name}: {deviation}");
        let pins = board.video.pins();
        let mut sites: Vec<&str> = pins.iter().map(|(_, site)| *site).collect();
        sites.push(&board.clock.pin);
        sites.sort_unstable();
        let count = sites.len();
        sites.dedup();
        let are_distinct = board.part.is_none() || sites.len() == count;
        assert!(are_distinct, "{name}: a pin twice");
    }
}

#[test]
fn a_cell_without_a_place_is_told_by_its_kind_and_a_part_that_is_full_from_it() {
    let said = "ERROR: Unable to find legal placement for cell 'core.words_0.59' of type 'RAM16SDP4' after 19901741 \
        attempts, check constraints and utilisation.";
    assert_eq!(unplaced(said), Some("RAM16SDP4"));
    assert_eq!(unplaced("ERROR: cell type 'X' is unsupported"), None);
    let full = "ERROR: Unable to find legal placement for all cells, design is probably at utilisation limit.";
    assert_eq!([said, full].map(is_crowded), [false, true]);
    assert_eq!(unplaced(full), None);
}

#[test]
fn a_description_that_is_none_is_refused_by_place_or_key() {
    let text = include_str!("../../../../boards/hx8k-evb.toml");
    let refused = |old: &str, new: &str| {
        let error = Board::parse(&text.replace(old, new), "mine").expect_err(new);
        error.to_string()
    };
    assert!(refused("[clock]", "[clok]").starts_with("boards/mine.toml:"));
    assert!(refused("100_000_000", "0").contains("clock.hertz is 0; accepted: 1 to"));
    assert!(refused("\"ice40\"", "\"ice41\"").contains("ice41"));
    assert!(refused("[\"E3\", \"H5\", \"F3\"]", "[\"E3\"]").contains("as many for each"));
    let basys3 = include_str!("../../../../boards/basys3.toml");
    let error = Board::parse(&basys3.replace("DSP48", "DSP"), "mine").expect_err("no such kind");
    let said = "part.cells is DSP; accepted: LUT, FF, RAMB36, DSP48";
    assert!(error.to_string().contains(said), "{error}");
    let unpaired = |text: &str, old: &str, new: &str| {
        let error = Board::parse(&text.replace(old, new), "mine").expect_err(new);
        let wanted = "both pins of a channel of a Gowin, one of others";
        assert!(error.to_string().contains(wanted), "{error}");
    };
    let nano = include_str!("../../../../boards/tang-nano-9k.toml");
    unpaired(nano, "\"71,70\"", "\"71\"");
    unpaired(nano, "\"69,68\"", "\"69,\"");
    let ulx3s = include_str!("../../../../boards/ulx3s-85.toml");
    unpaired(ulx3s, "\"A14\"", "\"A14,C14\"");
    let unknown = Board::named("de10").expect_err("no such board");
    assert!(matches!(unknown, BoardError::Unknown(..)));
}

#[test]
fn a_clock_out_of_reach_is_refused() {
    let board = Board::named("ulx3s-85").expect("a board");
    let error = Pll::of(&board, 148_500_000).expect_err("742.5 MHz for the pairs");
    assert!(error.to_string().contains("148500000"), "{error}");
}

/// What a program prints behind a label.
fn said(program: &std::path::Path, arguments: &[&str], label: &str) -> String {
    let mut command = Command::new(program);
    let command = command.args(arguments).current_dir(std::env::temp_dir());
    let output = command.output().expect("the program runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let line = text.lines().find_map(|line| line.split_once(label));
    let (_, rest) = line.unwrap_or_else(|| panic!("{label}: {text}"));
    let word = rest.split_whitespace().next();
    word.unwrap_or_default().to_owned()
}

#[test]
fn clocks_are_those_of_the_tools_or_nearer() {
    if std::env::var_os("IMOGENE_FULL").is_none_or(|value| value != "1") {
        return;
    }
    let icepll = Tool::beside(NEXTPNR_ICE40, "icepll").expect("icepll");
    let arguments = ["-i", "100", "-o", "25.175"];
    let pll = Pll::of(&Board::named("hx8k-evb").expect("a board"), VGA).expect("a clock");
    let labels = ["DIVR:", "DIVF:", "DIVQ:", "FILTER_RANGE:"];
    let found = labels.map(|label| said(&icepll.path, &arguments, label));
    let own = ["divr", "divf", "divq", "filter"].map(|name| pll.dividers[name].to_string());
    assert_eq!(found, own);

    let ecppll = Tool::beside(NEXTPNR_ECP5, "ecppll").expect("ecppll");
    let pll = Pll::of(&Board::named("ulx3s-85").expect("a board"), VGA).expect("a clock");
    let arguments = ["-i", "25", "-o", "125.875"];
    let found = said(&ecppll.path, &arguments, "clkout0 frequency:");
    let (own, found): (f64, f64) = (pll.fast_mhz(), found.parse().expect("MHz"));
    let from_mode = |mhz: f64| (mhz - 125.875).abs();
    assert!(from_mode(own) <= from_mode(found), "{own} and {found}");

    let gowin_pll = Tool::beside(NEXTPNR_GOWIN, "gowin_pll").expect("gowin_pll");
    for (name, part) in [
        ("tang-nano-9k", "GW1NR-9 C6/I5"),
        ("tang-nano-20k", "GW2AR-18 C8/I7"),
    ] {
        let pll = Pll::of(&Board::named(name).expect("a board"), VGA).expect("a clock");
        let arguments = ["-i", "27", "-o", "125.875", "-d", part];
        let labels = [".IDIV_SEL(", ".FBDIV_SEL("];
        let found = labels.map(|label| said(&gowin_pll.path, &arguments, label));
        let own = ["input", "feedback"].map(|name| format!("{}),", pll.dividers[name]));
        assert_eq!(found, own);
    }
}
