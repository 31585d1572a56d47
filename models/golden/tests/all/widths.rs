use imogene_contract::RootForm;
use imogene_golden::format::Format;
use imogene_golden::widths::{parse, print};

#[test]
fn text_and_widths_are_each_other() {
    let text = "depth=20,root=18,plane=30,normal=14,g1=2,g2=4,dropped=1";
    let widths = parse(text).unwrap();
    assert_eq!((widths.root, widths.dropped_rows), (18, 1));
    assert_eq!(print(&widths), text);
    assert_eq!(parse("depth=24").unwrap(), Format::BASE.widths());
    assert_eq!(parse("g2=4,depth=16").unwrap().guard_quadratic, 4);
    let text = format!("{text},root_form=linear2");
    assert_eq!(parse(&text).unwrap().root_form, RootForm::Linear(2));
    assert_eq!(print(&parse(&text).unwrap()), text);
    let usual = parse("depth=24,root_form=restoring").unwrap();
    assert_eq!(usual, Format::BASE.widths());
}

#[test]
fn what_is_no_width_is_refused() {
    let refused = |text: &str| parse(text).unwrap_err().to_string();
    for text in [
        "",
        "depth",
        "depth=",
        "depth=-3",
        "depth=20;root=3",
        "width=3",
    ] {
        assert!(refused(text).contains("expected a list"), "{text}");
    }
    assert!(refused("depth=20,depth=20").contains("twice"));
    assert!(refused("root=12").contains("depth=W"));
    assert!(refused("depth=40").contains("accepted are 8 to 32"));
    assert!(refused("depth=4294967295").contains("accepted are 8 to 32"));
    assert!(refused("depth=20,dropped=9").contains("0 to 8"));
    assert!(refused("depth=20,root_form=linear3").contains("0 to 2 corrections"));
    assert!(refused("depth=20,root_form=leading21").contains("leading root of 21 bits"));
    assert!(refused("depth=20,root_form=linear1,root_form=linear1").contains("twice"));
}
