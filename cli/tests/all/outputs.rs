//! Outputs destroy nothing: devices, pipes, links, modes, inputs, sets of files, standard output, interruptions,
//! limits.
//!
//! Every path that is written to lies in a folder of the test's own.

use crate::common::{imogene, scene};
use std::fs::{self, File};
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

const SIZE: [&str; 2] = ["--size", "48x36"];

/// A folder with a scene of its own in it.
struct Place {
    folder: TempDir,
}

impl Place {
    fn new() -> Place {
        let folder = tempfile::tempdir().unwrap();
        fs::copy(scene("cut-sphere.toml"), folder.path().join("c.toml")).unwrap();
        Place { folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn run(&self, arguments: &[&str]) -> Output {
        let mut command = imogene();
        command.current_dir(self.folder.path()).args(arguments);
        command.output().unwrap()
    }

    fn render(&self, arguments: &[&str]) -> Output {
        let mut all = vec!["render", "c.toml"];
        all.extend(SIZE);
        all.extend(arguments);
        self.run(&all)
    }

    /// The picture of the scene, by another file of its own.
    fn picture(&self) -> Vec<u8> {
        let other = Place::new();
        accepted(&other.render(&["-o", "x.png"]));
        fs::read(other.path("x.png")).unwrap()
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder.path()).unwrap();
        let mut names: Vec<String> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }
}

fn accepted(output: &Output) {
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{message}");
}

/// The message of a refusal, which is never long.
fn refused(output: &Output) -> String {
    let message = String::from_utf8(output.stderr.clone()).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.starts_with("error: "), "{message}");
    assert!(message.len() < 2_048, "{} bytes", message.len());
    message
}

fn assert_says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "no '{part}' in: {message}");
    }
}

fn make_pipe(path: &Path) {
    let made = Command::new("mkfifo").arg(path).status().unwrap();
    assert!(made.success());
}

#[test]
fn a_pipe_is_written_through_and_stays() {
    let place = Place::new();
    make_pipe(&place.path("pipe"));
    let pipe = place.path("pipe");
    let reader = std::thread::spawn(move || fs::read(pipe).unwrap());
    accepted(&place.render(&["-o", "pipe"]));
    assert_eq!(reader.join().unwrap(), place.picture());
    let kind = fs::metadata(place.path("pipe")).unwrap().file_type();
    assert!(kind.is_fifo());
}

#[test]
fn a_link_stays_and_its_target_is_replaced_and_keeps_its_mode() {
    let place = Place::new();
    fs::create_dir(place.path("deep")).unwrap();
    fs::write(place.path("deep/target.png"), "old").unwrap();
    let mode = fs::Permissions::from_mode(0o640);
    fs::set_permissions(place.path("deep/target.png"), mode).unwrap();
    symlink("deep/target.png", place.path("second")).unwrap();
    symlink("second", place.path("first")).unwrap();
    accepted(&place.render(&["-o", "first"]));
    assert_eq!(
        fs::read_link(place.path("first")).unwrap(),
        Path::new("second")
    );
    let target = place.path("deep/target.png");
    assert_eq!(fs::read(&target).unwrap(), place.picture());
    let mode = fs::symlink_metadata(&target).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o640);
}

#[test]
fn a_link_to_nothing_makes_its_target_and_a_circle_is_refused() {
    let place = Place::new();
    symlink("new.png", place.path("link")).unwrap();
    accepted(&place.render(&["-o", "link"]));
    assert_eq!(fs::read(place.path("new.png")).unwrap(), place.picture());
    symlink("circle", place.path("circle")).unwrap();
    assert_says(
        &refused(&place.render(&["-o", "circle"])),
        &["circle", "links"],
    );
}

#[test]
fn new_files_have_the_mode_of_the_mask() {
    let place = Place::new();
    let program = assert_cmd::cargo::cargo_bin("imogene");
    for (mask, mode) in [("022", 0o644), ("077", 0o600), ("002", 0o664)] {
        let script = format!("umask {mask}; \"$0\" render c.toml --size 48x36 -o new-{mask}.png");
        let mut shell = Command::new("sh");
        shell.arg("-c").arg(script).arg(&program);
        accepted(&shell.current_dir(place.folder.path()).output().unwrap());
        let facts = fs::metadata(place.path(&format!("new-{mask}.png"))).unwrap();
        assert_eq!(facts.permissions().mode() & 0o777, mode, "umask {mask}");
    }
}

