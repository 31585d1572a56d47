//! All points of a design space, in any order, on any number of programs, each kept when it is finished.

use super::TradeError;
use super::design::Design;
use super::measure::{Measured, measure};
pub use super::point::Request;
use super::point::{Key, Point, Run};
use super::prices::clock;
use super::report::Trade;
use super::view::Views;
use crate::kit::picture::{write_png, write_whole};
use imogene_analysis::metrics::map;
use imogene_golden::widths;
use imogene_plan::description::MachineKind;
use rayon::prelude::*;
use sha2::{Digest, Sha256};

/// A part of the points: number k of n, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which.
    pub number: usize,
    /// Of how many.
    pub of: usize,
}

type Group<'a> = &'a [Design];

type Files = (String, String);

/// Measures what is not kept already, and sums up all of it.
/// Fails if the scene is not for machines of quadric processors, or a file cannot be written or read.
pub fn run(request: &Request) -> Result<Trade, TradeError> {
    let run = Run::new(request)?;
    let truth = run.truth_file();
    let path = request.out.join(&truth);
    if !path.is_file() {
        let truth = run.views.whole_truth();
        write_png(&path, truth.width, truth.height, &truth.rgb)?;
    }
    run.finish(&groups(&request.designs).collect::<Vec<_>>())?;
    let empty = Trade {
        version: request.version.to_owned(),
        scene: request.name.to_owned(),
        title: run.views.whole().title.clone(),
        width: request.size.0,
        height: request.size.1,
        target: request.target.to_owned(),
        truth,
        legend: map::legend(),
        ..Trade::default()
    };
    run.trade(&empty, run.points()?)
}

/// Refuses what [`run`] would refuse before it measures anything.
pub fn check(request: &Request) -> Result<(), TradeError> {
    Run::new(request).map(|_| ())
}

/// Measures a part of the points and keeps them, without costs; gives their number.
pub fn run_shard(request: &Request, shard: Shard) -> Result<usize, TradeError> {
    let run = Run::new(request)?;
    let groups = groups(&request.designs).skip(shard.number - 1);
    let groups: Vec<Group> = groups.step_by(shard.of).collect();
    run.finish(&groups)?;
    Ok(groups.concat().len())
}

fn groups(designs: &[Design]) -> impl Iterator<Item = Group<'_>> {
    designs.chunk_by(|a, b| a.accuracy == b.accuracy)
}

