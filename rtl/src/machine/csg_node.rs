//! Nodes of the two trees of the decider of solids.

use crate::kernel::*;

/// Hands on the nearer of two faces; at equal depth the smaller face word: a front before a back, then the smaller id, then the smaller number.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `a_depth`, `b_depth` | in | `W` bits |
/// | `a_face`, `b_face` | in | 13 bits: is a back, id, number |
/// | `depth`, `face` | out | the nearer |
///
/// Latency 1.
#[derive(Default)]
pub struct NearerFace<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// First depth.
    pub a_depth: Signal<In, Int<W>>,
    /// First face.
    pub a_face: Signal<In, Word<13>>,
    /// Second depth.
    pub b_depth: Signal<In, Int<W>>,
    /// Second face.
    pub b_face: Signal<In, Word<13>>,
    /// Depth of the nearer.
    pub depth: Signal<Out, Int<W>>,
    /// The nearer.
    pub face: Signal<Out, Word<13>>,
    b_wins: Signal<Local, Bit>,
    kept_depth: DFF<Int<W>>,
    kept_face: DFF<Word<13>>,
    _asleep: bool,
}

block! {
    [const W: usize] NearerFace [W]
    inputs { clock, a_depth, a_face, b_depth, b_face }
    parts { depth, face, b_wins, kept_depth, kept_face }
    data { }
}

impl<const W: usize> Logic for NearerFace<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("nearer_face");
        clock!(self, clock, kept_depth, kept_face);
        self.b_wins.next = (self.b_depth.val() < self.a_depth.val())
            | ((self.b_depth.val() == self.a_depth.val())
                & (self.b_face.val() < self.a_face.val()));
        if self.b_wins.val() {
            self.kept_depth.d.next = self.b_depth.val();
            self.kept_face.d.next = self.b_face.val();
        } else {
            self.kept_depth.d.next = self.a_depth.val();
            self.kept_face.d.next = self.a_face.val();
        }
        self.depth.next = self.kept_depth.q.val();
        self.face.next = self.kept_face.q.val();
    }
}

/// A register in the place of a node that has one input only.
#[derive(Default)]
pub struct FaceRegister<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Depth.
    pub a_depth: Signal<In, Int<W>>,
    /// Face.
    pub a_face: Signal<In, Word<13>>,
    /// Depth, one clock later.
    pub depth: Signal<Out, Int<W>>,
    /// Face, one clock later.
    pub face: Signal<Out, Word<13>>,
    kept_depth: DFF<Int<W>>,
    kept_face: DFF<Word<13>>,
    _asleep: bool,
}

block! {
    [const W: usize] FaceRegister [W]
    inputs { clock, a_depth, a_face }
    parts { depth, face, kept_depth, kept_face }
    data { }
}

impl<const W: usize> Logic for FaceRegister<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("face_register");
        clock!(self, clock, kept_depth, kept_face);
        self.kept_depth.d.next = self.a_depth.val();
        self.kept_face.d.next = self.a_face.val();
        self.depth.next = self.kept_depth.q.val();
        self.face.next = self.kept_face.q.val();
    }
}

/// What two convex objects have in common: the farther front and the nearer back; of two fronts at one depth the smaller face word.
///
/// Latency 1.
#[derive(Default)]
pub struct Overlap<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// First front.
    pub a_zf: Signal<In, Int<W>>,
    /// First back.
    pub a_zb: Signal<In, Int<W>>,
    /// Face of the first front.
    pub a_face: Signal<In, Word<13>>,
    /// Second front.
    pub b_zf: Signal<In, Int<W>>,
    /// Second back.
    pub b_zb: Signal<In, Int<W>>,
    /// Face of the second front.
    pub b_face: Signal<In, Word<13>>,
    /// Front of what is in both.
    pub zf: Signal<Out, Int<W>>,
    /// Its back.
    pub zb: Signal<Out, Int<W>>,
    /// Face of its front.
    pub face: Signal<Out, Word<13>>,
    b_is_front: Signal<Local, Bit>,
    kept_zf: DFF<Int<W>>,
    kept_zb: DFF<Int<W>>,
    kept_face: DFF<Word<13>>,
    _asleep: bool,
}

