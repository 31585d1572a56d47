//! Cut of a depth interval by a plane.

use crate::format::{BACK_PLANE, FRONT_PLANE, PERPENDICULAR, far_end};
use crate::kernel::*;

/// Cuts one half of a depth interval with one plane.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `kind` | in | 2 bits: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0) |
/// | `surface` | in | the object is a bare surface (class patch) |
/// | `number` | in | 4 bits, face number of the plane |
/// | `zp` | in | `W` bits, clamped depth of the plane |
/// | `zf`, `zb` | in | `W` bits, front and back depth |
/// | `nf`, `nb` | in | 4 bits, front and back face |
/// | `cut_zf`, `cut_nf`, `cut_zb`, `cut_nb` | out | the interval after the cut |
///
/// Latency 1. A solid gets the plane as its new face; a bare surface loses the face that is cut away, and its other face
/// takes both places. Ties: a front plane at `zf` and a back plane at `zb` change nothing; a front plane at `zb` and a
/// back plane at `zf` keep a sheet. Absent is `ZMAX` twice with numbers 0. Section 2.4.2.
pub struct CutPlane<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Kind of the plane.
    pub kind: Signal<In, Word<2>>,
    /// The object is a bare surface.
    pub surface: Signal<In, Bit>,
    /// Face number of the plane.
    pub number: Signal<In, Word<4>>,
    /// Depth of the plane.
    pub zp: Signal<In, Int<W>>,
    /// Front depth.
    pub zf: Signal<In, Int<W>>,
    /// Front face.
    pub nf: Signal<In, Word<4>>,
    /// Back depth.
    pub zb: Signal<In, Int<W>>,
    /// Back face.
    pub nb: Signal<In, Word<4>>,
    /// Front depth after the cut.
    pub cut_zf: Signal<Out, Int<W>>,
    /// Front face after the cut.
    pub cut_nf: Signal<Out, Word<4>>,
    /// Back depth after the cut.
    pub cut_zb: Signal<Out, Int<W>>,
    /// Back face after the cut.
    pub cut_nb: Signal<Out, Word<4>>,
    is_front: Signal<Local, Bit>,
    is_back: Signal<Local, Bit>,
    is_perpendicular: Signal<Local, Bit>,
    before_front: Signal<Local, Bit>,
    at_front: Signal<Local, Bit>,
    before_back: Signal<Local, Bit>,
    at_back: Signal<Local, Bit>,
    removed: Signal<Local, Bit>,
    cuts_front: Signal<Local, Bit>,
    cuts_back: Signal<Local, Bit>,
    plane_is_negative: Signal<Local, Bit>,
    kept_zf: DFF<Int<W>>,
    kept_nf: DFF<Word<4>>,
    kept_zb: DFF<Int<W>>,
    kept_nb: DFF<Word<4>>,
    front: Constant<Word<2>>,
    back: Constant<Word<2>>,
    perpendicular: Constant<Word<2>>,
    absent: Constant<Int<W>>,
    no_face: Constant<Word<4>>,
    sign: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [const W: usize] CutPlane [W]
    inputs { clock, kind, surface, number, zp, zf, nf, zb, nb }
    parts { cut_zf, cut_nf, cut_zb, cut_nb, is_front, is_back, is_perpendicular, before_front,
        at_front, before_back, at_back, removed, cuts_front, cuts_back, plane_is_negative,
        kept_zf, kept_nf, kept_zb, kept_nb, front, back, perpendicular, absent, no_face, sign }
    data { }
}

impl<const W: usize> CutPlane<W> {
    /// A unit of `W` bits of depth.
    pub fn new() -> Self {
        Self {
            clock: Signal::default(),
            kind: Signal::default(),
            surface: Signal::default(),
            number: Signal::default(),
            zp: Signal::default(),
            zf: Signal::default(),
            nf: Signal::default(),
            zb: Signal::default(),
            nb: Signal::default(),
            cut_zf: Signal::default(),
            cut_nf: Signal::default(),
            cut_zb: Signal::default(),
            cut_nb: Signal::default(),
            is_front: Signal::default(),
            is_back: Signal::default(),
            is_perpendicular: Signal::default(),
            before_front: Signal::default(),
            at_front: Signal::default(),
            before_back: Signal::default(),
            at_back: Signal::default(),
            removed: Signal::default(),
            cuts_front: Signal::default(),
            cuts_back: Signal::default(),
            plane_is_negative: Signal::default(),
            kept_zf: DFF::default(),
            kept_nf: DFF::default(),
            kept_zb: DFF::default(),
            kept_nb: DFF::default(),
            front: constant(FRONT_PLANE),
            back: constant(BACK_PLANE),
            perpendicular: constant(PERPENDICULAR),
            absent: signed_constant(far_end(W)),
            no_face: constant(0),
            sign: constant(W as u64 - 1),
            _asleep: false,
        }
    }

    /// Clocks from the interval to the cut interval.
    pub const fn latency() -> usize {
        1
    }
}

impl<const W: usize> Default for CutPlane<W> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const W: usize> Logic for CutPlane<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("cut_plane");
        clock!(self, clock, kept_zf, kept_nf, kept_zb, kept_nb);
        self.is_front.next = self.kind.val() == self.front.val();
        self.is_back.next = self.kind.val() == self.back.val();
        self.is_perpendicular.next = self.kind.val() == self.perpendicular.val();
        self.before_front.next = self.zp.val() < self.zf.val();
        self.at_front.next = self.zp.val() == self.zf.val();
        self.before_back.next = self.zp.val() < self.zb.val();
        self.at_back.next = self.zp.val() == self.zb.val();
        self.plane_is_negative.next = self.zp.val().get_bit(self.sign.val().index());
        self.cuts_front.next =
            self.is_front.val() & !(self.before_front.val() | self.at_front.val());
        self.cuts_back.next = self.is_back.val() & self.before_back.val();
        self.removed.next = (self.is_perpendicular.val() & self.plane_is_negative.val())
            | (self.cuts_front.val() & !(self.before_back.val() | self.at_back.val()))
            | (self.cuts_back.val() & self.before_front.val());
        self.kept_zf.d.next = self.zf.val();
        self.kept_nf.d.next = self.nf.val();
        self.kept_zb.d.next = self.zb.val();
        self.kept_nb.d.next = self.nb.val();
        if self.removed.val() {
            self.kept_zf.d.next = self.absent.val();
            self.kept_nf.d.next = self.no_face.val();
            self.kept_zb.d.next = self.absent.val();
            self.kept_nb.d.next = self.no_face.val();
        } else if self.cuts_front.val() {
            if self.surface.val() {
                self.kept_zf.d.next = self.zb.val();
                self.kept_nf.d.next = self.nb.val();
            } else {
                self.kept_zf.d.next = self.zp.val();
                self.kept_nf.d.next = self.number.val();
            }
        } else if self.cuts_back.val() {
            if self.surface.val() {
                self.kept_zb.d.next = self.zf.val();
                self.kept_nb.d.next = self.nf.val();
            } else {
                self.kept_zb.d.next = self.zp.val();
                self.kept_nb.d.next = self.number.val();
            }
        }
        self.cut_zf.next = self.kept_zf.q.val();
        self.cut_nf.next = self.kept_nf.q.val();
        self.cut_zb.next = self.kept_zb.q.val();
        self.cut_nb.next = self.kept_nb.q.val();
    }
}

clocked!(CutPlane<const W: usize>);
