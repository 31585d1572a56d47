//! `imogene render --samples`: the machine's own supersampling. It draws the scene once for each place in a pixel and
//! takes the mean.

use super::models::draw;
use crate::arguments::Render;
use crate::command::load_seen;
use crate::failure::Failure;
use imogene_analysis::phong;
use imogene_golden::machine::accumulator::{Accumulator, PassPixel};
use imogene_scene::SceneFile;

/// The mean colours of `count` passes, whose places make a square grid about that of the plain picture.
pub fn colours(options: &Render, file: &SceneFile, count: u32) -> Result<Vec<u8>, Failure> {
    let side = count.isqrt();
    let place = |k: u32| (f64::from(k) + 0.5) / f64::from(side) - 0.5;
    let mut sums: Option<Accumulator> = None;
    let mut mean = vec![];
    for pass in 0..count {
        let mut file = file.flattened().into_owned();
        let sample_at = &mut file.camera.sample_at;
        sample_at[0] += place(pass % side);
        sample_at[1] += place(pass / side);
        let (framed, prepared) = load_seen(file, &options.scene)?;
        let (frame, lighting) = draw(options, &framed, &prepared)?;
        let rgb = phong::shade(&frame, &lighting, &framed, &prepared.format);
        let sums = sums.get_or_insert_with(|| Accumulator::new(rgb.len() / 3));
        for (address, colour) in rgb.chunks_exact(3).enumerate() {
            let pixel = PassPixel {
                address,
                first: pass == 0,
                last: pass + 1 == count,
                colour: [colour[0], colour[1], colour[2]],
            };
            mean.extend(sums.add(&pixel, count).into_iter().flatten());
        }
    }
    Ok(mean)
}
