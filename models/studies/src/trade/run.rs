//! All points of a design space, in any order, on any number of programs, each kept when it is finished.

use super::TradeError;
use super::design::Design;
use super::measure::{Measured, measure};
use super::point::{Cost, CostsOf, Point};
use super::report::{Trade, assemble};
use super::store::{Key, Store};
use crate::kit::picture::write_png;
use imogene_analysis::metrics::{Truth, map};
use imogene_contract::MachineWords;
use imogene_golden::machine::fitted::FittedMachine;
use imogene_golden::widths;
use imogene_prepare::Framing;
use imogene_scene::{FramedScene, SceneFile};
use rayon::prelude::*;
use sha2::{Digest, Sha256};
use std::path::Path;
use std::sync::OnceLock;

/// What is to be measured.
pub struct Request<'a> {
    /// The scene.
    pub file: &'a SceneFile,
    /// As the commands name it.
    pub name: &'a str,
    /// Picture size.
    pub size: (u32, u32),
    /// Device of the costs.
    pub target: &'a str,
    /// The points.
    pub designs: Vec<Design>,
    /// Folder of the results.
    pub out: &'a Path,
    /// Version of the program, which the results name.
    pub version: &'a str,
    /// What tells this program from any other that might measure something else.
    pub program: &'a str,
    /// Where costs come from.
    pub costs: CostsOf<'a>,
    /// Whether a cost without a clock is to be asked for again.
    pub with_clock: bool,
    /// Called with the number of points that are finished, from any thread.
    pub done: &'a (dyn Fn(u64) + Sync),
}

/// A part of the points: number k of n, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which.
    pub number: usize,
    /// Of how many.
    pub of: usize,
}

/// Machines whose costs are asked for at once, and kept before the next ones.
const TOGETHER: usize = 48;

/// Points of the same pixels, at least one.
type Group<'a> = &'a [Design];

/// A scene, solved when a point first asks for it.
struct Subject<'a> {
    request: &'a Request<'a>,
    framed: FramedScene,
    truth: OnceLock<Truth>,
    store: Store<'a>,
}

/// Measures what is not kept already, and sums up all of it.
/// Fails if the scene is not for machines of quadric processors, or a file cannot be written or read.
pub fn run(request: &Request) -> Result<Trade, TradeError> {
    let subject = Subject::new(request)?;
    let truth = subject.truth_file();
    if !request.out.join(&truth).is_file() {
        subject.truth()?;
    }
    subject.finish(&groups(&request.designs).collect::<Vec<_>>())?;
    subject.add_costs()?;
    let points = request.designs.iter().map(|design| {
        let id = design.name();
        subject.store.take(&id).ok_or_else(|| TradeError::Read {
            file: subject.store.path(&id).display().to_string(),
            problem: "it was changed during the run; run the command again".into(),
        })
    });
    let points = points.collect::<Result<Vec<Point>, TradeError>>()?;
    let empty = Trade {
        version: request.version.to_owned(),
        scene: request.name.to_owned(),
        title: subject.framed.title.clone(),
        width: request.size.0,
        height: request.size.1,
        target: request.target.to_owned(),
        truth,
        legend: map::legend(),
        measure: "",
        points: vec![],
    };
    Ok(assemble(empty, points))
}

/// Refuses what [`run`] would refuse before it measures anything.
pub fn check(request: &Request) -> Result<(), TradeError> {
    Subject::new(request).map(|_| ())
}

/// Measures a part of the points and keeps them, without costs; gives their number.
pub fn run_shard(request: &Request, shard: Shard) -> Result<usize, TradeError> {
    let subject = Subject::new(request)?;
    let groups = groups(&request.designs).skip(shard.number - 1);
    let groups: Vec<Group> = groups.step_by(shard.of).collect();
    subject.finish(&groups)?;
    Ok(groups.concat().len())
}

fn groups(designs: &[Design]) -> impl Iterator<Item = Group<'_>> {
    designs.chunk_by(|a, b| a.accuracy == b.accuracy)
}

