//! A depth buffer that is never too near: what balls surely cover, and how far that is at most.

use super::outline::Span;
use super::placed::Placed;
use super::view::View;
use imogene_golden::object::quadric::ScreenBox;
use rayon::prelude::*;

/// Lines that one thread draws at a time, and sides of the tiles whose farthest depth is known.
const TILE: usize = 16;

/// For each pixel, a depth that something is surely drawn at or before; infinite where nothing surely is.
pub(super) struct Buffer {
    width: usize,
    depth: Vec<f64>,
    /// The farthest depth of each tile.
    tiles: Vec<f64>,
}

impl Buffer {
    pub fn of(placed: &[Option<Placed>], view: &View) -> Buffer {
        let (width, height) = (view.width as usize, view.height as usize);
        let mut bands: Vec<Vec<&Placed>> = vec![vec![]; height.div_ceil(TILE)];
        let is_drawn = |placed: &&Placed| placed.span != Span::Beside && !placed.window.is_empty();
        for placed in placed.iter().flatten().filter(is_drawn) {
            let lines = placed.window.y0 as usize / TILE..=placed.window.y1 as usize / TILE;
            bands[lines].iter_mut().for_each(|band| band.push(placed));
        }
        let mut depth = vec![f64::INFINITY; width * height];
        let draw = |(band, lines): (usize, &mut [f64])| {
            for placed in &bands[band] {
                cover(placed, (band * TILE) as i64, lines, width);
            }
            farthest_of_tiles(lines, width)
        };
        let lines = depth.par_chunks_mut(width * TILE).enumerate();
        Buffer {
            tiles: lines.flat_map_iter(draw).collect(),
            width,
            depth,
        }
    }

    /// True if at every pixel at which the ball may be drawn something else surely is, and nearer.
    ///
    /// Of the objects drawn at a pixel the nearest is never one of those that are hidden so: it would lie behind a
    /// depth at which something is drawn. So what hides may itself be hidden.
    pub fn hides(&self, placed: &Placed) -> bool {
        let window = &placed.window;
        if window.is_empty() {
            return true;
        }
        let nearest = placed.nearest();
        if self.tiles_around(window).all(|farthest| farthest < nearest) {
            return true;
        }
        (window.y0..=window.y1).all(|y| {
            let line = &self.depth[y as usize * self.width..];
            let is_behind = |x: i64, nearest| line[x as usize] < nearest;
            placed.may_cover(y, is_behind)
        })
    }

    fn tiles_around(&self, window: &ScreenBox) -> impl Iterator<Item = f64> {
        let row = self.width.div_ceil(TILE);
        let tile = |n: i64| n as usize / TILE;
        let rows = tile(window.y0)..=tile(window.y1);
        let columns = tile(window.x0)..=tile(window.x1);
        rows.flat_map(move |y| columns.clone().map(move |x| self.tiles[y * row + x]))
    }
}

/// Draws what a ball surely covers of a band of lines, the first of which is `top`.
fn cover(placed: &Placed, top: i64, lines: &mut [f64], width: usize) {
    let window = &placed.window;
    let last = top + (lines.len() / width) as i64 - 1;
    for y in window.y0.max(top)..=window.y1.min(last) {
        let line = &mut lines[(y - top) as usize * width..][..width];
        placed.covered(y, |x, depth| {
            let pixel = &mut line[x as usize];
            *pixel = pixel.min(depth);
        });
    }
}

fn farthest_of_tiles(lines: &[f64], width: usize) -> Vec<f64> {
    let mut tiles = vec![f64::NEG_INFINITY; width.div_ceil(TILE)];
    for line in lines.chunks(width) {
        for (tile, pixels) in tiles.iter_mut().zip(line.chunks(TILE)) {
            *tile = pixels.iter().copied().fold(*tile, f64::max);
        }
    }
    tiles
}
