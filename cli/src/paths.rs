//! The paths of a command line, looked at before any work is done: what is read, what is written.

use crate::arguments::Command;
use crate::failure::{Failure, Result};
use crate::{output, process};
use Kind::{File, Folder, OneOf};
use imogene_files::{Identity, Target, check_folder};
use std::fmt::Display;
use std::path::{Path, PathBuf};

/// What a command reads and writes.
#[derive(Default)]
pub struct Paths {
    inputs: Vec<PathBuf>,
    outputs: Vec<Output>,
}

struct Output {
    option: &'static str,
    path: PathBuf,
    kind: Kind,
}

/// What an option writes.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// This file and no other: it may be standard output.
    File,
    /// This file among several.
    OneOf,
    /// Files in this folder.
    Folder,
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
            Command::Demo(o) => paths.folder([&o.out]),
            Command::Processors(o) => paths.file("--out", &o.out),
            Command::Emit(o) => paths.reads(&o.machine).folder([&o.out]),
            Command::Contract(o) => paths.file("--out", &o.out),
            Command::Package(o) => paths.folder([&o.out]),
            Command::Render(o) => {
                let paths = paths.reads([&o.scene.scene]);
                match o.frames {
                    Some(_) => paths.writes(Folder, "--output", Some(&o.output())),
                    None => paths
                        .file("--output", [&o.output()])
                        .file("--depth", &o.depth)
                        .file("--ids", &o.ids)
                        .file("--normals", &o.normals),
                }
            }
            Command::Prepare(o) => paths.reads([&o.scene]),
            Command::Cosim(o) => {
                let paths = paths.reads([&PathBuf::from(&o.subject)]);
                paths.writes(OneOf, "--vcd", &o.waves.files())
            }
            Command::Import(o) => paths.reads([&o.file]).file("--output", [&o.output]),
            Command::Terrain(o) => paths.file("--output", [&o.output]),
            Command::Machine(o) => paths
                .reads(&o.scenes)
                .reads([&o.machine])
                .reads(&o.overlay)
                .writes(OneOf, "--vcd", &o.waves.files())
                .folder([&o.out]),
            Command::Board(o) => paths.reads([&o.scene]).reads(&o.machine).folder([&o.out]),
            Command::Raytrace(o) => paths
                .reads(&o.scenes)
                .file("--output", &o.output)
                .file("--table", &o.table)
                .folder(&o.out),
            Command::Cracks(o) => paths
                .reads([&o.scene.scene])
                .file("--output", &o.output)
                .file("--plot", &o.plot),
            Command::Repair(o) => paths
                .reads([&o.scene.scene])
                .file("--output", &o.output)
                .file("--map", &o.map),
            Command::Check(o) => paths.reads([&o.scene.scene]).file("--map", &o.map),
            Command::Detail(o) => paths.reads([&o.scene.scene]).folder(&o.out),
            Command::Primitives(o) => paths.folder(&o.out),
            Command::Trade(o) => paths.reads([&o.scene]).folder([&o.out]),
            Command::Fit(o) => paths.reads(&o.scenes).folder([&o.out]),
            Command::Bounds(o) => paths.reads(&o.scenes),
            Command::Sweep(o) => paths.folder(&o.out),
            Command::Evaluate(o) => paths.folder(&o.out),
            Command::Synth(o) if o.check => paths.reads([&o.baseline]),
            Command::Synth(o) if o.table => {
                paths.writes(OneOf, "--out", [&o.out, &o.out.with_extension("json")])
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

    fn folder<'a>(self, paths: impl IntoIterator<Item = &'a PathBuf>) -> Paths {
        self.writes(Folder, "--out", paths)
    }

    fn file<'a>(self, option: &'static str, paths: impl IntoIterator<Item = &'a PathBuf>) -> Paths {
        self.writes(File, option, paths)
    }

    fn writes<'a>(
        mut self,
        kind: Kind,
        option: &'static str,
        paths: impl IntoIterator<Item = &'a PathBuf>,
    ) -> Paths {
        self.outputs.extend(paths.into_iter().map(|path| Output {
            option,
            path: path.clone(),
            kind,
        }));
        self
    }

    /// Refuses outputs that cannot be written, that would replace an input, or one another.
    pub fn check(&self, json: bool) -> Result {
        let inputs = self.inputs.iter().filter_map(|path| {
            let identity = Identity::of(path).ok()??;
            matches!(identity, Identity::Node(..)).then_some((path, identity))
        });
        let inputs: Vec<(&PathBuf, Identity)> = inputs.collect();
        let mut known: Vec<(&Output, Identity)> = vec![];
        for file in &self.outputs {
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
        output::spare(inputs.into_iter().map(|(_, identity)| identity).collect());
        Ok(())
    }
}

impl Output {
    /// The file that is written, if it is known.
    fn check(&self, json: bool) -> Result<Option<Identity>> {
        let refuse = |error: std::io::Error| self.refuse(error.to_string());
        if self.kind == Folder {
            if self.path == Path::new("-") {
                return Err(self.refuse(
                    "several files are written, and standard output takes one; give a folder",
                ));
            }
            return check_folder(&self.path).map(|()| None).map_err(refuse);
        }
        let target = Target::of(&self.path).map_err(refuse)?;
        if target == Target::Standard {
            if process::was_standard_output_closed() {
                return Err(self.refuse("standard output is closed"));
            }
            if self.kind != File {
                return Err(self.refuse(
                    "several files are written, and standard output takes one; give a file name",
                ));
            }
            if json {
                return Err(self.refuse(
                    "standard output takes either the file or the document of --json; give a file name, or leave --json out",
                ));
            }
            output::leave_standard_output();
        }
        target.check().map_err(refuse)?;
        target.identity().map_err(refuse)
    }

    fn collision(&self, other: &Output) -> String {
        if self.option == other.option {
            return "another file goes beside it, which would have this name; give another".into();
        }
        let (option, path) = (other.option, other.path.display());
        format!("{option} {path} is the same file; give each its own name")
    }

    fn refuse(&self, problem: impl Display) -> Failure {
        let (path, option) = (self.path.display(), self.option);
        Failure::Input(format!("cannot write '{path}' ({option}): {problem}"))
    }
}
