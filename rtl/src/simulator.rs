//! A processor or a machine of any format of the catalogue, behind one interface.
//!
//! The simulators hide the widths, which are compile-time parameters of the blocks, and speak plain integers. Outputs are
//! those visible after the clock edge.

use crate::catalogue::Unit;
use crate::emit::display::{DisplayRequest, with_machine};
use crate::emit::{EmitError, EmitRequest, Task, with_block};
use crate::for_format;
use crate::kernel::Ports;
use crate::machine::beam::Beam;
use crate::machine::coefficient_store::{
    BOX_COLUMNS, BOX_LINES, CONTROL, PLANE_ADDRESS, PLANE_WORDS,
};
use crate::object::quadric_processor::QuadricProcessor;
use crate::step::{Clocked, step};
use crate::word::{Int, Word};
use rust_hdl::core::prelude::{Block, Direction, In, Out, Signal};

/// Words of one cut plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlaneWords {
    /// 0 none, 1 front, 2 back, 3 perpendicular.
    pub kind: u8,
    /// Increment along the line.
    pub a: i64,
    /// Increment from line to line.
    pub b: i64,
    /// Value of the first pixel.
    pub c: i64,
    /// Normal.
    pub normal: [i16; 3],
}

/// Coefficient words of one quadric object.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct QuadricWords {
    /// Linear part: a, b, c.
    pub f1: [i64; 3],
    /// Quadratic, preconditioned: a2, b2, c, i0, p0, f.
    pub f2: [i64; 6],
    /// Normal components x, y, z: a, b, c of each.
    pub g: [[i64; 3]; 3],
    /// Factors of the root in the normal components.
    pub k: [i16; 3],
    /// First and last column of the screen box; empty if the first exceeds the last.
    pub box_x: (u16, u16),
    /// First and last line of the screen box.
    pub box_y: (u16, u16),
    /// 0 side, 1 front, 2 patch, 3 prism.
    pub class: u8,
    /// Places the root is shifted for the normal.
    pub shift: u8,
    /// Cut planes; a processor with more planes gets kind none for the others.
    pub planes: Vec<PlaneWords>,
}

impl QuadricWords {
    /// Addresses and data of the load bus, in ascending order. A negative number is extended over the whole word; the
    /// store keeps its low bits.
    pub fn load_words(&self) -> Vec<(u8, u64)> {
        let pair =
            |(first, last): (u16, u16)| u64::from(first & 0xfff) | (u64::from(last & 0xfff) << 12);
        let numbers = self
            .f1
            .iter()
            .chain(&self.f2)
            .chain(self.g.iter().flatten())
            .map(|word| *word as u64);
        let factors = self.k.iter().map(|word| i64::from(*word) as u64);
        let mut words: Vec<_> = (0..).zip(numbers.chain(factors)).collect();
        words.push((BOX_COLUMNS as u8, pair(self.box_x)));
        words.push((BOX_LINES as u8, pair(self.box_y)));
        words.push((
            CONTROL as u8,
            u64::from(self.class & 3) | (u64::from(self.shift & 31) << 2),
        ));
        for (number, plane) in self.planes.iter().enumerate() {
            let first = PLANE_ADDRESS + PLANE_WORDS * number as u64;
            words.extend((first as u8..).zip(plane.load_words()));
        }
        words
    }
}

impl PlaneWords {
    fn load_words(&self) -> [u64; 7] {
        let [nx, ny, nz] = self.normal.map(|word| i64::from(word) as u64);
        [
            u64::from(self.kind),
            self.a as u64,
            self.b as u64,
            self.c as u64,
            nx,
            ny,
            nz,
        ]
    }
}

/// An internal point of a processor at one moment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProbedPoint {
    /// Name, the same at every call.
    pub name: String,
    /// Bits.
    pub width: usize,
    /// Two's complement.
    pub signed: bool,
    /// Value; of an unsigned point of 64 bits the same bits.
    pub value: i64,
}

