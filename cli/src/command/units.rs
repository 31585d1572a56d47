//! What there is: `imogene units`, `processors`, `contract` and `roots`.

use crate::arguments::{Contract, Processors, Roots};
use crate::failure::Result;
use crate::output;
use imogene_contract::Unit;
use imogene_contract::parameters::{PARAMETERS, Parameter};
use imogene_golden::format::Format;
use imogene_package::{contract, processors};
use imogene_studies::kit::page::text;
use imogene_studies::root_errors::table;
use serde::Serialize;
use serde_json::{Value, json};

#[derive(Serialize)]
struct UnitEntry {
    name: &'static str,
    contract: &'static str,
    parameters: Vec<Value>,
    latency: &'static str,
    source: &'static str,
}

pub fn units(json: bool) -> Result {
    let units: Vec<UnitEntry> = Unit::ALL.into_iter().map(entry).collect();
    let symbol = |p: &Parameter| format!("{} --{}", p.symbol, p.option);
    let symbols: Vec<String> = PARAMETERS.iter().map(symbol).collect();
    let page = json!({ "units": units, "symbols": symbols });
    let page = output::page(include_str!("units.txt"), page)?;
    output::report(json, &units, |_| output::text(page));
    Ok(())
}

fn entry(unit: Unit) -> UnitEntry {
    let record = unit.record();
    let parameter = |option: &str, range: String| json!({ "option": option, "range": range });
    let mut parameters = vec![parameter("format", format!("{}..32", unit.least_word()))];
    let others = record.parameters.iter();
    parameters.extend(others.map(|p| parameter(p.option, p.range().replace(" to ", ".."))));
    UnitEntry {
        name: record.name,
        contract: record.computes,
        parameters,
        latency: record.latency,
        source: record.source,
    }
}

pub fn processors(options: &Processors, json: bool) -> Result {
    let list = processors::processors()?;
    if let Some(path) = &options.out {
        output::write_text(path, &processors::markdown(&list))?;
    }
    let values = json!({ "processors": list });
    let page = output::page(include_str!("processors.txt"), values)?;
    output::report(json, &list, |_| output::text(page));
    Ok(())
}

pub fn contract(options: &Contract, json: bool) -> Result {
    let contract = contract::contract(&options.shape.request(&options.unit)?)?;
    let text = match json {
        true => contract.json(),
        false => contract.markdown(),
    };
    match &options.out {
        Some(path) => output::write_text(path, &text),
        None => {
            output::text(text.trim_end());
            Ok(())
        }
    }
}

pub fn roots(options: &Roots, json: bool) -> Result {
    let rows = table(&Format::new(options.format)?);
    let values = json!({ "rows": rows });
    let page = text("no table", include_str!("roots.md"), values)?;
    output::report(json, &rows, |_| output::text(page.trim_end()));
    Ok(())
}
