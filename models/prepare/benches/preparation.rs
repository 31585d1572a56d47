//! Reading, framing and preparing a scene of many objects: a thousand balls and five hundred sticks, as an imported
//! molecule has them.

use criterion::{Criterion, criterion_group, criterion_main};
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_prepare::Framing;
use imogene_prepare::prepare;
use imogene_scene::SceneFile;
use std::fmt::Write;
use std::hint::black_box;

/// Balls on a lattice with steps that are no round numbers; every second has a stick. `eye` is along an axis, where the
/// camera frame is exact in few digits, or not.
fn scene(eye: [f64; 3]) -> String {
    let mut text = format!(
        "format = 1\ntitle = \"lattice\"\n[camera]\nkind = \"perspective\"\neye = {eye:?}\ntarget = [0, 0, 0]\nviewer_distance = 150.5\nview_height = 48.37\n\
         [[materials]]\nname = \"m\"\ncolour = [0.5, 0.5, 0.5]\n"
    );
    for k in 0..1000i32 {
        let [x, y, z] = [k % 10, k / 10 % 10, k / 100]
            .map(|n| f64::from(n - 5) * 2.573 + f64::from(k % 7) * 0.031);
        let place = format!("{{ translate = [{x:.3}, {y:.3}, {z:.3}] }}");
        writeln!(text, "[[objects]]\nname = \"ball {k}\"\nkind = \"sphere\"\nradius = 0.425\nmaterial = \"m\"\nplace = [{place}]").expect("text");
        if k % 2 == 0 {
            let turn = format!("{{ rotate = {{ axis = [0.{k:03}, 1.5, -0.75], degrees = 180 }} }}");
            writeln!(
                text,
                "[[objects]]\nname = \"stick {k}\"\nkind = \"elliptic_cylinder\"\nradii = [0.15, 0.15]\nmaterial = \"m\"\nplace = [{turn}, {place}]\n\
                 cuts = [{{ point = [0, 0, 0], normal = [0, -1, 0] }}, {{ point = [0, 1.487, 0], normal = [0, 1, 0] }}]"
            )
            .expect("text");
        }
    }
    text
}

fn preparation(c: &mut Criterion) {
    let format = Format::new(24).expect("of the catalogue");
    let mut group = c.benchmark_group("1500 objects");
    group.sample_size(10);
    for (view, eye) in [
        ("along an axis", [0.0, 0.0, 150.5]),
        ("turned", [61.7, 52.3, 127.1]),
    ] {
        let text = scene(eye);
        let read = |text: &str| SceneFile::parse(text, "lattice").expect("valid");
        group.bench_function(format!("read, {view}"), |b| {
            b.iter(|| read(black_box(&text)));
        });
        let file = read(&text);
        let frame = || file.frame(1280, 720).expect("valid");
        group.bench_function(format!("frame, {view}"), |b| b.iter(frame));
        let framed = frame();
        let prepared = || prepare(black_box(&framed), format).expect("fits");
        group.bench_function(format!("prepare, {view}"), |b| b.iter(prepared));
        let slots = prepared().slots();
        group.bench_function(format!("draw, {view}"), |b| {
            b.iter(|| beam::render(&slots, &format, 1280, 720, || ()));
        });
    }
    group.finish();
}

criterion_group!(benches, preparation);
criterion_main!(benches);
