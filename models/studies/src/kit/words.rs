//! Widths of machines: as long as asked for, then as short as scenes allow; and what is drawn in them.

use imogene_analysis::metrics::Drawing;
use imogene_contract::MachineWords;
use imogene_golden::machine::shader::shade_picture;
use imogene_prepare::lit_sphere::{SphereForm, shadowed_lights, sphere_words};
use imogene_prepare::shader::{ShaderError, material_numbers, shader_words};
use imogene_prepare::{NeededWidths, PreparedScene};
use imogene_scene::FramedScene;

/// What a machine shows of a scene, with the colours of its shading processor, or of tables of this form.
pub fn drawn(
    scene: &FramedScene,
    prepared: &PreparedScene,
    tables: Option<SphereForm>,
) -> Result<Drawing, ShaderError> {
    let format = &prepared.format;
    let shader = match tables {
        Some(form) => sphere_words(scene, format, form, shadowed_lights(prepared) as u32)?,
        None => shader_words(scene, format)?,
    };
    let materials = material_numbers(scene);
    Ok(Drawing::shaded_by(prepared, |frame, lighting| {
        shade_picture(frame, lighting, &materials, &shader)
    }))
}

/// The widths of a machine before it is known what its scenes require.
pub const fn widest(
    depth: u32,
    normal: u32,
    (guard_linear, guard_quadratic): (u32, u32),
    dropped_rows: u32,
) -> MachineWords {
    MachineWords {
        normal,
        guard_linear,
        guard_quadratic,
        dropped_rows,
        ..MachineWords::of(depth)
    }
}

/// The narrowest widths that take all scenes, and these; `prepared` gives nothing where a word is too short.
pub fn narrowest<E>(
    wide: &MachineWords,
    prepared: impl Fn(&MachineWords) -> Result<Option<Vec<PreparedScene>>, E>,
) -> Result<Option<(MachineWords, Vec<PreparedScene>)>, E> {
    let Some(in_wide) = prepared(wide)? else {
        return Ok(None);
    };
    let each = in_wide.iter().map(PreparedScene::needed);
    let most = each.fold(NeededWidths::default(), |most, one| most.or(&one));
    let mut widths = most.narrowed(wide);
    // The root of the rounded words may need a bit more in the narrower word; never more than the wide one has.
    while widths != *wide {
        if let Some(scenes) = prepared(&widths)? {
            return Ok(Some((widths, scenes)));
        }
        widths.root = (widths.root + 1).min(wide.root);
        widths.plane = (widths.plane + 1).min(wide.plane);
    }
    Ok(Some((*wide, in_wide)))
}
