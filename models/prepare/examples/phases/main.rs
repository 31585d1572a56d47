//! Times of each step from a scene in memory to a picture, and the greatest memory so far:
//! `phases ATOMS [all] [sticks] [turned] [OUT.toml]`.

mod molecule;

use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_prepare::Framing;
use imogene_prepare::{Options, prepare_with};
use std::time::Instant;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let has = |word: &str| arguments.iter().any(|argument| argument == word);
    let atoms = arguments
        .first()
        .and_then(|n| n.parse().ok())
        .unwrap_or(10_000);
    let towards = if has("turned") {
        [0.617, 0.523, 1.271]
    } else {
        [0.0, 0.0, 1.0]
    };
    let mut last = Instant::now();
    let mut told = |step: &str| {
        println!(
            "{step:<10} {:>8.3} s {:>8} MB",
            last.elapsed().as_secs_f64(),
            peak()
        );
        last = Instant::now();
    };
    let scene = molecule::scene(atoms, has("sticks"), towards);
    told("scene");
    if let Some(path) = arguments
        .iter()
        .find(|argument| argument.ends_with(".toml"))
    {
        std::fs::write(path, scene.to_toml().expect("valid")).expect("written");
        return told("write");
    }
    scene.validate().expect("valid");
    told("check");
    let (width, height) = (1920, 1080);
    let format = Format::new(24).expect("of the catalogue");
    let framed = match has("all") {
        true => scene.frame(width, height),
        false => scene.frame_seen(width, height, &format),
    };
    let framed = framed.expect("valid");
    told("frame");
    let prepared = prepare_with(&framed, format, Options::default()).expect("fits");
    told("prepare");
    let slots = prepared.slots();
    let frame = beam::render(&slots, &format, width as usize, height as usize, || ());
    told("draw");
    println!(
        "{} objects, {} pixels covered",
        prepared.objects.len(),
        frame.covered()
    );
}

/// Greatest memory of the process so far, in megabytes.
fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kib = line.and_then(|rest| rest.split_whitespace().next()?.parse::<u64>().ok());
    kib.unwrap_or(0) >> 10
}
