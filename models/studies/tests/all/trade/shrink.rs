use imogene_studies::trade::page::{Reducer, exact_png};

fn decoded(bytes: &[u8]) -> Vec<u8> {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().unwrap();
    let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut rgb).unwrap();
    rgb
}

#[test]
fn few_colours_stay_as_they_are() {
    let rgb: Vec<u8> = (0..200u8).flat_map(|v| [v, 255 - v, 7]).collect();
    let bytes = exact_png((20, 10), &rgb).unwrap().unwrap();
    assert_eq!(decoded(&bytes), rgb);
    let many = (0..300u32).flat_map(|v| [v as u8, (v >> 8) as u8, 0]);
    let many: Vec<u8> = many.collect();
    assert!(exact_png((30, 10), &many).is_none());
}

#[test]
fn many_colours_stay_near() {
    let pixel = |v| [(v % 64 * 4) as u8, (v / 64 * 4) as u8, 90];
    let rgb: Vec<u8> = (0..4096u32).flat_map(pixel).collect();
    let bytes = Reducer::new(&rgb).png((64, 64), &rgb).unwrap();
    let off = |(a, b): (&u8, &u8)| u32::from(a.abs_diff(*b));
    let sum: u32 = decoded(&bytes).iter().zip(&rgb).map(off).sum();
    assert!(sum / (3 * 4096) < 8, "{}", sum / (3 * 4096));
}
