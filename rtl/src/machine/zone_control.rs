//! Carries out the command stream of a zone machine.

use crate::kernel::*;

/// What a beat of the stream carries, by its `tdest`.
pub const OBJECT_WORD: u64 = 0;
/// A word of a volume.
pub const VOLUME_WORD: u64 = 1;
/// A word of the shading processor.
pub const SHADING_WORD: u64 = 2;
/// The material of an object.
pub const MATERIAL: u64 = 3;
/// A command.
pub const COMMAND: u64 = 4;

/// Takes the beats of the command stream in order: coefficient words go to the processors, commands begin passes over the zone.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `s_tvalid`, `s_tready` | in, out | AXI4-Stream handshake |
/// | `s_tdest` | in | 4 bits: 0 word of an object, 1 of a volume, 2 of the shading processor, 3 material of an object, 4 command |
/// | `s_tuser` | in | 24 bits: unit in 23..16, address in 15..0 |
/// | `s_tdata` | in | `F` bits |
/// | `pass_ends` | in | the last pixel of the pass is through |
/// | `load_object`, `load_volume`, `load_shading`, `load_material` | out | a word is on the load bus for them |
/// | `load_unit`, `load_address`, `load_data` | out | the load bus |
/// | `begin_pass` | out | a pass begins: counters to zero, words are taken over |
/// | `take_objects`, `take_volumes` | out | with `begin_pass`, in a drawing or lighting pass |
/// | `go` | out | one clock later: the raster of a drawing or lighting pass starts |
/// | `show_go` | out | one clock later: a showing pass starts |
/// | `is_drawing`, `is_lighting`, `is_showing` | out | during a pass |
/// | `is_first` | out | of a drawing or lighting pass: what the buffer held is forgotten |
/// | `was_drawn`, `was_lit`, `is_last_zone` | out | of a showing pass: what the buffer holds; the frame ends with this zone |
/// | `sample` | out | 6 bits, of a showing pass: first in bit 0, last in 1, column of the sample in 3..2, line in 5..4 |
/// | `x0`, `y0`, `width`, `height` | out | 12 bits, the zone |
///
/// Commands by address: 0 origin (`x0` in bits 11..0, `y0` in 23..12), 1 size (width, height likewise), 2 draw (bit 0: first pass of the zone), 3 light (bit 0:
/// first pass of the zone), 4 show (bit 0: the zone was lit, bit 1: drawn, bit 2: last zone of the frame, bits 8..3: the sample). A command waits for the end of the pass before it;
/// words of processors are taken during a pass, once the processors have started (`settle` clocks after the command); words of tables wait until the
/// pixels of the last showing pass are through the shading processor as well (`drain` clocks after its end). Other addresses and kinds are ignored.
pub struct ZoneControl<const F: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// A beat is there.
    pub s_tvalid: Signal<In, Bit>,
    /// What it carries.
    pub s_tdest: Signal<In, Word<4>>,
    /// Unit and address.
    pub s_tuser: Signal<In, Word<24>>,
    /// Data.
    pub s_tdata: Signal<In, Word<F>>,
    /// The pass is through.
    pub pass_ends: Signal<In, Bit>,
    /// The beat is taken.
    pub s_tready: Signal<Out, Bit>,
    /// A word for an object.
    pub load_object: Signal<Out, Bit>,
    /// A word for a volume.
    pub load_volume: Signal<Out, Bit>,
    /// A word for the shading processor.
    pub load_shading: Signal<Out, Bit>,
    /// A material.
    pub load_material: Signal<Out, Bit>,
    /// Unit of the word.
    pub load_unit: Signal<Out, Word<8>>,
    /// Address of the word.
    pub load_address: Signal<Out, Word<16>>,
    /// The word.
    pub load_data: Signal<Out, Word<F>>,
    /// A pass begins.
    pub begin_pass: Signal<Out, Bit>,
    /// Objects take their words.
    pub take_objects: Signal<Out, Bit>,
    /// Volumes take their words.
    pub take_volumes: Signal<Out, Bit>,
    /// The raster starts.
    pub go: Signal<Out, Bit>,
    /// A showing pass starts.
    pub show_go: Signal<Out, Bit>,
    /// A drawing pass.
    pub is_drawing: Signal<Out, Bit>,
    /// A lighting pass.
    pub is_lighting: Signal<Out, Bit>,
    /// A showing pass.
    pub is_showing: Signal<Out, Bit>,
    /// First pass of its kind.
    pub is_first: Signal<Out, Bit>,
    /// The buffer holds surfaces.
    pub was_drawn: Signal<Out, Bit>,
    /// The buffer holds flags.
    pub was_lit: Signal<Out, Bit>,
    /// The frame ends.
    pub is_last_zone: Signal<Out, Bit>,
    /// The sample.
    pub sample: Signal<Out, Word<6>>,
    /// First column.
    pub x0: Signal<Out, Word<12>>,
    /// First line.
    pub y0: Signal<Out, Word<12>>,
    /// Columns.
    pub width: Signal<Out, Word<12>>,
    /// Lines.
    pub height: Signal<Out, Word<12>>,
    address: Signal<Local, Word<16>>,
    is_command: Signal<Local, Bit>,
    is_coefficient: Signal<Local, Bit>,
    is_idle: Signal<Local, Bit>,
    is_settled: Signal<Local, Bit>,
    is_drained: Signal<Local, Bit>,
    is_ready: Signal<Local, Bit>,
    taken: Signal<Local, Bit>,
    kept_load_object: DFF<Bit>,
    kept_load_volume: DFF<Bit>,
    kept_load_shading: DFF<Bit>,
    kept_load_material: DFF<Bit>,
    kept_unit: DFF<Word<8>>,
    kept_address: DFF<Word<16>>,
    kept_data: DFF<Word<F>>,
    kept_begin: DFF<Bit>,
    kept_go: DFF<Bit>,
    kept_show_go: DFF<Bit>,
    drawing: DFF<Bit>,
    lighting: DFF<Bit>,
    showing: DFF<Bit>,
    first: DFF<Bit>,
    drawn: DFF<Bit>,
    lit: DFF<Bit>,
    last_zone: DFF<Bit>,
    kept_sample: DFF<Word<6>>,
    kept_x0: DFF<Word<12>>,
    kept_y0: DFF<Word<12>>,
    kept_width: DFF<Word<12>>,
    kept_height: DFF<Word<12>>,
    settling: DFF<Word<9>>,
    draining: DFF<Word<9>>,
    settle: Constant<Word<9>>,
    drain: Constant<Word<9>>,
    none: Constant<Word<9>>,
    one: Constant<Word<9>>,
    kind_object: Constant<Word<4>>,
    kind_volume: Constant<Word<4>>,
    kind_shading: Constant<Word<4>>,
    kind_material: Constant<Word<4>>,
    kind_command: Constant<Word<4>>,
    at_origin: Constant<Word<16>>,
    at_size: Constant<Word<16>>,
    at_draw: Constant<Word<16>>,
    at_light: Constant<Word<16>>,
    at_show: Constant<Word<16>>,
    second: Constant<Word<8>>,
    sample_bit: Constant<Word<8>>,
    unit_bit: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const F: usize] ZoneControl [F]
    inputs { clock, s_tvalid, s_tdest, s_tuser, s_tdata, pass_ends }
    parts { s_tready, load_object, load_volume, load_shading, load_material, load_unit, load_address, load_data, begin_pass, take_objects,
        take_volumes, go, show_go, is_drawing, is_lighting, is_showing, is_first, was_drawn, was_lit, is_last_zone, sample, x0, y0, width, height,
        address, is_command, is_coefficient, is_idle, is_settled, is_drained, is_ready, taken, kept_load_object, kept_load_volume,
        kept_load_shading, kept_load_material, kept_unit, kept_address, kept_data, kept_begin, kept_go, kept_show_go, drawing, lighting, showing,
        first, drawn, lit, last_zone, kept_sample, kept_x0, kept_y0, kept_width, kept_height, settling, draining, settle, drain, none, one, kind_object,
        kind_volume, kind_shading, kind_material, kind_command, at_origin, at_size, at_draw, at_light, at_show, second, sample_bit, unit_bit }
    data { }
}

