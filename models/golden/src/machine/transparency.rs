//! Transparent objects before the visible surface (source: Chaillou, IV.3.3): a pipeline of blends, farthest first, in
//! an order that the host makes.

/// A colour: red, green, blue.
pub type Colour = [u8; 3];

/// Clocks of one stage.
pub const STAGE_LATENCY: u32 = 4;
/// Most stages of a pipeline.
pub const MOST_LAYERS: usize = imogene_contract::words::MOST_LAYERS as usize;

/// What a stage hands on: the depth of the opaque surface, and the colour seen so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seen {
    /// Depth of the opaque surface. No transparent object changes it: a later one is nearer than the earlier, and only
    /// the surface hides it.
    pub depth: i64,
    /// Colour.
    pub colour: Colour,
}

/// A transparent object at a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layer {
    /// Depth; the far end of the format where the object is absent.
    pub depth: i64,
    /// Colour.
    pub colour: Colour,
    /// Its part of what is seen, in 255ths: with 256ths eight bits could not say opaque.
    pub weight: u8,
}

/// `round((t front + (255 - t) behind) / 255)`; 255 is odd, so there are no ties.
pub fn blend(front: u8, behind: u8, weight: u8) -> u8 {
    let [front, behind, weight] = [front, behind, weight].map(u32::from);
    let sum = weight * front + (255 - weight) * behind;
    ((sum + 127) / 255) as u8
}

/// One stage: an object strictly before the surface is blended over what is seen so far.
pub fn stage(seen: Seen, layer: Layer) -> Seen {
    if layer.depth >= seen.depth {
        return seen;
    }
    let mut colour = seen.colour;
    for (behind, front) in colour.iter_mut().zip(layer.colour) {
        *behind = blend(front, *behind, layer.weight);
    }
    Seen { colour, ..seen }
}

/// All stages, the first layer first.
pub fn pipeline(pixel: Seen, layers: &[Layer]) -> Seen {
    layers.iter().copied().fold(pixel, stage)
}

/// Clocks after the pixel at which each layer is taken.
pub fn starts(layers: usize) -> Vec<usize> {
    (0..layers).map(|i| i * STAGE_LATENCY as usize).collect()
}

/// Latency in clocks from the pixel.
pub const fn latency(layers: usize) -> u32 {
    layers as u32 * STAGE_LATENCY
}

/// Objects of a zone that cannot be sorted: each is farther than the next on some pixel, and the last farther than the
/// first. They have to be cut, or shown in different zones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoOrder {
    /// Their indices.
    pub circle: Vec<usize>,
}

/// The order in which the transparent objects of a zone go into the pipeline, farthest first. `depths[i]` are those of
/// object i on the pixels of the zone, `z_max` where it is absent.
///
/// Where two are there the farther one goes first; at equal depth the smaller index counts as nearer, as in the
/// decider. Of several orders the one whose first differing entry is the smallest index is given.
/// Fails when no order is right on all pixels.
pub fn order(depths: &[Vec<i64>], z_max: i64) -> Result<Vec<usize>, NoOrder> {
    let goes_before = |a: usize, b: usize| {
        let both = depths[a].iter().zip(&depths[b]);
        let mut both = both.filter(|&(&za, &zb)| za < z_max && zb < z_max);
        both.any(|(&za, &zb)| (za, a) > (zb, b))
    };
    let mut left: Vec<usize> = (0..depths.len()).collect();
    let mut sorted = Vec::new();
    while !left.is_empty() {
        let is_free = |&b: &usize| !left.iter().any(|&a| a != b && goes_before(a, b));
        match left.iter().copied().find(is_free) {
            Some(next) => {
                left.retain(|&object| object != next);
                sorted.push(next);
            }
            None => return Err(circle(&left, goes_before)),
        }
    }
    Ok(sorted)
}

/// A circle among objects of which each has another that goes before it.
fn circle(left: &[usize], goes_before: impl Fn(usize, usize) -> bool) -> NoOrder {
    let mut path = vec![left[0]];
    loop {
        let last = path[path.len() - 1];
        let before = left.iter().copied();
        let mut before = before.filter(|&a| a != last && goes_before(a, last));
        let next = before.next().expect("no object is free");
        if let Some(first) = path.iter().position(|&object| object == next) {
            let mut circle = path.split_off(first);
            // The path went from near to far.
            circle.reverse();
            return NoOrder { circle };
        }
        path.push(next);
    }
}
