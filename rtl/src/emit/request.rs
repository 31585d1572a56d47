//! A unit with its parameters: legal ranges, latency, and the command line that emits it.

use super::EmitError;
use crate::catalogue::Unit;
use crate::format::{
    DEPTH_WORDS, MOST_CARDS, MOST_CORRECTIONS, MOST_LAYERS, MOST_LIGHTS, MOST_LITERALS, MOST_MODE,
    MOST_OBJECTS, MOST_PLANES, MOST_PRODUCTS, MOST_SIDES,
};
use imogene_circuits::machine::shadow_clocks;
use imogene_contract::parameters::Parameters;
use imogene_contract::shading::LATENCY as SHADING_LATENCY;
use std::fmt::Write;

/// What to emit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EmitRequest {
    /// The unit.
    pub unit: Unit,
    /// Depth word `W` of the format.
    pub depth_word: usize,
    /// Cut planes of an object, 0 to 12.
    pub planes: usize,
    /// Rows of the root network between registers, 1 to `W`.
    pub rows_per_stage: usize,
    /// Object slots, 1 to 256.
    pub objects: usize,
    /// Digits that a shortened square root keeps, 1 to `W`; half of them if not given, as in the experiment of section B.10.
    pub digits: Option<usize>,
    /// Corrections of an approximate square root, 0 to 2; if not given, the fewest that stay under 1 % (section 4.1.2).
    pub corrections: Option<usize>,
    /// Sides of a facet, up to 4; 3 if not given.
    pub sides: Option<usize>,
    /// Number of a video mode, up to 3; 0 if not given.
    pub mode: Option<usize>,
    /// Cards of a decider, 1 to 64, with [`EmitRequest::objects`] processors each; 2 if not given.
    pub cards: Option<usize>,
    /// Layers of a transparency pipeline, 1 to 8; 2 if not given.
    pub layers: Option<usize>,
    /// Products of a solid, 1 to 16; 2 if not given.
    pub products: Option<usize>,
    /// Objects intersected in a product, 1 to 8; 2 if not given.
    pub intersected: Option<usize>,
    /// Objects taken away in a product, 0 to 8; 2 if not given.
    pub subtracted: Option<usize>,
    /// Lights of the shading processor, 1 to 4; 1 if not given.
    pub lights: Option<usize>,
}

impl EmitRequest {
    /// A unit at the base format 24, with the planes that are its default, 1 row per stage and 4 objects.
    pub fn new(unit: Unit) -> Self {
        Self {
            unit,
            depth_word: 24,
            planes: unit.default_planes(),
            rows_per_stage: 1,
            objects: 4,
            digits: None,
            corrections: None,
            sides: None,
            mode: None,
            cards: None,
            layers: None,
            products: None,
            intersected: None,
            subtracted: None,
            lights: None,
        }
    }

    /// Digits that the unit keeps.
    pub fn digits(&self) -> usize {
        self.digits.unwrap_or(self.depth_word / 2)
    }

    /// Corrections that the unit makes.
    pub fn corrections(&self) -> usize {
        let fewest = if self.unit == Unit::SquareRootLinear {
            2
        } else {
            1
        };
        self.corrections.unwrap_or(fewest)
    }

    /// Sides of the facet.
    pub fn sides(&self) -> usize {
        self.sides.unwrap_or(3)
    }

    /// Number of the video mode.
    pub fn mode(&self) -> usize {
        self.mode.unwrap_or(0)
    }

    /// Cards of the decider.
    pub fn cards(&self) -> usize {
        self.cards.unwrap_or(2)
    }

    /// Layers of the pipeline.
    pub fn layers(&self) -> usize {
        self.layers.unwrap_or(2)
    }

    /// Products of the solid.
    pub fn products(&self) -> usize {
        self.products.unwrap_or(2)
    }

    /// Objects intersected in a product.
    pub fn intersected(&self) -> usize {
        self.intersected.unwrap_or(2)
    }

    /// Objects taken away in a product.
    pub fn subtracted(&self) -> usize {
        self.subtracted.unwrap_or(2)
    }

    /// Lights of the shading processor.
    pub fn lights(&self) -> usize {
        self.lights.unwrap_or(1)
    }

    /// Checks every parameter against its legal range.
    pub fn check(&self) -> Result<(), EmitError> {
        check_format(self.depth_word)?;
        check_range("planes", self.planes, self.least("planes"), MOST_PLANES)?;
        check_range("rows per stage", self.rows_per_stage, 1, self.depth_word)?;
        check_range("objects", self.objects, 1, MOST_OBJECTS)?;
        check_range("digits", self.digits(), 1, self.depth_word)?;
        check_range("corrections", self.corrections(), 0, MOST_CORRECTIONS)?;
        check_range("sides", self.sides(), self.least("sides"), MOST_SIDES)?;
        check_range("mode", self.mode(), 0, MOST_MODE)?;
        check_range("cards", self.cards(), 1, MOST_CARDS)?;
        if self.unit == Unit::CardDecider {
            let inputs = self.objects * self.cards();
            check_range("objects times cards", inputs, 1, MOST_OBJECTS)?;
        }
        check_range("layers", self.layers(), 1, MOST_LAYERS)?;
        check_range("products", self.products(), 1, MOST_PRODUCTS)?;
        check_range("intersected", self.intersected(), 1, MOST_LITERALS)?;
        check_range("subtracted", self.subtracted(), 0, MOST_LITERALS)?;
        check_range("lights", self.lights(), 1, MOST_LIGHTS)?;
        let given = [
            ("digits", self.digits),
            ("corrections", self.corrections),
            ("sides", self.sides),
            ("mode", self.mode),
            ("cards", self.cards),
            ("layers", self.layers),
            ("products", self.products),
            ("intersected", self.intersected),
            ("subtracted", self.subtracted),
            ("lights", self.lights),
        ];
        let has = |name| self.unit.parameters().iter().any(|p| p.option == name);
        match given
            .iter()
            .find(|(name, value)| value.is_some() && !has(*name))
        {
            Some((parameter, _)) => Err(EmitError::Foreign {
                parameter,
                unit: self.unit.name(),
            }),
            None => Ok(()),
        }
    }

