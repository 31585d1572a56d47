use super::zones;
use imogene_plan::split::Division;

#[test]
fn text_and_division_are_each_other() {
    for text in ["zones:64x48", "lines:3", "zones:8x4096", "lines:1"] {
        let division: Division = text.parse().unwrap();
        assert_eq!(division.to_string(), text);
    }
    for text in [
        "",
        "zones",
        "zones:",
        "zones:64",
        "zones:7x8",
        "zones:3x",
        "lines:",
        "lines:0",
        "lines:-1",
        "lines:4097",
        "rows:3",
        "zones:64x64x64",
        "lines:3x3",
    ] {
        let error = text.parse::<Division>().unwrap_err().to_string();
        assert!(error.contains("zones:WxH or lines:N"), "{text}");
    }
}

#[test]
fn pieces_cover_each_pixel_once() {
    let divisions = [
        zones(5, 3),
        zones(40, 1),
        Division::Lines(1),
        Division::Lines(4),
        Division::Lines(30),
    ];
    for division in divisions {
        for (width, height) in [(13, 11), (1, 1), (10, 9)] {
            let mut seen = vec![0; (width * height) as usize];
            for piece in division.pieces(width, height) {
                assert!(piece.width > 0 && piece.height > 0);
                for y in 0..piece.height as usize {
                    for x in 0..piece.width as usize {
                        seen[piece.place(x, y, width as usize)] += 1;
                    }
                }
            }
            assert!(seen.iter().all(|&n| n == 1), "{division} {width}x{height}");
        }
    }
}