#[test]
fn standard_output_takes_the_file_and_reports_go_to_standard_error() {
    let place = Place::new();
    for name in ["-", "/dev/stdout"] {
        let output = place.render(&["-o", name]);
        accepted(&output);
        assert_eq!(output.stdout, place.picture(), "{name}");
        assert_says(
            &String::from_utf8_lossy(&output.stderr),
            &["48 x 36 pixels"],
        );
    }
    let output = place.run(&["terrain", "--levels", "2", "-o", "-"]);
    accepted(&output);
    accepted(&place.run(&["terrain", "--levels", "2", "-o", "f.heights"]));
    assert_eq!(output.stdout, fs::read(place.path("f.heights")).unwrap());
    assert_eq!(place.names(), ["c.toml", "f.heights"]);
}

#[test]
fn standard_output_takes_one_file_and_no_document_beside_it() {
    let place = Place::new();
    for (arguments, said) in [
        (
            &["render", "c.toml", "-o", "-", "--depth", "-"][..],
            "--output - is the same file",
        ),
        (&["render", "c.toml", "-o", "-", "--json"], "--json"),
        (&["cosim", "c.toml", "--vcd", "-"], "several files"),
        (&["emit", "beam", "--out", "-"], "several files"),
    ] {
        assert_says(&refused(&place.run(arguments)), &[said]);
    }
    assert_eq!(place.names(), ["c.toml"]);
}

#[test]
fn an_input_is_never_replaced() {
    let place = Place::new();
    let before = fs::read(place.path("c.toml")).unwrap();
    symlink("c.toml", place.path("link.toml")).unwrap();
    fs::hard_link(place.path("c.toml"), place.path("hard.toml")).unwrap();
    fs::copy(scene("teapot.toml"), place.path("teapot.toml")).unwrap();
    fs::write(place.path("a.pdb"), "ATOM\n").unwrap();
    let absolute = place.path("c.toml").display().to_string();
    for arguments in [
        &["render", "c.toml", "-o", "c.toml"][..],
        &["render", "c.toml", "-o", "./c.toml"],
        &["render", "c.toml", "-o", &absolute],
        &["render", "c.toml", "-o", "link.toml"],
        &["render", "c.toml", "-o", "x.png", "--depth", "hard.toml"],
        &["render", "link.toml", "-o", "x.png", "--ids", "c.toml"],
        &["import", "a.pdb", "-o", "a.pdb"],
        &["trace", "teapot.toml", "c.toml", "--table", "c.toml"],
        &["cracks", "c.toml", "-o", "c.toml"],
        &["repair", "c.toml", "--map", "c.toml"],
        &["cosim", "c.toml", "--vcd", "c.toml"],
    ] {
        let message = refused(&place.run(arguments));
        assert_says(&message, &["which the command reads", "another name"]);
    }
    assert_eq!(fs::read(place.path("c.toml")).unwrap(), before);
    assert_eq!(fs::read(place.path("a.pdb")).unwrap(), b"ATOM\n");
}

#[test]
fn an_input_in_the_output_folder_is_not_replaced_by_one_of_its_files() {
    let place = Place::new();
    let machine = scene("../machines/beam-160x120.toml");
    // The description lies where the summary of the machine goes.
    fs::create_dir(place.path("out")).unwrap();
    fs::copy(machine, place.path("out/summary.json")).unwrap();
    let before = fs::read(place.path("out/summary.json")).unwrap();
    let output = place.run(&[
        "machine",
        "c.toml",
        "--machine",
        "out/summary.json",
        "--out",
        "out",
        "--emit-only",
    ]);
    assert_says(
        &refused(&output),
        &["summary.json", "read by the same command"],
    );
    assert_eq!(fs::read(place.path("out/summary.json")).unwrap(), before);
    assert_eq!(fs::read_dir(place.path("out")).unwrap().count(), 1);
}