    /// Least legal value of a parameter, 0 if the unit does not have it.
    fn least(&self, option: &str) -> usize {
        let mut parameters = self.unit.parameters().iter();
        parameters
            .find(|p| p.option == option)
            .map_or(0, |p| p.least)
    }

    /// What the circuit is built for.
    pub fn parameters(&self) -> Parameters {
        Parameters {
            depth_word: self.depth_word as u32,
            planes: self.planes as u32,
            rows_per_stage: self.rows_per_stage as u32,
            objects: self.objects as u32,
            digits: self.digits() as u32,
            corrections: self.corrections() as u32,
            sides: self.sides() as u32,
            mode: self.mode() as u32,
            cards: self.cards() as u32,
            layers: self.layers() as u32,
            products: self.products() as u32,
            intersected: self.intersected() as u32,
            subtracted: self.subtracted() as u32,
            lights: self.lights() as u32,
        }
    }

    /// Options of the command line and their values.
    pub fn options(&self) -> Vec<(&'static str, usize)> {
        let value = |option| match option {
            "planes" => self.planes,
            "rows-per-stage" => self.rows_per_stage,
            "digits" => self.digits(),
            "corrections" => self.corrections(),
            "sides" => self.sides(),
            "mode" => self.mode(),
            "cards" => self.cards(),
            "layers" => self.layers(),
            "products" => self.products(),
            "intersected" => self.intersected(),
            "subtracted" => self.subtracted(),
            "lights" => self.lights(),
            _ => self.objects,
        };
        let parameters = self.unit.parameters().iter();
        parameters.map(|p| (p.option, value(p.option))).collect()
    }

    /// Latency in clocks.
    pub fn latency(&self) -> usize {
        let root = self.depth_word.div_ceil(self.rows_per_stage);
        let short_root = self.digits().div_ceil(self.rows_per_stage);
        let decision = tree(self.objects);
        match self.unit {
            Unit::SquareRoot | Unit::SquareRootNonRestoring => root,
            Unit::SquareRootIterative => self.depth_word,
            Unit::SquareRootRows => short_root,
            Unit::SquareRootLeading => short_root + 2,
            Unit::SquareRootLinear => 1 + 2 * self.corrections(),
            Unit::SquareRootQuadratic => 3 + 2 * self.corrections(),
            Unit::QuadricPe => root + 2,
            Unit::PlaneDepth => 2,
            Unit::NormalUnit => 3,
            Unit::QuadricProcessor => root + self.planes + 7,
            Unit::PatchProcessor => root + 7,
            Unit::FirstGenerationProcessor => root + 6,
            Unit::QuadricVolume => root + 4,
            Unit::PolyhedralVolume | Unit::CylinderProcessor => 3,
            Unit::PolyhedronProcessor => tree(self.planes) + 4,
            Unit::PatchDecider | Unit::FacetProcessor | Unit::CurvedFacetProcessor => 2,
            Unit::SphereProcessor | Unit::Overlay => 4,
            Unit::PixelFifo => 2,
            Unit::Accumulator | Unit::FrameStore | Unit::PostFilter => 3,
            Unit::Decider => decision,
            Unit::VisibilityChain => self.objects,
            Unit::CardDecider => self.objects + tree(self.cards()),
            Unit::CsgDecider => {
                let candidates = self.products() * (self.subtracted() + 1);
                tree(self.intersected()) + 1 + tree(candidates)
            }
            Unit::TransparencyStage => 2,
            Unit::TransparencyPipeline => 2 * self.layers(),
            Unit::ShadowStage => shadow_clocks(self.objects) as usize,
            Unit::Beam => 1 + (root + self.planes + 7) + decision,
            Unit::ShadingProcessor => SHADING_LATENCY,
            _ => 1,
        }
    }

    /// The command line that makes the same text.
    pub fn command(&self) -> String {
        self.command_with_prefix("")
    }

    /// The command line that makes the same text with a prefix before the names of modules; none if it is empty.
    pub fn command_with_prefix(&self, prefix: &str) -> String {
        let mut command = format!(
            "imogene emit {} --format {}",
            self.unit.name(),
            self.depth_word
        );
        for (option, value) in self.options() {
            let _ = write!(command, " --{option} {value}");
        }
        if !prefix.is_empty() {
            let _ = write!(command, " --prefix {prefix}");
        }
        command + " --out DIR"
    }
}

/// Levels of a binary tree.
const fn tree(inputs: usize) -> usize {
    inputs.next_power_of_two().trailing_zeros() as usize
}

/// Refuses a format outside the catalogue.
fn check_format(depth_word: usize) -> Result<(), EmitError> {
    if DEPTH_WORDS.contains(&depth_word) {
        Ok(())
    } else {
        Err(EmitError::Format { value: depth_word })
    }
}

fn check_range(
    parameter: &'static str,
    value: usize,
    least: usize,
    most: usize,
) -> Result<(), EmitError> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        Err(EmitError::Range {
            parameter,
            value,
            least,
            most,
        })
    }
}