block! {
    [const W: usize] Overlap [W]
    inputs { clock, a_zf, a_zb, a_face, b_zf, b_zb, b_face }
    parts { zf, zb, face, b_is_front, kept_zf, kept_zb, kept_face }
    data { }
}

impl<const W: usize> Logic for Overlap<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("overlap");
        clock!(self, clock, kept_zf, kept_zb, kept_face);
        self.b_is_front.next = (self.a_zf.val() < self.b_zf.val())
            | ((self.a_zf.val() == self.b_zf.val()) & (self.b_face.val() < self.a_face.val()));
        if self.b_is_front.val() {
            self.kept_zf.d.next = self.b_zf.val();
            self.kept_face.d.next = self.b_face.val();
        } else {
            self.kept_zf.d.next = self.a_zf.val();
            self.kept_face.d.next = self.a_face.val();
        }
        if self.b_zb.val() < self.a_zb.val() {
            self.kept_zb.d.next = self.b_zb.val();
        } else {
            self.kept_zb.d.next = self.a_zb.val();
        }
        self.zf.next = self.kept_zf.q.val();
        self.zb.next = self.kept_zb.q.val();
        self.face.next = self.kept_face.q.val();
    }
}

/// A register in the place of an [`Overlap`] that has one input only.
#[derive(Default)]
pub struct OverlapRegister<const W: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Front.
    pub a_zf: Signal<In, Int<W>>,
    /// Back.
    pub a_zb: Signal<In, Int<W>>,
    /// Face of the front.
    pub a_face: Signal<In, Word<13>>,
    /// Front, one clock later.
    pub zf: Signal<Out, Int<W>>,
    /// Back, one clock later.
    pub zb: Signal<Out, Int<W>>,
    /// Face, one clock later.
    pub face: Signal<Out, Word<13>>,
    kept_zf: DFF<Int<W>>,
    kept_zb: DFF<Int<W>>,
    kept_face: DFF<Word<13>>,
    _asleep: bool,
}

block! {
    [const W: usize] OverlapRegister [W]
    inputs { clock, a_zf, a_zb, a_face }
    parts { zf, zb, face, kept_zf, kept_zb, kept_face }
    data { }
}

impl<const W: usize> Logic for OverlapRegister<W> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("overlap_register");
        clock!(self, clock, kept_zf, kept_zb, kept_face);
        self.kept_zf.d.next = self.a_zf.val();
        self.kept_zb.d.next = self.a_zb.val();
        self.kept_face.d.next = self.a_face.val();
        self.zf.next = self.kept_zf.q.val();
        self.zb.next = self.kept_zb.q.val();
        self.face.next = self.kept_face.q.val();
    }
}

/// The face word of an object: is a back, id, number. No clock.
pub struct FaceWord {
    /// Id of the object.
    pub id: Signal<In, Word<8>>,
    /// Number of its face.
    pub number: Signal<In, Word<4>>,
    /// The face is the back of an object taken away.
    pub is_back: Signal<In, Bit>,
    /// The word.
    pub face: Signal<Out, Word<13>>,
    wide_id: Signal<Local, Word<13>>,
    wide_number: Signal<Local, Word<13>>,
    name: Signal<Local, Word<13>>,
    back_flag: Constant<Word<13>>,
    by_number: Constant<Word<8>>,
    _asleep: bool,
}

block! {
    [] FaceWord []
    inputs { id, number, is_back }
    parts { face, wide_id, wide_number, name, back_flag, by_number }
    data { }
}

impl Default for FaceWord {
    fn default() -> Self {
        fields! {
            [id, number, is_back, face, wide_id, wide_number, name]
            back_flag: constant(1 << 12),
            by_number: constant(4),
        }
    }
}

impl Logic for FaceWord {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("face_word");
        self.wide_id.next = bit_cast::<13, 8>(self.id.val());
        self.wide_number.next = bit_cast::<13, 4>(self.number.val());
        self.name.next = (self.wide_id.val() << self.by_number.val()) | self.wide_number.val();
        if self.is_back.val() {
            self.face.next = self.name.val() | self.back_flag.val();
        } else {
            self.face.next = self.name.val();
        }
    }
}
