//! The part of a beam machine that draws: from the raster to the colour of every pixel.

use super::object_array::ObjectArray;
use super::shading_processor::ShadingProcessor;
use super::volume_array::VolumeArray;
use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;
use crate::unit::delay::{FlagDelay, WordDelay};

/// How many processors of what kind a beam machine has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BeamShape {
    /// Object processors, one for each object.
    pub objects: usize,
    /// Cut planes of each.
    pub planes: usize,
    /// Volume processors, one for each shadow or light volume; may be none.
    pub volumes: usize,
    /// Planes of each.
    pub volume_planes: usize,
    /// Rows of the root networks between registers.
    pub rows_per_stage: usize,
    /// Bits of the address of a word that waits for the vertical blanking.
    pub loader_bits: usize,
}

/// Draws pixel after pixel: a processor for each object and each volume, the decider, the shadow stage, the material table, the shading processor.
///
/// Widths: `W1 = W + 1`, `S = W + 2`, `F = 2 W`, `P = W + 12`.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `valid`, `start`, `line`, `x`, `y` | in | raster flags and pixel |
/// | `load_object`, `load_volume`, `load_shading`, `load_material` | in | a word is on the load bus for them |
/// | `load_unit`, `load_address`, `load_data` | in | the load bus |
/// | `take` | in | all words of a frame are there |
/// | `out_valid`, `red`, `green`, `blue` | out | the colour of a pixel, 8 bits |
///
/// Latency [`Self::latency`]. The id of an object is the number of its processor. The words of an object stay until they are written again; a volume takes part
/// if its control word was written between the last two `take`.
pub struct BeamCore<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
{
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// This clock carries a pixel.
    pub valid: Signal<In, Bit>,
    /// First pixel of the frame.
    pub start: Signal<In, Bit>,
    /// First pixel of a later line.
    pub line: Signal<In, Bit>,
    /// Column.
    pub x: Signal<In, Word<12>>,
    /// Line.
    pub y: Signal<In, Word<12>>,
    /// A word for an object.
    pub load_object: Signal<In, Bit>,
    /// A word for a volume.
    pub load_volume: Signal<In, Bit>,
    /// A word for the shading processor.
    pub load_shading: Signal<In, Bit>,
    /// A material.
    pub load_material: Signal<In, Bit>,
    /// Unit of the word.
    pub load_unit: Signal<In, Word<8>>,
    /// Address of the word.
    pub load_address: Signal<In, Word<16>>,
    /// The word.
    pub load_data: Signal<In, Word<F>>,
    /// All words are there.
    pub take: Signal<In, Bit>,
    /// A colour is here.
    pub out_valid: Signal<Out, Bit>,
    /// Red.
    pub red: Signal<Out, Word<8>>,
    /// Green.
    pub green: Signal<Out, Word<8>>,
    /// Blue.
    pub blue: Signal<Out, Word<8>>,
    objects: ObjectArray<W, W1, S, F, P>,
    volumes: Vec<VolumeArray<W, W1, S, F, P>>,
    volume_flags: Vec<FlagDelay>,
    volume_x: Vec<WordDelay<Word<12>>>,
    volume_y: Vec<WordDelay<Word<12>>>,
    materials: BlockMemory<12, 8>,
    shading: ShadingProcessor<W>,
    late_valid: WordDelay<Bit>,
    late_x: WordDelay<Word<12>>,
    late_y: WordDelay<Word<12>>,
    late_depth: WordDelay<Int<W>>,
    late_nx: WordDelay<Int<16>>,
    late_ny: WordDelay<Int<16>>,
    late_nz: WordDelay<Int<16>>,
    late_material: WordDelay<Word<8>>,
    word_address: Signal<Local, Word<8>>,
    source_flags: Signal<Local, Word<16>>,
    all_sources: Constant<Word<16>>,
    _lit: usize,
    _dark: usize,
    _asleep: bool,
}

