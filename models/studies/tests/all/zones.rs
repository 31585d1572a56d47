//! Scenes whose coefficients are rounded anew for each zone of the screen.

use imogene_analysis::metrics::Drawing;
use imogene_golden::format::Format;
use imogene_prepare::rounding::Anchor;
use imogene_prepare::{Framing, Options, prepare_with};
use imogene_studies::zones::zones;
use imogene_testkit::scene_file;

/// Zones whose words are rounded about a pixel outside them still draw their part of the picture of these words.
#[test]
fn zones_draw_their_part_of_the_screen() {
    let scene = scene_file("cut-sphere").frame(60, 45).unwrap();
    let format = Format::new(16).unwrap();
    let drawing = Drawing::in_zones(&zones(&scene, format, 16).unwrap(), &scene);
    for (x, y) in [(0, 0), (16, 16), (32, 16), (48, 32)] {
        let (width, height) = (16.min(60 - x), 16.min(45 - y));
        let anchor = Anchor {
            x: (x + width / 2) as i64,
            y: (y + height / 2) as i64,
        };
        let options = Options {
            anchor: Some(anchor),
            ..Options::ROOTS
        };
        let whole = Drawing::of(&prepare_with(&scene, format, options).unwrap(), &scene);
        for index in (y..y + height).flat_map(|v| (x..x + width).map(move |u| v * 60 + u)) {
            assert_eq!(drawing.frame.depth[index], whole.frame.depth[index]);
            assert_eq!(drawing.frame.id[index], whole.frame.id[index]);
            assert_eq!(drawing.frame.normal[index], whole.frame.normal[index]);
            assert_eq!(drawing.backs[index], whole.backs[index]);
        }
    }
}
