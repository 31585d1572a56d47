//! Pictures side by side, with maps of their errors below.

const GAP: usize = 4;

/// A sheet of pictures.
pub struct Sheet {
    /// Pixels per line.
    pub width: usize,
    /// Lines.
    pub height: usize,
    /// 8-bit red, green, blue.
    pub rgb: Vec<u8>,
}

impl Sheet {
    /// Pictures of one size, each above its map, in bands of so many.
    pub fn of(pairs: &[[Vec<u8>; 2]], (width, height): (usize, usize), band: usize) -> Sheet {
        let span = |count: usize, side: usize| (count * (side + GAP)).saturating_sub(GAP);
        let columns = pairs.len().min(band);
        let mut sheet = Sheet {
            width: span(columns, width),
            height: span(2 * pairs.len().div_ceil(band.max(1)), height),
            rgb: vec![],
        };
        sheet.rgb = vec![255; 3 * sheet.width * sheet.height];
        for (place, panels) in pairs.iter().enumerate() {
            let left = place % band * (width + GAP);
            for (row, panel) in (2 * (place / band)..).zip(panels) {
                for (y, line) in (row * (height + GAP)..).zip(panel.chunks(3 * width)) {
                    let start = 3 * (y * sheet.width + left);
                    sheet.rgb[start..start + line.len()].copy_from_slice(line);
                }
            }
        }
        sheet
    }
}
