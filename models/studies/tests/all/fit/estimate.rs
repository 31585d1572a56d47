use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_studies::fit::estimate::of_slot;

/// Within a quarter of what synthesis says of quadric processors at 24 bits (`docs/resources.md`): 2693 cells
/// without planes, 4992 with three, 11783 with twelve.
#[test]
fn the_base_processor_is_about_as_large_as_synthesis_says() {
    for (planes, synthesised) in [(0, 2693.0), (3, 4992.0), (12, 11_783.0)] {
        let slot = FittedSlot::full(planes);
        let ratio = of_slot(&Format::BASE.widths(), &slot) / synthesised;
        assert!((0.75..1.25).contains(&ratio), "{planes} planes: {ratio}");
    }
}
