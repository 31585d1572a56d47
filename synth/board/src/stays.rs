//! How long the images in the memory of a board stay on its screen.

use num_integer::gcd;

/// The longest stay of an image in the memory, in frames of the screen; one that stays longer is there more than once.
const LONGEST: u64 = 256;

/// One stay for all images, in frames of the screen of so many a second, and how often each of them follows itself, of
/// the seconds that each is to be seen.
pub fn stays(seconds: &[f64], rate: f64) -> (u64, Vec<usize>) {
    let frames = |seconds: &f64| ((seconds * rate).round() as u64).max(1);
    let frames: Vec<u64> = seconds.iter().map(frames).collect();
    let common: u64 = frames.iter().fold(0, |common, frames| gcd(common, *frames));
    let divides = |stay: &u64| common.is_multiple_of(*stay);
    let stay = (1..=common.min(LONGEST)).rev().find(divides).unwrap_or(1);
    let counts = frames.iter().map(|frames| (frames / stay) as usize);
    (stay, counts.collect())
}
