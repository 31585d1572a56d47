//! Devices, pipes, links, modes, inputs, sets of files.

use super::{make_pipe, picture, place, refused, render, shell};
use crate::common::{columns, names_in, repository, scene};
use std::fs::{self, File};
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::Path;

#[test]
fn a_pipe_is_written_through_and_stays() {
    let place = place();
    make_pipe(&place.path("pipe"));
    let pipe = place.path("pipe");
    let reader = std::thread::spawn(move || fs::read(pipe).unwrap());
    render(&place, "-o pipe").ended(0);
    assert_eq!(reader.join().unwrap(), picture());
    let kind = fs::metadata(place.path("pipe")).unwrap().file_type();
    assert!(kind.is_fifo());
}

#[test]
fn a_link_stays_and_its_target_is_replaced_and_keeps_its_mode() {
    let place = place();
    fs::create_dir(place.path("deep")).unwrap();
    place.write("deep/target.png", "old");
    let target = place.path("deep/target.png");
    fs::set_permissions(&target, fs::Permissions::from_mode(0o640)).unwrap();
    symlink("deep/target.png", place.path("second")).unwrap();
    symlink("second", place.path("first")).unwrap();
    render(&place, "-o first").ended(0);
    let link = fs::read_link(place.path("first")).unwrap();
    assert_eq!(link, Path::new("second"));
    assert_eq!(place.bytes("deep/target.png"), picture());
    let mode = fs::symlink_metadata(&target).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o640);
}

#[test]
fn a_link_to_nothing_makes_its_target_and_a_circle_is_refused() {
    let place = place();
    symlink("new.png", place.path("link")).unwrap();
    render(&place, "-o link").ended(0);
    assert_eq!(place.bytes("new.png"), picture());
    symlink("circle", place.path("circle")).unwrap();
    refused(render(&place, "-o circle"), &["circle", "links"]);
}

#[test]
fn new_files_have_the_mode_of_the_mask() {
    let place = place();
    for (mask, mode) in [("022", 0o644), ("077", 0o600), ("002", 0o664)] {
        let render = format!("render c.toml --size 48x36 -o new-{mask}.png");
        shell(&place, &format!("umask {mask}; \"$0\" {render}")).ended(0);
        let facts = fs::metadata(place.path(&format!("new-{mask}.png"))).unwrap();
        assert_eq!(facts.permissions().mode() & 0o777, mode, "umask {mask}");
    }
}

#[test]
fn an_input_is_never_replaced() {
    let place = place();
    let before = place.bytes("c.toml");
    symlink("c.toml", place.path("link.toml")).unwrap();
    fs::hard_link(place.path("c.toml"), place.path("hard.toml")).unwrap();
    fs::copy(scene("teapot.toml"), place.path("teapot.toml")).unwrap();
    place.write("a.pdb", "ATOM\n");
    let absolute = format!("render c.toml -o {}", place.path("c.toml").display());
    for line in [
        "render c.toml -o c.toml",
        "render c.toml -o ./c.toml",
        &absolute,
        "render c.toml -o link.toml",
        "render c.toml -o x.png --depth hard.toml",
        "render link.toml -o x.png --ids c.toml",
        "import a.pdb -o a.pdb",
        "trace teapot.toml c.toml --table c.toml",
        "cracks c.toml -o c.toml",
        "repair c.toml --map c.toml",
        "cosim c.toml --vcd c.toml",
    ] {
        let parts = ["which the command reads", "another name"];
        refused(place.run(line), &parts);
    }
    assert_eq!(place.bytes("c.toml"), before);
    assert_eq!(place.bytes("a.pdb"), b"ATOM\n");
}