#[test]
fn no_two_outputs_are_one_file() {
    let place = Place::new();
    fs::write(place.path("there.npy"), "old").unwrap();
    symlink("there.npy", place.path("link.npy")).unwrap();
    symlink(".", place.path("here")).unwrap();
    for [one, other] in [
        ["q.npy", "q.npy"],
        ["q.npy", "here/q.npy"],
        ["there.npy", "link.npy"],
        ["new/q.npy", "./new/q.npy"],
    ] {
        let output = place.render(&["-o", "x.png", "--depth", one, "--ids", other]);
        assert_says(&refused(&output), &["--depth", "--ids", "the same file"]);
    }
    assert_says(
        &refused(&place.run(&["cosim", "c.toml", "--vcd", "x.gtkw"])),
        &["--vcd"],
    );
    assert_eq!(fs::read(place.path("there.npy")).unwrap(), b"old");
    assert_eq!(place.names(), ["c.toml", "here", "link.npy", "there.npy"]);
}

#[test]
fn outputs_that_cannot_be_written_are_refused_in_words() {
    let place = Place::new();
    fs::create_dir(place.path("folder")).unwrap();
    for (arguments, said) in [
        (
            &["emit", "beam", "--out", "c.toml"][..],
            "it is a file; a folder is wanted",
        ),
        (
            &["emit", "beam", "--out", "c.toml/below"],
            "'c.toml' is a file",
        ),
        (
            &["render", "c.toml", "-o", "folder"],
            "it is a folder; a file is wanted",
        ),
        (
            &["render", "c.toml", "-o", "new/"],
            "a folder; a file is wanted",
        ),
        (
            &["render", "c.toml", "-o", "c.toml/x.png"],
            "Not a directory",
        ),
    ] {
        assert_says(&refused(&place.run(arguments)), &[said]);
    }
    assert_eq!(place.names(), ["c.toml", "folder"]);
}

#[test]
fn a_set_of_files_appears_whole_or_not_at_all() {
    let place = Place::new();
    fs::write(place.path("x.png"), "old").unwrap();
    make_pipe(&place.path("pipe"));
    // A reader that leaves at once: what is written to the pipe is refused, and nothing else appears.
    let pipe = place.path("pipe");
    let reader = std::thread::spawn(move || drop(File::open(pipe).unwrap()));
    let output = place.run(&[
        "render",
        "c.toml",
        "--size",
        "640x480",
        "-o",
        "x.png",
        "--depth",
        "new/deep/q.npy",
        "--ids",
        "pipe",
    ]);
    reader.join().unwrap();
    assert_eq!(output.status.code(), Some(141), "{:?}", output.stderr);
    assert_eq!(fs::read(place.path("x.png")).unwrap(), b"old");
    assert_eq!(place.names(), ["c.toml", "pipe", "x.png"]);
    accepted(&place.render(&["-o", "x.png", "--depth", "new/deep/q.npy"]));
    assert_eq!(fs::read(place.path("x.png")).unwrap(), place.picture());
    assert!(place.path("new/deep/q.npy").is_file());
}

#[test]
fn a_folder_of_files_appears_whole_or_not_at_all() {
    let place = Place::new();
    // The list of the files comes last, and its name is taken by a folder.
    fs::create_dir_all(place.path("out/pe1.f")).unwrap();
    let output = place.run(&["emit", "pe1", "--split", "--out", "out"]);
    assert_says(&refused(&output), &["pe1.f", "it is a folder"]);
    assert_eq!(fs::read_dir(place.path("out")).unwrap().count(), 1);
    fs::remove_dir(place.path("out/pe1.f")).unwrap();
    accepted(&place.run(&["emit", "pe1", "--split", "--out", "out"]));
    assert!(fs::read_dir(place.path("out")).unwrap().count() > 1);
}

