//! The shading processor against the shading in floating point, on whole pictures.

use imogene_analysis::phong::shade;
use imogene_golden::format::Format;
use imogene_golden::machine::beam::render;
use imogene_golden::machine::shader::shade_picture;
use imogene_prepare::Framing;
use imogene_prepare::lit_sphere::{SphereForm, sphere_words};
use imogene_prepare::prepare;
use imogene_prepare::shader::{ShaderError, material_numbers, shader_words};
use imogene_scene::{FramedScene, Projection};
use imogene_testkit::scene_file;

fn framed(name: &str) -> FramedScene {
    scene_file(name).frame(192, 144).unwrap()
}

#[test]
fn pictures_are_those_of_the_formula_to_one_level() {
    for name in [
        "molecule.toml",
        "orthographic.toml",
        "teapot.toml",
        "hyperbolic-paraboloid.toml",
        "shadows/robot.toml",
        "light/colonnade.toml",
    ] {
        for depth_word in [16, 24, 32] {
            let scene = framed(name);
            let prepared = prepare(&scene, Format::new(depth_word).unwrap()).unwrap();
            let frame = render(&prepared.slots(), &prepared.format, 192, 144, || {});
            let lighting = prepared.light(&frame, || {});
            let words = shader_words(&scene, &prepared.format).unwrap();
            let drawn = shade_picture(&frame, &lighting, &material_numbers(&scene), &words);
            let exact = shade(&frame, &lighting, &scene, &prepared.format);
            let differ = drawn.iter().zip(&exact).filter(|(a, b)| a != b).count();
            let most = drawn.iter().zip(&exact).map(|(a, b)| a.abs_diff(*b)).max();
            println!(
                "{name} {depth_word}: {differ} of {} differ, by {most:?}",
                exact.len()
            );
            assert!(frame.covered() > 1000);
            assert!(most <= Some(1), "{name}, format {depth_word}: {most:?}");
            assert!(differ * 50 < exact.len(), "{name}: {differ}");
        }
    }
}

#[test]
fn light_is_halved_at_the_distance_of_the_attenuation() {
    let mut scene = framed("cut-sphere.toml");
    let Projection::Perspective { distance } = scene.projection.clone() else {
        panic!("a perspective scene");
    };
    let distance = imogene_algebra::rational::to_f64(&distance);
    scene.ambient = [0.0; 3];
    let format = Format::BASE;
    let pixel = imogene_golden::machine::shader::Pixel {
        x: 96,
        y: 72,
        depth: 0,
        material: 0,
        normal: [0, 0, -32767],
        flags: u16::MAX,
    };
    let mut level = |attenuation| {
        scene.attenuation = attenuation;
        let words = shader_words(&scene, &format).unwrap();
        let shader = imogene_golden::machine::shader::Shader::new(&words);
        shader.levels(&pixel).unwrap()[0] as f64
    };
    let full = level(None);
    assert!(full > 0.0);
    for (k, part) in [(1.0, 0.5), (3.0, 0.75), (1.0 / 3.0, 0.25)] {
        let seen = level(Some(k * distance)) / full;
        assert!((seen - part).abs() < 1e-3, "{k}: {seen}");
    }
}

#[test]
fn what_the_processor_cannot_hold_is_refused() {
    let mut scene = framed("orthographic.toml");
    let format = Format::BASE;
    scene.attenuation = Some(1e-4);
    let refused = shader_words(&scene, &format);
    assert_eq!(refused, Err(ShaderError::Attenuation(1e-4)));
    let form = SphereForm {
        places: 4,
        nearest: false,
    };
    let refused = sphere_words(&scene, &format, form, 0);
    assert_eq!(refused, Err(ShaderError::NoDistance));
    scene.attenuation = None;
    scene.lights = vec![scene.lights[0]; 17];
    let error = shader_words(&scene, &format).unwrap_err();
    assert_eq!(error, ShaderError::Lights(17));
    assert!(error.to_string().contains("at most 16"));
    scene.lights.truncate(16);
    scene.width = 5000;
    assert!(matches!(
        shader_words(&scene, &format),
        Err(ShaderError::Picture(5000, 144))
    ));
    scene.width = 192;
    scene.materials = vec![scene.materials[0].clone(); 257];
    let refusal = shader_words(&scene, &format);
    assert_eq!(refusal, Err(ShaderError::Materials(257)));
}
