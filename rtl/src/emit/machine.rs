//! Beam machines of any words and slots: hardware that is fitted to a scene.
//!
//! Widths are constants of the compiler. A program with one call of [`emit_machine`] for each set of words, and [`serve`] around them, is compiled
//! where a machine is wanted; the blocks that it instantiates are those of this crate.

use super::collect::collect;
use super::{EmitError, Emitted, Heading, merge, module_texts, names, ports};
use crate::format::{MOST_OBJECTS, MOST_PLANES};
use crate::machine::beam::Beam;
use crate::machine::slot_shape::SlotShape;
use serde::{Deserialize, Serialize};
use std::fmt::Write;
use std::io::{Read, Write as _};

/// The words from which all others of a machine follow, in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct MachineWords {
    /// Depth word `W`.
    pub depth: usize,
    /// Root `K`.
    pub root: usize,
    /// Last digits of the root that are not computed.
    pub dropped_rows: usize,
    /// Plane word `P`.
    pub plane: usize,
    /// Normal component.
    pub normal: usize,
    /// Guard bits of f1.
    pub guard_linear: usize,
    /// Guard bits of f2.
    pub guard_quadratic: usize,
}

/// A beam machine.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct MachineRequest {
    /// Its words.
    pub words: MachineWords,
    /// Rows of the root network between registers.
    pub rows_per_stage: usize,
    /// Its slots.
    pub slots: Vec<SlotShape>,
    /// Before the name of every module; may be empty.
    pub prefix: String,
    /// The command line that makes the same text, for the header.
    pub command: String,
}

/// Constant parameters of [`emit_machine`].
pub const PARAMETERS: usize = 14;

impl MachineWords {
    /// The parameters of [`emit_machine`] in their order: `W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G, B`.
    pub fn parameters(&self) -> [usize; PARAMETERS] {
        let Self {
            depth,
            root,
            dropped_rows,
            plane,
            normal,
            guard_linear,
            guard_quadratic,
        } = *self;
        let rows = root - dropped_rows;
        let sum = depth + 2;
        let (linear, quadratic) = (sum + guard_linear, 2 * root + guard_quadratic);
        let normal_part = normal + 8;
        // A word of the screen box has 24 bits.
        let bus = [linear, quadratic, plane, normal_part, 24];
        let bus = bus.into_iter().fold(0, usize::max);
        [
            depth,
            rows + 1,
            sum,
            2 * rows,
            plane,
            rows,
            rows + 2,
            root,
            linear,
            quadratic,
            normal,
            normal - 1,
            normal_part,
            bus,
        ]
    }
}

impl MachineRequest {
    /// Checks every count; the words are those of a format that the models accept, or the program does not compile.
    fn check(&self) -> Result<(), EmitError> {
        let range = |parameter, value, least, most| {
            if (least..=most).contains(&value) {
                Ok(())
            } else {
                Err(EmitError::Range {
                    parameter,
                    value,
                    least,
                    most,
                })
            }
        };
        range("objects", self.slots.len(), 1, MOST_OBJECTS)?;
        for slot in &self.slots {
            range("planes", slot.planes, 0, MOST_PLANES)?;
        }
        let rows = self.words.root - self.words.dropped_rows;
        range("rows per stage", self.rows_per_stage, 1, rows)?;
        if self.prefix.is_empty() {
            Ok(())
        } else {
            names::check_prefix(&self.prefix)
        }
    }
}

/// The Verilog of a machine whose words are the constant parameters: those of [`MachineWords::parameters`], in that order.
///
/// # Errors
///
/// When a count is out of its range, or a prefix begins no identifier.
pub fn emit_machine<
    const W: usize,
    const W1: usize,
    const S: usize,
    const F: usize,
    const P: usize,
    const R: usize,
    const R2: usize,
    const K: usize,
    const E1: usize,
    const E2: usize,
    const N: usize,
    const N1: usize,
    const G: usize,
    const B: usize,
>(
    request: &MachineRequest,
) -> Result<Emitted, EmitError> {
    request.check()?;
    let rows = request.rows_per_stage;
    let scope = collect(
        Beam::<W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G, B>::of_slots(&request.slots, rows),
    )?;
    let ports = ports(&scope);
    let latency = Beam::<W, W1, S, F, P, R, R2, K, E1, E2, N, N1, G, B>::latency_of_slots(
        &request.slots,
        rows,
    );
    let top = format!("{}beam", request.prefix);
    let heading = Heading {
        top: &top,
        contract: "the visible surface of the objects of a scene, in the words and slots that the scene requires",
        parameters: parameters(request),
        latency,
        error: "exact in its integer words; the contract beside it states how far they are from the scene",
        source: "architecture, 7",
        ports: &ports,
        command: &request.command,
    };
    let header = heading.text();
    Ok(Emitted {
        header,
        modules: module_texts(merge::modules(&scope, &request.prefix)?),
        top,
        ports,
        latency,
    })
}

