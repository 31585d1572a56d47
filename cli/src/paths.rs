//! The paths of a command line, looked at before any work is done: what is read, what is written.

use crate::arguments::Command;
use crate::failure::Failure;
use crate::{output, process};
use imogene_files::{Identity, Target, check_folder};
use std::path::{Path, PathBuf};

/// What a command reads and writes.
#[derive(Default)]
pub struct Paths {
    inputs: Vec<PathBuf>,
    files: Vec<OutputFile>,
    folders: Vec<(&'static str, PathBuf)>,
}

struct OutputFile {
    option: &'static str,
    path: PathBuf,
    /// The option writes this file and no other: it may be standard output.
    alone: bool,
}

impl Paths {
    /// Those of a command.
    pub fn of(command: &Command) -> Paths {
        let paths = Paths::default();
        match command {
            // A file that is there is refused by the command itself, and one that is not is nobody's.
            Command::New(_)
            | Command::Units
            | Command::Roots(_)
            | Command::Speed(_)
            | Command::Shading(_)
            | Command::Prove(_) => paths,
            Command::Demo(o) => paths.folder("--out", Some(&o.out)),
            Command::Processors(o) => paths.file("--out", &o.out),
            Command::Emit(o) => paths.reads(&o.machine).folder("--out", Some(&o.out)),
            Command::Contract(o) => paths.file("--out", &o.out),
            Command::Package(o) => paths.folder("--out", Some(&o.out)),
            Command::Render(o) => {
                let paths = paths.reads([&o.scene.scene]);
                match o.frames {
                    Some(_) => paths.folder("--output", Some(&o.output())),
                    None => paths
                        .file("--output", Some(&o.output()))
                        .file("--depth", &o.depth)
                        .file("--ids", &o.ids)
                        .file("--normals", &o.normals),
                }
            }
            Command::Prepare(o) => paths.reads([&o.scene]),
            Command::Cosim(o) => {
                let paths = paths.reads([&PathBuf::from(&o.subject)]);
                paths.set("--vcd", &o.waves.files())
            }
            Command::Import(o) => paths.reads([&o.file]).file("--output", Some(&o.output)),
            Command::Terrain(o) => paths.file("--output", Some(&o.output)),
            Command::Machine(o) => paths
                .reads(&o.scenes)
                .reads([&o.machine])
                .reads(&o.overlay)
                .set("--vcd", &o.waves.files())
                .folder("--out", Some(&o.out)),
            Command::Board(o) => paths
                .reads([&o.scene])
                .reads(&o.machine)
                .folder("--out", Some(&o.out)),
            Command::Raytrace(o) => paths
                .reads(&o.scenes)
                .file("--output", &o.output)
                .file("--table", &o.table)
                .folder("--out", &o.out),
            Command::Cracks(o) => paths
                .reads([&o.scene.scene])
                .file("--output", &o.output)
                .file("--plot", &o.plot),
            Command::Repair(o) => paths
                .reads([&o.scene.scene])
                .file("--output", &o.output)
                .file("--map", &o.map),
            Command::Check(o) => paths.reads([&o.scene.scene]).file("--map", &o.map),
            Command::Detail(o) => paths.reads([&o.scene.scene]).folder("--out", &o.out),
            Command::Primitives(o) => paths.folder("--out", &o.out),
            Command::Trade(o) => paths.reads([&o.scene]).folder("--out", Some(&o.out)),
            Command::Fit(o) => paths.reads(&o.scenes).folder("--out", Some(&o.out)),
            Command::Bounds(o) => paths.reads(&o.scenes),
            Command::Sweep(o) => paths.folder("--out", &o.out),
            Command::Evaluate(o) => paths.folder("--out", &o.out),
            Command::Synth(o) if o.check => paths.reads([&o.baseline]),
            Command::Synth(o) if o.table => {
                paths.set("--out", [&o.out, &o.out.with_extension("json")])
            }
            Command::Synth(o) => paths.reads(&o.machine),
            Command::Peers(o) => paths.reads(&o.rtl),
            Command::Mutate(o) => paths.file("--out", &o.out),
        }
    }