#[test]
fn a_disk_without_room_leaves_no_file() {
    let place = Place::new();
    let program = assert_cmd::cargo::cargo_bin("imogene");
    // The limit of a file's size stands for the end of the disk: 200 blocks hold the picture, not the array.
    let script =
        "trap '' XFSZ; ulimit -f 200; \"$0\" render c.toml --size 320x240 -o x.png --depth q.npy";
    let mut shell = Command::new("sh");
    shell.arg("-c").arg(script).arg(program);
    let output = shell.current_dir(place.folder.path()).output().unwrap();
    assert_says(&refused(&output), &["cannot write 'q.npy'"]);
    assert_eq!(place.names(), ["c.toml"]);
}

fn printed_into(arguments: &[&str], out: Stdio) -> Output {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin("imogene"));
    let child = command.args(arguments).stdout(out).stderr(Stdio::piped());
    child.spawn().unwrap().wait_with_output().unwrap()
}

#[test]
fn lost_standard_output_is_an_error() {
    for arguments in [
        &["units"][..],
        &["units", "--json"],
        &["--help"],
        &["--version"],
    ] {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let message = refused(&printed_into(arguments, full.into()));
        assert_says(&message, &["cannot write standard output"]);
    }
    let program = assert_cmd::cargo::cargo_bin("imogene");
    let mut shell = Command::new("sh");
    let shell = shell.arg("-c").arg("\"$0\" units >&-").arg(program);
    assert_says(
        &refused(&shell.output().unwrap()),
        &["standard output", "closed"],
    );
}

#[test]
fn a_closed_pipe_ends_the_program_quietly() {
    for arguments in [&["units"][..], &["units", "--json"]] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = printed_into(arguments, writer.into());
        assert_eq!(output.status.code(), Some(141));
        assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    }
}

#[test]
fn failures_are_documents_too() {
    let place = Place::new();
    for arguments in [
        &["render", "missing.toml", "-o", "x.png", "--json"][..],
        &["render", "c.toml", "-o", "c.toml", "--json"],
        &[
            "--json", "render", "c.toml", "--format", "nan", "-o", "x.png",
        ],
        &["nonsense", "--json"],
    ] {
        let output = place.run(arguments);
        let message = refused(&output);
        let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(document["error"]["exit_code"], 2);
        let said = document["error"]["message"].as_str().unwrap();
        assert_eq!(message, format!("error: {said}\n"));
    }
    // A report that was printed says of itself that a check failed; no second document follows.
    let output = place.run(&[
        "fit",
        "c.toml",
        "--size",
        "16x12",
        "--max-depth-error",
        "0.0000001",
        "--out",
        "f",
        "--json",
    ]);
    assert_eq!(output.status.code(), Some(1));
    let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(document["error"]["exit_code"], 1);
    assert!(!place.path("f").exists());
}

#[test]
fn usage_is_refused_in_plain_words() {
    let place = Place::new();
    for (arguments, said) in [
        (&["bounds", "--cases", "0"][..], "1 or more"),
        (&["bounds", "--cases", "x"], "a whole number is expected"),
        (
            &["render", "c.toml", "-o", "x", "--format", "nan"],
            "8 to 32",
        ),
        (&["emit", "pe1", "--out", "x", "--format", ""], "8 to 32"),
        (
            &["fit", "c.toml", "--out", "x", "--max-depth-error", "-1"],
            "is no limit of a depth",
        ),
        (
            &["fit", "c.toml", "--out", "x", "--max-colour-error", "-1"],
            "0 or more",
        ),
        (
            &["fit", "c.toml", "--out", "x", "--max-normal-error", "nan"],
            "0 or more",
        ),
        (&["terrain", "--roughness", "-1", "-o", "x"], "-1"),
        (
            &["terrain", "--roughness", "rough", "-o", "x"],
            "a number is expected",
        ),
        (&[], "a command is expected"),
    ] {
        let output = place.run(arguments);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert_says(&message, &[said]);
    }
    assert_eq!(place.names(), ["c.toml"]);
}

#[test]
fn endless_files_are_refused() {
    let place = Place::new();
    for (arguments, said) in [
        (&["render", "/dev/zero", "-o", "x.png"][..], "256 MiB"),
        (
            &["import", "/dev/zero", "--as", "step", "-o", "x.toml"],
            "1 GiB",
        ),
        (
            &["machine", "c.toml", "--machine", "/dev/zero", "--out", "x"],
            "1 MiB",
        ),
    ] {
        assert_says(&refused(&place.run(arguments)), &["/dev/zero", said]);
    }
    assert_eq!(place.names(), ["c.toml"]);
}

