//! The golden zone machine: it knows nothing but the beats that it is sent.

use super::ZoneMachine;
use super::beat::{Beat, command, kind};
use super::decode::Registers;
use super::sample::Sample;
use crate::format::Format;
use crate::machine::beam;
use crate::machine::frame::{Frame, FrameLayer};
use crate::machine::lighting::{ALL_SOURCES, Lighting};
use crate::object::member::for_each_seen;
use crate::object::quadric::{ObjectPixel, QuadricWords};
use crate::object::slot::{ProcessorWords, Slot};
use crate::object::volume_line::for_each_inside;
use crate::object::words::Words;
use imogene_contract::object::ProductSlots;
use serde::Serialize;
use std::collections::BTreeMap;
use thiserror::Error;

/// A stream that no host should send.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum StreamError {
    /// No such word, command or unit.
    #[error("beat {}: unit {}, address {} does not exist in this machine", .0.kind, .0.unit, .0.address)]
    Address(Beat),
    /// Commands in an order that has no meaning.
    #[error("{0}")]
    Order(&'static str),
    /// A pixel beside the picture.
    #[error("pixel ({0}, {1}) is shown outside the picture")]
    Outside(u16, u16),
    /// Two zones overlap.
    #[error("pixel ({0}, {1}) is shown twice")]
    Twice(u16, u16),
    /// Zones do not cover the screen.
    #[error("{0} pixels of the picture are not shown")]
    Missing(usize),
}

/// A pixel as it leaves for shading and the frame store.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ShownPixel {
    /// Column of the screen.
    pub x: u16,
    /// Line of the screen.
    pub y: u16,
    /// Which sample of the pixel it is.
    pub sample: Sample,
    /// Visible depth; the format's `z_max` where nothing is seen. There id and normal are 0 and all flags are set.
    pub depth: i64,
    /// Index of the object.
    pub id: u16,
    /// Normal of the visible face.
    pub normal: [i16; 3],
    /// Sources that reach the point.
    pub flags: u16,
    /// The last pixel of the zone.
    pub pass_ends: bool,
    /// The last pixel of the frame.
    pub last: bool,
}

#[derive(Clone, Copy, Debug)]
struct Kept {
    depth: i64,
    id: u16,
    normal: [i16; 3],
    flags: u16,
}

impl Kept {
    /// The nearer stays; at equal depth the smaller id, and of two parts of one object the one that came first.
    fn take(&mut self, id: u16, pixel: &ObjectPixel) {
        if (pixel.zf, id) < (self.depth, self.id) {
            self.depth = pixel.zf;
            self.id = id;
            self.normal = pixel.normal;
        }
    }
}

#[derive(Clone, Copy, Debug, Default)]
struct Progress {
    placed: bool,
    sized: bool,
    drawn: bool,
    lit: bool,
}

/// The machine.
#[derive(Clone, Debug)]
pub struct ZoneMachineModel {
    format: Format,
    objects: Vec<Registers>,
    products: Vec<ProductSlots>,
    layers: Vec<Registers>,
    /// The transparent objects of the zone that was shown last, by their places.
    shown: Vec<Option<FrameLayer>>,
    volumes: Vec<Registers>,
    /// Indices of the materials of objects, as the stream gave them.
    pub materials: BTreeMap<u16, u64>,
    /// Words of the shading processor, by address.
    pub shading: BTreeMap<u16, u64>,
    origin: [u16; 2],
    size: [u16; 2],
    progress: Progress,
    samples: u32,
    buffer: Vec<Kept>,
}

impl ZoneMachineModel {
    /// The machine before the first beat. The size of its zones is in the stream.
    pub fn new(format: &Format, machine: &ZoneMachine) -> ZoneMachineModel {
        let volumes = Registers::of_volume(machine.volume_planes);
        ZoneMachineModel {
            format: *format,
            objects: machine.slots.iter().map(Registers::of_object).collect(),
            products: machine.products.clone(),
            layers: machine.layers.iter().map(Registers::of_object).collect(),
            shown: vec![],
            volumes: vec![volumes; machine.volume_processors],
            materials: BTreeMap::new(),
            shading: BTreeMap::new(),
            origin: [0; 2],
            size: [0; 2],
            progress: Progress::default(),
            samples: machine.samples,
            buffer: vec![],
        }
    }

    /// One beat; the pixels that it shows go to `sink`.
    pub fn beat(&mut self, beat: &Beat, sink: impl FnMut(ShownPixel)) -> Result<(), StreamError> {
        let unknown = || StreamError::Address(*beat);
        let (unit, address, data) = (usize::from(beat.unit), beat.address, beat.data);
        let write = |registers: Option<&mut Registers>| {
            let is_written = registers.is_some_and(|own| own.write(address, data));
            is_written.then_some(()).ok_or_else(unknown)
        };
        match beat.kind {
            kind::OBJECT => write(self.objects.iter_mut().chain(&mut self.layers).nth(unit)),
            kind::VOLUME => write(self.volumes.get_mut(unit)),
            kind::SHADING => {
                self.shading.insert(address, data);
                Ok(())
            }
            kind::MATERIAL if address < 1 << super::ID_BITS => {
                self.materials.insert(address, data);
                Ok(())
            }
            kind::COMMAND => match address {
                command::ORIGIN => self.place(data),
                command::SIZE => self.resize(data),
                command::DRAW => self.draw(data),
                command::LIGHT => self.light(data),
                command::SHOW => self.show(data, sink),
                _ => Err(unknown()),
            },
            _ => Err(unknown()),
        }
    }

