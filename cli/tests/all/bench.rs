//! A bench of a user's own: what `imogene machine --emit-only` writes, in Icarus Verilog, without any other program
//! of ours.
//!
//! Needs the package 'iverilog' and fails without it.

use crate::common::Place;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

const BEAM: &str = "machine = \"beam\"\nobjects = 2\n";
const ZONE: &str = "machine = \"zone\"\nobjects = 2\nzone = { width = 20, height = 8 }\n";
const COMMON: &str = "planes = 3\nlights = 2\nrows_per_stage = 6\nmode = { columns = [32, 4, 4, 4], lines = [12, 2, 2, 20] }\n";
const STREAM: &str = "output = \"stream\"\n";

/// The same without a processor of light, which takes long in an interpreter.
fn plain() -> String {
    COMMON.replace("lights = 2", "lights = 0")
}

/// The files of a machine for two scenes, one after the other, and their description, in a folder.
fn emitted(place: &Place, description: &str, options: &str) -> (PathBuf, Value) {
    place.write("machine.toml", description);
    let scenes = "scenes/crossing-cylinders.toml scenes/cut-sphere.toml";
    let options = format!("--machine machine.toml --emit-only --out out {options}");
    let summary = place.json(&format!("machine {scenes} {options}"));
    let written = summary["files"].as_array().expect("files");
    let names = "beats.hex shading.hex pixels.hex bench.json bench.v golden.png";
    for name in names.split(' ').map(|name| format!("out/{name}")) {
        let is_told = written.iter().any(|file| *file == *name);
        assert!(is_told && place.has(&name), "{name}");
    }
    let described = serde_json::from_str(&place.text("out/bench.json"));
    (place.path("out"), described.expect("JSON"))
}

/// What a program of the package says in a folder, and whether it ended well.
fn icarus(folder: &Path, line: &str) -> (bool, String) {
    let mut words = line.split(' ');
    let mut command = Command::new(words.next().expect("a program"));
    let output = command.args(words).current_dir(folder).output();
    let output = output.expect("the package 'iverilog' is installed");
    let said = [output.stdout, output.stderr].concat();
    let said = String::from_utf8_lossy(&said).into_owned();
    (output.status.success(), said)
}

/// Compiles and runs a bench beside a description, which ends well or not, and says these parts.
fn run(folder: &Path, bench: &str, ends_well: bool, parts: &[&str]) {
    let described = std::fs::read(folder.join("bench.json")).expect("a file");
    let described: Value = serde_json::from_slice(&described).expect("JSON");
    let verilog = described["verilog"].as_str().expect("a name");
    let compile = format!("iverilog -g2005 -s bench -o bench.vvp {bench} {verilog}");
    let (is_compiled, said) = icarus(folder, &compile);
    assert!(is_compiled, "{said}");
    let (ended_well, said) = icarus(folder, "vvp -n bench.vvp");
    assert_eq!(ended_well, ends_well, "{said}");
    for part in parts {
        assert!(said.contains(part), "no '{part}' in: {said}");
    }
}

/// Lines of words, without comments.
fn words(path: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(path).expect("a file");
    let lines = text.lines().filter(|line| !line.starts_with("//"));
    lines.map(str::to_owned).collect()
}

#[test]
fn the_bench_that_is_written_finds_every_pixel() {
    // Words of f2 that are no whole number of hexadecimal digits long.
    let odd = "depth_word = 17\nwidths = { g1 = 10, g2 = 3 }\n";
    for description in [
        format!("{BEAM}{}overlay = true\n", plain()),
        format!("{ZONE}{}smoothing = \"3x3\"\n", plain()),
        format!("{BEAM}{COMMON}{STREAM}"),
        format!("{ZONE}{COMMON}{STREAM}"),
        format!("{ZONE}{COMMON}{STREAM}{odd}"),
    ] {
        let place = Place::new();
        place.write_mask("mask.png", 32, 12);
        let options = match description.contains("overlay") {
            true => "--overlay mask.png",
            false => "",
        };
        let (out, _) = emitted(&place, &description, options);
        let beats = words(&out.join("beats.hex")).len();
        let wanted = format!("2 frames of 384 pixels, {beats} beats: 0 differences");
        run(&out, "bench.v", true, &[&wanted]);
        assert_eq!(words(&out.join("pixels.hex")).len(), 2 * 384);
    }
}

