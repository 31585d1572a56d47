//! Pixels per second, on one thread, of the golden quadric processor with three cut planes, in each instruction set
//! it is compiled for, beside a plain floating-point ray caster that solves the same object on the same pixels (front
//! depth, face and normal).

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use imogene_algebra::rational::{integer, to_f64};
use imogene_golden::format::Format;
use imogene_golden::object::line::{Instructions, for_each_present_by};
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_prepare::prepare;
use imogene_scene::{DepthRange, FramedQuadric, FramedScene, Plane, Projection, Quadric, Surface};
use std::hint::black_box;

const WIDTH: u32 = 720;
const HEIGHT: u32 = 540;
const DISTANCE: i64 = 1000;

/// A ball that fills most of the screen, its front cut off by three planes that meet in a corner.
fn scene() -> FramedScene {
    let [a, b, c, d, e, f, g, h, i, j] = [1, 1, 1, 0, 0, 0, -20, 10, -500, 160_500].map(integer);
    let plane = |coefficients: [i64; 4]| {
        let [a, b, c, d] = coefficients.map(integer);
        Plane { a, b, c, d }
    };
    let cut = FramedQuadric {
        name: "cut ball".into(),
        surface: Surface::Solid,
        quadric: Quadric {
            a,
            b,
            c,
            d,
            e,
            f,
            g,
            h,
            i,
            j,
        },
        planes: vec![
            plane([0, 0, -1, 260]),
            plane([2, 1, -2, 420]),
            plane([-1, 3, -2, 510]),
        ],
        material: 0,
        casts_shadow: true,
    };
    let projection = Projection::Perspective {
        distance: integer(DISTANCE),
    };
    FramedScene {
        title: "benchmark".into(),
        width: WIDTH,
        height: HEIGHT,
        range: DepthRange::of_pixels(&projection),
        sample_at: [0.0; 2],
        projection,
        objects: vec![cut.into()],
        solids: vec![],
        materials: vec![],
        lights: vec![],
        sources: vec![],
        ambient: [1.0; 3],
        attenuation: None,
        background: [0; 3],
    }
}

/// Everything that is handed on, folded into one number so that nothing is optimised away.
fn golden(instructions: Instructions, words: &QuadricWords, window: &ScreenBox) -> i64 {
    let mut sum = 0i64;
    for y in window.y0..=window.y1 {
        for_each_present_by(instructions, words, &Format::BASE, y, |x, pixel| {
            let [nx, ny, nz] = pixel.normal.map(i64::from);
            sum =
                sum.wrapping_add(x ^ pixel.zf ^ pixel.zb ^ i64::from(pixel.number) ^ nx ^ ny ^ nz);
        });
    }
    sum
}

/// The same object in floating point.
struct Caster {
    quadric: [f64; 10],
    planes: Vec<[f64; 4]>,
}

impl Caster {
    fn new(object: &FramedQuadric) -> Caster {
        Caster {
            quadric: object.quadric.coefficients().map(to_f64),
            planes: object
                .planes
                .iter()
                .map(|p| p.coefficients().map(to_f64))
                .collect(),
        }
    }

    /// Front depth along the ray, face and unit normal at a pixel.
    #[inline]
    fn first_hit(&self, x: i64, y: i64) -> Option<(f64, usize, [f64; 3])> {
        let [a, b, c, d, e, f, g, h, i, j] = self.quadric;
        let distance = DISTANCE as f64;
        let [dx, dy, dz] = [
            (x - i64::from(WIDTH / 2)) as f64,
            (y - i64::from(HEIGHT / 2)) as f64,
            distance,
        ];
        let square = (a * dx + 2.0 * d * dy) * dx
            + (b * dy + 2.0 * f * dz) * dy
            + (c * dz + 2.0 * e * dx) * dz;
        let half = (g - e * distance) * dx + (h - f * distance) * dy + (i - c * distance) * dz;
        let eye = (c * distance - 2.0 * i) * distance + j;
        let discriminant = half * half - square * eye;
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        let (mut near, mut far) = ((-half - root) / square, (-half + root) / square);
        let mut face = 0;
        for (index, [pa, pb, pc, pd]) in self.planes.iter().enumerate() {
            let slope = pa * dx + pb * dy + pc * dz;
            let crossing = (pc * distance - pd) / slope;
            if slope < 0.0 {
                if crossing > near {
                    (near, face) = (crossing, 2 + index);
                }
            } else if crossing < far {
                far = crossing;
            }
        }
        if near > far {
            return None;
        }
        Some((
            near,
            face,
            self.normal(face, [near * dx, near * dy, near * dz - distance]),
        ))
    }

    #[inline]
    fn normal(&self, face: usize, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c, d, e, f, g, h, i, _] = self.quadric;
        let normal = match face {
            0 => [
                a * x + d * y + e * z + g,
                d * x + b * y + f * z + h,
                e * x + f * y + c * z + i,
            ],
            plane => [
                self.planes[plane - 2][0],
                self.planes[plane - 2][1],
                self.planes[plane - 2][2],
            ],
        };
        let length = normal.iter().map(|v| v * v).sum::<f64>().sqrt();
        normal.map(|v| v / length)
    }
}

fn float(caster: &Caster, window: &ScreenBox) -> f64 {
    let mut sum = 0.0;
    for y in window.y0..=window.y1 {
        for x in window.x0..=window.x1 {
            if let Some((depth, face, [nx, ny, nz])) = caster.first_hit(x, y) {
                sum += depth + face as f64 + nx + ny + nz;
            }
        }
    }
    sum
}

fn benchmark(criterion: &mut Criterion) {
    let scene = scene();
    let prepared = prepare(&scene, Format::BASE).expect("fits the base format");
    let words = &prepared.objects[0].quadric().expect("a quadric").words;
    let window = words.screen_box;
    let caster = Caster::new(scene.objects[0].quadric().expect("a quadric"));
    let mut group = criterion.benchmark_group("quadric processor, three planes");
    group.throughput(Throughput::Elements(window.pixels()));
    for instructions in Instructions::available() {
        let name = format!("golden integer model, {instructions:?}");
        group.bench_function(name, |b| {
            b.iter(|| golden(instructions, black_box(words), &window));
        });
    }
    group.bench_function("floating-point ray caster", |b| {
        b.iter(|| float(black_box(&caster), &window));
    });
    group.finish();
}

criterion_group!(benches, benchmark);
criterion_main!(benches);
