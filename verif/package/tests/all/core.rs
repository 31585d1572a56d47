//! The committed cores, and benches that find a wrong vector. Needs the package 'iverilog'. FuseSoC runs every core
//! with `IMOGENE_FULL=1`.

use imogene_contract::Unit;
use imogene_package::core::{File, core, package};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn write(folder: &Path, files: &[File]) {
    for (name, text) in files {
        let path = folder.join(name);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("a new folder");
        std::fs::write(path, text).expect("a new file");
    }
}

fn files_below(folder: &Path, found: &mut BTreeSet<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files_below(&path, found);
        } else {
            found.insert(path);
        }
    }
}

/// The units whose text a reader looks at; `imogene package` makes all others.
const READ: [Unit; 8] = [
    Unit::Pe1,
    Unit::Pe2,
    Unit::SquareRoot,
    Unit::QuadricPe,
    Unit::CutPlane,
    Unit::QuadricProcessor,
    Unit::Decider,
    Unit::Beam,
];

#[test]
fn committed_cores_are_those_of_this_source() {
    let folder = Path::new(ROOT).join("ip");
    let mut left = BTreeSet::new();
    files_below(&folder, &mut left);
    for (name, text) in package(&READ, 0).expect("every unit is packaged") {
        let path = folder.join(&name);
        let committed = std::fs::read_to_string(&path).unwrap_or_default();
        let is_fresh = committed == text;
        let remedy = "run the command in ip/README.md";
        assert!(is_fresh, "ip/{name} is stale; {remedy}");
        left.remove(&path);
    }
    assert!(left.is_empty(), "nothing makes {left:?}; remove them");
}

fn run(program: &str, arguments: &[&str], folder: &Path) -> Output {
    Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap_or_else(|error| panic!("{program}: {error}; scripts/setup installs it"))
}

/// Compiles and runs a bench as its FuseSoC target does.
fn simulate(files: &[File]) -> Output {
    let folder = tempfile::tempdir().expect("a scratch folder");
    write(folder.path(), files);
    let mut arguments = vec!["-g2005", "-sbench", "-o", "bench/bench.vvp"];
    let names = files.iter().map(|(name, _)| name.as_str());
    arguments.extend(names.filter(|name| name.ends_with(".v")));
    let compiled = run("iverilog", &arguments, folder.path());
    assert!(compiled.status.success(), "{compiled:?}");
    run("vvp", &["-n", "bench.vvp"], &folder.path().join("bench"))
}

#[test]
fn benches_of_the_machine_pass() {
    for unit in [Unit::CutPlane, Unit::CoefficientStore, Unit::Beam] {
        let files = core(unit, 300).expect("a core");
        let done = simulate(&files);
        let text = String::from_utf8_lossy(&done.stdout);
        let passes = done.status.success() && text.contains("DONE 0");
        assert!(passes, "{}: {text}", unit.name());
        // The mask is not empty: at least half of the clocks state every bit of some output.
        let mask = text_of(&files, "bench/mask.hex");
        let stated = mask.lines().filter(|line| line.ends_with('f')).count();
        assert!(stated >= 150, "{}: {stated} clocks", unit.name());
    }
}

fn text_of<'a>(files: &'a [File], name: &str) -> &'a str {
    let found = files.iter().find(|(own, _)| own == name);
    &found.expect("a vector file").1
}

/// Turns over the lowest bit of an expected value that is compared.
fn spoil(files: &mut [File]) {
    let [mask, expected] = ["mask", "expected"].map(|n| text_of(files, &format!("bench/{n}.hex")));
    let (mut lines, mut todo) = (Vec::new(), true);
    for (line, mask) in expected.lines().zip(mask.lines()) {
        let mut line = line.to_owned();
        if todo && mask.ends_with('f') {
            let last = line.pop().and_then(|c| c.to_digit(16)).expect("a digit");
            line.push(char::from_digit(last ^ 1, 16).expect("a digit"));
            todo = false;
        }
        lines.push(line + "\n");
    }
    assert!(!todo, "nothing is compared");
    let wrong = lines.concat();
    let expected = files.iter_mut().find(|(n, _)| n == "bench/expected.hex");
    expected.expect("a vector file").1 = wrong;
}

#[test]
fn a_wrong_vector_fails_the_bench() {
    for unit in [Unit::CutPlane, Unit::SquareRoot, Unit::Beam] {
        let mut files = core(unit, 300).expect("a core");
        spoil(&mut files);
        let done = simulate(&files);
        let text = String::from_utf8_lossy(&done.stdout);
        assert_eq!(done.status.code(), Some(1), "{}: {text}", unit.name());
        assert!(text.contains("DONE 1"), "{}: {text}", unit.name());
    }
}

fn fusesoc(folder: &Path, target: &str, unit: Unit) -> Output {
    let program = Path::new(ROOT).join("target/tools/bin/fusesoc");
    let target = format!("--target={target}");
    let name = format!("imogene:ip:{}", unit.name());
    let arguments = ["--cores-root", "cores", "run", &target, &name];
    run(&program.to_string_lossy(), &arguments, folder)
}

fn is_full() -> bool {
    std::env::var_os("IMOGENE_FULL").is_some_and(|value| value == "1")
}

#[test]
fn fusesoc_runs_every_core() {
    if !is_full() {
        return;
    }
    let folder = tempfile::tempdir().expect("a scratch folder");
    let files = package(&Unit::ALL, 500).expect("every unit");
    write(&folder.path().join("cores"), &files);
    for unit in Unit::ALL {
        for target in ["lint", "sim"] {
            let done = fusesoc(folder.path(), target, unit);
            assert!(done.status.success(), "{target} {}: {done:?}", unit.name());
        }
    }
    let done = fusesoc(folder.path(), "synth", Unit::Pe1);
    assert!(done.status.success(), "synth: {done:?}");
}

#[test]
fn fusesoc_reports_a_wrong_vector_and_a_lint_warning() {
    if !is_full() {
        return;
    }
    let folder = tempfile::tempdir().expect("a scratch folder");
    let mut files = core(Unit::CutPlane, 300).expect("a core");
    spoil(&mut files);
    for (name, text) in &mut files {
        if name == "rtl/cut_plane.v" {
            *text = text.replace("endmodule", "  wire [3:0] spare = 5'd17;\nendmodule");
        }
    }
    write(&folder.path().join("cores"), &files);
    for (target, reason) in [("lint", "%Warning-WIDTH"), ("sim", "DONE 1")] {
        let done = fusesoc(folder.path(), target, Unit::CutPlane);
        let text = [done.stdout, done.stderr].concat();
        let text = String::from_utf8_lossy(&text);
        let is_found = !done.status.success() && text.contains(reason);
        assert!(is_found, "{target}: {text}");
    }
}