/// Inputs of a quadric processor at one clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ProcessorInputs {
    /// This clock carries a pixel.
    pub valid: bool,
    /// First pixel of the zone.
    pub start: bool,
    /// First pixel of a later line.
    pub line: bool,
    /// Column.
    pub x: u16,
    /// Line.
    pub y: u16,
}

/// Outputs of a quadric processor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ProcessorOutputs {
    /// The results belong to a pixel.
    pub valid: bool,
    /// Front depth.
    pub zf: i64,
    /// Back depth.
    pub zb: i64,
    /// Front face.
    pub number: u8,
    /// Normal.
    pub normal: [i16; 3],
}

/// Inputs of a beam machine at one clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BeamInputs {
    /// Begin a zone.
    pub go: bool,
    /// Pixels of a line.
    pub width: u16,
    /// Lines of the zone.
    pub height: u16,
}

/// Outputs of a beam machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BeamOutputs {
    /// This clock carries a result.
    pub valid: bool,
    /// Visible depth; `ZMAX` is background.
    pub depth: i64,
    /// Visible object.
    pub id: u8,
    /// Visible face.
    pub number: u8,
    /// Normal.
    pub normal: [i16; 3],
}

/// A quadric processor in simulation.
pub trait QuadricProcessorSimulator: Send {
    /// Sets the coefficient ports.
    fn set_words(&mut self, words: &QuadricWords);
    /// Gives one clock.
    fn clock(&mut self, inputs: ProcessorInputs) -> ProcessorOutputs;
    /// Clocks from the flags to the outputs.
    fn latency(&self) -> usize;
    /// The internal points as they stand.
    fn probe(&self) -> Vec<ProbedPoint>;
}

/// A beam machine in simulation.
pub trait BeamSimulator: Send {
    /// Writes one coefficient word; takes one clock. Not to be used while a zone is drawn.
    fn load(&mut self, object: u8, address: u8, data: u64);
    /// Gives one clock.
    fn clock(&mut self, inputs: BeamInputs) -> BeamOutputs;
    /// Clocks from `go` to the first pixel.
    fn latency(&self) -> usize;
    /// The internal points of the processor of a slot as they stand; none where there is no such slot.
    fn probe(&self, object: usize) -> Vec<ProbedPoint>;
}

/// A quadric processor of a format of the catalogue.
///
/// # Errors
///
/// When a parameter is out of its legal range.
pub fn quadric_processor_simulator(
    depth_word: usize,
    planes: usize,
    rows_per_stage: usize,
) -> Result<Box<dyn QuadricProcessorSimulator>, EmitError> {
    let request = EmitRequest {
        depth_word,
        planes,
        rows_per_stage,
        ..EmitRequest::new(Unit::QuadricProcessor)
    };
    request.check()?;
    for_format!(depth_word, processor(planes, rows_per_stage))
}

/// A beam machine of a format of the catalogue.
///
/// # Errors
///
/// When a parameter is out of its legal range.
pub fn beam_simulator(
    depth_word: usize,
    objects: usize,
    planes: usize,
    rows_per_stage: usize,
) -> Result<Box<dyn BeamSimulator>, EmitError> {
    EmitRequest {
        depth_word,
        planes,
        rows_per_stage,
        objects,
        ..EmitRequest::new(Unit::Beam)
    }
    .check()?;
    for_format!(depth_word, beam(objects, planes, rows_per_stage))
}

/// Any unit in simulation, driven by words in the order of its ports.
pub trait UnitSimulator: Send {
    /// Gives one clock. `inputs` holds a word for each input port but the clock, of which the low bits count; the answer
    /// holds a word for each output port.
    fn clock(&mut self, inputs: &[u64]) -> Vec<u64>;
}

impl<B: Clocked + Ports + Send> UnitSimulator for Simulated<B> {
    fn clock(&mut self, inputs: &[u64]) -> Vec<u64> {
        self.block.set_inputs(&mut inputs.iter().copied());
        step(&mut self.block);
        self.block.outputs()
    }
}