impl<'a> Run<'a> {
    fn new(request: &'a Request<'a>) -> Result<Run<'a>, TradeError> {
        let views = Views::new(request.file, request.size)?;
        let mut objects = views.whole().objects.iter();
        if let Some(other) = objects.find(|o| o.quadric().is_none()) {
            let (name, processor) = (other.name(), other.processor());
            return Err(TradeError::Refused(format!(
                "object '{name}': drawn by the processor \"{processor}\"; trade measures machines of quadric \
                 processors, which draw every object of a quadric: leave `processor` out"
            )));
        }
        let key = Key {
            scene: digest(request.file.to_toml()?),
            name: request.name.to_owned(),
            size: request.size,
            target: request.target.to_owned(),
            program: request.program.to_owned(),
        };
        Ok(Run {
            request,
            views,
            key,
        })
    }

    /// File of the true picture, which is another for every scene and size.
    fn truth_file(&self) -> String {
        let (width, height) = self.request.size;
        let own = digest(format!("{} {}", self.key.scene, self.key.program));
        format!("pictures/truth-{width}x{height}-{}.png", &own[..8])
    }

    fn finish(&self, groups: &[Group]) -> Result<(), TradeError> {
        groups.par_iter().try_for_each(|group| {
            let is_kept = |design: &Design| self.take(&design.name()).is_some();
            if !group.iter().all(is_kept) {
                self.measure(group)?;
            }
            (self.request.done)(group.len() as u64);
            Ok(())
        })
    }

    fn points(&self) -> Result<Vec<Point>, TradeError> {
        let point = |design: &Design| {
            let id = design.name();
            let changed = "it was changed during the run; run the command again";
            let lost = || TradeError::unreadable(&self.path(&id), changed);
            Ok(self.with_commands(self.take(&id).ok_or_else(lost)?))
        };
        self.request.designs.iter().map(point).collect()
    }

    fn measure(&self, group: Group) -> Result<(), TradeError> {
        let accuracy = group[0].accuracy;
        let measured = measure(&self.views, &accuracy);
        let name = accuracy.name();
        let files = (format!("pictures/{name}.png"), format!("maps/{name}.png"));
        if let Ok(measured) = &measured {
            let (width, height) = self.request.size;
            for (file, rgb) in [(&files.0, &measured.rgb), (&files.1, &measured.map)] {
                let path = self.request.out.join(file);
                write_png(&path, width as usize, height as usize, rgb)?;
            }
        }
        for design in group {
            let measured = measured.as_ref().map_err(String::clone);
            let point = measured.and_then(|measured| self.point(design, measured, &files));
            let point = point.unwrap_or_else(|problem| Point {
                id: design.name(),
                design: *design,
                refused: Some(problem),
                ..Point::default()
            });
            if let (Some(file), Some(machine)) = (&point.machine_file, &point.machine) {
                let (id, machine) = (&point.id, machine.to_toml());
                let text = format!("# The machine of the point {id}\n{machine}");
                let path = self.request.out.join(file);
                write_whole(&path, |out| out.write_all(text.as_bytes()))?;
            }
            self.keep(&point)?;
        }
        Ok(())
    }

    fn point(&self, design: &Design, measured: &Measured, files: &Files) -> Result<Point, String> {
        let machine = measured.machine(design)?;
        let timing = (self.request.timing)(&machine);
        let is_beam = machine.machine == MachineKind::Beam;
        let id = design.name();
        // The registers of the restoring network are those that are counted.
        let is_counted = design.accuracy.root_form.is_usual();
        let toggles = is_counted.then(|| measured.toggles(&machine));
        Ok(Point {
            unit: ["zone_machine", "beam_stream"][usize::from(is_beam)].into(),
            design: *design,
            format: Some(measured.widths),
            latency: is_beam.then_some(timing.latency),
            clocks_per_frame: Some(measured.clocks(&machine, &timing)?),
            errors: Some(measured.metrics.clone()),
            picture_error: Some(measured.picture_error),
            toggles: toggles.transpose()?,
            mhz_estimated: clock(&machine, self.request.target),
            picture: Some(files.0.clone()),
            map: Some(files.1.clone()),
            machine_file: Some(format!("machines/{id}.toml")),
            machine: Some(machine),
            id,
            ..Point::default()
        })
    }

    /// The point with the commands that make it again, which depend on the folder.
    fn with_commands(&self, point: Point) -> Point {
        let scene = quoted(self.request.name);
        let Some(file) = &point.machine_file else {
            let (width, height) = self.request.size;
            let widths = widths::print(&point.design.accuracy.widest());
            let command = format!(
                "imogene render {scene} --size {width}x{height} --model golden --widths {widths} -o picture.png"
            );
            return Point { command, ..point };
        };
        let file = quoted(&self.request.out.join(file).display().to_string());
        let command = format!("imogene machine {scene} --machine {file} --out DIR");
        Point {
            emit: Some(command.replace(" --out", " --emit-only --out")),
            command,
            ..point
        }
    }
}

/// A word of a command line, in quotes where a shell would not leave it as it is.
pub fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+:@%".contains(c);
    match !text.is_empty() && text.chars().all(plain) {
        true => text.to_owned(),
        false => format!("'{}'", text.replace('\'', "'\\''")),
    }
}

/// Digest of anything that results depend on.
pub fn digest(bytes: impl AsRef<[u8]>) -> String {
    let bytes = Sha256::digest(bytes);
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