#[test]
fn the_bench_of_several_pixels_per_clock_finds_every_pixel() {
    let mode = "mode = { columns = [96, 4, 4, 4], lines = [4, 2, 2, 20] }\n";
    let plain = plain();
    let lines = plain.split_inclusive('\n');
    let lines = lines.filter(|line| !line.starts_with("mode"));
    let common: String = lines.chain([mode]).collect();
    // A whole picture for each scene, or two fields.
    let cases = [
        ("pixels_per_clock = 2\n", 1),
        ("pixels_per_clock = 4\ninterlaced = true\n", 2),
        ("modules = 4\n", 1),
    ];
    for (lanes, fields) in cases {
        let place = Place::new();
        let (out, _) = emitted(&place, &format!("{BEAM}{common}{STREAM}{lanes}"), "");
        let frames = format!("{} frames of {} pixels", 2 * fields, 384 / fields);
        run(&out, "bench.v", true, &[&frames, " 0 differences"]);
        if fields == 2 {
            let pixels = words(&out.join("pixels.hex"));
            let wrong = [&pixels[..7], &["12_34_56".to_owned()], &pixels[8..]].concat();
            std::fs::write(out.join("pixels.hex"), wrong.join("\n")).expect("a file");
            run(&out, "bench.v", false, &["frame 0, column 7, line 0"]);
        }
    }
}

/// The numerator of a quotient is longer than every other word, and so is the data of a beat.
#[test]
fn the_bench_of_a_quotient_has_the_data_of_its_machine() {
    let place = Place::new();
    let eye = "scenes/extremes/eye-on-quadric.toml";
    let fit = "--size 32x24 --max-depth-error 2px --no-cost --out fit";
    place.json(&format!("fit {eye} {fit}"));
    let machine = "--machine fit/machine.toml --emit-only --out out";
    place.json(&format!("machine {eye} {machine}"));
    let parts = ["of 768 pixels", " 0 differences"];
    run(&place.path("out"), "bench.v", true, &parts);
}

#[test]
fn the_bench_that_is_written_sees_what_is_wrong() {
    let place = Place::new();
    let (out, _) = emitted(&place, &format!("{ZONE}{}{STREAM}", plain()), "");
    let pixels = words(&out.join("pixels.hex"));
    let mut wrong = pixels.clone();
    wrong[32 * 7 + 5] = "12_34_56".into();
    assert_ne!(wrong, pixels);
    std::fs::write(out.join("pixels.hex"), wrong.join("\n")).expect("a file");
    let place_of_it = "frame 0, column 5, line 7";
    let parts = [place_of_it, "expected 123456", " 1 differences"];
    run(&out, "bench.v", false, &parts);
    // Without its end the second frame never comes.
    std::fs::write(out.join("pixels.hex"), pixels.join("\n")).expect("a file");
    let mut beats = words(&out.join("beats.hex"));
    let last = beats.pop().expect("a beat");
    assert!(last.starts_with("1_4_"), "the last show command: {last}");
    beats.push(last.replacen("1_4_", "0_3_", 1));
    std::fs::write(out.join("beats.hex"), beats.join("\n")).expect("a file");
    run(&out, "bench.v", false, &["1 of 2 frames"]);
}

/// Written by hand from docs/machines.md and bench.json: a host and a receiver that stall. With `BEAM` for the beam
/// machine, without it for the zone machine.
const BY_HAND: &str = r#"
module bench;
    reg [79:0] beats [0:99999];
    reg [23:0] pixels [0:2*384-1];
    reg clock = 0;
    always #1 clock = ~clock;
    reg [31:0] random = 32'h2545f491;
    integer next = 0, offered = 0, taken = 0, wrong = 0, frame = 0, place;
    reg s_tvalid = 0, m_tready = 0, current = 0;
    wire s_tready, m_tvalid, m_tlast, swapped;
    wire [23:0] m_tdata;
    reg [79:0] beat = 0;
`ifdef BEAM
    wire m_tuser;
    beam_stream machine (.clock(clock), .s_tvalid(s_tvalid), .s_tready(s_tready), .s_tdest(beat[75:72]), .s_tuser(beat[71:48]),
        .s_tdata(beat[47:0]), .s_tlast(beat[76]), .m_tvalid(m_tvalid), .m_tready(m_tready), .m_tdata(m_tdata), .m_tuser(m_tuser),
        .m_tlast(m_tlast), .swapped(swapped), .refused());
`else
    wire [23:0] m_tuser;
    zone_machine machine (.clock(clock), .s_tvalid(s_tvalid), .s_tready(s_tready), .s_tdest(beat[75:72]), .s_tuser(beat[71:48]),
        .s_tdata(beat[47:0]), .m_tvalid(m_tvalid), .m_tready(m_tready), .m_tdata(m_tdata), .m_tuser(m_tuser), .m_tlast(m_tlast));
    assign swapped = 0;
