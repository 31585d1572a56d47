//! Which mutants that nothing killed are no mutants at all: proofs of equivalence by Yosys.
//!
//! First with the registers cut: for every state that the facts allow, next state and outputs of unit and mutant are
//! equal. Where that fails, over time: by induction from the initial state. The base case of the induction also tells
//! when a mutant *does* differ.

use super::cut::{cut, cut_command};
use super::facts::{ASSUMED, Proof, assume};
use super::mutant::Mutant;
use crate::mutation::score::{Fate, Kill, MutationError, Options};
use crate::subject::Subject;
use imogene_tools::{ToolError, read, write, yosys};
use rayon::prelude::*;
use std::path::Path;

/// Steps of the induction at most.
const STEPS: u32 = 40;

/// Judges what the campaign left.
pub(super) struct Judge<'a> {
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
    pub(super) fn new(
        folder: &'a Path,
        top: &'a str,
        subject: &Subject,
        options: &Options,
    ) -> Result<Judge<'a>, MutationError> {
        let facts = assume(folder, top, &subject.name)?;
        let netlist = read(&folder.join(ASSUMED))?;
        write(&folder.join(CUT), &cut(&netlist))?;
        let mut initial = netlist
            .lines()
            .filter(|line| line.contains("attribute \\init "));
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

    /// The fate of each mutant; `kills` says where those that are dead were killed.
    pub(super) fn judge(
        &self,
        mutants: &[Mutant],
        kills: Vec<Option<Kill>>,
        on_done: &(impl Fn() + Sync),
    ) -> Result<Vec<Fate>, MutationError> {
        let judged = mutants.par_iter().zip(kills).map(|(mutant, kill)| {
            let fate = match kill {
                Some(kill) => Fate::Killed(kill),
                None => self.survivor(mutant)?,
            };
            on_done();
            Ok(fate)
        });
        judged.collect()
    }

    fn survivor(&self, mutant: &Mutant) -> Result<Fate, ToolError> {
        if mutant.port == "CLK" {
            let reason = "It changes the clock of a register, which the proofs do not model";
            return Ok(Fate::Survived(reason.into()));
        }
        let command = cut_command(&mutant.command, &mutant.cell, &self.netlist);
        let cut = self.prove(mutant.number, CUT, &command, "sat")?;
        if cut.contains("SUCCESS") {
            return Ok(Fate::Equivalent);
        }
        // Nothing is stated of the outputs before the first result is there.
        let time = format!(
            "sat -tempinduct -set-init-zero -seq {} -maxsteps {STEPS}",
            self.latency
        );
        let time = if self.begins_at_zero {
            self.prove(mutant.number, ASSUMED, &mutant.command, &time)?
        } else {
            String::new()
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
            format!(
                "Undecided: no stimulus found a difference, and no proof within {} s{without}",
                self.seconds
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
