//! Beam machines of any words and slots: hardware that is fitted to a scene.

use super::{EmitError, Emitted, Heading, circuit, names};
use crate::format::{MOST_OBJECTS, MOST_PLANES};
use imogene_circuits::machine::{Beam, Load, Slot, Zone, beam};
use imogene_circuits::object::{Network, Widths};
use imogene_hdl::Design;
use std::fmt::Write;

/// The words from which all others of a machine follow, in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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

/// Shape of the quadric processor of a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SlotShape {
    /// Cut planes, 0 to 12.
    pub planes: usize,
    /// With half B, for objects of class front.
    pub two_volumes: bool,
}

impl SlotShape {
    /// A processor for every class of object.
    pub const fn full(planes: usize) -> Self {
        Self {
            planes,
            two_volumes: true,
        }
    }
}

/// A beam machine.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
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

    /// The machine.
    fn machine(&self) -> Beam {
        let words = self.words;
        let (sum, root) = (words.depth + 2, words.root - words.dropped_rows);
        Beam {
            depth: words.depth as u32,
            widths: Widths {
                linear: (sum + words.guard_linear) as u32,
                quadratic: (2 * words.root + words.guard_quadratic) as u32,
                gradient: words.normal as u32 + 8,
                normal: words.normal as u32,
                plane: words.plane as u32,
            },
            root: Network {
                sum: sum as u32,
                digits: words.root as u32,
                rows: root as u32,
                rows_per_stage: self.rows_per_stage as u32,
            },
            slots: self
                .slots
                .iter()
                .map(|slot| Slot {
                    planes: slot.planes,
                    two_volumes: slot.two_volumes,
                })
                .collect(),
        }
    }
}

/// The Verilog of a machine.
///
/// # Errors
///
/// When a count is out of its range, or a prefix begins no identifier.
pub fn emit_machine(request: &MachineRequest) -> Result<Emitted, EmitError> {
    request.check()?;
    let machine = request.machine();
    let design = Design::of(|| {
        beam(
            "top",
            Zone::input(),
            Load::input(machine.widths.bus()),
            &machine,
        );
    });
    let ports = circuit::ports(&design);
    let latency = machine.latency() as usize;
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
    Ok(Emitted {
        header: heading.text(),
        modules: circuit::modules(&design, &request.prefix),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::emit;
    use imogene_contract::{Request, Unit};

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

    /// Equal slots make the machine of the catalogue, module for module.
    #[test]
    fn equal_slots_are_the_machine_of_the_catalogue() {
        let fitted = emit_machine(&request(&[(2, true); 3])).unwrap();
        let catalogue = emit(&Request {
            planes: 2,
            objects: 3,
            ..Request::of(Unit::Beam, 16)
        })
        .unwrap();
        assert_eq!(fitted.modules, catalogue.modules);
        assert_eq!(fitted.latency, catalogue.latency);
    }

    #[test]
    fn a_machine_has_the_words_that_were_asked_for() {
        let words = MachineWords {
            depth: 19,
            root: 15,
            dropped_rows: 2,
            plane: 23,
            normal: 11,
            guard_linear: 3,
            guard_quadratic: 5,
        };
        let request = request(&[(1, false), (3, true)]);
        let emitted = emit_machine(&MachineRequest { words, ..request }).unwrap();
        let width = |name: &str| {
            let port = emitted.ports.iter().find(|port| port.name == name);
            port.unwrap().width
        };
        assert_eq!(["depth", "nx", "load_data"].map(width), [19, 11, 35]);
        assert_eq!(emitted.latency, 1 + (13 + 3 + 7) + 1);
        let text = emitted.bundle();
        assert!(text.contains("root 15, of which the last 2 digits are zero"));
    }

    #[test]
    fn a_machine_of_different_slots_waits_for_the_longest() {
        let fitted = emit_machine(&request(&[(0, false), (2, true), (3, false)])).unwrap();
        // Raster control, root, planes, and what is around them, the tree of three inputs.
        assert_eq!(fitted.latency, 1 + (16 + 2 + 7) + 2);
        let text = fitted.bundle();
        assert!(text.contains("slots, by their planes, v with half B: 0 2v 3"));
        let has = |name: &str| fitted.modules.iter().any(|(module, _)| module == name);
        assert!(has("two_volume_merge"));
        let single = emit_machine(&request(&[(0, false), (1, false)])).unwrap();
        assert!(!single.modules.iter().any(|(m, _)| m == "two_volume_merge"));
    }

    #[test]
    fn counts_out_of_range_are_refused() {
        assert!(emit_machine(&request(&[])).is_err());
        assert!(emit_machine(&request(&[(13, false)])).is_err());
        let prefixed = MachineRequest {
            prefix: "9".into(),
            ..request(&[(0, false)])
        };
        assert!(emit_machine(&prefixed).is_err());
        let deep = MachineRequest {
            rows_per_stage: 17,
            ..request(&[(0, false)])
        };
        assert!(emit_machine(&deep).is_err());
    }
}
