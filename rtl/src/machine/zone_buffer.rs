//! What is known of the pixels of a zone between passes.

use crate::kernel::*;
use crate::unit::block_memory::BlockMemory;

/// Keeps the nearest surface and the source flags of every pixel of a zone in block memory.
///
/// Widths: `P = W + 12`, a depth and an id side by side.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `begin_pass` | in | the next pixel of every stream is the first of the zone |
/// | `is_first` | in | of a pass: what the buffer held is forgotten |
/// | `drawn_soon` | in | a pixel of a drawing pass comes at the next clock |
/// | `drawn` | in | a pixel of a drawing pass is here |
/// | `depth`, `id`, `nx`, `ny`, `nz` | in | its surface |
/// | `depth_soon` | in | a lighting pass wants the depth of its next pixel at the next clock |
/// | `flags_soon` | in | a lighting pass wants the flags of its next pixel at the next clock |
/// | `lit` | in | a pixel of a lighting pass has its new flags |
/// | `lit_flags` | in | 16 bits |
/// | `show_soon` | in | a showing pass wants all of its next pixel at the next clock |
/// | `seen_depth`, `seen_id`, `seen_nx`, `seen_ny`, `seen_nz`, `seen_flags` | out | one clock after they were wanted |
///
/// A surface replaces the one in the buffer if it is nearer, or at equal depth if its id is smaller, so that the order of passes does not matter.
/// Latency 1 from a wanted pixel to its values, 2 from a drawn pixel to the buffer.
pub struct ZoneBuffer<const W: usize, const P: usize, const A: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Start at the first pixel.
    pub begin_pass: Signal<In, Bit>,
    /// Forget what the buffer held.
    pub is_first: Signal<In, Bit>,
    /// A drawn pixel comes next.
    pub drawn_soon: Signal<In, Bit>,
    /// A drawn pixel is here.
    pub drawn: Signal<In, Bit>,
    /// Its depth.
    pub depth: Signal<In, Int<W>>,
    /// Its object.
    pub id: Signal<In, Word<12>>,
    /// Its normal, x.
    pub nx: Signal<In, Int<16>>,
    /// Its normal, y.
    pub ny: Signal<In, Int<16>>,
    /// Its normal, z.
    pub nz: Signal<In, Int<16>>,
    /// A depth is wanted.
    pub depth_soon: Signal<In, Bit>,
    /// Flags are wanted.
    pub flags_soon: Signal<In, Bit>,
    /// New flags are here.
    pub lit: Signal<In, Bit>,
    /// The new flags.
    pub lit_flags: Signal<In, Word<16>>,
    /// All of a pixel is wanted.
    pub show_soon: Signal<In, Bit>,
    /// Depth in the buffer.
    pub seen_depth: Signal<Out, Int<W>>,
    /// Object in the buffer.
    pub seen_id: Signal<Out, Word<12>>,
    /// Normal in the buffer, x.
    pub seen_nx: Signal<Out, Int<16>>,
    /// Normal in the buffer, y.
    pub seen_ny: Signal<Out, Int<16>>,
    /// Normal in the buffer, z.
    pub seen_nz: Signal<Out, Int<16>>,
    /// Flags in the buffer.
    pub seen_flags: Signal<Out, Word<16>>,
    surfaces: BlockMemory<A, P>,
    normals: BlockMemory<A, 48>,
    flags: BlockMemory<A, 16>,
    read_place: DFF<Word<A>>,
    flags_place: DFF<Word<A>>,
    write_place: DFF<Word<A>>,
    lit_place: DFF<Word<A>>,
    kept_drawn: DFF<Bit>,
    kept_wins: DFF<Bit>,
    kept_surface: DFF<Word<P>>,
    kept_normal: DFF<Word<48>>,
    read_surface: Signal<Local, Bit>,
    read_flags: Signal<Local, Bit>,
    is_nearer: Signal<Local, Bit>,
    is_smaller: Signal<Local, Bit>,
    depth_bits: Signal<Local, Word<W>>,
    surface: Signal<Local, Word<P>>,
    x_bits: Signal<Local, Word<16>>,
    y_bits: Signal<Local, Word<16>>,
    z_bits: Signal<Local, Word<16>>,
    normal: Signal<Local, Word<48>>,
    old_depth: Signal<Local, Int<W>>,
    old_id: Signal<Local, Word<12>>,
    begin_place: Constant<Word<A>>,
    next_place: Constant<Word<A>>,
    depth_bit: Constant<Word<8>>,
    y_bit: Constant<Word<8>>,
    z_bit: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const W: usize, const P: usize, const A: usize] ZoneBuffer [W, P, A]
    inputs { clock, begin_pass, is_first, drawn_soon, drawn, depth, id, nx, ny, nz, depth_soon, flags_soon, lit, lit_flags, show_soon }
    parts { seen_depth, seen_id, seen_nx, seen_ny, seen_nz, seen_flags, surfaces, normals, flags, read_place, flags_place, write_place,
        lit_place, kept_drawn, kept_wins, kept_surface, kept_normal, read_surface, read_flags, is_nearer, is_smaller, depth_bits, surface,
        x_bits, y_bits, z_bits, normal, old_depth, old_id, begin_place, next_place, depth_bit, y_bit, z_bit }
    data { }
}