#[test]
fn an_input_in_the_output_folder_is_not_replaced_by_one_of_its_files() {
    let place = place();
    let machine = repository("machines/beam-160x120.toml");
    // The description lies where the summary of the machine goes.
    fs::create_dir(place.path("out")).unwrap();
    fs::copy(machine, place.path("out/summary.json")).unwrap();
    let before = place.bytes("out/summary.json");
    let run = place.run("machine c.toml --machine out/summary.json --out out --emit-only");
    refused(run, &["summary.json", "read by the same command"]);
    assert_eq!(place.bytes("out/summary.json"), before);
    assert_eq!(names_in(&place.path("out")).len(), 1);
}

#[test]
fn no_two_outputs_are_one_file() {
    let place = place();
    place.write("there.npy", "old");
    symlink("there.npy", place.path("link.npy")).unwrap();
    symlink(".", place.path("here")).unwrap();
    for [one, other] in [
        ["q.npy", "q.npy"],
        ["q.npy", "here/q.npy"],
        ["there.npy", "link.npy"],
        ["new/q.npy", "./new/q.npy"],
    ] {
        let run = render(&place, &format!("-o x.png --depth {one} --ids {other}"));
        refused(run, &["--depth", "--ids", "the same file"]);
    }
    refused(place.run("cosim c.toml --vcd x.gtkw"), &["--vcd"]);
    assert_eq!(place.bytes("there.npy"), b"old");
    assert_eq!(place.names(), ["c.toml", "here", "link.npy", "there.npy"]);
}

#[test]
fn outputs_that_cannot_be_written_are_refused_in_words() {
    let place = place();
    fs::create_dir(place.path("folder")).unwrap();
    let cases = "
        emit beam --out c.toml        | it is a file; a folder is wanted
        emit beam --out c.toml/below  | 'c.toml' is a file
        render c.toml -o folder       | it is a folder; a file is wanted
        render c.toml -o new/         | a folder; a file is wanted
        render c.toml -o c.toml/x.png | Not a directory
    ";
    for [line, said] in columns(cases) {
        refused(place.run(line), &[said]);
    }
    assert_eq!(place.names(), ["c.toml", "folder"]);
}

#[test]
fn a_set_of_files_appears_whole_or_not_at_all() {
    let place = place();
    place.write("x.png", "old");
    make_pipe(&place.path("pipe"));
    // A reader that leaves at once: what is written to the pipe is refused, and nothing else appears.
    let pipe = place.path("pipe");
    let reader = std::thread::spawn(move || drop(File::open(pipe).unwrap()));
    let files = "-o x.png --depth new/deep/q.npy --ids pipe";
    let run = place.run(&format!("render c.toml --size 640x480 {files}"));
    reader.join().unwrap();
    run.ended(141);
    assert_eq!(place.bytes("x.png"), b"old");
    assert_eq!(place.names(), ["c.toml", "pipe", "x.png"]);
    render(&place, "-o x.png --depth new/deep/q.npy").ended(0);
    assert_eq!(place.bytes("x.png"), picture());
    assert!(place.has("new/deep/q.npy"));
}

#[test]
fn a_folder_of_files_appears_whole_or_not_at_all() {
    let place = place();
    // The list of the files comes last, and its name is taken by a folder.
    fs::create_dir_all(place.path("out/pe1.f")).unwrap();
    let run = place.run("emit pe1 --split --out out");
    refused(run, &["pe1.f", "it is a folder"]);
    assert_eq!(names_in(&place.path("out")).len(), 1);
    fs::remove_dir(place.path("out/pe1.f")).unwrap();
    place.run("emit pe1 --split --out out").ended(0);
    assert!(names_in(&place.path("out")).len() > 1);
}

#[test]
fn a_disk_without_room_leaves_no_file() {
    let place = place();
    // The limit of a file's size stands for the end of the disk: 200 blocks hold the picture, not the array.
    let limit = "trap '' XFSZ; ulimit -f 200";
    let render = "\"$0\" render c.toml --size 320x240 -o x.png --depth q.npy";
    let run = shell(&place, &format!("{limit}; {render}"));
    refused(run, &["cannot write 'q.npy'"]);
    assert_eq!(place.names(), ["c.toml"]);
}
