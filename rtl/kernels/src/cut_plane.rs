//! One cut of an interval by a plane.

use imogene_contract::words::far_end;
use rust_hdl::prelude::*;

/// What a plane leaves of an interval. Latency 2. Section 2.4.2.
///
/// A front plane (kind 1) moves the front back, a back plane (2) the back forward, a perpendicular one (3) removes all
/// where it is negative. Of the two points of a bare surface the cut one goes.
#[derive(LogicBlock)]
pub struct CutPlane<const W: usize> {
    /// Clock.
    pub clock: Signal<In, Clock>,
    /// Kind of the plane, 0 for none.
    pub kind: Signal<In, Bits<2>>,
    /// The object is a bare surface.
    pub surface: Signal<In, Bit>,
    /// Face number of the plane.
    pub number: Signal<In, Bits<4>>,
    /// Depth of the plane.
    pub zp: Signal<In, Signed<W>>,
    /// Front depth.
    pub zf: Signal<In, Signed<W>>,
    /// Front face.
    pub nf: Signal<In, Bits<4>>,
    /// Back depth.
    pub zb: Signal<In, Signed<W>>,
    /// Back face.
    pub nb: Signal<In, Bits<4>>,
    /// Front depth that is left, the far end where nothing is.
    pub cut_zf: Signal<Out, Signed<W>>,
    /// Front face that is left.
    pub cut_nf: Signal<Out, Bits<4>>,
    /// Back depth that is left.
    pub cut_zb: Signal<Out, Signed<W>>,
    /// Back face that is left.
    pub cut_nb: Signal<Out, Bits<4>>,
    before_front: DFF<Bit>,
    behind_front: DFF<Bit>,
    before_back: DFF<Bit>,
    behind_back: DFF<Bit>,
    late_kind: DFF<Bits<2>>,
    late_surface: DFF<Bit>,
    late_number: DFF<Bits<4>>,
    late_zp: DFF<Signed<W>>,
    late_zf: DFF<Signed<W>>,
    late_nf: DFF<Bits<4>>,
    late_zb: DFF<Signed<W>>,
    late_nb: DFF<Bits<4>>,
    front: DFF<Signed<W>>,
    front_face: DFF<Bits<4>>,
    back: DFF<Signed<W>>,
    back_face: DFF<Bits<4>>,
    cuts_front: Signal<Local, Bit>,
    cuts_back: Signal<Local, Bit>,
    removed: Signal<Local, Bit>,
    zero: Signal<Local, Signed<W>>,
    absent: Constant<Signed<W>>,
}

impl<const W: usize> Default for CutPlane<W> {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            kind: Default::default(),
            surface: Default::default(),
            number: Default::default(),
            zp: Default::default(),
            zf: Default::default(),
            nf: Default::default(),
            zb: Default::default(),
            nb: Default::default(),
            cut_zf: Default::default(),
            cut_nf: Default::default(),
            cut_zb: Default::default(),
            cut_nb: Default::default(),
            before_front: Default::default(),
            behind_front: Default::default(),
            before_back: Default::default(),
            behind_back: Default::default(),
            late_kind: Default::default(),
            late_surface: Default::default(),
            late_number: Default::default(),
            late_zp: Default::default(),
            late_zf: Default::default(),
            late_nf: Default::default(),
            late_zb: Default::default(),
            late_nb: Default::default(),
            front: Default::default(),
            front_face: Default::default(),
            back: Default::default(),
            back_face: Default::default(),
            cuts_front: Default::default(),
            cuts_back: Default::default(),
            removed: Default::default(),
            zero: Default::default(),
            absent: Constant::new(far_end(W as u32).into()),
        }
    }
}

impl<const W: usize> Logic for CutPlane<W> {
    #[hdl_gen]
    fn update(&mut self) {
        clock!(self, clock, before_front, behind_front);
        clock!(self, clock, before_back, behind_back);
        clock!(self, clock, late_kind, late_surface, late_number);
        clock!(self, clock, late_zp, late_zf, late_nf, late_zb, late_nb);
        clock!(self, clock, front, front_face, back, back_face);
        // A signal, because Yosys takes the `localparam signed` of a constant for unsigned.
        self.zero.next = 0.into();
        self.before_front.d.next = self.zp.val() < self.zf.val();
        self.behind_front.d.next = self.zp.val() > self.zf.val();
        self.before_back.d.next = self.zp.val() < self.zb.val();
        self.behind_back.d.next = self.zp.val() > self.zb.val();
        self.late_kind.d.next = self.kind.val();
        self.late_surface.d.next = self.surface.val();
        self.late_number.d.next = self.number.val();
        self.late_zp.d.next = self.zp.val();
        self.late_zf.d.next = self.zf.val();
        self.late_nf.d.next = self.nf.val();
        self.late_zb.d.next = self.zb.val();
        self.late_nb.d.next = self.nb.val();
        self.cuts_front.next = (self.late_kind.q.val() == 1) & self.behind_front.q.val();
        self.cuts_back.next = (self.late_kind.q.val() == 2) & self.before_back.q.val();
        self.removed.next = ((self.late_kind.q.val() == 3)
            & (self.late_zp.q.val() < self.zero.val()))
            | (self.cuts_front.val() & self.behind_back.q.val())
            | (self.cuts_back.val() & self.before_front.q.val());
        self.front.d.next = self.late_zf.q.val();
        self.front_face.d.next = self.late_nf.q.val();
        self.back.d.next = self.late_zb.q.val();
        self.back_face.d.next = self.late_nb.q.val();
        if self.removed.val() {
            self.front.d.next = self.absent.val();
            self.front_face.d.next = 0.into();
            self.back.d.next = self.absent.val();
            self.back_face.d.next = 0.into();
        } else if self.cuts_front.val() & self.late_surface.q.val() {
            self.front.d.next = self.late_zb.q.val();
            self.front_face.d.next = self.late_nb.q.val();
        } else if self.cuts_front.val() {
            self.front.d.next = self.late_zp.q.val();
            self.front_face.d.next = self.late_number.q.val();
        } else if self.cuts_back.val() & self.late_surface.q.val() {
            self.back.d.next = self.late_zf.q.val();
            self.back_face.d.next = self.late_nf.q.val();
        } else if self.cuts_back.val() {
            self.back.d.next = self.late_zp.q.val();
            self.back_face.d.next = self.late_number.q.val();
        }
        self.cut_zf.next = self.front.q.val();
        self.cut_nf.next = self.front_face.q.val();
        self.cut_zb.next = self.back.q.val();
        self.cut_nb.next = self.back_face.q.val();
    }
}
