//! The machine code of units: its bytes, and a number that changes with any of them. With a unit and a file the code of
//! one lane goes there, for `objdump -D -b binary -m i386:x86-64 -M intel FILE`.

use imogene_compiled::Program;
use imogene_contract::{Request, Unit};
use std::error::Error;
use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let wanted = arguments.first();
    let units = Unit::ALL.iter().copied();
    for unit in units.filter(|unit| wanted.is_none_or(|wanted| unit.name() == wanted)) {
        let design = imogene_rtl::emit::design(&Request::new(unit))?;
        for compile in [Program::new, Program::in_lanes, Program::on_one_stimulus] {
            let program = compile(&design, &[]);
            let code = program.machine_code().ok_or("this processor has no AVX2")?;
            let digest = BuildHasherDefault::<DefaultHasher>::default().hash_one(code);
            let (name, lanes, bytes) = (unit.name(), program.lanes(), code.len());
            println!("{name}, lanes {lanes}: {bytes} bytes, {digest:016x}");
            if let (Some(file), 1) = (arguments.get(1), lanes) {
                std::fs::write(file, code)?;
            }
        }
    }
    Ok(())
}