struct Simulate;

impl Task for Simulate {
    type Outcome = Box<dyn UnitSimulator>;

    fn run<B: Clocked + Ports + Send + 'static>(
        self,
        mut block: B,
    ) -> Result<Self::Outcome, EmitError> {
        block.connect_all();
        Ok(Box::new(Simulated { block, latency: 0 }))
    }
}

/// The unit that [`emit`](crate::emit::emit) gives for the same request; the order of the words is that of
/// [`Emitted::ports`](crate::emit::Emitted::ports).
///
/// # Errors
///
/// When a parameter is out of its legal range.
pub fn unit_simulator(request: &EmitRequest) -> Result<Box<dyn UnitSimulator>, EmitError> {
    with_block(request, Simulate)
}

/// The machine that [`emit_display`](crate::emit::display::emit_display) gives for the same request.
///
/// # Errors
///
/// When a number is out of its legal range.
pub fn display_simulator(request: &DisplayRequest) -> Result<Box<dyn UnitSimulator>, EmitError> {
    with_machine(request, Simulate)
}

fn processor<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>(
    planes: usize,
    rows_per_stage: usize,
) -> Result<Box<dyn QuadricProcessorSimulator>, EmitError> {
    let mut block = QuadricProcessor::<W, W1, S, F, P>::new(planes, rows_per_stage);
    block.connect_all();
    let latency = QuadricProcessor::<W, W1, S, F, P>::latency(planes, rows_per_stage);
    Ok(Box::new(Simulated { block, latency }))
}

fn beam<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>(
    objects: usize,
    planes: usize,
    rows_per_stage: usize,
) -> Result<Box<dyn BeamSimulator>, EmitError> {
    let mut block = Beam::<W, W1, S, F, P>::new(objects, planes, rows_per_stage);
    block.connect_all();
    let latency = Beam::<W, W1, S, F, P>::latency(objects, planes, rows_per_stage);
    Ok(Box::new(Simulated { block, latency }))
}

