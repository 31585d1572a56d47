use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_studies::fit::estimate::of_slot;

/// Within a quarter of what synthesis says of quadric processors at 24 bits (`docs/resources.md`): 2241 cells
/// without planes, 3422 with three, 6602 with twelve.
#[test]
fn the_base_processor_is_about_as_large_as_synthesis_says() {
    for (planes, synthesised) in [(0, 2241.0), (3, 3422.0), (12, 6602.0)] {
        let slot = FittedSlot::quadric(planes);
        let ratio = of_slot(&Format::BASE.widths(), &slot) / synthesised;
        assert!((0.75..1.25).contains(&ratio), "{planes} planes: {ratio}");
    }
}
