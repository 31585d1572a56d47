use imogene_analysis::metrics::map::{
    BACKGROUND, CRACK, FACE, OBJECT, PRESENCE, class, legend, map,
};
use imogene_analysis::metrics::{Back, PixelError, SameFace};

fn same(depth: f64) -> PixelError {
    PixelError::Same(SameFace {
        depth,
        back: Back::None,
        angle: 0.0,
    })
}

#[test]
fn classes_are_powers_of_two_of_words() {
    let wanted = [
        (0.0, -4),
        (0.0625, -4),
        (0.07, -3),
        (-1.0, 0),
        (1.01, 1),
        (1e9, 19),
    ];
    for (words, class_of) in wanted {
        assert_eq!(class(words), class_of, "{words}");
    }
}

#[test]
fn every_kind_of_pixel_has_its_colour() {
    let pixels = [
        PixelError::Background,
        PixelError::Missing,
        PixelError::Extra,
        PixelError::Object,
        PixelError::Face,
        same(0.0),
        same(1e9),
        same(3.0),
    ];
    let rgb = map(&pixels, &[7]);
    let wanted = [
        BACKGROUND, PRESENCE, PRESENCE, OBJECT, FACE, [0; 3], [255; 3], CRACK,
    ];
    assert_eq!(rgb, wanted.concat());
    // All colours of the legend differ.
    let mut colours: Vec<[u8; 3]> = legend().into_iter().map(|(_, c)| c).collect();
    let all = colours.len();
    colours.sort_unstable();
    colours.dedup();
    assert_eq!(colours.len(), all);
}
