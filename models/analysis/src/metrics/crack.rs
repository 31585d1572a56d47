//! Cracks: places where the picture looks through a surface that is closed.

use super::pixel::{Golden, one_word, word_error};
use super::truth::Truth;

/// Pixels at which the truth shows a surface, there and at all eight neighbours, and the picture shows the background,
/// or a point of another object or face that lies behind all nine true points by more than a pixel of depth and more
/// than a word of its format.
///
/// All nine: a pixel on an object's outline that the picture misses shows what is truly seen beside it, which is no
/// crack.
pub fn cracks(truth: &Truth, golden: Golden) -> Vec<usize> {
    let lines = 1..truth.height.saturating_sub(1);
    let all = lines.flat_map(|y| (1..truth.width.saturating_sub(1)).map(move |x| (x, y)));
    all.filter(|&(x, y)| is_crack(truth, golden, x, y))
        .map(|(x, y)| y * truth.width + x)
        .collect()
}

fn is_crack(truth: &Truth, golden: Golden, x: usize, y: usize) -> bool {
    let index = y * truth.width + x;
    let Some(exact) = truth.pixels[index] else {
        return false;
    };
    let id = golden.frame.id[index];
    let same_object = id == exact.id as i32;
    if same_object && (!golden.numbered[id as usize] || golden.frame.number[index] == exact.number)
    {
        return false;
    }
    let mut deepest = i64::MIN;
    for line in y - 1..=y + 1 {
        for column in x - 1..=x + 1 {
            match truth.pixels[line * truth.width + column] {
                Some(neighbour) => deepest = deepest.max(neighbour.depth),
                None => return false,
            }
        }
    }
    let margin = truth.words_per_pixel.max(one_word(golden.format));
    id < 0 || word_error(golden.frame.depth[index], deepest, golden.format) > margin
}
