//! Golden flags against exact flags, pixel by pixel.

use super::F;
use super::decide::decided;
use imogene_analysis::exact;
use imogene_analysis::exact::render::ExactPixel;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::unit::depth_interval::FACE_NEAR_END;
use imogene_prepare::PreparedScene;
use imogene_scene::FramedScene;

/// What a comparison counts, over all pixels and sources.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Flags of pixels at which both see the same face.
    pub flags: usize,
    /// Flags that the words leave open.
    pub open: usize,
    /// Open flags that differ.
    pub differing: usize,
    /// Of them those at an edge of the exact light: a neighbour of the pixel has the other exact flag.
    pub at_an_edge: usize,
    /// Of them those at a terminator: such a neighbour shows the same face.
    pub on_one_face: usize,
    /// Lit and dark flags of the exact picture.
    pub lit: usize,
    pub dark: usize,
}

/// Compares the flags of all pixels; where the words decide, golden and exact flags are what they decide.
pub fn compare(framed: &FramedScene, prepared: &PreparedScene, tally: &mut Tally) {
    let frame = prepared.frame(|| ());
    let golden = prepared.light(&frame, || ());
    let truth = exact::shadow::lighting(framed, || ());
    let seen = exact::render::render(framed, &F, || ());
    for (index, pixel) in seen.iter().enumerate() {
        let Some(pixel) = same_face(*pixel, &frame, index) else {
            continue;
        };
        let (x, y) = (index % frame.width, index / frame.width);
        for source in 0..framed.sources.len() {
            let flag = |lighting: &Lighting| lighting.flags[index] >> source & 1 == 1;
            let (got, wanted) = (flag(&golden), flag(&truth));
            tally.flags += 1;
            tally.lit += usize::from(wanted);
            tally.dark += usize::from(!wanted);
            let depth = frame.depth[index];
            match decided(framed, prepared, source, x as i64, y as i64, depth, &pixel) {
                Some(lit) => assert_eq!(
                    (got, wanted),
                    (lit, lit),
                    "{} at ({x}, {y}), lights[{source}], object {}, face {}",
                    framed.title,
                    framed.objects[pixel.id as usize].name(),
                    pixel.number
                ),
                None => {
                    tally.open += 1;
                    if got != wanted {
                        let around = around(index, frame.width, frame.height);
                        let others: Vec<usize> = around
                            .filter(|&i| truth.flags[i] >> source & 1 != u16::from(wanted))
                            .filter(|&i| seen[i].is_some())
                            .collect();
                        let face = |i: usize| seen[i].map(|p| (p.id, p.number));
                        let own = others.iter().any(|&i| face(i) == face(index));
                        tally.differing += 1;
                        tally.at_an_edge += usize::from(!others.is_empty());
                        tally.on_one_face += usize::from(own);
                    }
                }
            }
        }
    }
}

fn same_face(pixel: Option<ExactPixel>, frame: &Frame, index: usize) -> Option<ExactPixel> {
    let pixel = pixel?;
    let same = frame.id[index] == pixel.id as i32 && frame.number[index] == pixel.number;
    // Where the near end opens a solid one sees its inside, which is in no volume.
    (same && pixel.number != FACE_NEAR_END).then_some(pixel)
}

/// The pixels around one, as far as the picture reaches.
fn around(index: usize, width: usize, height: usize) -> impl Iterator<Item = usize> {
    let (x, y) = (index % width, index / width);
    let lines = y.saturating_sub(1)..=(y + 1).min(height - 1);
    lines.flat_map(move |v| {
        (x.saturating_sub(1)..=(x + 1).min(width - 1)).map(move |u| v * width + u)
    })
}
