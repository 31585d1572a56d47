use imogene_contract::Request;
use imogene_faults::Known;
use imogene_verif::mutation::contract::contract;

/// Behind every row there is a remainder of a known size.
#[test]
fn what_is_known_of_roots_is_proven() {
    for unit in ["square_root", "square_root_non_restoring", "quadric_pe"] {
        let request = Request::given(unit, 16, &[]).expect("a unit of the catalogue");
        let subject = imogene_verif::unit::subject(&request).expect("its defaults are legal");
        let design = imogene_rtl::emit::design(&request).expect("a legal request");
        let known = Known::new(&design, &contract(&subject, &design));
        assert_eq!(known.proven_remainders(), 16, "{unit}");
    }
}
