//! From a design to a library: its wrapper and C interface, Verilator, the C++ compiler, and the cache.

use crate::engine::design::Source;
use imogene_tools::{COMPILER, FileError, ToolError, VERILATOR, digest, made, write};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock};

/// Environment variable that names the folder of the compiled libraries.
pub const CACHE_VARIABLE: &str = "IMOGENE_CACHE";

/// Environment variable with options of the C++ compiler that are added to ours, as in `-O3 -march=native`.
const COMPILER_VARIABLE: &str = "IMOGENE_CXXFLAGS";

/// Options that shape the code; a change of them makes new libraries.
const VERILATOR_OPTIONS: &str = "--cc -O3 --x-assign fast -Wno-fatal -Wno-lint -Wno-style";
/// No symbol of one library may stand for that of another in the same process, hence the hidden and not unique symbols.
const COMPILER_OPTIONS: &str = "-std=c++17 -O2 -fPIC -fvisibility=hidden -fno-gnu-unique -w";
/// Verilator's run time, compiled once for all designs.
const RUN_TIME: [&str; 2] = ["verilated", "verilated_threads"];

const WRAPPER: &str = "imogene_wrapper";
/// Class that Verilator makes of it.
const CLASS: &str = "Vimogene";

/// Symbols of the C interface, as the loader wants them.
pub(super) const CREATE: &[u8] = b"imogene_create\0";
pub(super) const DESTROY: &[u8] = b"imogene_destroy\0";
pub(super) const CLOCK: &[u8] = b"imogene_clock\0";

/// Versions of the programs and the folder of Verilator's run time, asked for once per process.
struct Tools {
    versions: String,
    root: PathBuf,
}

fn tools() -> Result<&'static Tools, ToolError> {
    static TOOLS: OnceLock<Tools> = OnceLock::new();
    if let Some(tools) = TOOLS.get() {
        return Ok(tools);
    }
    let here = Path::new(".");
    let verilator = VERILATOR.run(["--version"], here)?;
    let compiler = COMPILER.run(["--version"], here)?;
    let root = VERILATOR.run(["--getenv", "VERILATOR_ROOT"], here)?;
    let compiler = compiler.lines().next().unwrap_or_default();
    Ok(TOOLS.get_or_init(|| Tools {
        versions: format!("{}\n{compiler}", verilator.trim()),
        root: root.trim().into(),
    }))
}

/// Where compiled libraries are kept: the folder that the variable [`CACHE_VARIABLE`] names, else the build folder that
/// this program was built in, else the user's cache folder, else the folder for temporary files.
pub fn cache_folder() -> PathBuf {
    if let Some(folder) = std::env::var_os(CACHE_VARIABLE) {
        return folder.into();
    }
    let user = || {
        let cache = std::env::var_os("XDG_CACHE_HOME").map(PathBuf::from);
        cache.or_else(|| Some(PathBuf::from(std::env::var_os("HOME")?).join(".cache")))
    };
    let folder = build_folder().or_else(|| user().map(|folder| folder.join("imogene")));
    folder
        .unwrap_or_else(std::env::temp_dir)
        .join("verilator-cache")
}

/// The build folder around this program, known by the mark that Cargo puts there.
fn build_folder() -> Option<PathBuf> {
    let program = std::env::current_exe().ok()?;
    let mut folders = program.ancestors().skip(1);
    folders
        .find(|folder| folder.join("CACHEDIR.TAG").is_file())
        .map(Path::to_path_buf)
}

/// The library of a design, made with more options of Verilator and of the compiler than ours unless it is kept.
pub(super) fn library(source: &Source, [verilator, more]: [&str; 2]) -> Result<PathBuf, ToolError> {
    let verilog = format!("{}\n{}", source.text, wrapper(source));
    let shim = shim(source.inputs.len(), source.outputs.len());
    let tools = tools()?;
    let of_user = std::env::var(COMPILER_VARIABLE).unwrap_or_default();
    let more = more.split_whitespace().chain(of_user.split_whitespace());
    let more = COMPILER_OPTIONS.split(' ').chain(more);
    let mut compiler: Vec<String> = more.map(String::from).collect();
    for folder in ["include", "include/vltstd"] {
        compiler.extend(["-I".into(), tools.root.join(folder).display().to_string()]);
    }
    let more = verilator.split_whitespace();
    let verilator: Vec<&str> = VERILATOR_OPTIONS.split(' ').chain(more).collect();
    let options = format!("{}\n{}", verilator.join(" "), compiler.join(" "));
    let name = digest([&*verilog, &shim, &tools.versions, &options]);
    let cache = cache_folder();
    let path = cache.join(format!("{name}.so"));
    made(&path, |folder| {
        let run_time = run_time(&cache, tools, &compiler, &options)?;
        write(&folder.join("design.v"), &verilog)?;
        write(&folder.join("shim.cpp"), &shim)?;
        let placing = format!("--prefix {CLASS} --top-module {WRAPPER} --Mdir cpp design.v");
        VERILATOR.run(verilator.into_iter().chain(placing.split(' ')), folder)?;
        link(folder, &compiler, &run_time)
    })?;
    Ok(path)
}

