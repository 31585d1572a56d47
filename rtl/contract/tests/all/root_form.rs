use imogene_contract::RootForm;

const ALL: &str = "restoring non-restoring iterative linear0 linear2 quadratic1 leading12";

#[test]
fn text_and_forms_are_each_other() {
    for text in ALL.split(' ') {
        let form: RootForm = text.parse().expect("a form");
        assert_eq!(form.to_string(), text);
        assert_eq!(
            form.is_exact(),
            ["restoring", "non-restoring", "iterative"].contains(&text)
        );
    }
    assert_eq!(RootForm::default().to_string(), "restoring");
}

#[test]
fn what_is_no_form_is_refused_with_what_would_do() {
    for (text, part) in [
        ("", "accepted: restoring"),
        ("cubic1", "'cubic1' is no form of the root"),
        ("restoring2", "is no form"),
        ("Linear2", "is no form"),
        ("linear", "a linear root takes 0 to 2 corrections"),
        ("linear3", "0 to 2 corrections"),
        ("quadratic99999999999", "0 to 2 corrections"),
        ("leading0", "1 to 32 digits"),
        ("leading33", "1 to 32 digits"),
        ("iterative2", "is no form"),
        ("rows12", "`dropped` of the widths"),
    ] {
        let error = text.parse::<RootForm>().unwrap_err().to_string();
        assert!(error.contains(part), "{text}: {error}");
    }
}

/// The clocks that the page of the roots has of 24 digits, one row to a stage and four.
#[test]
fn latencies_are_those_of_the_units() {
    let forms = ALL.split(' ').map(|text| text.parse::<RootForm>().unwrap());
    let forms: Vec<RootForm> = forms.collect();
    let clocks = |rows| Vec::from_iter(forms.iter().map(|form| form.latency(24, rows)));
    assert_eq!(clocks(1), [24, 24, 24, 1, 5, 5, 13]);
    assert_eq!(clocks(4), [6, 6, 24, 1, 5, 5, 5]);
}

/// What a record prints of its bound is no less than a hundredth of a percent below what is counted with.
#[test]
fn errors_are_those_of_the_records() {
    for text in ["linear0", "linear1", "linear2", "quadratic0", "quadratic1"] {
        let form: RootForm = text.parse().unwrap();
        let percent = 100.0 * form.error().0;
        let bounds = form.unit().record().error;
        let (_, list) = bounds.split_once("{C: ").unwrap();
        let (list, _) = list.split_once('}').unwrap();
        let place = text.trim_start_matches(char::is_alphabetic).parse();
        let stated = list.split(", ").nth(place.unwrap()).unwrap();
        let stated: f64 = stated.parse().unwrap();
        let off = percent - stated;
        assert!((0.0..0.01).contains(&off), "{text}: {stated}");
    }
}
