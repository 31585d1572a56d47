//! `imogene peers`.

use crate::arguments::Peers;
use crate::failure::Result;
use crate::output;
use imogene_files::text::counted;
use imogene_synth::Target;
use imogene_synth::peer::{Comparison, Measured, Peer, compare};

/// Measures a design of another project beside a unit.
pub fn run(options: &Peers, json: bool) -> Result {
    let request = options.shape.request(&options.against)?;
    request.check()?;
    let target = Target::from_name(&options.target)?;
    let peer = Peer {
        files: options.rtl.clone(),
        top: options.top.clone(),
        clock: options.clock.clone(),
        include: options.include.clone(),
        parameters: options.parameter.clone(),
    };
    let comparison = compare(&peer, &request, target, options.seeds)?;
    output::report(json, &comparison, |_| output::text(describe(&comparison)));
    Ok(())
}

fn describe(comparison: &Comparison) -> String {
    let (peer, unit) = (&comparison.peer, &comparison.unit);
    let tools = comparison.tools.iter();
    let tools = tools.map(|(tool, version)| format!("{tool} {version}"));
    let (one, other) = (title(peer), title(unit));
    let tools = output::joined(tools, ", ");
    let seeds = counted(comparison.seeds, "seed");
    let mut lines = vec![
        format!("{one} beside {other} for {}", comparison.target),
        format!("{tools}, {seeds}"),
        row("", ["peer", "unit", "peer/unit"]),
    ];
    let counts = peer.figures.counts().into_iter().zip(unit.figures.counts());
    for ((name, peer), (_, unit)) in counts {
        if peer.is_none() && unit.is_none() {
            continue;
        }
        let text = |count: Option<u64>| count.map_or("-".to_owned(), |count| count.to_string());
        lines.push(line(name, &text(peer), &text(unit), comparison));
    }
    if comparison.seeds > 0 && unit.figures.cells.is_some() {
        lines.push(line("Fmax", &clock(peer), &clock(unit), comparison));
    }
    let latency = counted(unit.latency.unwrap_or_default(), "clock");
    lines.push(format!(
        "latency of {}: {latency}; that of the peer is in its documentation",
        unit.top
    ));
    lines.join("\n")
}

fn title(design: &Measured) -> String {
    let parameters = design.parameters.iter();
    let parameters = parameters.map(|(name, value)| format!("{name}={value}"));
    match output::joined(parameters, ", ") {
        none if none.is_empty() => design.top.clone(),
        parameters => format!("{} ({parameters})", design.top),
    }
}

fn line(name: &'static str, peer: &str, unit: &str, comparison: &Comparison) -> String {
    let ratio = comparison.ratios.get(name).copied().flatten();
    let ratio = ratio.map_or("-".to_owned(), |ratio| format!("{ratio:.2}"));
    row(name, [peer, unit, &ratio])
}

fn row(name: &str, [peer, unit, ratio]: [&str; 3]) -> String {
    format!("  {name:<12} {peer:>12} {unit:>12} {ratio:>12}")
}

fn clock(design: &Measured) -> String {
    match (design.figures.fmax_mhz, &design.figures.does_not_fit) {
        (Some(fmax), _) => format!("{fmax:.1} MHz"),
        (None, Some(excess)) => format!("too large: {excess}"),
        (None, None) => "-".to_owned(),
    }
}
