use imogene_contract::{Request, Unit};

#[test]
fn errors_follow_the_parameters() {
    let error = |name, option, value| {
        let request = Request::given(name, 24, &[(option, Some(value))]);
        request.expect("legal").error()
    };
    assert!(error("square_root_rows", "digits", 10).contains("below 2^14 of the last"));
    assert!(error("square_root_leading", "digits", 10).contains("below 2^-9 of the root"));
    assert!(error("square_root_quadratic", "corrections", 0).contains("1.345 %"));
    let two = Request::new(Unit::SquareRootLinear).error();
    assert!(two.contains("0.473 %"), "{two}");
}

/// The figures of approximate roots are those of the page where they are measured.
#[test]
fn figures_are_those_of_the_documentation() {
    let page = include_str!("../../../../docs/root-network.md");
    for (unit, measured) in [
        (Unit::SquareRootLinear, "6.066, 1.681, 0.507"),
        (Unit::SquareRootQuadratic, "1.364, 0.540, 0.221"),
    ] {
        let lists = unit.record().error.split(['{', '}']);
        let lists: Vec<_> = lists.filter_map(|part| part.strip_prefix("C: ")).collect();
        assert_eq!(lists[1], measured);
        assert!(lists.iter().all(|list| page.contains(&format!("{list} %"))));
    }
}

/// A formula that cannot be read, or a symbol that the unit does not have, ends in a panic.
#[test]
fn every_record_can_be_read() {
    for unit in Unit::ALL {
        let request = Request::new(unit);
        request.check().expect("defaults are legal");
        assert!(request.latency() < 100 && !request.error().is_empty());
        let record = unit.record();
        assert!(!record.computes.is_empty() && !record.source.is_empty());
        assert_eq!(Unit::from_name(record.name), Ok(unit));
    }
}

#[test]
fn forms_of_the_root_are_of_units_that_hold_one() {
    let with = |unit, text: &str| {
        let form = text.parse().expect("a form");
        Request::new(unit).with_root_form(form)
    };
    let linear = with(Unit::QuadricProcessor, "linear2").expect("legal");
    assert_eq!(linear.latency(), 1 + 2 * 2 + 11);
    assert!(linear.error().contains("root, bound: 0.473 %"));
    assert!(linear.arguments().contains("--root-form linear2"));
    let beam = with(Unit::Beam, "leading8").expect("legal");
    assert_eq!(beam.latency(), 1 + (7 + 2 + 11) + 2);
    for unit in Unit::ALL {
        assert!(with(unit, "restoring").is_ok());
        let name = unit.name();
        let mut holding =
            "quadric_pe quadric_processor patch_processor first_generation_processor \
                           quadric_volume beam"
                .split(' ');
        let is_taken = with(unit, "quadratic0").is_ok();
        assert_eq!(is_taken, holding.any(|one| one == name), "{name}");
    }
    let refused = with(Unit::QuadricPe, "leading25").unwrap_err().to_string();
    assert!(refused.contains("leading root = 25"), "{refused}");
}