#[test]
fn a_scene_beyond_the_memory_is_refused_before_it_is_read() {
    let place = Place::new();
    let mut text = fs::read_to_string(place.path("c.toml")).unwrap();
    text += &"# a comment that takes room\n".repeat(1_000_000);
    fs::write(place.path("large.toml"), text).unwrap();
    let program = assert_cmd::cargo::cargo_bin("imogene");
    let mut shell = Command::new("sh");
    let script = "ulimit -v 1000000; \"$0\" render large.toml -o x.png";
    shell.arg("-c").arg(script).arg(program);
    let output = shell.current_dir(place.folder.path()).output().unwrap();
    assert_says(&refused(&output), &["large.toml", "GiB of memory", "free"]);
    assert_eq!(place.names(), ["c.toml", "large.toml"]);
}

#[test]
fn messages_are_short_whatever_they_quote() {
    let place = Place::new();
    let own = fs::read_to_string(place.path("c.toml")).unwrap();
    let name = "n".repeat(1 << 20);
    for text in [
        format!("{own}\nx = {}", "[".repeat(100_000)),
        format!("{own}\nx = {}", "[ ".repeat(100_000)),
        format!("{own}\n{}a = 1", "a.".repeat(500_000)),
        format!("{own}\n[[materials]]\nname = \"{name}\"\ncolour = [1, 1, 2]\n"),
        format!(
            "{own}\n[[materials]]\nname = \"{}\"\ncolour = [1, 1, 2]\n",
            "\\n".repeat(500_000)
        ),
        format!(
            "{own}\n[[objects]]\nname = \"{name}\"\nmaterial = \"{name}\"\nkind = \"sphere\"\nradius = 1\n"
        ),
    ] {
        fs::write(place.path("hostile.toml"), text).unwrap();
        refused(&place.run(&["render", "hostile.toml", "-o", "x.png"]));
    }
    let path = format!("{}x", "long/".repeat(20_000));
    refused(&place.run(&["render", &path, "-o", "x.png"]));
    refused(&place.run(&["render", "c.toml", "-o", &path]));
    refused(&place.run(&["render", "c.toml", "--size", &path, "-o", "x.png"]));
    let of_a_command = place.run(&[&path]);
    refused(&of_a_command);
}

/// Waits until a file whose name begins like a temporary one is there.
fn wait_for_temporary_file(folder: &Path) {
    let begun = Instant::now();
    let is_temporary =
        |entry: fs::DirEntry| entry.file_name().to_string_lossy().starts_with(".imogene-");
    while !fs::read_dir(folder)
        .unwrap()
        .any(|entry| entry.is_ok_and(is_temporary))
    {
        assert!(
            begun.elapsed() < Duration::from_secs(60),
            "no temporary file"
        );
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn an_interruption_leaves_nothing_and_says_so() {
    for (signal, code) in [("INT", 130), ("TERM", 143)] {
        let place = Place::new();
        let scratch = tempfile::tempdir().unwrap();
        make_pipe(&place.path("pipe"));
        // Nobody reads the pipe: the set waits there, complete but for its names.
        let child = Command::new(assert_cmd::cargo::cargo_bin("imogene"))
            .args([
                "render",
                "c.toml",
                "-o",
                "x.png",
                "--depth",
                "pipe",
                "--ids",
                "new/i.npy",
            ])
            .args(SIZE)
            .current_dir(place.folder.path())
            .env("TMPDIR", scratch.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        wait_for_temporary_file(place.folder.path());
        let sent = Command::new("kill")
            .args(["-s", signal, &child.id().to_string()])
            .status();
        assert!(sent.unwrap().success());
        let output = child.wait_with_output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{message}");
        assert!(
            message.starts_with("interrupted: ") && message.lines().count() == 1,
            "{message}"
        );
        assert_eq!(place.names(), ["c.toml", "pipe"]);
        assert_eq!(fs::read_dir(scratch.path()).unwrap().count(), 0);
    }
}
