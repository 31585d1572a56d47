//! Register slice of the command stream.

use crate::kernel::*;

/// Keeps up to two beats of an AXI4-Stream, so that no path leads from its receiver to its sender or back within a clock.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `s_tvalid`, `s_tdest`, `s_tuser`, `s_tdata` | in | 1, 4, 24, `F` bits |
/// | `s_tready` | out | from a register |
/// | `m_tvalid`, `m_tdest`, `m_tuser`, `m_tdata` | out | from registers |
/// | `m_tready` | in | |
///
/// Latency 1; one beat per clock.
#[derive(Default)]
pub struct StreamSlice<const F: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// A beat comes.
    pub s_tvalid: Signal<In, Bit>,
    /// What it carries.
    pub s_tdest: Signal<In, Word<4>>,
    /// Unit and address.
    pub s_tuser: Signal<In, Word<24>>,
    /// Data.
    pub s_tdata: Signal<In, Word<F>>,
    /// The receiver takes a beat.
    pub m_tready: Signal<In, Bit>,
    /// The beat is taken.
    pub s_tready: Signal<Out, Bit>,
    /// A beat is there.
    pub m_tvalid: Signal<Out, Bit>,
    /// What it carries.
    pub m_tdest: Signal<Out, Word<4>>,
    /// Unit and address.
    pub m_tuser: Signal<Out, Word<24>>,
    /// Data.
    pub m_tdata: Signal<Out, Word<F>>,
    comes: Signal<Local, Bit>,
    goes: Signal<Local, Bit>,
    is_there: DFF<Bit>,
    dest: DFF<Word<4>>,
    user: DFF<Word<24>>,
    data: DFF<Word<F>>,
    is_waiting: DFF<Bit>,
    waiting_dest: DFF<Word<4>>,
    waiting_user: DFF<Word<24>>,
    waiting_data: DFF<Word<F>>,
    _asleep: bool,
}

block! {
    [const F: usize] StreamSlice [F]
    inputs { clock, s_tvalid, s_tdest, s_tuser, s_tdata, m_tready }
    parts { s_tready, m_tvalid, m_tdest, m_tuser, m_tdata, comes, goes, is_there, dest, user, data, is_waiting, waiting_dest, waiting_user,
        waiting_data }
    data { }
}

impl<const F: usize> Logic for StreamSlice<F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("stream_slice");
        dff_setup!(
            self,
            clock,
            is_there,
            dest,
            user,
            data,
            is_waiting,
            waiting_dest,
            waiting_user,
            waiting_data
        );
        self.comes.next = self.s_tvalid.val() & !self.is_waiting.q.val();
        self.goes.next = self.m_tready.val() | !self.is_there.q.val();
        if self.goes.val() {
            if self.is_waiting.q.val() {
                self.is_there.d.next = true;
                self.dest.d.next = self.waiting_dest.q.val();
                self.user.d.next = self.waiting_user.q.val();
                self.data.d.next = self.waiting_data.q.val();
                self.is_waiting.d.next = false;
            } else {
                self.is_there.d.next = self.comes.val();
                self.dest.d.next = self.s_tdest.val();
                self.user.d.next = self.s_tuser.val();
                self.data.d.next = self.s_tdata.val();
            }
        } else if self.comes.val() {
            self.is_waiting.d.next = true;
            self.waiting_dest.d.next = self.s_tdest.val();
            self.waiting_user.d.next = self.s_tuser.val();
            self.waiting_data.d.next = self.s_tdata.val();
        }
        self.s_tready.next = !self.is_waiting.q.val();
        self.m_tvalid.next = self.is_there.q.val();
        self.m_tdest.next = self.dest.q.val();
        self.m_tuser.next = self.user.q.val();
        self.m_tdata.next = self.data.q.val();
    }
}

clocked!(StreamSlice<const F: usize>);
