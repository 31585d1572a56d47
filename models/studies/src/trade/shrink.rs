//! Pictures of few colours, for the page.

use color_quant::NeuQuant;
use std::collections::HashMap;

/// Colours of a picture of the page.
const COLOURS: usize = 256;

/// A PNG file.
type Encoded = Result<Vec<u8>, png::EncodingError>;

/// Reduces pictures to one set of colours, chosen for a picture like all of them.
pub struct Reducer {
    network: NeuQuant,
    palette: Vec<u8>,
}

impl Reducer {
    /// Chooses the colours by a picture.
    pub fn new(rgb: &[u8]) -> Reducer {
        let colours = rgb.chunks_exact(3);
        let opaque: Vec<u8> = colours.flat_map(|c| [c[0], c[1], c[2], 255]).collect();
        // Every pixel is looked at, so that small bright spots have their colours.
        let network = NeuQuant::new(1, COLOURS, &opaque);
        let palette = network.color_map_rgb();
        Reducer { network, palette }
    }

    /// A picture in these colours, as PNG.
    pub fn png(&self, size: (u32, u32), rgb: &[u8]) -> Encoded {
        let mut known: HashMap<[u8; 3], u8> = HashMap::new();
        let index = |c: &[u8]| {
            let colour = [c[0], c[1], c[2]];
            let find = || self.network.index_of(&[c[0], c[1], c[2], 255]) as u8;
            *known.entry(colour).or_insert_with(find)
        };
        let indices: Vec<u8> = rgb.chunks_exact(3).map(index).collect();
        encode(size, &self.palette, &indices)
    }
}

/// A picture of at most 256 colours without any change, as PNG; `None` if it has more.
pub fn exact_png(size: (u32, u32), rgb: &[u8]) -> Option<Encoded> {
    let mut known: HashMap<[u8; 3], usize> = HashMap::new();
    let mut palette = vec![];
    let mut indices = Vec::with_capacity(rgb.len() / 3);
    for c in rgb.chunks_exact(3) {
        let next = known.len();
        let index = *known.entry([c[0], c[1], c[2]]).or_insert_with(|| {
            palette.extend_from_slice(c);
            next
        });
        indices.push(u8::try_from(index).ok()?);
    }
    Some(encode(size, &palette, &indices))
}

fn encode((width, height): (u32, u32), palette: &[u8], indices: &[u8]) -> Encoded {
    let mut bytes = vec![];
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(palette);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(indices)?;
    writer.finish()?;
    Ok(bytes)
}
