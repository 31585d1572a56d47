//! `imogene trade --engine hq`: a HyperQueue server with two workers, and what becomes of a run that loses some of it.
//! `scripts/setup --parts` installs it.

use crate::common::{Place, Run, imogene, repository, scene};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::LazyLock;
use std::time::{Duration, Instant};

const DEADLINE: Duration = Duration::from_secs(60);

fn command(out: &Path, more: &str) -> Command {
    let (out, teapot) = (out.display(), scene("teapot.toml"));
    let options = "--size 48x36 --points quick --no-cost";
    let line = format!("trade {teapot} {options} --out {out} {more}");
    let mut command = Command::new(env!("CARGO_BIN_EXE_imogene"));
    command.args(line.split_whitespace());
    command.stdout(Stdio::null()).stderr(Stdio::piped());
    command
}

/// The results of one program.
static WANTED: LazyLock<String> = LazyLock::new(|| {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("alone");
    assert!(command(&out, "").status().unwrap().success());
    results(&out)
});

/// The results in a folder, without its name.
fn results(out: &Path) -> String {
    let text = std::fs::read_to_string(out.join("trade.json")).unwrap();
    text.replace(&out.display().to_string(), "OUT")
}

/// Processes by their arguments, this one left out.
fn processes(wanted: impl Fn(&[String]) -> bool) -> Vec<u32> {
    let entries = std::fs::read_dir("/proc").unwrap().flatten();
    let pids = entries.filter_map(|e| e.file_name().to_str()?.parse::<u32>().ok());
    let is_wanted = |pid: &u32| {
        let line = std::fs::read(format!("/proc/{pid}/cmdline")).unwrap_or_default();
        let line = String::from_utf8_lossy(&line).into_owned();
        let arguments: Vec<String> = line.split('\0').map(str::to_owned).collect();
        *pid != std::process::id() && wanted(&arguments)
    };
    pids.filter(is_wanted).collect()
}

/// A part of a run into this folder.
fn is_part<'a>(out: &'a str) -> impl Fn(&[String]) -> bool + 'a {
    move |arguments| {
        ["--shard", out]
            .iter()
            .all(|word| arguments.iter().any(|a| a == word))
    }
}

/// The server of a run into this folder: the Python process, with its workers.
fn is_server<'a>(out: &'a str) -> impl Fn(&[String]) -> bool + 'a {
    move |arguments| {
        ["LocalCluster", out]
            .iter()
            .all(|word| arguments.iter().any(|a| a.contains(word)))
    }
}

fn kill(pid: u32) -> bool {
    let status = Command::new("kill").args(["-9", &pid.to_string()]).status();
    status.unwrap().success()
}

/// Waits for a process that was not killed before, and kills it; one that dies is listed for a moment longer.
fn kill_first(wanted: impl Fn(&[String]) -> bool, killed: &[u32], run: &mut Child) -> u32 {
    let started = Instant::now();
    while started.elapsed() < DEADLINE {
        let alive = processes(&wanted);
        if let Some(&pid) = alive.iter().find(|pid| !killed.contains(pid))
            && kill(pid)
        {
            return pid;
        }
        assert!(run.try_wait().unwrap().is_none(), "the run ended before");
        std::thread::sleep(Duration::from_millis(2));
    }
    panic!("no such process");
}

fn succeeds(run: Child) -> String {
    let output = run.wait_with_output().unwrap();
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{error}");
    error
}

#[test]
fn a_part_that_is_killed_is_done_again() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("parts");
    let mut run = command(&out, "--engine hq").spawn().unwrap();
    let place = out.display().to_string();
    // Two of the parts, which the two workers run.
    let first = kill_first(is_part(&place), &[], &mut run);
    let second = kill_first(is_part(&place), &[first], &mut run);
    assert_ne!(first, second);
    succeeds(run);
    assert!(results(&out) == *WANTED);
}

#[test]
fn a_run_whose_server_dies_goes_on_where_it_stopped() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("parts");
    let place = out.display().to_string();
    let mut run = command(&out, "--engine hq").spawn().unwrap();
    let points = out.join("points");
    // Finished points; one that is being written has another name.
    let is_point = |entry: &std::io::Result<std::fs::DirEntry>| {
        let path = entry.as_ref().unwrap().path();
        path.extension().is_some_and(|name| name == "json")
    };
    let kept = || std::fs::read_dir(&points).map_or(0, |all| all.filter(is_point).count());
    let started = Instant::now();
    while kept() == 0 && started.elapsed() < DEADLINE {
        std::thread::sleep(Duration::from_millis(2));
    }
    // The server with its workers is the Python process.
    kill_first(is_server(&place), &[], &mut run);
    let output = run.wait_with_output().unwrap();
    let error = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert!(error.contains("goes on where it stopped"), "{error}");
    assert!(!out.join("trade.json").exists());
    let before = kept();
    assert!(before > 0);
    let mut again = command(&out, "--engine hq --workers 1");
    succeeds(again.spawn().unwrap());
    assert!(results(&out) == *WANTED);
}

/// A server that runs already, given by its folder.
#[test]
fn a_running_server_takes_the_parts() {
    let folder = tempfile::tempdir().unwrap();
    let server = folder.path().join("server");
    let text = "import sys, time\nfrom hyperqueue.cluster import LocalCluster, WorkerConfig\n\
                cluster = LocalCluster(sys.argv[1])\ncluster.start_worker(WorkerConfig(cores=1))\n\
                print('ready', flush=True)\ntime.sleep(120)";
    let mut host = Command::new(python())
        .args(["-c", text, server.to_str().unwrap()])
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let started = Instant::now();
    while !server.join("hq-current").exists() && started.elapsed() < DEADLINE {
        std::thread::sleep(Duration::from_millis(20));
    }
    std::thread::sleep(Duration::from_millis(500));
    let out = folder.path().join("parts");
    let more = format!("--engine hq --server {}", server.display());
    let run = command(&out, &more).spawn().unwrap();
    let output = run.wait_with_output().unwrap();
    host.kill().unwrap();
    host.wait().unwrap();
    assert!(output.status.success(), "{output:?}");
    assert!(results(&out) == *WANTED);
}

fn python() -> PathBuf {
    repository("target/tools/bin/python")
}

#[test]
fn a_scene_that_is_refused_starts_no_server() {
    let place = Place::new();
    let out = place.path("out");
    let mesh = "scenes/processors/mesh.toml";
    let mut command = imogene(&format!("trade {mesh} --engine hq --out {}", out.display()));
    let tools = command.env("IMOGENE_TOOLS", place.path("nothing"));
    Run::of(tools).refused(&["processor \"facet\""]);
    assert!(!out.exists());
}
