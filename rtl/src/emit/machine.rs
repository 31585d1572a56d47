//! Beam machines of any words and slots: hardware that is fitted to a scene.

use super::words::{check_slots, check_words, lines, slots_line};
use super::{Emitted, Heading, circuit, names};
pub use imogene_circuits::machine::Slot;
use imogene_circuits::machine::{Beam, Load, Zone, beam};
pub use imogene_circuits::machines::MachineWords;
use imogene_circuits::machines::objects;
use imogene_contract::RequestError;
use imogene_hdl::Design;

/// A beam machine.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct MachineRequest {
    /// Its words.
    pub words: MachineWords,
    /// Rows of the root network between registers.
    pub rows_per_stage: usize,
    /// Its slots.
    pub slots: Vec<Slot>,
    /// Before the name of every module; may be empty.
    pub prefix: String,
    /// The command line that makes the same text, for the header.
    pub command: String,
}

impl MachineRequest {
    fn check(&self) -> Result<(), RequestError> {
        check_words(&self.words, self.rows_per_stage)?;
        check_slots(&self.slots)?;
        names::check_optional(&self.prefix)
    }

    fn machine(&self) -> Beam {
        objects(&self.words, self.rows_per_stage as u32, self.slots.clone())
    }

    /// The circuit of the machine.
    ///
    /// # Errors
    ///
    /// When a number is out of its range, or a prefix begins no identifier.
    pub fn design(&self) -> Result<Design, RequestError> {
        self.check()?;
        let machine = self.machine();
        let load = || Load::input(machine.widths.bus());
        Ok(Design::of(|| {
            beam("top", Zone::input(), load(), &machine);
        }))
    }
}

/// The Verilog of a machine.
///
/// # Errors
///
/// When a count is out of its range, or a prefix begins no identifier.
pub fn emit_machine(request: &MachineRequest) -> Result<Emitted, RequestError> {
    let design = request.design()?;
    let ports = circuit::ports(&design);
    let latency = request.machine().latency() as usize;
    let mut parameters = lines(&request.words, request.rows_per_stage);
    parameters.push(slots_line(&request.slots));
    let top = format!("{}beam", request.prefix);
    let heading = Heading {
        top: &top,
        contract: "the visible surface of the objects of a scene, in the words and slots that the scene requires",
        parameters,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::emit;
    use imogene_contract::{Request, Unit};

    const BASE: MachineWords = MachineWords::of(16);

    fn request(slots: &[(usize, bool)]) -> MachineRequest {
        let slots = slots.iter();
        MachineRequest {
            words: BASE,
            rows_per_stage: 1,
            slots: slots
                .map(|&(planes, two_volumes)| Slot {
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
        let refused = |words: MachineWords| {
            let request = MachineRequest {
                words,
                ..request(&[(0, false)])
            };
            emit_machine(&request).unwrap_err().to_string()
        };
        for depth in [7, 33] {
            let text = refused(MachineWords::of(depth));
            assert!(text.contains("legal values are 8 to 32"), "{text}");
        }
        let guarded = |depth, guard_linear, guard_quadratic| MachineWords {
            guard_linear,
            guard_quadratic,
            ..MachineWords::of(depth)
        };
        assert!(refused(guarded(24, 17, 0)).contains("guard bits of f1 = 17"));
        assert!(refused(guarded(30, 0, 5)).contains("legal values are 0 to 4"));
    }
}
