use imogene_golden::machine::shader::{LightWords, MaterialWords, ShaderWords};

#[test]
fn loading_gives_back_the_words() {
    let light = LightWords {
        source: 13,
        point: true,
        shift: 14,
        base: [-1, 1 << 26, -(1 << 27)],
        slope: [5, -6, 7],
        colour: [81_600, 1, 131_071],
    };
    let material = MaterialWords {
        ambient: [1, 2, 65_535],
        diffuse: [3, 65_534, 4],
        specular: 40_000,
        exponent: 200,
    };
    let mut words = ShaderWords {
        size: [4096, 1],
        is_field: true,
        perspective: true,
        view_shift: 9,
        distance: 131_071,
        attenuation: Some(-77),
        offset_when_on: -77,
        background: [1, 128, 255],
        ..ShaderWords::unloaded(24, 4)
    };
    words.lights[3] = light;
    words.materials[255] = material;
    let mut loaded = ShaderWords::unloaded(24, 4);
    for (address, word) in words.load_words() {
        loaded.load(address, word);
    }
    assert_eq!(loaded, words);
}