impl<const F: usize> ZoneControl<F> {
    /// A control whose processors have all started `settle` clocks after a command, and whose pixels are shaded `drain` clocks after the end of a
    /// showing pass.
    ///
    /// # Panics
    ///
    /// When a number does not fit 9 bits.
    pub fn new(settle: usize, drain: usize) -> Self {
        assert!(
            settle < 512 && drain < 512,
            "waits of a zone control have 9 bits"
        );
        fields! {
            [clock, s_tvalid, s_tdest, s_tuser, s_tdata, pass_ends, s_tready, load_object, load_volume, load_shading, load_material,
                load_unit, load_address, load_data, begin_pass, take_objects, take_volumes, go, show_go, is_drawing, is_lighting, is_showing,
                is_first, was_drawn, was_lit, is_last_zone, sample, x0, y0, width, height, address, is_command, is_coefficient, is_idle, is_settled,
                is_drained, is_ready, taken, kept_load_object, kept_load_volume, kept_load_shading, kept_load_material, kept_unit, kept_address,
                kept_data, kept_begin, kept_go, kept_show_go, drawing, lighting, showing, first, drawn, lit, last_zone, kept_sample, kept_x0, kept_y0,
                kept_width, kept_height, settling, draining]
            settle: constant(settle as u64),
            drain: constant(drain as u64),
            none: constant(0),
            one: constant(1),
            kind_object: constant(OBJECT_WORD),
            kind_volume: constant(VOLUME_WORD),
            kind_shading: constant(SHADING_WORD),
            kind_material: constant(MATERIAL),
            kind_command: constant(COMMAND),
            at_origin: constant(0),
            at_size: constant(1),
            at_draw: constant(2),
            at_light: constant(3),
            at_show: constant(4),
            second: constant(12),
            sample_bit: constant(3),
            unit_bit: constant(16),
        }
    }
}

