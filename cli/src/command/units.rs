//! `imogene units`.

use crate::failure::Failure;
use crate::output;
use imogene_contract::Unit;
use imogene_contract::parameters::PARAMETERS;
use serde::Serialize;

#[derive(Serialize)]
struct UnitEntry {
    name: &'static str,
    contract: &'static str,
    parameters: Vec<ParameterEntry>,
    latency: &'static str,
    source: &'static str,
}

#[derive(Serialize)]
struct ParameterEntry {
    option: String,
    range: String,
}

pub fn run(json: bool) -> Result<(), Failure> {
    let units: Vec<UnitEntry> = Unit::ALL.into_iter().map(entry).collect();
    if json {
        output::json(&units);
        return Ok(());
    }
    for unit in units {
        let options = unit.parameters.iter();
        let options = options.map(|p| format!("--{} {}", p.option, p.range));
        output::text(format!(
            "{}\n  {}\n  parameters: {}\n  latency:    {} clock{}\n  source:     {}\n",
            unit.name,
            unit.contract,
            output::joined(options, ", "),
            unit.latency,
            if unit.latency == "1" { "" } else { "s" },
            unit.source
        ));
    }
    let symbols = PARAMETERS.iter();
    let symbols = symbols.map(|p| format!("{} --{}", p.symbol, p.option));
    output::text(format!("W --format, {}", output::joined(symbols, ", ")));
    Ok(())
}

fn entry(unit: Unit) -> UnitEntry {
    let record = unit.record();
    let mut parameters = vec![ParameterEntry {
        option: "format".into(),
        range: format!("{}..32", unit.least_word()),
    }];
    parameters.extend(record.parameters.iter().map(|parameter| ParameterEntry {
        option: parameter.option.into(),
        range: parameter.range().replace(" to ", ".."),
    }));
    UnitEntry {
        name: record.name,
        contract: record.computes,
        parameters,
        latency: record.latency,
        source: record.source,
    }
}