block! {
    [const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize] BeamCore [W, W1, S, F, P]
    inputs { clock, valid, start, line, x, y, load_object, load_volume, load_shading, load_material, load_unit, load_address, load_data, take }
    parts { out_valid, red, green, blue, objects, volumes, volume_flags, volume_x, volume_y, materials, shading, late_valid,
        late_x, late_y, late_depth, late_nx, late_ny, late_nz, late_material, word_address, source_flags, all_sources }
    data { _lit, _dark }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>
    BeamCore<W, W1, S, F, P>
{
    /// The core of a shape with `lights` lights.
    ///
    /// # Panics
    ///
    /// When the widths do not fit each other or a number is out of range.
    pub fn new(shape: &BeamShape, lights: usize) -> Self {
        let rows = shape.rows_per_stage;
        let lit = shape.volumes.min(1);
        let drawn = ObjectArray::<W, W1, S, F, P>::latency(shape.objects, shape.planes, rows);
        let volume_start = drawn - VolumeArray::<W, W1, S, F, P>::depth_offset(rows);
        let decided = Self::decided(shape);
        fields! {
            [clock, valid, start, line, x, y, load_object, load_volume, load_shading, load_material, load_unit, load_address, load_data, take, out_valid,
                red, green, blue, word_address, source_flags]
            objects: ObjectArray::new(shape.objects, shape.planes, rows, false),
            volumes: repeat(lit, || VolumeArray::new(shape.volumes, shape.volume_planes, rows)),
            volume_flags: repeat(lit, || FlagDelay::new(volume_start)),
            volume_x: repeat(lit, || WordDelay::new(volume_start)),
            volume_y: repeat(lit, || WordDelay::new(volume_start)),
            materials: BlockMemory::of_address_bits(8),
            shading: ShadingProcessor::new(lights),
            late_valid: WordDelay::new(decided - drawn),
            late_x: WordDelay::new(decided),
            late_y: WordDelay::new(decided),
            late_depth: WordDelay::new(decided - drawn),
            late_nx: WordDelay::new(decided - drawn),
            late_ny: WordDelay::new(decided - drawn),
            late_nz: WordDelay::new(decided - drawn),
            late_material: WordDelay::new(decided - drawn - 1),
            all_sources: constant(0xffff),
            _lit: lit,
            _dark: 1 - lit,
        }
    }

    /// Clocks from a wanted pixel to what the shading processor is told of it.
    fn decided(shape: &BeamShape) -> usize {
        let rows = shape.rows_per_stage;
        let drawn = ObjectArray::<W, W1, S, F, P>::latency(shape.objects, shape.planes, rows);
        if shape.volumes == 0 {
            return drawn + 1;
        }
        drawn - VolumeArray::<W, W1, S, F, P>::depth_offset(rows)
            + VolumeArray::<W, W1, S, F, P>::latency(shape.volumes, rows)
    }

    /// Clocks from a pixel to its colour.
    pub fn latency(shape: &BeamShape) -> usize {
        Self::decided(shape) + ShadingProcessor::<W>::latency()
    }
}

impl<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize> Logic
    for BeamCore<W, W1, S, F, P>
{
    #[hdl_gen]
    fn update(&mut self) {
        comment!("beam_core");
        clock!(
            self,
            clock,
            objects,
            materials,
            shading,
            late_valid,
            late_x,
            late_y,
            late_depth,
            late_nx,
            late_ny,
            late_nz,
            late_material
        );
        self.word_address.next = self.load_address.val().get_bits::<8>(0);
        self.objects.valid.next = self.valid.val();
        self.objects.start.next = self.start.val();
        self.objects.line.next = self.line.val();
        self.objects.x.next = self.x.val();
        self.objects.y.next = self.y.val();
        self.objects.take.next = self.take.val();
        self.objects.load_valid.next = self.load_object.val();
        self.objects.load_object.next = self.load_unit.val();
        self.objects.load_address.next = self.word_address.val();
        self.objects.load_data.next = self.load_data.val();
        self.materials.write.next = self.load_material.val();
        self.materials.write_address.next = self.load_address.val().get_bits::<12>(0);
        self.materials.write_data.next = self.load_data.val().get_bits::<8>(0);
        self.materials.read_address.next = self.objects.id.val();
        self.late_material.word.next = self.materials.read_data.val();
        self.late_valid.word.next = self.objects.out_valid.val();
        self.late_depth.word.next = self.objects.depth.val();
        self.late_nx.word.next = self.objects.nx.val();
        self.late_ny.word.next = self.objects.ny.val();
        self.late_nz.word.next = self.objects.nz.val();
        self.late_x.word.next = self.x.val();
        self.late_y.word.next = self.y.val();
        for _i in 0..self._dark {
            self.source_flags.next = self.all_sources.val();
        }
        for i in 0..self._lit {
            self.volume_flags[i].clock.next = self.clock.val();
            self.volume_flags[i].valid.next = self.valid.val();
            self.volume_flags[i].start.next = self.start.val();
            self.volume_flags[i].line.next = self.line.val();
            self.volume_x[i].clock.next = self.clock.val();
            self.volume_x[i].word.next = self.x.val();
            self.volume_y[i].clock.next = self.clock.val();
            self.volume_y[i].word.next = self.y.val();
            self.volumes[i].clock.next = self.clock.val();
            self.volumes[i].valid.next = self.volume_flags[i].late_valid.val();
            self.volumes[i].start.next = self.volume_flags[i].late_start.val();
            self.volumes[i].line.next = self.volume_flags[i].late_line.val();
            self.volumes[i].x.next = self.volume_x[i].late.val();
            self.volumes[i].y.next = self.volume_y[i].late.val();
            self.volumes[i].depth.next = self.objects.depth.val();
            self.volumes[i].flags_in.next = self.all_sources.val();
            self.volumes[i].take.next = self.take.val();
            self.volumes[i].load_valid.next = self.load_volume.val();
            self.volumes[i].load_volume.next = self.load_unit.val();
            self.volumes[i].load_address.next = self.word_address.val();
            self.volumes[i].load_data.next = self.load_data.val();
            self.source_flags.next = self.volumes[i].source_flags.val();
        }
        self.shading.load_valid.next = self.load_shading.val();
        self.shading.load_address.next = self.load_address.val();
        self.shading.load_data.next = self.load_data.val().get_bits::<32>(0);
        self.shading.valid.next = self.late_valid.late.val();
        self.shading.x.next = self.late_x.late.val();
        self.shading.y.next = self.late_y.late.val();
        self.shading.material.next = self.late_material.late.val();
        self.shading.flags.next = self.source_flags.val();
        self.shading.depth.next = self.late_depth.late.val();
        self.shading.nx.next = self.late_nx.late.val();
        self.shading.ny.next = self.late_ny.late.val();
        self.shading.nz.next = self.late_nz.late.val();
        self.out_valid.next = self.shading.out_valid.val();
        self.red.next = self.shading.red.val();
        self.green.next = self.shading.green.val();
        self.blue.next = self.shading.blue.val();
    }
}

clocked!(BeamCore<const W: usize, const W1: usize, const S: usize, const F: usize, const P: usize>);
