//! The checks of solids.

use super::error::SceneError;
use super::file::SceneFile;
use super::limits::{Checked, check_count, check_name, check_new, unless};
use super::names::known;
use super::shape::{Processor, Shape, Surface};
use super::solid::{MAX_LEAVES, Operand, Operation};
use std::collections::HashSet;
use std::fmt::Arguments;

impl SceneFile {
    pub(super) fn check_solids(&self) -> Checked {
        let mut names = HashSet::new();
        for (index, solid) in self.solids.iter().enumerate() {
            check_name(format_args!("solids[{index}].name"), &solid.name)?;
            let place = format_args!("solid `{}`", solid.name);
            check_new(names.insert(&solid.name), place, "solid")?;
            check_operation(place, &solid.of)?;
            let named = solid.of.names();
            check_count(place, named.len(), "objects are named in it", MAX_LEAVES)?;
            named
                .into_iter()
                .try_for_each(|name| self.check_member(place, name))?;
        }
        Ok(())
    }

    /// Refuses what is no volume along every line of sight, or is not drawn by a quadric processor.
    fn check_member(&self, place: Arguments, name: &str) -> Checked {
        let place = format_args!("{place}, object `{name}`");
        let Some(object) = self.objects.iter().find(|object| object.name == name) else {
            let names = self.objects.iter().map(|o| o.name.as_str());
            let (problem, accepted) = ("there is no such object", known(names, "`[[objects]]`"));
            return Err(SceneError::value(place, problem, accepted));
        };
        let is_volume = object.mode == Surface::Solid
            && !matches!(
                object.shape,
                Shape::Mesh(_) | Shape::TetrahedronPatch { .. }
            );
        let accepted = "solids are made of objects with `mode = \"solid\"`";
        unless(is_volume, place, "it is a surface without inside", accepted)?;
        let is_drawn = matches!(object.processor, None | Some(Processor::Quadric));
        let accepted =
            "objects of solids have the quadric processor, which is theirs if none is given";
        unless(is_drawn, place, "its processor hands on no back", accepted)
    }
}

fn check_operation(place: Arguments, operation: &Operation) -> Checked {
    let problem = "an operation has too few operands";
    let accepted = "a union, an intersection or a difference has two operands at least";
    unless(operation.operands().len() >= 2, place, problem, accepted)?;
    let mut operands = operation.operands().iter();
    operands.try_for_each(|operand| match operand {
        Operand::Operation(operation) => check_operation(place, operation),
        Operand::Object(_) => Ok(()),
    })
}