    /// A whole frame of `width x height` samples: the beats up to the one that says it is the last. Face numbers are
    /// not kept, so they are 0.
    pub fn frame(
        &mut self,
        beats: impl IntoIterator<Item = Beat>,
        width: usize,
        height: usize,
    ) -> Result<(Frame, Lighting), StreamError> {
        let mut frame = Frame::background(width, height, self.format.z_max());
        let mut lighting = Lighting::full(&frame);
        let mut shown = vec![false; width * height];
        let mut pixels = vec![];
        let mut layers: BTreeMap<usize, FrameLayer> = BTreeMap::new();
        for beat in beats {
            self.beat(&beat, |pixel| pixels.push(pixel))?;
            for (of_zone, pixel) in pixels.drain(..).enumerate() {
                let Sample { of, column, line } = pixel.sample;
                let place = |pixel: u16, sample| usize::from(pixel) * of as usize + sample as usize;
                let (x, y) = (place(pixel.x, column), place(pixel.y, line));
                if x >= width || y >= height {
                    return Err(StreamError::Outside(pixel.x, pixel.y));
                }
                let at = y * width + x;
                if std::mem::replace(&mut shown[at], true) {
                    return Err(StreamError::Twice(pixel.x, pixel.y));
                }
                for (place, layer) in self.shown.iter().enumerate() {
                    let Some(layer) = layer else { continue };
                    let own = layers.entry(place).or_insert_with(|| FrameLayer {
                        depth: vec![self.format.z_max(); width * height],
                        normal: vec![[0; 3]; width * height],
                        ..*layer
                    });
                    own.depth[at] = layer.depth[of_zone];
                    own.normal[at] = layer.normal[of_zone];
                }
                if pixel.depth != self.format.z_max() {
                    frame.depth[at] = pixel.depth;
                    frame.id[at] = pixel.id.into();
                    frame.normal[at] = pixel.normal;
                    lighting.flags[at] = pixel.flags;
                }
            }
            if beat.last {
                break;
            }
        }
        frame.layers = layers.into_values().collect();
        match shown.iter().filter(|&&shown| !shown).count() {
            0 => Ok((frame, lighting)),
            missing => Err(StreamError::Missing(missing)),
        }
    }

    fn place(&mut self, data: u64) -> Result<(), StreamError> {
        self.not_begun()?;
        self.origin = pair(data);
        self.progress.placed = true;
        Ok(())
    }

    fn resize(&mut self, data: u64) -> Result<(), StreamError> {
        self.not_begun()?;
        self.size = pair(data);
        self.progress.sized = true;
        refuse(self.size.contains(&0), "a zone without pixels")
    }

    fn not_begun(&self) -> Result<(), StreamError> {
        refuse(self.progress.drawn, "a zone moves after its first pass")
    }

    fn draw(&mut self, data: u64) -> Result<(), StreamError> {
        self.has_zone()?;
        let first = data & command::FIRST != 0;
        let why = "the first draw pass of a zone says so, and no other one";
        refuse(first == self.progress.drawn, why)?;
        refuse(self.progress.lit, "a draw pass after a light pass")?;
        if first {
            self.buffer = vec![self.background(); self.pixels()];
        }
        let objects = self.objects.iter_mut();
        let loaded = objects.map(|own| Some((own.id(), words_in(own, self.size, &self.format)?)));
        let mut loaded: Vec<Option<(u16, ProcessorWords)>> = loaded.collect();
        let members: usize = self.products.iter().map(ProductSlots::count).sum();
        let mut members = loaded.split_off(loaded.len() - members).into_iter();
        for (id, words) in loaded.into_iter().flatten() {
            self.draw_object(id, &words);
        }
        for product in self.products.clone() {
            let own = members.by_ref().take(product.count());
            self.draw_product(product.intersected, own.collect());
        }
        self.progress.drawn = true;
        Ok(())
    }

    /// The transparent objects that were loaded since the last zone was shown.
    fn show_layers(&mut self) {
        let (size, format) = (self.size, &self.format);
        let [width, height] = size.map(usize::from);
        let layers = self.layers.iter_mut().map(|registers| {
            let slot = Slot {
                object: registers.id().into(),
                words: words_in(registers, size, format)?,
                weight: Some(registers.weight()),
            };
            beam::layer(&slot, format, width, height)
        });
        self.shown = layers.collect();
    }