/// A block that is stepped by hand.
struct Simulated<B> {
    block: B,
    latency: usize,
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    QuadricProcessorSimulator for Simulated<QuadricProcessor<W, W1, S, F, P>>
{
    fn set_words(&mut self, words: &QuadricWords) {
        set_words(&mut self.block, words);
    }

    fn clock(&mut self, inputs: ProcessorInputs) -> ProcessorOutputs {
        let block = &mut self.block;
        block.valid.next = inputs.valid;
        block.start.next = inputs.start;
        block.line.next = inputs.line;
        block.x.next = Word::new(inputs.x.into());
        block.y.next = Word::new(inputs.y.into());
        step(block);
        ProcessorOutputs {
            valid: block.out_valid.val(),
            zf: block.zf.val().get(),
            zb: block.zb.val().get(),
            number: block.number.val().get() as u8,
            normal: normal(&block.nx, &block.ny, &block.nz),
        }
    }

    fn latency(&self) -> usize {
        self.latency
    }

    fn probe(&self) -> Vec<ProbedPoint> {
        points(&self.block)
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> BeamSimulator
    for Simulated<Beam<W, W1, S, F, P>>
{
    fn load(&mut self, object: u8, address: u8, data: u64) {
        let block = &mut self.block;
        block.go.next = false;
        block.load_valid.next = true;
        block.load_object.next = Word::new(object.into());
        block.load_address.next = Word::new(address.into());
        block.load_data.next = Word::new(data);
        step(block);
        block.load_valid.next = false;
    }

    fn clock(&mut self, inputs: BeamInputs) -> BeamOutputs {
        let block = &mut self.block;
        block.go.next = inputs.go;
        block.width.next = Word::new(inputs.width.into());
        block.height.next = Word::new(inputs.height.into());
        step(block);
        BeamOutputs {
            valid: block.valid.val(),
            depth: block.depth.val().get(),
            id: block.id.val().get() as u8,
            number: block.number.val().get() as u8,
            normal: normal(&block.nx, &block.ny, &block.nz),
        }
    }

    fn latency(&self) -> usize {
        self.latency
    }

    fn probe(&self, object: usize) -> Vec<ProbedPoint> {
        self.block
            .processors
            .get(object)
            .map_or_else(Vec::new, points)
    }
}

fn normal(
    x: &Signal<Out, Int<16>>,
    y: &Signal<Out, Int<16>>,
    z: &Signal<Out, Int<16>>,
) -> [i16; 3] {
    [x, y, z].map(|component| component.val().get() as i16)
}

fn set<D: Direction, const N: usize>(port: &mut Signal<D, Int<N>>, value: i64) {
    port.next = Int::new(value);
}

fn set_word<const N: usize>(port: &mut Signal<In, Word<N>>, value: impl Into<u64>) {
    port.next = Word::new(value.into());
}

fn set_words<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>(
    block: &mut QuadricProcessor<W, W1, S, F, P>,
    words: &QuadricWords,
) {
    let linear = [&mut block.f1_a, &mut block.f1_b, &mut block.f1_c];
    linear
        .into_iter()
        .zip(words.f1)
        .for_each(|(port, value)| set(port, value));
    let quadratic = [
        &mut block.f2_a2,
        &mut block.f2_b2,
        &mut block.f2_c,
        &mut block.f2_i0,
        &mut block.f2_p0,
        &mut block.f2_f,
    ];
    quadratic
        .into_iter()
        .zip(words.f2)
        .for_each(|(port, value)| set(port, value));
    let parts = [
        &mut block.gx_a,
        &mut block.gx_b,
        &mut block.gx_c,
        &mut block.gy_a,
        &mut block.gy_b,
        &mut block.gy_c,
        &mut block.gz_a,
        &mut block.gz_b,
        &mut block.gz_c,
    ];
    parts
        .into_iter()
        .zip(words.g.as_flattened())
        .for_each(|(port, value)| set(port, *value));
    let factors = [&mut block.kx, &mut block.ky, &mut block.kz];
    factors
        .into_iter()
        .zip(words.k)
        .for_each(|(port, value)| set(port, value.into()));
    set_word(&mut block.box_x0, words.box_x.0);
    set_word(&mut block.box_x1, words.box_x.1);
    set_word(&mut block.box_y0, words.box_y.0);
    set_word(&mut block.box_y1, words.box_y.1);
    set_word(&mut block.object_class, words.class);
    set_word(&mut block.shift, words.shift);
    for number in 0..block.planes.len() {
        let plane = words.planes.get(number).copied().unwrap_or_default();
        set_word(&mut block.plane_kind[number], plane.kind);
        set(&mut block.plane_a[number], plane.a);
        set(&mut block.plane_b[number], plane.b);
        set(&mut block.plane_c[number], plane.c);
        set(&mut block.plane_nx[number], plane.normal[0].into());
        set(&mut block.plane_ny[number], plane.normal[1].into());
        set(&mut block.plane_nz[number], plane.normal[2].into());
    }
}

/// Collects points under their names.
struct Points(Vec<ProbedPoint>);

impl Points {
    fn bit(&mut self, name: &str, value: bool) {
        self.push(name, 1, false, value.into());
    }

    fn word<const N: usize>(&mut self, name: &str, value: Word<N>) {
        self.push(name, N, false, value.get() as i64);
    }

    fn number<const N: usize>(&mut self, name: &str, value: Int<N>) {
        self.push(name, N, true, value.get());
    }

    fn push(&mut self, name: &str, width: usize, signed: bool, value: i64) {
        self.0.push(ProbedPoint {
            name: name.to_owned(),
            width,
            signed,
            value,
        });
    }
}

fn points<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>(
    block: &QuadricProcessor<W, W1, S, F, P>,
) -> Vec<ProbedPoint> {
    let mut points = Points(Vec::new());
    points.bit("valid", block.valid.val());
    points.bit("start", block.start.val());
    points.bit("line", block.line.val());
    points.word("x", block.x.val());
    points.word("y", block.y.val());
    let quadric = &block.quadric;
    points.number("f2", quadric.f2.value.val());
    points.word("root", quadric.square_root.root.val());
    points.number("f1", quadric.f1.value.val());
    points.number("near_sum", quadric.near_sum.val());
    points.number("far_sum", quadric.far_sum.val());
    points.bit("is_inside", quadric.is_inside.val());
    points.bit("in_box", block.in_box.late.val());
    let interval = &block.interval;
    points.number("interval_zf_a", interval.zf_a.val());
    points.word("interval_nf_a", interval.nf_a.val());
    points.number("interval_zb_a", interval.zb_a.val());
    points.word("interval_nb_a", interval.nb_a.val());
    points.number("interval_zf_b", interval.zf_b.val());
    points.word("interval_nf_b", interval.nf_b.val());
    points.number("interval_zb_b", interval.zb_b.val());
    points.word("interval_nb_b", interval.nb_b.val());
    for (number, plane) in block.planes.iter().enumerate() {
        points.number(&format!("plane_{number}_value"), plane.plane.value.val());
        points.number(&format!("plane_{number}_depth"), plane.depth.val());
        for (half, cut) in [("a", &block.cut_a[number]), ("b", &block.cut_b[number])] {
            points.number(&format!("cut_{number}_zf_{half}"), cut.cut_zf.val());
            points.word(&format!("cut_{number}_nf_{half}"), cut.cut_nf.val());
            points.number(&format!("cut_{number}_zb_{half}"), cut.cut_zb.val());
            points.word(&format!("cut_{number}_nb_{half}"), cut.cut_nb.val());
        }
    }
    points.number("merged_zf", block.merge.zf.val());
    points.word("merged_nf", block.merge.nf.val());
    points.number("merged_zb", block.merge.zb.val());
    points.word("merged_nb", block.merge.nb.val());
    points.number("gx", block.normal.component_x.g.value.val());
    points.number("gy", block.normal.component_y.g.value.val());
    points.number("gz", block.normal.component_z.g.value.val());
    points.bit("out_valid", block.out_valid.val());
    points.number("zf", block.zf.val());
    points.number("zb", block.zb.val());
    points.word("number", block.number.val());
    points.number("nx", block.nx.val());
    points.number("ny", block.ny.val());
    points.number("nz", block.nz.val());
    points.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn load_words_follow_the_address_map() {
        let words = QuadricWords {
            f1: [1, 2, -3],
            f2: [4, 5, 6, 7, 8, 9],
            g: [[10, 11, 12], [13, 14, 15], [16, 17, 18]],
            k: [19, -20, 21],
            box_x: (22, 23),
            box_y: (24, 25),
            class: 2,
            shift: 5,
            planes: vec![
                PlaneWords::default(),
                PlaneWords {
                    kind: 3,
                    a: 1,
                    b: 2,
                    c: 3,
                    normal: [4, 5, -6],
                },
            ],
        };
        let loaded = words.load_words();
        let addresses: Vec<_> = loaded.iter().map(|(address, _)| *address).collect();
        assert_eq!(addresses, (0..38).collect::<Vec<u8>>());
        let data = |address: usize| loaded[address].1;
        assert_eq!(
            (data(2), data(8), data(9), data(17)),
            (-3_i64 as u64, 9, 10, 18)
        );
        assert_eq!(
            (data(19), data(21), data(22), data(23)),
            (-20_i64 as u64, 22 | 23 << 12, 24 | 25 << 12, 2 | 5 << 2)
        );
        assert_eq!((data(31), data(34), data(37)), (3, 3, -6_i64 as u64));
    }
}
