//! Repaired pictures are the exact ones.

use imogene_analysis::exact::render::{render, to_frame};
use imogene_golden::format::Format;
use imogene_oracle::repair::{differing_faces, repair};
use imogene_prepare::Framing;
use imogene_prepare::prepare;

/// Every scene that the words of 16 bits take, objects and faces at all pixels; what the words decide is left as it
/// was.
#[test]
fn every_scene_in_short_words_is_repaired_to_the_exact_picture() {
    let (mut mended, mut untouched, mut scenes) = (0, 0, 0);
    for (name, scene) in crate::common::all() {
        if scene.objects.len() > 40 {
            continue;
        }
        let (w, h) = match (scene.image.width, scene.image.height) {
            (w, h) if w * h <= 64 * 128 => (w, h),
            _ => (80, 60),
        };
        let framed = scene.frame(w, h).expect("framed");
        let format = Format::new(16).expect("of the catalogue");
        let Ok(prepared) = prepare(&framed, format) else {
            continue;
        };
        let repaired = repair(&framed, &prepared, || ());
        let exact = to_frame(&render(&framed, &format, || ()), &framed, &format);
        assert_eq!(differing_faces(&repaired.frame, &exact), 0, "{name}");
        assert!(repaired.leaves_the_rest(), "{name}");
        mended += repaired.report.mended;
        untouched += repaired.report.pixels - repaired.report.open;
        scenes += 1;
    }
    let are_many = scenes > 50 && mended > 20 && untouched > 100_000;
    assert!(are_many, "{scenes} {mended} {untouched}");
}
