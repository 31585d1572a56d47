//! Two programs that draw the same facets, timed in one run: contour following, and the model of the facet processor.

use imogene_golden::format::Format;
use imogene_golden::object::facet::FacetWords;
use imogene_golden::object::facet_contour::{FacetContour, Operations};
use imogene_golden::object::quadric::ObjectPixel;
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::object::words::{Object, Words};
use serde::Serialize;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Facets by a program and by processors: additions; the keys are stable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct FacetWork {
    /// Contour following.
    pub contour: Operations,
    /// Additions of the facet processors, each over its screen box.
    pub processor_box_additions: u64,
    /// Additions of the facet processors, each over the whole screen, as when all work at once.
    pub processor_screen_additions: u64,
}

/// The facets among the processors of a machine.
pub fn facets<'a>(slots: &'a [Slot]) -> Vec<&'a FacetWords> {
    let facet = |slot: &'a Slot| match &slot.words {
        ProcessorWords::Facet(words) => Some(words),
        _ => None,
    };
    slots.iter().filter_map(facet).collect()
}

/// Counts the work of facets on a screen of so many pixels.
pub fn work(facets: &[&FacetWords], format: &Format, screen: u64) -> FacetWork {
    let mut work = FacetWork::default();
    for words in facets {
        work.contour += FacetContour::new(words, format).operations();
        // Every elementary processor adds once a clock.
        let processors = words.edges.len() as u64 + 4;
        work.processor_box_additions += processors * words.screen_box.pixels();
        work.processor_screen_additions += processors * screen;
    }
    work
}

/// How fast the two programs are; the keys are stable.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Speed {
    /// Pixels of facets drawn per second by contour following.
    pub contour_pixels_per_second: f64,
    /// The same facets and pixels by the model of the processor over each facet's screen box.
    pub processor_model_pixels_per_second: f64,
    /// The first over the second.
    pub ratio: f64,
    /// Clock in MHz at which one facet processor, a pixel of a box a clock, is as fast as contour following.
    pub break_even_mhz: f64,
}

/// Times both, about `time` each, on one thread.
pub fn measure(facets: &[&FacetWords], format: &Format, time: Duration) -> Speed {
    let contour = rate(facets, time, |words, sum| {
        FacetContour::new(words, format).for_each_pixel(|_, _, pixel| sum.add(&pixel));
    });
    let model = rate(facets, time, |words, sum| scan(words, format, sum));
    let boxes: u64 = facets.iter().map(|f| f.screen_box.pixels()).sum();
    let drawn = work(facets, format, 0).contour.pixels.max(1);
    Speed {
        contour_pixels_per_second: contour,
        processor_model_pixels_per_second: model,
        ratio: contour / model,
        break_even_mhz: contour * boxes as f64 / drawn as f64 / 1e6,
    }
}

/// What is drawn, so that nothing can be left out.
#[derive(Default)]
struct Sum {
    pixels: u64,
    values: i64,
}

impl Sum {
    #[inline]
    fn add(&mut self, pixel: &ObjectPixel) {
        self.pixels += 1;
        let [x, y, z] = pixel.normal.map(i64::from);
        self.values = self.values.wrapping_add(pixel.zf ^ x ^ y << 16 ^ z << 32);
    }
}

fn scan(words: &FacetWords, format: &Format, sum: &mut Sum) {
    let window = words.screen_box;
    let [width, height] = window.size();
    let zone = words.for_zone(window.x0, window.y0, width, height);
    for y in 0..height {
        for x in 0..width {
            let pixel = zone.at(x, y, format);
            if pixel.zf != format.z_max() {
                sum.add(&pixel);
            }
        }
    }
}

/// Pixels per second of all facets, drawn again and again until the time is over.
fn rate(facets: &[&FacetWords], time: Duration, draw: impl Fn(&FacetWords, &mut Sum)) -> f64 {
    let started = Instant::now();
    let mut pixels = 0;
    loop {
        let mut sum = Sum::default();
        for words in facets {
            draw(black_box(words), &mut sum);
        }
        pixels += black_box(sum).pixels;
        let elapsed = started.elapsed();
        if elapsed >= time {
            return pixels as f64 / elapsed.as_secs_f64();
        }
    }
}
