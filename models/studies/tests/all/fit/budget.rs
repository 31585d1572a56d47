use imogene_analysis::metrics::{Metrics, Spread};
use imogene_studies::fit::budget::{Budget, CountLimit, DepthLimit, worst};

#[test]
fn limits_are_read_with_their_units() {
    assert_eq!("1".parse(), Ok(DepthLimit::Words(1.0)));
    assert_eq!("2.5lsb".parse(), Ok(DepthLimit::Words(2.5)));
    assert_eq!("0.5px".parse(), Ok(DepthLimit::Pixels(0.5)));
    assert_eq!("0".parse(), Ok(CountLimit::Pixels(0)));
    assert_eq!("0.1%".parse::<CountLimit>().map(|l| l.of(76_800)), Ok(76));
    for text in ["", "-1", "px", "nan", "1 m", "inf"] {
        let error = text.parse::<DepthLimit>().unwrap_err();
        assert!(error.contains("0.5px"), "{text}: {error}");
    }
    for text in ["", "-1", "0.5", "%", "a%"] {
        let error = text.parse::<CountLimit>().unwrap_err();
        assert!(error.contains("0.1%"), "{text}: {error}");
    }
}

#[test]
fn every_limit_is_held_against_its_figure() {
    let spread = |max| Spread {
        max,
        ..Spread::default()
    };
    let metrics = Metrics {
        silhouette: 3,
        visible_part: 4,
        depth_words: spread(7.0),
        depth_px: spread(0.25),
        normal_deg: spread(2.0),
        colour_same_face: spread(5.0),
        colour: spread(200.0),
        ..Metrics::default()
    };
    let budget = Budget {
        depth: Some(DepthLimit::Pixels(0.5)),
        silhouette: Some(CountLimit::Pixels(2)),
        faces: Some(CountLimit::Percent(1.0)),
        colour: Some(5.0),
        normal: Some(1.0),
    };
    let items = budget.judge(&metrics, 400);
    let found = items.iter().map(|i| (i.limit, i.measured, i.holds()));
    let found: Vec<(&str, f64, bool)> = found.collect();
    let expected = [
        ("depth", 0.25, true),
        ("silhouette", 3.0, false),
        ("faces", 4.0, true),
        ("colour", 5.0, true),
        ("normal", 2.0, false),
    ];
    assert_eq!(found, expected);
    assert_eq!(Budget::default().judge(&metrics, 400), []);
    assert_eq!(
        budget.options(),
        " --max-depth-error 0.5px --max-silhouette-errors 2 --max-face-errors 1% --max-colour-error 5 \
         --max-normal-error 1"
    );
    let better = budget.judge(&Metrics::default(), 400);
    assert_eq!(worst(&[better, items.clone()]), items);
}
