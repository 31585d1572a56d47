//! Flags of the light sources, from the answers of the shadow and light volumes.

use crate::format::MOST_OBJECTS;
use crate::kernel::*;

/// Words that one register takes.
const GROUP: usize = 8;

/// Tells which sources reach the visible point: flag s stays if the point is outside every shadow volume of source s and inside every light
/// volume of it.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `flags_in` | in | 16 bits: the flags before these volumes, all ones in a first pass |
/// | `volume_i_inside` | in | the point is inside volume i |
/// | `volume_i_kind` | in | 0 shadow, 1 light; held |
/// | `volume_i_source` | in | 4 bits, the source of the volume; held |
/// | `volume_i_enabled` | in | without it the volume takes nothing away; held |
/// | `flags` | out | 16 bits |
///
/// Every volume gives a word of 16 flags, and the words are joined eight to a register: latency 1 for up to 8 volumes, `ceil(log8 M)` for more.
pub struct ShadowStage {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Flags before these volumes.
    pub flags_in: Signal<In, Word<16>>,
    /// Inside each volume.
    pub volume_inside: Vec<Signal<In, Bit>>,
    /// Shadow or light.
    pub volume_kind: Vec<Signal<In, Bit>>,
    /// Source of each volume.
    pub volume_source: Vec<Signal<In, Word<4>>>,
    /// The volume counts.
    pub volume_enabled: Vec<Signal<In, Bit>>,
    /// Flags after these volumes.
    pub flags: Signal<Out, Word<16>>,
    takes_away: Vec<Signal<Local, Bit>>,
    mask: Vec<Signal<Local, Word<16>>>,
    branch: Vec<Signal<Local, Word<16>>>,
    joined: Vec<Signal<Local, Word<16>>>,
    kept: Vec<DFF<Word<16>>>,
    one: Constant<Word<16>>,
    unchanged: Constant<Word<16>>,
    opening: Vec<Constant<Word<16>>>,
    following: Vec<Constant<Word<16>>>,
    preceding: Vec<Constant<Word<16>>>,
    closing: Vec<Constant<Word<16>>>,
    kept_branch: Vec<Constant<Word<16>>>,
    _volumes: usize,
    _openings: usize,
    _followings: usize,
    _registers: usize,
    _inner: usize,
    _asleep: bool,
}

block! {
    [] ShadowStage []
    inputs { clock, flags_in, volume_inside, volume_kind, volume_source, volume_enabled }
    parts { flags, takes_away, mask, branch, joined, kept, one, unchanged, opening, following, preceding,
        closing, kept_branch }
    data { _volumes, _openings, _followings, _registers, _inner }
}

/// Where the words of all levels stand: those of the volumes, then those of the registers, level by level.
struct Levels {
    /// First words of all groups but the very first.
    openings: Vec<usize>,
    /// All other words but the very first.
    followings: Vec<usize>,
    /// Last words of the groups, one for each register.
    closings: Vec<usize>,
}

impl Levels {
    fn new(volumes: usize) -> Self {
        let mut levels = Self {
            openings: Vec::new(),
            followings: Vec::new(),
            closings: Vec::new(),
        };
        let (mut first, mut level) = (0, volumes);
        loop {
            for place in 0..level {
                let element = first + place;
                match place % GROUP {
                    0 if element > 0 => levels.openings.push(element),
                    0 => (),
                    _ => levels.followings.push(element),
                }
                if place % GROUP == GROUP - 1 || place == level - 1 {
                    levels.closings.push(element);
                }
            }
            first += level;
            level = level.div_ceil(GROUP);
            if level == 1 {
                return levels;
            }
        }
    }
}

fn places(list: &[usize]) -> Vec<Constant<Word<16>>> {
    list.iter().map(|&place| constant(place as u64)).collect()
}

impl ShadowStage {
    /// A stage for `volumes` volumes.
    ///
    /// # Panics
    ///
    /// When `volumes` is not in `1..=256`.
    pub fn new(volumes: usize) -> Self {
        assert!(
            (1..=MOST_OBJECTS).contains(&volumes),
            "a shadow stage has 1 to {MOST_OBJECTS} volumes"
        );
        let levels = Levels::new(volumes);
        let registers = levels.closings.len();
        let preceding: Vec<usize> = levels.followings.iter().map(|place| place - 1).collect();
        let kept_branch: Vec<usize> = (volumes..volumes + registers - 1).collect();
        fields! {
            [clock, flags_in, flags]
            volume_inside: repeat(volumes, Default::default),
            volume_kind: repeat(volumes, Default::default),
            volume_source: repeat(volumes, Default::default),
            volume_enabled: repeat(volumes, Default::default),
            takes_away: repeat(volumes, Default::default),
            mask: repeat(volumes, Default::default),
            branch: repeat(volumes + registers - 1, Default::default),
            joined: repeat(volumes + registers - 1, Default::default),
            kept: repeat(registers, Default::default),
            one: constant(1),
            unchanged: constant(0xffff),
            opening: places(&levels.openings),
            following: places(&levels.followings),
            preceding: places(&preceding),
            closing: places(&levels.closings),
            kept_branch: places(&kept_branch),
            _volumes: volumes,
            _openings: levels.openings.len(),
            _followings: levels.followings.len(),
            _registers: registers,
            _inner: registers - 1,
        }
    }

    /// Clocks from the answers to the flags.
    pub const fn latency(volumes: usize) -> usize {
        let (mut level, mut clocks) = (volumes.div_ceil(GROUP), 1);
        while level > 1 {
            level = level.div_ceil(GROUP);
            clocks += 1;
        }
        clocks
    }
}

impl Logic for ShadowStage {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("shadow_stage");
        for i in 0..self._volumes {
            self.takes_away[i].next = self.volume_enabled[i].val()
                & (self.volume_inside[i].val() ^ self.volume_kind[i].val());
            self.mask[i].next = self.one.val() << self.volume_source[i].val();
            if self.takes_away[i].val() {
                self.branch[i].next = !self.mask[i].val();
            } else {
                self.branch[i].next = self.unchanged.val();
            }
        }
        for i in 0..self._registers {
            self.kept[i].clock.next = self.clock.val();
            self.flags.next = self.kept[i].q.val();
        }
        for i in 0..self._inner {
            self.branch[self.kept_branch[i].val().index()].next = self.kept[i].q.val();
        }
        self.joined[0].next = self.flags_in.val() & self.branch[0].val();
        for i in 0..self._openings {
            self.joined[self.opening[i].val().index()].next =
                self.branch[self.opening[i].val().index()].val();
        }
        for i in 0..self._followings {
            self.joined[self.following[i].val().index()].next =
                self.joined[self.preceding[i].val().index()].val()
                    & self.branch[self.following[i].val().index()].val();
        }
        for i in 0..self._registers {
            self.kept[i].d.next = self.joined[self.closing[i].val().index()].val();
        }
    }
}

clocked!(ShadowStage);
