mod design;
mod source;

use imogene_synth::Figures;
use imogene_synth::peer::ratios;

#[test]
fn a_ratio_is_peer_over_unit_and_nothing_is_divided_by_nothing() {
    let figures = |lut, dsp, fmax_mhz| Figures {
        lut: Some(lut),
        dsp: Some(dsp),
        fmax_mhz,
        ..Figures::default()
    };
    let ratios = ratios(&figures(30, 2, Some(50.0)), &figures(20, 0, Some(200.0)));
    assert_eq!(ratios["LUT"], Some(1.5));
    assert_eq!(ratios["DSP"], None);
    assert_eq!(ratios["Fmax"], Some(0.25));
    assert_eq!(ratios["cells"], None);
}
