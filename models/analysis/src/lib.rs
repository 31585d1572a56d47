//! Exact reference, error bounds and measures of pictures.
//!
//! The exact reference ([`exact`]) solves each pixel in big integers by another route than the machine. It is the truth
//! that golden models and hardware are measured against ([`metrics`]) and that the bounds ([`bounds`]) hold for.
//!
//! ```
//! use imogene_analysis::{exact::render::DEPTH_FRACTION, metrics::{Drawing, Truth, measure}};
//! use imogene_prepare::{Framing, prepare};
//! use imogene_scene::SceneFile;
//!
//! let text = r#"format = 1
//! title = "A ball"
//! camera = { kind = "orthographic", eye = [0, 0, 9], target = [0, 0, 0], view_height = 4, half_depth = 2 }
//! materials = [{ name = "clay", colour = [0.8, 0.4, 0.3] }]
//! objects = [{ name = "ball", kind = "sphere", radius = 1, material = "clay" }]"#;
//! let framed = SceneFile::parse(text, "ball.toml")?.frame(38, 38)?;
//!
//! // At 9.5 pixels a unit the ball covers the pixels of a disc about pixel (19, 19).
//! let truth = Truth::new(&framed, || ());
//! let disc = (-19..19).flat_map(|y| (-19..19).map(move |x| x * x + y * y)).filter(|square| *square <= 90);
//! assert_eq!(truth.covered(), disc.count());
//! // At its middle it begins half of the way to the near end.
//! assert_eq!(truth.pixels[19 * 38 + 19].map(|pixel| pixel.depth), Some(-(((1 << 23) - 1) << DEPTH_FRACTION) / 2));
//! // The golden picture has the same outline, for no pixel is so near to it that rounded words could not tell.
//! let (metrics, _) = measure(&truth, &Drawing::of(&prepare(&framed, Truth::FORMAT)?, &framed));
//! assert_eq!(metrics.silhouette, 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod bounds;
pub mod exact;
pub mod metrics;
pub mod phong;
