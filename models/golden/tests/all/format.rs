use imogene_contract::{MachineWords, RootForm};
use imogene_golden::format::{Format, wrap, wrap64};

#[test]
fn base_format_is_24_48() {
    let f = Format::BASE;
    let widths = [f.depth, f.sum, f.quadratic, f.root, f.plane];
    assert_eq!(widths, [24, 26, 48, 24, 36]);
    assert_eq!((f.z_max(), f.z_low()), (8_388_607, -8_388_607));
    for depth in [7, 33] {
        let refused = Format::new(depth).unwrap_err().to_string();
        assert!(refused.contains("accepted are 8 to 32"), "{refused}");
    }
}

#[test]
fn guard_bits_widen_the_processors_only() {
    let base = Format::BASE;
    let f = base.with_guards(2, 4).unwrap();
    assert_eq!((f.pe1_width(), f.pe2_width(), f.bus()), (28, 52, 52));
    assert_eq!((f.sum, f.quadratic, f.z_max()), (26, 48, base.z_max()));
    assert_eq!((f.drop_linear(-1), f.drop_linear(7)), (-1, 1));
    assert_eq!((f.drop_quadratic(-1), f.drop_quadratic(15)), (-1, 0));
    assert!(f.has_guards() && !base.has_guards());
}

#[test]
fn guard_bits_beyond_the_words_are_refused() {
    let refused = |depth, linear, quadratic| {
        let format = Format::new(depth).unwrap();
        let refused = format.with_guards(linear, quadratic);
        refused.unwrap_err().to_string()
    };
    assert!(refused(24, 17, 0).contains("at most 16 each"));
    assert!(refused(28, 0, 9).contains("at most 8"));
    assert!(refused(32, 0, 1).contains("at most 0"));
    let short = Format::new(16).unwrap().with_guards(16, 0).unwrap();
    assert_eq!((short.bus(), short.pe1_width()), (34, 34));
    assert!(Format::BASE.with_guards(16, 16).is_ok());
}

#[test]
fn fitted_formats_have_every_width_in_its_range() {
    let base = Format::BASE.widths();
    assert_eq!(Format::fitted(&base), Ok(Format::BASE));
    let small = MachineWords {
        depth: 10,
        root: 8,
        plane: 14,
        normal: 12,
        guard_linear: 1,
        guard_quadratic: 3,
        dropped_rows: 2,
        root_form: RootForm::Restoring,
    };
    let f = Format::fitted(&small).unwrap();
    assert_eq!((f.quadratic, f.pe2_width(), f.pe1_width()), (16, 19, 13));
    assert_eq!((f.normal_linear, f.greatest_normal()), (20, 2047));
    assert_eq!((f.root_rows(), f.keep_rows(0xff)), (6, 0xfc));
    // Two coordinates are the widest word of so small a machine.
    assert_eq!(f.bus(), 24);
    let refused = |change: fn(&mut MachineWords)| {
        let mut widths = small;
        change(&mut widths);
        Format::fitted(&widths).unwrap_err().to_string()
    };
    assert!(refused(|w| w.depth = 33).contains("depth word of 33 bits: accepted are 8 to 32"));
    assert!(refused(|w| w.root = 11).contains("4 to 10"));
    assert!(refused(|w| w.plane = 9).contains("10 to 22"));
    assert!(refused(|w| w.normal = 9).contains("10 to 16"));
    assert!(refused(|w| w.guard_linear = 17).contains("at most 16 each"));
    // Six digits are computed.
    assert!(refused(|w| w.root_form = RootForm::Leading(7)).contains("1 to 6"));
    assert!(refused(|w| w.root_form = RootForm::Linear(2)).contains("linear root of 6 bits"));
}

#[test]
fn wrap_sign_extends() {
    assert_eq!(wrap(1 << 23, 24), -(1 << 23));
    assert_eq!(wrap(-(1 << 23) - 1, 24), (1 << 23) - 1);
    assert_eq!(wrap64((1 << 35) + 5, 36), -(1 << 35) + 5);
}