    fn draw_object(&mut self, id: u16, words: &ProcessorWords) {
        let lines = self.buffer.chunks_mut(self.size[0].into());
        for (y, line) in (0..).zip(lines) {
            words.for_each_present(&self.format, y, |x, pixel| {
                line[x as usize].take(id, &pixel);
            });
        }
    }

    /// Nothing, if an object is missing that is intersected. The id of a pixel is that of the object whose face it is.
    fn draw_product(&mut self, intersected: usize, loaded: Vec<Option<(u16, ProcessorWords)>>) {
        if loaded[..intersected].contains(&None) {
            return;
        }
        let quadric = |(id, words)| match words {
            ProcessorWords::Quadric(words) => (id, words),
            _ => unreachable!("the slots of products are of quadrics"),
        };
        let members = loaded.into_iter().flatten().map(quadric);
        let (ids, objects): (Vec<u16>, Vec<QuadricWords>) = members.unzip();
        let format = &self.format;
        let lines = self.buffer.chunks_mut(self.size[0].into());
        for (y, line) in (0..).zip(lines) {
            for_each_seen(&objects, intersected, format, y, |x, object, pixel| {
                line[x as usize].take(ids[object], &pixel);
            });
        }
    }

    fn light(&mut self, data: u64) -> Result<(), StreamError> {
        refuse(!self.progress.drawn, "a light pass before a draw pass")?;
        let first = data & command::FIRST != 0;
        let why = "the first light pass of a zone says so, and no other one";
        refuse(first == self.progress.lit, why)?;
        if first {
            for kept in &mut self.buffer {
                kept.flags = ALL_SOURCES;
            }
        }
        for index in 0..self.volumes.len() {
            if self.volumes[index].take() {
                self.apply_volume(index);
            }
        }
        self.progress.lit = true;
        Ok(())
    }

    fn apply_volume(&mut self, index: usize) {
        let mut words = self.volumes[index].volume(&self.format);
        words.crop(self.size);
        let width = usize::from(self.size[0]);
        for (y, line) in self.buffer.chunks_mut(width).enumerate() {
            let depths: Vec<i64> = line.iter().map(|kept| kept.depth).collect();
            let mut inside = vec![false; width];
            let sink = |x: usize| inside[x] = true;
            for_each_inside(&words, &self.format, y as i64, &depths, sink);
            for (kept, inside) in line.iter_mut().zip(inside) {
                kept.flags = words.after(kept.flags, inside);
            }
        }
    }

    fn show(&mut self, data: u64, mut sink: impl FnMut(ShownPixel)) -> Result<(), StreamError> {
        self.has_zone()?;
        let [lit, drawn, last] =
            [command::LIT, command::DRAWN, command::LAST_ZONE].map(|bit| data & bit != 0);
        let why = "a show pass whose bits are not the passes that there were";
        refuse(
            [lit, drawn] != [self.progress.lit, self.progress.drawn],
            why,
        )?;
        let why = "a show pass of a sample that the machine's pixels have not";
        let sample = Sample::of_bits(data, self.samples).ok_or(StreamError::Order(why))?;
        let pixels = self.pixels();
        let width = usize::from(self.size[0]);
        for index in 0..pixels {
            let background = self.background();
            let kept = self.buffer.get(index).filter(|_| drawn);
            let kept = kept.filter(|kept| kept.depth != background.depth);
            let kept = kept.copied().unwrap_or(background);
            sink(ShownPixel {
                x: self.origin[0] + (index % width) as u16,
                y: self.origin[1] + (index / width) as u16,
                depth: kept.depth,
                id: kept.id,
                normal: kept.normal,
                flags: if lit { kept.flags } else { ALL_SOURCES },
                sample,
                pass_ends: index + 1 == pixels,
                last: last && index + 1 == pixels,
            });
        }
        self.show_layers();
        self.progress = Progress::default();
        Ok(())
    }

    fn has_zone(&self) -> Result<(), StreamError> {
        let has_zone = self.progress.placed && self.progress.sized;
        refuse(!has_zone, "a pass before origin and size of the zone")
    }

    fn pixels(&self) -> usize {
        self.size.map(usize::from).iter().product()
    }

    fn background(&self) -> Kept {
        Kept {
            depth: self.format.z_max(),
            id: 0,
            normal: [0; 3],
            flags: ALL_SOURCES,
        }
    }
}

/// Words of an object in a zone of a size, if it was loaded since they were asked for.
fn words_in(registers: &mut Registers, size: [u16; 2], format: &Format) -> Option<ProcessorWords> {
    if !registers.take() {
        return None;
    }
    let mut words = registers.object(format);
    words.crop(size);
    Some(words)
}

fn refuse(wrong: bool, order: &'static str) -> Result<(), StreamError> {
    (!wrong).then_some(()).ok_or(StreamError::Order(order))
}

fn pair(data: u64) -> [u16; 2] {
    [data & 0xfff, data >> 12 & 0xfff].map(|word| word as u16)
}
