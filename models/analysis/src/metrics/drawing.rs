//! What the golden model draws: everything that is compared with the truth.

use crate::phong::shade;
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::Slot;
use imogene_golden::object::words::Words;
use imogene_prepare::PreparedScene;
use imogene_scene::FramedScene;
use std::ops::Range;

/// A golden picture with all that was decided at every pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Format of its words.
    pub format: Format,
    /// What is seen.
    pub frame: Frame,
    /// Back depth of the visible object, `z_max` where nothing is seen.
    pub backs: Vec<i64>,
    /// Of each object, whether its face numbers are those of the true object: quadric and patch processors alone.
    pub numbered: Vec<bool>,
    /// The picture, 8-bit red, green and blue.
    pub rgb: Vec<u8>,
}

/// A rectangle of the screen with the scene as it was prepared for it.
pub struct ZoneScene {
    /// Its pixels.
    pub window: ScreenBox,
    /// Words for the whole screen.
    pub prepared: PreparedScene,
}

impl Drawing {
    /// The picture of a prepared scene, shaded by the exact formula.
    pub fn of(prepared: &PreparedScene, scene: &FramedScene) -> Drawing {
        let shade = |frame: &Frame, lit: &Lighting| shade(frame, lit, scene, &prepared.format);
        Drawing::shaded_by(prepared, shade)
    }

    /// The picture of a prepared scene; `shade` gives red, green and blue of every pixel of the frame.
    pub fn shaded_by(
        prepared: &PreparedScene,
        shade: impl FnOnce(&Frame, &Lighting) -> Vec<u8>,
    ) -> Drawing {
        let size = (prepared.width as usize, prepared.height as usize);
        let (frame, backs) =
            beam::render_with_backs(&prepared.slots(), &prepared.format, size.0, size.1, || ());
        Drawing::decided(frame, backs, prepared, shade)
    }

    /// The picture of a scene prepared anew for each zone; shadow and light volumes are those of the first one.
    pub fn in_zones(zones: &[ZoneScene], scene: &FramedScene) -> Drawing {
        let whole = &zones[0].prepared;
        let (width, height) = (scene.width as usize, scene.height as usize);
        let mut frame = Frame::background(width, height, whole.format.z_max());
        let mut backs = frame.depth.clone();
        for ZoneScene { window, prepared } in zones {
            let (ScreenBox { x0, y0, .. }, [columns, lines]) = (*window, window.size());
            let mut slots = prepared.slots();
            for Slot { words, .. } in &mut slots {
                *words = words.for_zone(x0, y0, columns, lines);
            }
            let [x0, y0, columns, lines] = [x0, y0, columns, lines].map(|n| n as usize);
            let (part, part_backs) =
                beam::render_with_backs(&slots, &prepared.format, columns, lines, || ());
            for line in 0..lines {
                let (from, to) = (line * columns, (y0 + line) * width + x0);
                let (from, to) = (from..from + columns, to..to + columns);
                copy(&mut frame, to.clone(), &part, from.clone());
                backs[to].copy_from_slice(&part_backs[from]);
            }
        }
        let shade = |frame: &Frame, lit: &Lighting| shade(frame, lit, scene, &whole.format);
        Drawing::decided(frame, backs, whole, shade)
    }

    /// The same picture with `side x side` pixels for each of its own.
    pub fn enlarged(&self, side: usize) -> Drawing {
        let Frame { width, height, .. } = self.frame;
        self.shown([width * side, height * side], |x, y| {
            y / side * width + x / side
        })
    }

    /// The same picture with every even line in the place of the odd one below it as well.
    pub fn of_even_lines(&self) -> Drawing {
        let Frame { width, height, .. } = self.frame;
        self.shown([width, height], |x, y| y / 2 * 2 * width + x)
    }

    /// A picture of another size, each of whose pixels is that of this one at an index.
    fn shown(
        &self,
        [columns, lines]: [usize; 2],
        place: impl Fn(usize, usize) -> usize,
    ) -> Drawing {
        let mut shown = Frame::background(columns, lines, 0);
        let (mut backs, mut rgb) = (vec![], vec![]);
        for at in 0..columns * lines {
            let from = place(at % columns, at / columns);
            copy(&mut shown, at..at + 1, &self.frame, from..from + 1);
            backs.push(self.backs[from]);
            rgb.extend(&self.rgb[3 * from..3 * from + 3]);
        }
        Drawing {
            format: self.format,
            frame: shown,
            backs,
            numbered: self.numbered.clone(),
            rgb,
        }
    }

    fn decided(
        frame: Frame,
        backs: Vec<i64>,
        prepared: &PreparedScene,
        shade: impl FnOnce(&Frame, &Lighting) -> Vec<u8>,
    ) -> Drawing {
        let lighting = prepared.light(&frame, || ());
        let rgb = shade(&frame, &lighting);
        let numbered = prepared.objects.iter().map(|o| o.quadric().is_some());
        Drawing {
            format: prepared.format,
            frame,
            backs,
            numbered: numbered.collect(),
            rgb,
        }
    }
}

fn copy(frame: &mut Frame, to: Range<usize>, part: &Frame, from: Range<usize>) {
    frame.depth[to.clone()].copy_from_slice(&part.depth[from.clone()]);
    frame.id[to.clone()].copy_from_slice(&part.id[from.clone()]);
    frame.number[to.clone()].copy_from_slice(&part.number[from.clone()]);
    frame.normal[to].copy_from_slice(&part.normal[from]);
}
