use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_studies::fit::estimate::of_slot;

/// Within a quarter of what synthesis says of quadric processors at 24 bits (`docs/resources.md`): 2244 cells
/// without planes, 3423 with three, 6603 with twelve.
#[test]
fn the_base_processor_is_about_as_large_as_synthesis_says() {
    for (planes, synthesised) in [(0, 2244.0), (3, 3423.0), (12, 6603.0)] {
        let slot = FittedSlot::quadric(planes);
        let ratio = of_slot(&Format::BASE.widths(), &slot) / synthesised;
        assert!((0.75..1.25).contains(&ratio), "{planes} planes: {ratio}");
    }
}
