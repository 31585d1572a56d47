//! Golden flags against exact flags, pixel by pixel.

use super::decide::decided;
use crate::pictures::Pictures;
use imogene_analysis::exact::shadow;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::unit::depth_interval::FACE_NEAR_END;

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
pub fn compare(pictures: &Pictures, tally: &mut Tally) {
    let framed = &pictures.scene;
    let golden = pictures.prepared.light(&pictures.golden, || ());
    let truth = shadow::lighting(framed, || ());
    for (index, pixel) in pictures.seen() {
        if pixel.number == FACE_NEAR_END {
            // Where the near end opens a solid one sees its inside, which is in no volume.
            continue;
        }
        let (x, y) = pictures.place(index);
        for source in 0..framed.sources.len() {
            let flag = |lighting: &Lighting| lighting.flags[index] >> source & 1 == 1;
            let (got, wanted) = (flag(&golden), flag(&truth));
            tally.flags += 1;
            tally.lit += usize::from(wanted);
            tally.dark += usize::from(!wanted);
            match decided(pictures, source, index, &pixel) {
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
                        let other = |i: &usize| {
                            truth.flags[*i] >> source & 1 != u16::from(wanted)
                                && pictures.exact[*i].is_some()
                        };
                        let others: Vec<usize> = pictures.around(index, 1).filter(other).collect();
                        let face = |i| pictures.exact_face(i);
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
