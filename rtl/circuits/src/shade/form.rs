//! What gives the pixels of a machine their colours.

use super::{
    FlatPoint, Lights, Point, Shaded, ShadingLoad, SpherePoint, Tables, flat_shading, lit_sphere,
    lit_sphere_nearest, shading_processor,
};
use imogene_contract::shading::{FLAT_LATENCY, LATENCY, table_latency};
use imogene_contract::words::NORMAL;
use imogene_hdl::{Value, join};

/// The form of shading that a machine has.
#[derive(Clone, Debug)]
pub struct Shading {
    /// Its lights. Without one, and without tables, every object has the ambient level of its material.
    pub lights: Lights,
    /// Tables in the place of a shading processor: each material has one for every way in which lights can reach it.
    pub tables: Option<Tables>,
}

impl Shading {
    /// Clocks from a point to its colour.
    pub fn latency(&self) -> u32 {
        match (&self.tables, self.lights.count) {
            (Some(tables), _) => table_latency(tables.places, tables.nearest),
            (None, 0) => FLAT_LATENCY,
            (None, _) => LATENCY as u32,
        }
    }

    /// True if colours depend on the flags of the sources.
    pub fn asks_sources(&self) -> bool {
        self.lights.count > 0
    }

    /// The colour of every point, one per clock. Latency [`Shading::latency`].
    pub fn shade(&self, at: &str, point: Point, load: ShadingLoad) -> Shaded {
        let full = point.normal.map(|part| part.extend(NORMAL));
        match (&self.tables, self.lights.count as u32) {
            (Some(tables), lights) => {
                let table = match lights {
                    0 => point.material,
                    lights => {
                        let own = point.material.low(point.material.width() - lights);
                        join([own, point.flags.low(lights)])
                    }
                };
                let point = SpherePoint {
                    valid: point.valid,
                    pixel: point.pixel,
                    depth: point.depth,
                    table,
                    normal: point.normal,
                };
                if tables.nearest {
                    return lit_sphere_nearest(at, point, load, tables);
                }
                let point = SpherePoint {
                    normal: full,
                    ..point
                };
                lit_sphere(at, point, load, tables)
            }
            (None, 0) => {
                let point = FlatPoint {
                    valid: point.valid,
                    depth: point.depth,
                    material: point.material,
                };
                flat_shading(at, point, load)
            }
            (None, _) => {
                let point = Point {
                    normal: full,
                    ..point
                };
                shading_processor(at, point, load, self.lights)
            }
        }
    }
}
