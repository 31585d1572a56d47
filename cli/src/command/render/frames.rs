//! `imogene render --frames`.

use super::models::{exact_frame, exact_lighting};
use crate::arguments::{FrameRange, Model, Render};
use crate::command::{read_scene, size_of};
use crate::failure::{Failure, Result};
use crate::{missing, output};
use imogene_analysis::phong;
use imogene_files::{Outputs, WriteError};
use imogene_prepare::Reuse;
use imogene_prepare::animator::{Animator, PreparedFrame};
use imogene_studies::picture::Preview;
use serde::Serialize;
use std::path::PathBuf;
use std::time::Instant;

/// The frames that were drawn; the keys are stable.
#[derive(Serialize)]
struct FramesReport {
    scene: PathBuf,
    model: Model,
    width: u32,
    height: u32,
    seconds: f64,
    /// Animated PNG of the frames.
    preview: PathBuf,
    /// Sums over the frames.
    #[serde(flatten)]
    reuse: Reuse,
    frames: Vec<FrameReport>,
}

/// One frame; the keys are stable.
#[derive(Serialize)]
struct FrameReport {
    /// Number in the animation, from 1.
    frame: usize,
    image: String,
    /// Frame of the image, from 1.
    step: u32,
    steps: u32,
    /// Seconds that it is shown.
    duration: f64,
    prepare_seconds: f64,
    draw_seconds: f64,
    covered_pixels: usize,
    #[serde(flatten)]
    reuse: Reuse,
    file: PathBuf,
}

/// Draws the frames of an animation, one after the other; objects, shadows and lines of each in parallel.
pub fn run(options: &Render, range: FrameRange, json: bool) -> Result {
    if options.model == Model::Rtl {
        return Err(Failure::Input(
            "--frames are drawn by the models; give --model golden or exact, or one --frame to --model rtl".into(),
        ));
    }
    let started = Instant::now();
    let path = &options.scene.scene;
    let file = read_scene(path, &options.scene.view)?;
    let size = size_of(&file, options.scene.size);
    let format = options.scene.format()?;
    let animator = Animator::new(&file, size, format, missing::options());
    let animator = animator.map_err(Failure::in_file(path))?;
    let range = range.of("--frames", animator.playback.count());
    let range = range.map_err(Failure::in_file(path))?;
    let preview_path = options.output().join("animation.png");
    let count = range.clone().count();
    let failed = |error| Failure::from(WriteError::at(&preview_path)(error));
    let mut files = output::files();
    let preview = Preview::new(files.open(&preview_path)?, size, count as u32);
    let mut preview = preview.map_err(failed)?;
    let frames = draw(options, animator, range, &mut files, |rgb, seconds| {
        preview.frame(rgb, seconds).map_err(failed)
    })?;
    preview.finish().map_err(failed)?;
    let report = FramesReport {
        scene: path.clone(),
        model: options.model,
        width: size.0,
        height: size.1,
        seconds: started.elapsed().as_secs_f64(),
        preview: preview_path.clone(),
        reuse: total(&frames),
        frames,
    };
    let report_path = options.output().join("frames.json");
    files.add_text(&report_path, &(output::json_text(&report) + "\n"))?;
    files.finish()?;
    output::told(json, &report, include_str!("frames.txt"))?;
    if !json {
        output::wrote(&[report_path]);
    }
    Ok(())
}

fn draw(
    options: &Render,
    mut animator: Animator,
    range: std::ops::RangeInclusive<usize>,
    files: &mut Outputs,
    mut show: impl FnMut(&[u8], f64) -> Result,
) -> Result<Vec<FrameReport>> {
    let bar = output::progress(range.clone().count() as u64, "frames");
    let mut reports = vec![];
    for number in range {
        let started = Instant::now();
        let frame = animator.prepare(number - 1, &|| ());
        let frame = frame.map_err(|error| {
            bar.finish_and_clear();
            let problem = format!("frame {number}: {error}");
            Failure::at(&options.scene.scene, problem)
        })?;
        bar.suspend(|| {
            missing::tell(&format!("frame {number}: "), &frame.framed, &frame.prepared)
        })?;
        let prepare_seconds = started.elapsed().as_secs_f64();
        let file = options.output().join(format!("frame-{number:04}.png"));
        let started = Instant::now();
        let (rgb, covered_pixels) = picture_of(options, &frame);
        let draw_seconds = started.elapsed().as_secs_f64();
        let size = [frame.prepared.width, frame.prepared.height].map(|side| side as usize);
        output::add_picture(files, &file, size, &rgb)?;
        show(&rgb, frame.frame.duration)?;
        reports.push(FrameReport {
            frame: number,
            image: frame.frame.image,
            step: frame.frame.step,
            steps: frame.frame.steps,
            duration: frame.frame.duration,
            prepare_seconds,
            draw_seconds,
            covered_pixels,
            reuse: frame.reuse,
            file,
        });
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(reports)
}

/// Red, green and blue of every pixel, and how many pixels show an object.
fn picture_of(options: &Render, frame: &PreparedFrame) -> (Vec<u8>, usize) {
    let (framed, prepared) = (&frame.framed, &frame.prepared);
    let is_exact = options.model == Model::Exact;
    let drawn = match is_exact {
        true => exact_frame(framed, prepared),
        false => prepared.frame(|| ()),
    };
    let lighting = match is_exact {
        true => exact_lighting(framed, &drawn),
        false => prepared.light(&drawn, || ()),
    };
    let rgb = phong::shade(&drawn, &lighting, framed, &prepared.format);
    (rgb, drawn.covered())
}

fn total(frames: &[FrameReport]) -> Reuse {
    let mut sum = Reuse::default();
    for FrameReport { reuse, .. } in frames {
        sum.objects_prepared += reuse.objects_prepared;
        sum.objects_reused += reuse.objects_reused;
        sum.volumes_prepared += reuse.volumes_prepared;
        sum.volumes_reused += reuse.volumes_reused;
    }
    sum
}
