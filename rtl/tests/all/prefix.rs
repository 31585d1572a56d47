//! Two configurations of one unit in a single design: their modules under different prefixes.

use crate::support::{Random, directory, run};
use imogene_contract::{Request, Unit};
use imogene_rtl::emit::{Emitted, emit, emit_with_prefix};

fn root(depth_word: usize, prefix: &str) -> Emitted {
    let request = Request::of(Unit::SquareRoot, depth_word as u32);
    emit_with_prefix(&request, prefix).unwrap()
}

/// A bench that feeds both networks the same radicands and prints both roots of each.
fn bench(radicands: &[u64]) -> String {
    let mut text = String::from(
        "module bench;\n  reg clock = 0;\n  reg [47:0] radicand;\n  wire [15:0] narrow;\n  wire [23:0] wide;\n\
         \n  narrow_square_root a (.clock(clock), .radicand(radicand[31:0]), .root(narrow), .remainder());\n\
         \n  wide_square_root b (.clock(clock), .radicand(radicand), .root(wide), .remainder());\n\
         \n  initial begin\n",
    );
    let clocks = "repeat (24) begin #1 clock = 1; #1 clock = 0; end";
    for radicand in radicands {
        text += &format!("    radicand = 48'd{radicand}; {clocks}\n");
        text += "    $display(\"%0d %0d\", narrow, wide);\n";
    }
    text + "  end\nendmodule\n"
}

#[test]
fn two_widths_of_one_unit_work_in_one_design() {
    let mut random = Random(11);
    let mut radicands: Vec<u64> = (0..60).map(|_| random.next() >> 17).collect();
    radicands.extend([0, 1, 0xffff_ffff, (1 << 47) - 1]);
    let folder = directory("two-prefixes");
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    std::fs::write(path("narrow.v"), root(16, "narrow_").bundle()).unwrap();
    std::fs::write(path("wide.v"), root(24, "wide_").bundle()).unwrap();
    std::fs::write(path("bench.v"), bench(&radicands)).unwrap();
    let files = ["narrow.v", "wide.v", "bench.v"].map(path);
    let mut arguments = vec!["-g2005", "-s", "bench", "-o"];
    let binary = path("bench.vvp");
    arguments.push(&binary);
    arguments.extend(files.iter().map(String::as_str));
    let built = run("iverilog", "iverilog", &arguments);
    let said = String::from_utf8_lossy(&built.stderr);
    assert!(built.status.success(), "{said}");
    let said = run("vvp", "iverilog", &["-n", &binary]).stdout;
    let roots = |r: &u64| format!("{} {}", (r & 0xffff_ffff).isqrt(), r.isqrt());
    let expected: Vec<String> = radicands.iter().map(roots).collect();
    let said = String::from_utf8(said).unwrap();
    assert_eq!(said.lines().collect::<Vec<_>>(), expected);
    // Without prefixes the same two texts do not go together.
    std::fs::write(path("narrow.v"), root(16, "wide_").bundle()).unwrap();
    assert!(!run("iverilog", "iverilog", &arguments).status.success());
}

#[test]
fn a_prefix_changes_the_names_of_modules_and_nothing_else() {
    for unit in Unit::ALL {
        let request = Request::new(unit);
        let plain = emit(&request).unwrap();
        let named = emit_with_prefix(&request, "mine_").unwrap();
        assert_eq!(named.top, format!("mine_{}", unit.name()));
        assert_eq!((&named.ports, named.latency), (&plain.ports, plain.latency));
        assert!(named.header.contains(" --prefix mine_ --out DIR"));
        for (file, text) in named.files() {
            assert!(file.starts_with("mine_") && text.starts_with("// mine_"));
        }
        let without = |text: &str| text.replace("mine_", "").replace(" --prefix ", "");
        assert_eq!(without(&named.bundle()), plain.bundle());
        for ((long, _), (short, _)) in named.modules.iter().zip(&plain.modules) {
            assert_eq!(long, &format!("mine_{short}"));
        }
    }
}

#[test]
fn a_prefix_that_begins_no_identifier_is_refused() {
    for prefix in ["", "1st_", "_a", "a-b", "a__b", "a b", "a$", "\u{e4}_"] {
        let refused = emit_with_prefix(&Request::new(Unit::Pe1), prefix).unwrap_err();
        let message = refused.to_string();
        for part in [&format!("`{prefix}`"), "begin with a letter"] {
            assert!(message.contains(part), "{message}");
        }
    }
}
