//! Devices, pipes, links, modes, inputs, sets of files.

use super::{Place, accepted, assert_says, make_pipe, refused};
use crate::common::scene;
use std::fs::{self, File};
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::Command;

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