`endif
    initial begin
        $readmemh("beats.hex", beats);
        $readmemh("pixels.hex", pixels);
    end
    always @(negedge clock) begin
        random = {random[30:0], random[31] ^ random[21] ^ random[1] ^ random[0]};
        m_tready <= random[3:0] < 11;
        if (!s_tvalid && random[7:4] < 11 && ^beats[next] !== 1'bx) begin
            beat <= beats[next];
            s_tvalid <= 1;
        end
    end
    always @(posedge clock) begin
        if (s_tvalid && s_tready) begin
            next = next + 1;
            s_tvalid <= 0;
        end
`ifdef BEAM
        if (swapped) current = 1;
        if (m_tvalid && m_tready && (taken > 0 || (current && m_tuser))) begin
            place = taken;
            if (m_tlast !== (place % 32 == 31)) wrong = wrong + 1;
`else
        if (m_tvalid && m_tready) begin
            place = m_tuser[23:12] * 32 + m_tuser[11:0];
            if (m_tlast !== (taken == 383)) wrong = wrong + 1;
`endif
            if (m_tdata !== pixels[frame * 384 + place]) wrong = wrong + 1;
            taken = taken + 1;
            if (taken == 384) begin
                $display("frame %0d: %0d wrong", frame, wrong);
                taken = 0;
                frame = frame + 1;
                if (frame == FRAMES) $finish;
            end
        end
    end
    initial #2000000 $fatal(1, "too late");
endmodule
"#;

#[test]
fn a_bench_written_by_hand_from_the_documents_finds_every_pixel() {
    // The hand-written beam bench stops after the first frame: it does not wait for its pixels before it sends the
    // next.
    for (machine, frames, define) in [(ZONE, 2, ""), (BEAM, 1, "`define BEAM\n")] {
        let place = Place::new();
        let (out, _) = emitted(&place, &format!("{machine}{COMMON}{STREAM}"), "");
        let text = BY_HAND.replace("FRAMES", &frames.to_string());
        std::fs::write(out.join("by_hand.v"), define.to_owned() + &text).expect("a file");
        let last = format!("frame {}: 0 wrong", frames - 1);
        run(&out, "by_hand.v", true, &[&last]);
    }
}

#[test]
fn the_words_are_where_the_description_says() {
    let place = Place::new();
    let (out, described) = emitted(&place, &format!("{BEAM}{COMMON}"), "");
    let mut shading_of_beats = vec![];
    for described in described["words"].as_array().expect("files") {
        let path = out.join(described["file"].as_str().expect("a name"));
        let words = words(&path);
        assert_eq!(described["count"], words.len());
        let fields = described["fields"].as_array().expect("fields");
        let digits = |field: &Value| field["digits"].as_u64().expect("digits") as usize;
        let digits: Vec<usize> = fields.iter().map(digits).collect();
        for word in &words {
            let parts: Vec<&str> = word.split('_').collect();
            let lengths: Vec<usize> = parts.iter().map(|part| part.len()).collect();
            assert_eq!(lengths, digits, "{word}");
            if path.ends_with("beats.hex") && parts[1] == "2" {
                let data = u64::from_str_radix(parts[4], 16).expect("hexadecimal");
                shading_of_beats.push(format!("{}_{data:08x}", parts[3]));
            }
        }
    }
    assert_eq!(shading_of_beats, words(&out.join("shading.hex")));
    let frames = described["frames"].as_array().expect("frames");
    let beats = words(&out.join("beats.hex"));
    for frame in frames {
        let at = |key: &str| frame["beats.hex"][key].as_u64().expect("a number") as usize;
        let of_frame = &beats[at("first_word")..][..at("words")];
        let ends = of_frame.iter().filter(|beat| beat.starts_with('1')).count();
        assert!(ends == 1 && of_frame.last().is_some_and(|beat| beat.starts_with('1')));
    }
    assert_eq!(frames.len(), 2);
}
