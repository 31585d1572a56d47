//! One cut of an interval by a plane.

use imogene_contract::words::far_end;
use rust_hdl::prelude::*;

/// What a plane leaves of an interval. Latency 1. Section 2.4.2.
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
        clock!(self, clock, front, front_face, back, back_face);
        // A signal, because Yosys takes the `localparam signed` of a constant for unsigned.
        self.zero.next = 0.into();
        self.cuts_front.next = (self.kind.val() == 1) & (self.zp.val() > self.zf.val());
        self.cuts_back.next = (self.kind.val() == 2) & (self.zp.val() < self.zb.val());
        self.removed.next = ((self.kind.val() == 3) & (self.zp.val() < self.zero.val()))
            | (self.cuts_front.val() & (self.zp.val() > self.zb.val()))
            | (self.cuts_back.val() & (self.zp.val() < self.zf.val()));
        self.front.d.next = self.zf.val();
        self.front_face.d.next = self.nf.val();
        self.back.d.next = self.zb.val();
        self.back_face.d.next = self.nb.val();
        if self.removed.val() {
            self.front.d.next = self.absent.val();
            self.front_face.d.next = 0.into();
            self.back.d.next = self.absent.val();
            self.back_face.d.next = 0.into();
        } else if self.cuts_front.val() & self.surface.val() {
            self.front.d.next = self.zb.val();
            self.front_face.d.next = self.nb.val();
        } else if self.cuts_front.val() {
            self.front.d.next = self.zp.val();
            self.front_face.d.next = self.number.val();
        } else if self.cuts_back.val() & self.surface.val() {
            self.back.d.next = self.zf.val();
            self.back_face.d.next = self.nf.val();
        } else if self.cuts_back.val() {
            self.back.d.next = self.zp.val();
            self.back_face.d.next = self.number.val();
        }
        self.cut_zf.next = self.front.q.val();
        self.cut_nf.next = self.front_face.q.val();
        self.cut_zb.next = self.back.q.val();
        self.cut_nb.next = self.back_face.q.val();
    }
}
