//! `imogene units`.

use crate::failure::Failure;
use crate::output;
use imogene_contract::Unit;
use imogene_contract::parameters::PARAMETERS;
use serde::Serialize;
use serde_json::json;

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
    let symbols = PARAMETERS.iter();
    let symbols = symbols.map(|p| format!("{} --{}", p.symbol, p.option));
    let symbols: Vec<String> = symbols.collect();
    let page = json!({ "units": units, "symbols": symbols });
    let page = output::page(include_str!("units.txt"), page)?;
    output::report(json, &units, |_| output::text(page));
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