/// What the header says of the words and slots.
fn parameters(request: &MachineRequest) -> Vec<String> {
    let words = &request.words;
    let mut lines = vec![
        format!("depth word {}", words.depth),
        format!(
            "root {}, of which the last {} digits are zero",
            words.root, words.dropped_rows
        ),
        format!("plane word {}", words.plane),
        format!("normal component {}", words.normal),
        format!(
            "guard bits {} of f1, {} of f2",
            words.guard_linear, words.guard_quadratic
        ),
        format!("rows per stage {}", request.rows_per_stage),
    ];
    let mut slots = String::from("slots, by their planes, v with half B:");
    for slot in &request.slots {
        let halves = if slot.two_volumes { "v" } else { "" };
        let _ = write!(slots, " {}{halves}", slot.planes);
    }
    lines.push(slots);
    lines
}

/// A set of words with the call that emits its machines.
pub type Entry = (
    [usize; PARAMETERS],
    fn(&MachineRequest) -> Result<Emitted, EmitError>,
);

/// Reads requests as a JSON list from standard input, and writes for each of them, in order, its Verilog or a refusal, as a JSON list.
///
/// # Errors
///
/// When the input is no such list or has words that no entry is for, or a stream breaks.
pub fn serve(entries: &[Entry]) -> Result<(), String> {
    let mut text = String::new();
    let input = std::io::stdin().read_to_string(&mut text);
    input.map_err(|error| error.to_string())?;
    let requests: Vec<MachineRequest> =
        serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let mut answers = Vec::new();
    for request in &requests {
        let parameters = request.words.parameters();
        let entry = entries.iter().find(|(words, _)| *words == parameters);
        let (_, emit) = entry.ok_or_else(|| format!("no entry for {parameters:?}"))?;
        answers.push(emit(request).map_err(|error| error.to_string()));
    }
    let text = serde_json::to_string(&answers).map_err(|error| error.to_string())?;
    let output = std::io::stdout().write_all(text.as_bytes());
    output.map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::Unit;
    use crate::emit::{EmitRequest, emit};

    const BASE: MachineWords = MachineWords {
        depth: 16,
        root: 16,
        dropped_rows: 0,
        plane: 28,
        normal: 16,
        guard_linear: 0,
        guard_quadratic: 0,
    };

    fn request(slots: &[(usize, bool)]) -> MachineRequest {
        let slots = slots.iter();
        MachineRequest {
            words: BASE,
            rows_per_stage: 1,
            slots: slots
                .map(|&(planes, two_volumes)| SlotShape {
                    planes,
                    two_volumes,
                })
                .collect(),
            prefix: String::new(),
            command: "a command".into(),
        }
    }

    fn emitted(request: &MachineRequest) -> Result<Emitted, EmitError> {
        emit_machine::<16, 17, 18, 32, 28, 16, 18, 16, 18, 32, 16, 15, 24, 32>(request)
    }

    #[test]
    fn the_words_of_the_catalogue_have_the_parameters_of_the_catalogue() {
        assert_eq!(
            BASE.parameters(),
            [16, 17, 18, 32, 28, 16, 18, 16, 18, 32, 16, 15, 24, 32]
        );
    }

    /// Equal slots make the machine of the catalogue, module for module.
    #[test]
    fn equal_slots_are_the_machine_of_the_catalogue() {
        let fitted = emitted(&request(&[(2, true); 3])).unwrap();
        let catalogue = emit(&EmitRequest {
            depth_word: 16,
            planes: 2,
            objects: 3,
            ..EmitRequest::new(Unit::Beam)
        })
        .unwrap();
        assert_eq!(fitted.modules, catalogue.modules);
        assert_eq!(fitted.latency, catalogue.latency);
    }

    #[test]
    fn a_machine_of_different_slots_waits_for_the_longest() {
        let fitted = emitted(&request(&[(0, false), (2, true), (3, false)])).unwrap();
        // Raster control, root, planes, and what is around them, the tree of three inputs.
        assert_eq!(fitted.latency, 1 + (16 + 2 + 7) + 2);
        let text = fitted.bundle();
        assert!(text.contains("slots, by their planes, v with half B: 0 2v 3"));
        let has = |name: &str| fitted.modules.iter().any(|(module, _)| module == name);
        assert!(has("two_volume_merge") && has("word_delay_w12_x1"));
        let single = emitted(&request(&[(0, false), (1, false)])).unwrap();
        assert!(!single.modules.iter().any(|(m, _)| m == "two_volume_merge"));
    }

    #[test]
    fn counts_out_of_range_are_refused() {
        assert!(emitted(&request(&[])).is_err());
        assert!(emitted(&request(&[(13, false)])).is_err());
        let prefixed = MachineRequest {
            prefix: "9".into(),
            ..request(&[(0, false)])
        };
        assert!(emitted(&prefixed).is_err());
        let deep = MachineRequest {
            rows_per_stage: 17,
            ..request(&[(0, false)])
        };
        assert!(emitted(&deep).is_err());
    }
}
