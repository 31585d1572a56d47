//! The text of the program.

use imogene_rtl::emit::machine::{MachineRequest, PARAMETERS};
use std::collections::BTreeSet;
use std::path::Path;

/// The manifest: a workspace of its own, with the versions that this one has locked.
pub(crate) fn manifest(rtl: &Path) -> String {
    format!(
        "[package]\nname = \"imogene-fitted\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
         [dependencies]\nimogene-rtl = {{ path = {rtl:?} }}\n\n[workspace]\n\n\
         # The program runs for a moment; it is compiled for each set of words.\n\
         [profile.release.package.imogene-fitted]\nopt-level = 0\n\n\
         [profile.release.package.imogene-rtl]\nopt-level = 0\n"
    )
}

/// The program: one entry for each set of words.
pub(crate) fn source(requests: &[MachineRequest]) -> String {
    let sets: BTreeSet<[usize; PARAMETERS]> =
        requests.iter().map(|r| r.words.parameters()).collect();
    let entries = sets.iter().map(|words| {
        let list: Vec<String> = words.iter().map(usize::to_string).collect();
        let list = list.join(", ");
        format!("        ([{list}], emit_machine::<{list}>),\n")
    });
    let entries: String = entries.collect();
    format!(
        "//! Beam machines of the words that were asked for; written by imogene.\n\n\
         use imogene_rtl::emit::machine::{{emit_machine, serve}};\n\n\
         fn main() -> Result<(), String> {{\n    serve(&[\n{entries}    ])\n}}\n"
    )
}