impl<const W: usize, const P: usize, const A: usize> ZoneBuffer<W, P, A> {
    /// An empty buffer for zones of up to `2^bits` pixels.
    ///
    /// # Panics
    ///
    /// When `P` is not `W + 12`, or `bits` is not in `1..=A`.
    pub fn new(bits: usize) -> Self {
        assert!(P == W + 12, "a depth and an id lie side by side");
        fields! {
            [clock, begin_pass, is_first, drawn_soon, drawn, depth, id, nx, ny, nz, depth_soon, flags_soon, lit, lit_flags, show_soon,
                seen_depth, seen_id, seen_nx, seen_ny, seen_nz, seen_flags, read_place, flags_place, write_place,
                lit_place, kept_drawn, kept_wins, kept_surface, kept_normal, read_surface, read_flags, is_nearer, is_smaller, depth_bits,
                surface, x_bits, y_bits, z_bits, normal, old_depth, old_id]
            surfaces: BlockMemory::of_address_bits(bits),
            normals: BlockMemory::of_address_bits(bits),
            flags: BlockMemory::of_address_bits(bits),
            begin_place: constant(0),
            next_place: constant(1),
            depth_bit: constant(12),
            y_bit: constant(16),
            z_bit: constant(32),
        }
    }
}

impl<const W: usize, const P: usize, const A: usize> Logic for ZoneBuffer<W, P, A> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("zone_buffer");
        clock!(self, clock, surfaces, normals, flags);
        dff_setup!(
            self,
            clock,
            read_place,
            flags_place,
            write_place,
            lit_place,
            kept_drawn,
            kept_wins,
            kept_surface,
            kept_normal
        );
        // Places advance with each pixel of their stream.
        self.read_surface.next =
            self.drawn_soon.val() | self.depth_soon.val() | self.show_soon.val();
        self.read_flags.next = self.flags_soon.val() | self.show_soon.val();
        if self.begin_pass.val() {
            self.read_place.d.next = self.begin_place.val();
            self.flags_place.d.next = self.begin_place.val();
            self.write_place.d.next = self.begin_place.val();
            self.lit_place.d.next = self.begin_place.val();
        } else {
            if self.read_surface.val() {
                self.read_place.d.next = self.read_place.q.val() + self.next_place.val();
            }
            if self.read_flags.val() {
                self.flags_place.d.next = self.flags_place.q.val() + self.next_place.val();
            }
            if self.kept_drawn.q.val() {
                self.write_place.d.next = self.write_place.q.val() + self.next_place.val();
            }
            if self.lit.val() {
                self.lit_place.d.next = self.lit_place.q.val() + self.next_place.val();
            }
        }
        self.surfaces.read_address.next = self.read_place.q.val();
        self.normals.read_address.next = self.read_place.q.val();
        self.flags.read_address.next = self.flags_place.q.val();
        // The drawn surface against the one in the buffer.
        self.old_depth.next = signed_cast(
            self.surfaces
                .read_data
                .val()
                .get_bits::<W>(self.depth_bit.val().index()),
        );
        self.old_id.next = self.surfaces.read_data.val().get_bits::<12>(0);
        self.is_nearer.next = self.depth.val() < self.old_depth.val();
        self.is_smaller.next =
            (self.depth.val() == self.old_depth.val()) & (self.id.val() < self.old_id.val());
        self.depth_bits.next = unsigned_cast(self.depth.val());
        self.surface.next = (bit_cast::<P, W>(self.depth_bits.val()) << self.depth_bit.val())
            | bit_cast::<P, 12>(self.id.val());
        self.x_bits.next = unsigned_cast(self.nx.val());
        self.y_bits.next = unsigned_cast(self.ny.val());
        self.z_bits.next = unsigned_cast(self.nz.val());
        self.normal.next = bit_cast::<48, 16>(self.x_bits.val())
            | (bit_cast::<48, 16>(self.y_bits.val()) << self.y_bit.val())
            | (bit_cast::<48, 16>(self.z_bits.val()) << self.z_bit.val());
        self.kept_drawn.d.next = self.drawn.val();
        self.kept_wins.d.next =
            self.drawn.val() & (self.is_first.val() | self.is_nearer.val() | self.is_smaller.val());
        self.kept_surface.d.next = self.surface.val();
        self.kept_normal.d.next = self.normal.val();
        self.surfaces.write.next = self.kept_wins.q.val();
        self.surfaces.write_address.next = self.write_place.q.val();
        self.surfaces.write_data.next = self.kept_surface.q.val();
        self.normals.write.next = self.kept_wins.q.val();
        self.normals.write_address.next = self.write_place.q.val();
        self.normals.write_data.next = self.kept_normal.q.val();
        self.flags.write.next = self.lit.val();
        self.flags.write_address.next = self.lit_place.q.val();
        self.flags.write_data.next = self.lit_flags.val();
        self.seen_depth.next = self.old_depth.val();
        self.seen_id.next = self.old_id.val();
        self.seen_nx.next = signed_cast(self.normals.read_data.val().get_bits::<16>(0));
        self.seen_ny.next = signed_cast(
            self.normals
                .read_data
                .val()
                .get_bits::<16>(self.y_bit.val().index()),
        );
        self.seen_nz.next = signed_cast(
            self.normals
                .read_data
                .val()
                .get_bits::<16>(self.z_bit.val().index()),
        );
        self.seen_flags.next = self.flags.read_data.val();
    }
}

clocked!(ZoneBuffer<const W: usize, const P: usize, const A: usize>);