    fn reads<'a>(mut self, inputs: impl IntoIterator<Item = &'a PathBuf>) -> Paths {
        self.inputs.extend(inputs.into_iter().cloned());
        self
    }

    fn file<'a>(self, option: &'static str, path: impl IntoIterator<Item = &'a PathBuf>) -> Paths {
        self.output_files(option, path, true)
    }

    /// Several files of one option.
    fn set<'a>(self, option: &'static str, paths: impl IntoIterator<Item = &'a PathBuf>) -> Paths {
        self.output_files(option, paths, false)
    }

    fn output_files<'a>(
        mut self,
        option: &'static str,
        paths: impl IntoIterator<Item = &'a PathBuf>,
        alone: bool,
    ) -> Paths {
        self.files.extend(paths.into_iter().map(|path| OutputFile {
            option,
            path: path.clone(),
            alone,
        }));
        self
    }

    fn folder<'a>(
        mut self,
        option: &'static str,
        path: impl IntoIterator<Item = &'a PathBuf>,
    ) -> Paths {
        self.folders
            .extend(path.into_iter().map(|path| (option, path.clone())));
        self
    }

    /// Refuses outputs that cannot be written, that would replace an input, or one another.
    pub fn check(&self, json: bool) -> Result<(), Failure> {
        let inputs = self.inputs.iter().filter_map(|path| {
            let identity = Identity::of(path).ok()??;
            matches!(identity, Identity::Node(..)).then_some((path, identity))
        });
        let inputs: Vec<(&PathBuf, Identity)> = inputs.collect();
        let mut known: Vec<(&OutputFile, Identity)> = vec![];
        for file in &self.files {
            let Some(identity) = file.check(json)? else {
                continue;
            };
            if let Some((input, _)) = inputs.iter().find(|(_, other)| *other == identity) {
                return Err(file.refuse(format!(
                    "this is '{}', which the command reads; give another name",
                    input.display()
                )));
            }
            if let Some((other, _)) = known.iter().find(|(_, other)| *other == identity) {
                return Err(file.refuse(file.collision(other)));
            }
            known.push((file, identity));
        }
        for (option, path) in &self.folders {
            check_output_folder(option, path)?;
        }
        output::spare(inputs.into_iter().map(|(_, identity)| identity).collect());
        Ok(())
    }
}

impl OutputFile {
    fn check(&self, json: bool) -> Result<Option<Identity>, Failure> {
        let refuse = |error: std::io::Error| self.refuse(error.to_string());
        let target = Target::of(&self.path).map_err(refuse)?;
        if target == Target::Standard {
            if process::was_standard_output_closed() {
                return Err(self.refuse("standard output is closed".into()));
            }
            if !self.alone {
                return Err(self.refuse(
                    "several files are written, and standard output takes one; give a file name"
                        .into(),
                ));
            }
            if json {
                return Err(self.refuse(
                    "standard output takes either the file or the document of --json; give a file name, or leave --json out"
                        .into(),
                ));
            }
            output::leave_standard_output();
        }
        target.check().map_err(refuse)?;
        target.identity().map_err(refuse)
    }

    fn collision(&self, other: &OutputFile) -> String {
        if self.option == other.option {
            return "another file goes beside it, which would have this name; give another".into();
        }
        let (option, path) = (other.option, other.path.display());
        format!("{option} {path} is the same file; give each its own name")
    }

    fn refuse(&self, problem: String) -> Failure {
        refuse(self.option, &self.path, &problem)
    }
}

fn refuse(option: &str, path: &Path, problem: &str) -> Failure {
    Failure::Input(format!(
        "cannot write '{}' ({option}): {problem}",
        path.display()
    ))
}

fn check_output_folder(option: &str, path: &Path) -> Result<(), Failure> {
    if path == Path::new("-") {
        let problem = "several files are written, and standard output takes one; give a folder";
        return Err(refuse(option, path, problem));
    }
    check_folder(path).map_err(|error| refuse(option, path, &error.to_string()))
}