impl<'a> Subject<'a> {
    fn new(request: &'a Request<'a>) -> Result<Subject<'a>, TradeError> {
        let framed = request.file.frame(request.size.0, request.size.1)?;
        if let Some(other) = framed.objects.iter().find(|o| o.quadric().is_none()) {
            return Err(TradeError::Processor {
                object: other.name().to_owned(),
                processor: other.processor(),
            });
        }
        let key = Key {
            scene: digest(request.file.to_toml()?),
            name: request.name.to_owned(),
            size: request.size,
            target: request.target.to_owned(),
            program: request.program.to_owned(),
        };
        Ok(Subject {
            request,
            framed,
            truth: OnceLock::new(),
            store: Store {
                folder: request.out,
                key,
            },
        })
    }

    /// File of the true picture, which is another for every scene and size.
    fn truth_file(&self) -> String {
        let (width, height) = self.request.size;
        let key = &self.store.key;
        let own = digest(format!("{} {}", key.scene, key.program));
        format!("pictures/truth-{width}x{height}-{}.png", &own[..8])
    }

    fn truth(&self) -> Result<&Truth, TradeError> {
        if let Some(truth) = self.truth.get() {
            return Ok(truth);
        }
        let truth = self.truth.get_or_init(|| Truth::new(&self.framed, || ()));
        let path = self.request.out.join(self.truth_file());
        write_png(&path, truth.width, truth.height, &truth.rgb)?;
        Ok(truth)
    }

    /// Every point of the groups, kept.
    fn finish(&self, groups: &[Group]) -> Result<(), TradeError> {
        if groups.iter().any(|group| !self.is_kept(group)) {
            self.truth()?;
        }
        groups.par_iter().try_for_each(|group| {
            if !self.is_kept(group) {
                self.measure(group)?;
            }
            (self.request.done)(group.len() as u64);
            Ok(())
        })
    }

    fn is_kept(&self, group: Group) -> bool {
        let mut names = group.iter().map(Design::name);
        names.all(|id| self.store.take(&id).is_some())
    }

    /// The costs of all machines that have none yet, many in one go: they share most of their modules.
    fn add_costs(&self) -> Result<(), TradeError> {
        let kept = self.request.designs.iter();
        let points: Vec<Point> = kept
            .filter_map(|design| self.store.take(&design.name()))
            .filter(|point| self.lacks_cost(point))
            .collect();
        for points in points.chunks(TOGETHER) {
            let machines: Vec<FittedMachine> =
                points.iter().filter_map(|p| p.machine.clone()).collect();
            let costs: Vec<Result<Cost, String>> = match (self.request.costs)(&machines) {
                Ok(costs) => costs.into_iter().map(Ok).collect(),
                Err(problem) => vec![Err(problem); machines.len()],
            };
            // A cost without a clock is better than none.
            let better = |(point, cost): &(&Point, _)| point.cost.is_none() || Result::is_ok(cost);
            for (point, cost) in points.iter().zip(costs).filter(better) {
                self.store.keep(&self.with_cost(point.clone(), cost))?;
            }
        }
        Ok(())
    }

    fn lacks_cost(&self, point: &Point) -> bool {
        let without_clock = |cost: Cost| self.request.with_clock && cost.fmax_mhz.is_none();
        point.machine.is_some() && point.cost.is_none_or(without_clock)
    }

    fn with_cost(&self, point: Point, cost: Result<Cost, String>) -> Point {
        let (cost, cost_refused) = match cost {
            Ok(cost) => (Some(cost), None),
            Err(problem) => (None, Some(problem)),
        };
        let (width, height) = self.request.size;
        let pixels = f64::from(width) * f64::from(height);
        let per_second = |mhz: f64| Some(mhz * 1e6 * pixels / point.clocks_per_frame? as f64);
        Point {
            pixels_per_second: cost.and_then(|c| per_second(c.fmax_mhz?)),
            cost,
            cost_refused,
            ..point
        }
    }

    fn measure(&self, group: Group) -> Result<(), TradeError> {
        let truth = self.truth()?;
        let accuracy = group[0].accuracy;
        let measured = measure(&self.framed, truth, &accuracy);
        let name = accuracy.name();
        let files = (format!("pictures/{name}.png"), format!("maps/{name}.png"));
        if let Ok(measured) = &measured {
            for (file, rgb) in [(&files.0, &measured.rgb), (&files.1, &measured.map)] {
                let path = self.request.out.join(file);
                write_png(&path, truth.width, truth.height, rgb)?;
            }
        }
        for design in group {
            let point = match &measured {
                Ok(measured) => self.point(design, measured, &files),
                Err(problem) => self.refused(design, problem),
            };
            self.store.keep(&point)?;
        }
        Ok(())
    }

    fn point(&self, design: &Design, measured: &Measured, files: &(String, String)) -> Point {
        let machine = measured.machine(design.rows_per_stage);
        Point {
            format: Some(measured.widths),
            latency: Some(measured.latency(&machine)),
            clocks_per_frame: Some(measured.clocks_per_frame(&machine)),
            errors: Some(measured.metrics.clone()),
            toggles: Some(measured.toggles(design.rows_per_stage)),
            picture: Some(files.0.clone()),
            map: Some(files.1.clone()),
            emit: Some(machine.command()),
            machine: Some(machine),
            ..self.unmeasured(design, &measured.widths)
        }
    }

    /// A point of which nothing is known but why.
    fn refused(&self, design: &Design, problem: &str) -> Point {
        Point {
            refused: Some(problem.to_owned()),
            ..self.unmeasured(design, &design.accuracy.widest())
        }
    }

    /// A point with the command that draws it in these widths.
    fn unmeasured(&self, design: &Design, widths: &MachineWords) -> Point {
        let unit = match design.accuracy.catalogue {
            true => "beam",
            false => "fitted_beam",
        };
        Point {
            id: design.name(),
            unit: unit.into(),
            design: *design,
            command: self.command(design, &widths::print(widths)),
            ..Point::default()
        }
    }

    fn command(&self, design: &Design, widths: &str) -> String {
        let (width, height) = self.request.size;
        let scene = quoted(self.request.name);
        let zone = match design.accuracy.zone {
            0 => String::new(),
            zone => format!(" --zone {zone}"),
        };
        format!(
            "imogene render {scene} --size {width}x{height} --model golden --widths {widths}{zone} -o picture.png"
        )
    }
}

/// A word of a command line.
fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+:@%".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', "'\\''"))
    }
}

/// Digest of anything that results depend on.
pub fn digest(bytes: impl AsRef<[u8]>) -> String {
    let bytes = Sha256::digest(bytes);
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_a_command_line_survive_a_shell() {
        assert_eq!(quoted("scenes/teapot.toml"), "scenes/teapot.toml");
        assert_eq!(quoted("my scene.toml"), "'my scene.toml'");
        assert_eq!(quoted("it's"), "'it'\\''s'");
        assert_eq!(quoted(""), "''");
    }
}