/// Compiles what Verilator wrote as one file, and links it; the name of the library.
fn link(
    folder: &Path,
    compiler: &[String],
    run_time: &[PathBuf],
) -> Result<&'static str, ToolError> {
    let generated = folder.join("cpp");
    let entries = std::fs::read_dir(&generated).map_err(FileError::at(&generated))?;
    let mut files: Vec<String> = entries
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| name.ends_with(".cpp"))
        .map(|name| format!("#include \"cpp/{name}\"\n"))
        .collect();
    files.sort();
    let unit = format!("#include \"shim.cpp\"\n{}", files.concat());
    write(&folder.join("all.cpp"), &unit)?;
    let mut arguments = compiler.to_vec();
    arguments.extend(["-I", "cpp", "-shared", "-o", "design.so", "all.cpp"].map(String::from));
    arguments.extend(run_time.iter().map(|path| path.display().to_string()));
    arguments.push("-pthread".into());
    COMPILER.run(arguments, folder)?;
    Ok("design.so")
}

/// Objects of Verilator's run time, compiled unless they are kept.
fn run_time(
    cache: &Path,
    tools: &Tools,
    compiler: &[String],
    options: &str,
) -> Result<Vec<PathBuf>, ToolError> {
    // One thread of a process compiles them. Two processes may both: the later renaming wins with equal files.
    static ONE: Mutex<()> = Mutex::new(());
    let _guard = ONE.lock().unwrap_or_else(|broken| broken.into_inner());
    let name = digest([&*tools.versions, options]);
    let object = |part: &str| {
        let path = cache.join(format!("{part}-{}.o", &name[..16]));
        made(&path, |folder| -> Result<_, ToolError> {
            let source = tools.root.join(format!("include/{part}.cpp"));
            let mut arguments = compiler.to_vec();
            arguments.extend(["-c", "-o", "part.o"].map(String::from));
            arguments.push(source.display().to_string());
            COMPILER.run(arguments, folder)?;
            Ok("part.o")
        })?;
        Ok(path)
    };
    RUN_TIME.into_iter().map(object).collect()
}

/// A module whose ports have numbers: a port of the design may be named like a word of C++.
fn wrapper(source: &Source) -> String {
    let mut ports = String::from("    input wire clock");
    let mut connections = String::from("        .clock(clock)");
    for (direction, prefix, signals) in [
        ("input", "in", source.inputs),
        ("output", "out", source.outputs),
    ] {
        for (index, signal) in signals.iter().enumerate() {
            let high = signal.width - 1;
            let _ = write!(ports, ",\n    {direction} wire [{high}:0] {prefix}{index}");
            let _ = write!(connections, ",\n        .{}({prefix}{index})", signal.name);
        }
    }
    let top = source.top;
    format!("module {WRAPPER} (\n{ports}\n);\n    {top} unit (\n{connections}\n    );\nendmodule\n")
}

/// The C interface. One call is one clock: the inputs change after the falling edge, so that a register on the wrong
/// edge is seen, and settle before the rising edge, which Verilator sees to; the outputs are those after it.
fn shim(inputs: usize, outputs: usize) -> String {
    let mut set = String::new();
    for index in 0..inputs {
        let _ = writeln!(set, "    m.in{index} = inputs[{index}];");
    }
    let mut get = String::new();
    for index in 0..outputs {
        let _ = writeln!(get, "    outputs[{index}] = m.out{index};");
    }
    format!(
        "#include \"{CLASS}.h\"
#include \"verilated.h\"
#include <cstdint>

double sc_time_stamp() {{ return 0; }}

struct State {{
    VerilatedContext context;
    {CLASS} model;
    State() : context(), model(&context) {{}}
}};

#define EXPORT extern \"C\" __attribute__((visibility(\"default\")))

EXPORT void* imogene_create() {{ return new State(); }}

EXPORT void imogene_destroy(void* state) {{ delete static_cast<State*>(state); }}

EXPORT void imogene_clock(void* state, const uint64_t* inputs, uint64_t* outputs) {{
    {CLASS}& m = static_cast<State*>(state)->model;
    (void)inputs;
    m.clock = 0;
    m.eval();
{set}    m.clock = 1;
    m.eval();
{get}}}
"
    )
}
