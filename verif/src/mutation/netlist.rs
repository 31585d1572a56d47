//! Mutants of a unit's netlist.
//!
//! Yosys elaborates the emitted Verilog and lists mutants: one bit of one cell port inverted, stuck, or disturbed by
//! another bit. All of them go into one design that an input selects from, which is compiled once; each mutant is then
//! run on the unit's own stimulus against the golden model until the first difference. What nothing kills Yosys may
//! prove equivalent.
//!
//! First with the registers cut: for every state that the facts allow, next state and outputs of unit and mutant are
//! equal. Where that fails, over time: by induction from the initial state. The base case of the induction also tells
//! when a mutant *does* differ.

pub mod cut;
pub mod facts;
pub mod mutant;

use super::score::{Fate, Kill, MutationError, MutationReport, Options};
use super::vectors::vectors;
use crate::engine::design::Source;
use crate::engine::verilator::Model;
use crate::subject::Subject;
use cut::{cut, cut_command};
use facts::{ASSUMED, Proof, assume};
use imogene_tools::{ToolError, read, scratch, write, yosys};
use mutant::{Mutant, SOURCE, all_mutants, elaborate, selector};
use rayon::prelude::*;
use std::path::Path;
use std::time::Instant;

/// Makes mutants of a unit's emitted Verilog, the name of its module and the text, kills them, and proves the rest
/// equivalent where that is so.
///
/// `on_done` is called once for each mutant, from any thread.
pub fn run(
    subject: &Subject,
    (top, text): (&str, &str),
    options: &Options,
    on_done: impl Fn() + Sync,
) -> Result<MutationReport, MutationError> {
    let started = Instant::now();
    let scratch = scratch()?;
    let folder = scratch.path();
    write(&folder.join(SOURCE), text)?;
    let (mutants, candidates) = elaborate(folder, top, text, options)?;
    let kills = kills(subject, top, folder, &mutants, options)?;
    let judge = Judge::new(folder, top, subject, options)?;
    let fates = mutants.par_iter().zip(kills).map(|(mutant, kill)| {
        let fate = match kill {
            Some(kill) => Fate::Killed(kill),
            None => judge.survivor(mutant)?,
        };
        on_done();
        Ok::<_, ToolError>(fate)
    });
    let fates: Vec<Fate> = fates.collect::<Result<_, _>>()?;
    let mut report = MutationReport::of(&subject.name, &subject.options);
    for (mutant, fate) in mutants.iter().zip(fates) {
        report.count(fate, options.clocks, || mutant.text.clone());
    }
    report.candidates = candidates;
    Ok(report.ended(started))
}

/// Where each mutant was killed: stimulus and clock.
fn kills(
    subject: &Subject,
    top: &str,
    folder: &Path,
    mutants: &[Mutant],
    options: &Options,
) -> Result<Vec<Option<Kill>>, MutationError> {
    let text = all_mutants(folder, top, mutants)?;
    let mut inputs = subject.inputs.clone();
    inputs.push(selector(mutants.len()));
    let source = Source {
        top,
        text: &text,
        inputs: &inputs,
        outputs: &subject.outputs,
    };
    // Without a pass of Verilator 5.006 that makes wrong code of a netlist of a thousand mutants.
    let model = Model::compile(&source, ["-fno-dfg", ""])?;
    let vectors = vectors(subject, options.clocks, 0..options.stimuli);
    let first = |mutant: usize| {
        let mut all = vectors.iter().enumerate();
        all.find_map(|(stimulus, vectors)| {
            let mut unit = model.instance();
            let mut found = vec![0; subject.outputs.len()];
            let clock = vectors.first(|_, given, stated| {
                let given: Vec<u64> = given.iter().copied().chain([mutant as u64]).collect();
                unit.clock_words(&given, &mut found);
                stated.differs(&found)
            })?;
            Some((stimulus, clock))
        })
    };
    if let Some((stimulus, clock)) = first(0) {
        let unit = subject.name.clone();
        return Err(MutationError::Baseline(unit, stimulus, clock));
    }
    let kills = mutants.par_iter().map(|mutant| first(mutant.number));
    Ok(kills.collect())
}

/// Steps of the induction at most.
const STEPS: u32 = 40;

/// Judges what the campaign left.
struct Judge<'a> {
    folder: &'a Path,
    top: &'a str,
    /// Clocks from an input to its result.
    latency: usize,
    /// Text of the netlist with the facts.
    netlist: String,
    begins_at_zero: bool,
    facts: Proof,
    seconds: u32,
}

/// The netlist with the facts and cut registers.
const CUT: &str = "cut.il";

impl<'a> Judge<'a> {
    fn new(
        folder: &'a Path,
        top: &'a str,
        subject: &Subject,
        options: &Options,
    ) -> Result<Judge<'a>, MutationError> {
        let facts = assume(folder, top, &subject.name)?;
        let netlist = read(&folder.join(ASSUMED))?;
        write(&folder.join(CUT), &cut(&netlist))?;
        let lines = netlist.lines();
        let mut initial = lines.filter(|line| line.contains("attribute \\init "));
        let begins_at_zero = initial.all(|line| {
            let bits = line.rsplit(['\'', ' ']).next().unwrap_or_default();
            !bits.contains(|c: char| c.is_ascii_digit() && c != '0')
        });
        Ok(Judge {
            folder,
            top,
            latency: subject.latency,
            begins_at_zero,
            facts,
            netlist,
            seconds: options.proof_seconds,
        })
    }

    fn survivor(&self, mutant: &Mutant) -> Result<Fate, ToolError> {
        let command = cut_command(&mutant.command, &mutant.cell, &self.netlist);
        let cut = self.prove(mutant.number, CUT, &command, "sat")?;
        if cut.contains("SUCCESS") {
            return Ok(Fate::Equivalent);
        }
        // Nothing is stated of the outputs before the first result is there.
        let latency = self.latency;
        let time = format!("sat -tempinduct -set-init-zero -seq {latency} -maxsteps {STEPS}");
        let time = match self.begins_at_zero {
            true => self.prove(mutant.number, ASSUMED, &mutant.command, &time)?,
            false => String::new(),
        };
        if time.contains("SUCCESS") {
            return Ok(Fate::Equivalent);
        }
        let reason = if time.contains("model found for base case") {
            "It differs from the unit on some input: the stimulus is too weak, or the contract leaves that input open".into()
        } else {
            let without = match self.facts {
                Proof::Proven(_) => "",
                Proof::Failed => ", without the facts of its registers, whose proof failed",
            };
            let seconds = self.seconds;
            format!(
                "Undecided: no stimulus found a difference, and no proof within {seconds} s{without}"
            )
        };
        Ok(Fate::Survived(reason))
    }

    /// One attempt on a netlist; returns what Yosys said.
    fn prove(
        &self,
        number: usize,
        netlist: &str,
        command: &str,
        sat: &str,
    ) -> Result<String, ToolError> {
        let (top, seconds) = (self.top, self.seconds);
        // Merging leaves one copy of all that the mutation does not touch.
        let script = format!(
            "read_rtlil {netlist}\nsetattr -unset init w:*\ncopy {top} gate\ndelete gate/t:$assume\n\
             mutate -module gate {command}\nmiter -equiv -make_assert -flatten {top} gate miter\nhierarchy -top miter\n\
             opt_merge -share_all\nopt_clean\n\
             {sat} -prove-asserts -set-assumes -timeout {seconds} miter\n"
        );
        yosys(self.folder, &format!("{netlist}_{number}.ys"), &script)
    }
}
