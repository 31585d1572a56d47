//! One scene of spheres and cylinders drawn by facets, by paraboloids and as quadrics, each measured against the exact
//! quadrics (sources: Nyiri, 4.1.2 and 5; Chaillou, IV.2.4).

pub mod errors;
pub mod speed;
pub mod tessellate;

use crate::kit::sheet::Sheet;
use imogene_algebra::rational::to_f64;
use imogene_analysis::metrics::map::colour;
use imogene_analysis::metrics::{PixelError, Truth};
use imogene_analysis::phong::shade;
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::object::slot::Slot;
use imogene_prepare::Framing;
use imogene_prepare::animator::FrameProblem;
use imogene_prepare::prepare;
use imogene_scene::{FramedObject, FramedScene, Processor, SceneFile};

/// Greatest distance of a fair polygon from its circle, in pixels.
pub const FAIR_ERROR: f64 = 0.5;

/// How round objects are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// As meshes with so many sides around.
    Facets(usize),
    /// As meshes whose sides are at most half a pixel from the circle, each object with a number of its own.
    FairFacets,
    /// By sphere and cylinder processors.
    Paraboloids,
    /// By quadric processors.
    Quadrics,
}

impl Variant {
    /// The five of the comparison.
    pub const ALL: [Variant; 5] = [
        Variant::Facets(8),
        Variant::Facets(20),
        Variant::FairFacets,
        Variant::Paraboloids,
        Variant::Quadrics,
    ];

    /// What it is called in reports.
    pub fn name(self) -> String {
        match self {
            Variant::Facets(sides) => format!("facets_{sides}"),
            Variant::FairFacets => "facets_fair".into(),
            Variant::Paraboloids => "paraboloids".into(),
            Variant::Quadrics => "quadrics".into(),
        }
    }
}

/// A variant as it was drawn.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Which.
    pub variant: Variant,
    /// Sides around, for each object; none if it is no mesh.
    pub sides: Vec<Option<usize>>,
    /// Processors in the order of the objects, facets that are turned away from the viewer left out.
    pub slots: Vec<Slot>,
    /// Facets of the meshes, those turned away as well.
    pub faces: usize,
    /// What the golden model draws.
    pub frame: Frame,
    /// The picture, 8-bit red, green and blue.
    pub rgb: Vec<u8>,
}

/// A scene of the quadric processor, its truth, and what round objects it has.
#[derive(Clone, Debug)]
pub struct Subject {
    file: SceneFile,
    format: Format,
    /// The scene itself.
    pub framed: FramedScene,
    /// What is truly seen.
    pub truth: Truth,
    /// Radius of each object in pixels.
    pub radii: Vec<f64>,
    /// Which of them are spheres.
    pub spheres: Vec<bool>,
}

impl Subject {
    /// Draws the truth of a scene at a size.
    /// Fails if the size is out of range, or an object is not one that paraboloids can draw.
    pub fn new(
        file: &SceneFile,
        size: (u32, u32),
        format: Format,
    ) -> Result<Subject, FrameProblem> {
        let framed = file.frame(size.0, size.1)?;
        let round = by(file, Processor::Paraboloid).frame(size.0, size.1)?;
        let radius = |object: &FramedObject| match object {
            FramedObject::Sphere(sphere) => to_f64(&sphere.radius),
            FramedObject::Cylinder(cylinder) => to_f64(&cylinder.radius),
            _ => unreachable!("paraboloids draw spheres and cylinders alone"),
        };
        let is_sphere = |object: &FramedObject| matches!(object, FramedObject::Sphere(_));
        Ok(Subject {
            file: file.clone(),
            format,
            truth: Truth::new(&framed, || ()),
            radii: round.objects.iter().map(radius).collect(),
            spheres: round.objects.iter().map(is_sphere).collect(),
            framed,
        })
    }

    /// Draws a variant; fails if an object of it does not fit the machine.
    pub fn draw(&self, variant: Variant) -> Result<Drawn, FrameProblem> {
        let sides = |object: usize| match variant {
            Variant::Facets(sides) => Some(sides),
            Variant::FairFacets => Some(fair_sides(self.radii[object])),
            Variant::Paraboloids | Variant::Quadrics => None,
        };
        let sides: Vec<Option<usize>> = (0..self.radii.len()).map(sides).collect();
        let mut file = match variant {
            Variant::Paraboloids => by(&self.file, Processor::Paraboloid),
            _ => self.file.clone(),
        };
        for (object, sides) in file.objects.iter_mut().zip(&sides) {
            if let Some(sides) = sides {
                tessellate::to_mesh(object, *sides);
            }
        }
        let mut framed = file.frame(self.framed.width, self.framed.height)?;
        let faces = tessellate::drop_turned_away(&mut framed);
        let slots = prepare(&framed, self.format)?.slots();
        let (width, height) = (framed.width as usize, framed.height as usize);
        let frame = beam::render(&slots, &self.format, width, height, || ());
        let rgb = shade(&frame, &Lighting::full(&frame), &framed, &self.format);
        Ok(Drawn {
            variant,
            sides,
            slots,
            faces,
            frame,
            rgb,
        })
    }
}

fn by(file: &SceneFile, processor: Processor) -> SceneFile {
    let mut file = file.clone();
    for object in &mut file.objects {
        object.processor = Some(processor);
    }
    file
}

/// Sides of the regular polygon in a circle of `radius` pixels that is nowhere more than [`FAIR_ERROR`] inside it:
/// `ceil(pi / acos(1 - error / R))`, at least 3.
pub fn fair_sides(radius: f64) -> usize {
    if radius <= FAIR_ERROR {
        return 3;
    }
    let half = (1.0 - FAIR_ERROR / radius).acos();
    ((std::f64::consts::PI / half).ceil() as usize).max(3)
}

/// The pictures of the variants in one row, the maps of their errors in the row below.
pub fn sheet(variants: &[(&Drawn, &[PixelError])], words_per_pixel: f64) -> Sheet {
    let frames = variants.iter().map(|(drawn, _)| &drawn.frame);
    let size = frames.map(|frame| (frame.width, frame.height)).next();
    let pair = |(drawn, pixels): &(&Drawn, &[PixelError])| {
        let map = pixels.iter();
        let map = map.flat_map(|pixel| colour(pixel, words_per_pixel));
        [drawn.rgb.clone(), map.collect()]
    };
    let pairs: Vec<[Vec<u8>; 2]> = variants.iter().map(pair).collect();
    Sheet::of(&pairs, size.unwrap_or_default(), variants.len())
}