impl<const F: usize> Logic for ZoneControl<F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("zone_control");
        dff_setup!(
            self,
            clock,
            kept_load_object,
            kept_load_volume,
            kept_load_shading,
            kept_load_material,
            kept_unit,
            kept_address,
            kept_data,
            kept_begin,
            kept_go,
            kept_show_go,
            drawing,
            lighting,
            showing,
            first,
            drawn,
            lit,
            last_zone,
            kept_sample,
            kept_x0,
            kept_y0,
            kept_width,
            kept_height,
            settling,
            draining
        );
        self.address.next = self.s_tuser.val().get_bits::<16>(0);
        self.is_command.next = self.s_tdest.val() == self.kind_command.val();
        self.is_coefficient.next = (self.s_tdest.val() == self.kind_object.val())
            | (self.s_tdest.val() == self.kind_volume.val());
        self.is_idle.next = !(self.drawing.q.val() | self.lighting.q.val() | self.showing.q.val());
        self.is_settled.next = self.settling.q.val() == self.none.val();
        self.is_drained.next = self.draining.q.val() == self.none.val();
        self.is_ready.next = (self.is_coefficient.val() & self.is_settled.val())
            | (!self.is_coefficient.val()
                & self.is_idle.val()
                & (self.is_command.val() | self.is_drained.val()));
        self.taken.next = self.s_tvalid.val() & self.is_ready.val();
        self.kept_load_object.d.next =
            self.taken.val() & (self.s_tdest.val() == self.kind_object.val());
        self.kept_load_volume.d.next =
            self.taken.val() & (self.s_tdest.val() == self.kind_volume.val());
        self.kept_load_shading.d.next =
            self.taken.val() & (self.s_tdest.val() == self.kind_shading.val());
        self.kept_load_material.d.next =
            self.taken.val() & (self.s_tdest.val() == self.kind_material.val());
        self.kept_unit.d.next = self
            .s_tuser
            .val()
            .get_bits::<8>(self.unit_bit.val().index());
        self.kept_address.d.next = self.address.val();
        self.kept_data.d.next = self.s_tdata.val();
        if self.settling.q.val() != self.none.val() {
            self.settling.d.next = self.settling.q.val() - self.one.val();
        }
        if self.draining.q.val() != self.none.val() {
            self.draining.d.next = self.draining.q.val() - self.one.val();
        }
        self.kept_begin.d.next = false;
        self.kept_go.d.next =
            self.kept_begin.q.val() & (self.drawing.q.val() | self.lighting.q.val());
        self.kept_show_go.d.next = self.kept_begin.q.val() & self.showing.q.val();
        if self.pass_ends.val() {
            self.drawing.d.next = false;
            self.lighting.d.next = false;
            self.showing.d.next = false;
            if self.showing.q.val() {
                self.draining.d.next = self.drain.val();
            }
        }
        if self.taken.val() & self.is_command.val() {
            if self.address.val() == self.at_origin.val() {
                self.kept_x0.d.next = self.s_tdata.val().get_bits::<12>(0);
                self.kept_y0.d.next = self.s_tdata.val().get_bits::<12>(self.second.val().index());
            }
            if self.address.val() == self.at_size.val() {
                self.kept_width.d.next = self.s_tdata.val().get_bits::<12>(0);
                self.kept_height.d.next =
                    self.s_tdata.val().get_bits::<12>(self.second.val().index());
            }
            if self.address.val() == self.at_draw.val() {
                self.kept_begin.d.next = true;
                self.drawing.d.next = true;
                self.first.d.next = self.s_tdata.val().get_bit(0);
                self.settling.d.next = self.settle.val();
            }
            if self.address.val() == self.at_light.val() {
                self.kept_begin.d.next = true;
                self.lighting.d.next = true;
                self.first.d.next = self.s_tdata.val().get_bit(0);
                self.settling.d.next = self.settle.val();
            }
            if self.address.val() == self.at_show.val() {
                self.kept_begin.d.next = true;
                self.showing.d.next = true;
                self.lit.d.next = self.s_tdata.val().get_bit(0);
                self.drawn.d.next = self.s_tdata.val().get_bit(1);
                self.last_zone.d.next = self.s_tdata.val().get_bit(2);
                self.kept_sample.d.next = self
                    .s_tdata
                    .val()
                    .get_bits::<6>(self.sample_bit.val().index());
            }
        }
        self.s_tready.next = self.is_ready.val();
        self.load_object.next = self.kept_load_object.q.val();
        self.load_volume.next = self.kept_load_volume.q.val();
        self.load_shading.next = self.kept_load_shading.q.val();
        self.load_material.next = self.kept_load_material.q.val();
        self.load_unit.next = self.kept_unit.q.val();
        self.load_address.next = self.kept_address.q.val();
        self.load_data.next = self.kept_data.q.val();
        self.begin_pass.next = self.kept_begin.q.val();
        self.take_objects.next = self.kept_begin.q.val() & self.drawing.q.val();
        self.take_volumes.next = self.kept_begin.q.val() & self.lighting.q.val();
        self.go.next = self.kept_go.q.val();
        self.show_go.next = self.kept_show_go.q.val();
        self.is_drawing.next = self.drawing.q.val();
        self.is_lighting.next = self.lighting.q.val();
        self.is_showing.next = self.showing.q.val();
        self.is_first.next = self.first.q.val();
        self.was_drawn.next = self.drawn.q.val();
        self.was_lit.next = self.lit.q.val();
        self.is_last_zone.next = self.last_zone.q.val();
        self.sample.next = self.kept_sample.q.val();
        self.x0.next = self.kept_x0.q.val();
        self.y0.next = self.kept_y0.q.val();
        self.width.next = self.kept_width.q.val();
        self.height.next = self.kept_height.q.val();
    }
}

clocked!(ZoneControl<const F: usize>);
