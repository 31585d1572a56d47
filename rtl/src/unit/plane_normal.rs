//! Normal of a face that is a plane.

use crate::format::{CAP, FIRST_PLANE};
use crate::kernel::*;

/// Gives the constant normal of the plane that is seen.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `number` | in | 4 bits: 2 + i plane i, 15 an end of the depth word |
/// | `end_nz` | in | 16 bits, component z at the end of the depth word |
/// | `plane_i_nx`, `plane_i_ny`, `plane_i_nz` | in | 16 bits, normal of plane i |
/// | `nx`, `ny`, `nz` | out | 16 bits; zero for any other number |
///
/// Latency 1.
pub struct PlaneNormal {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Visible face.
    pub number: Signal<In, Word<4>>,
    /// Component z at the end of the depth word.
    pub end_nz: Signal<In, Int<16>>,
    /// Component x of each plane.
    pub plane_nx: Vec<Signal<In, Int<16>>>,
    /// Component y of each plane.
    pub plane_ny: Vec<Signal<In, Int<16>>>,
    /// Component z of each plane.
    pub plane_nz: Vec<Signal<In, Int<16>>>,
    /// Component x.
    pub nx: Signal<Out, Int<16>>,
    /// Component y.
    pub ny: Signal<Out, Int<16>>,
    /// Component z.
    pub nz: Signal<Out, Int<16>>,
    kept_nx: DFF<Int<16>>,
    kept_ny: DFF<Int<16>>,
    kept_nz: DFF<Int<16>>,
    zero: Constant<Int<16>>,
    cap: Constant<Word<4>>,
    plane_number: Vec<Constant<Word<4>>>,
    _planes: usize,
    _asleep: bool,
}

block! {
    [] PlaneNormal []
    inputs { clock, number, end_nz, plane_nx, plane_ny, plane_nz }
    parts { nx, ny, nz, kept_nx, kept_ny, kept_nz, zero, cap, plane_number }
    data { _planes }
}

impl PlaneNormal {
    /// A unit for `planes` planes.
    pub fn new(planes: usize) -> Self {
        fields! {
            [clock, number, end_nz, nx, ny, nz, kept_nx, kept_ny, kept_nz]
            plane_nx: repeat(planes, Default::default),
            plane_ny: repeat(planes, Default::default),
            plane_nz: repeat(planes, Default::default),
            zero: signed_constant(0),
            cap: constant(CAP),
            plane_number: (0..planes as u64)
                .map(|i| constant(FIRST_PLANE + i))
                .collect(),
            _planes: planes,
        }
    }

    /// Clocks from the face to its normal.
    pub const fn latency() -> usize {
        1
    }
}

impl Logic for PlaneNormal {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("plane_normal");
        clock!(self, clock, kept_nx, kept_ny, kept_nz);
        self.kept_nx.d.next = self.zero.val();
        self.kept_ny.d.next = self.zero.val();
        self.kept_nz.d.next = self.zero.val();
        if self.number.val() == self.cap.val() {
            self.kept_nz.d.next = self.end_nz.val();
        }
        for i in 0..self._planes {
            if self.number.val() == self.plane_number[i].val() {
                self.kept_nx.d.next = self.plane_nx[i].val();
                self.kept_ny.d.next = self.plane_ny[i].val();
                self.kept_nz.d.next = self.plane_nz[i].val();
            }
        }
        self.nx.next = self.kept_nx.q.val();
        self.ny.next = self.kept_ny.q.val();
        self.nz.next = self.kept_nz.q.val();
    }
}

clocked!(PlaneNormal);
