//! Words on their way to the processors of a machine.

use super::{Load, VolumeLoad};
use imogene_contract::command_stream::kind;
use imogene_hdl::{Bits, Bundle, Value, bundle, module, net};

bundle! {
    /// A beat of AXI4-Stream.
    Beat(width) {
        tvalid: Bits(1), "a beat is there";
        tdest: Bits(4), "what it carries";
        tuser: Bits(24), "unit in 23..16, address in 15..0";
        tdata: Bits(width), "the word";
    }

    /// The load bus of a machine.
    WordBus(width) {
        object: Bits(1), "a word for an object";
        volume: Bits(1), "a word for a volume";
        shading: Bits(1), "a word for the shading processor";
        material: Bits(1), "a material of an object";
        unit: Bits(8), "unit of the word";
        address: Bits(16), "its address";
        data: Bits(width), "the word";
    }
}

impl WordBus {
    /// The word of a beat.
    pub fn of(beat: Beat) -> WordBus {
        let is = |kind: u8| beat.tvalid & beat.tdest.is(kind.into());
        WordBus {
            object: is(kind::OBJECT),
            volume: is(kind::VOLUME),
            shading: is(kind::SHADING),
            material: is(kind::MATERIAL),
            unit: beat.tuser.slice(23, 16),
            address: beat.tuser.low(16),
            data: beat.tdata,
        }
    }

    /// The bus, without a word unless it is wanted.
    pub fn when(self, wanted: Bits) -> WordBus {
        WordBus {
            object: self.object & wanted,
            volume: self.volume & wanted,
            shading: self.shading & wanted,
            material: self.material & wanted,
            ..self
        }
    }

    /// The words of objects.
    pub fn objects(&self) -> Load {
        Load {
            valid: self.object,
            object: self.unit,
            address: self.address.low(8),
            data: self.data,
        }
    }

    /// The words of volumes.
    pub fn volumes(&self) -> VolumeLoad {
        VolumeLoad {
            valid: self.volume,
            volume: self.unit,
            address: self.address.low(8),
            data: self.data,
        }
    }
}

/// Keeps up to two beats, so that no path leads from the receiver of a stream to its sender or back within a clock;
/// with them `tready` for the sender.
///
/// Latency 1; one beat per clock.
pub fn stream_slice(at: &str, beat: Beat, ready: Bits) -> (Beat, Bits) {
    let inputs = (("s", beat), ("m_tready", ready));
    module("stream_slice", at, inputs, |(beat, ready)| {
        net! {
            let is_there = Bits::register(1);
            let is_waiting = Bits::register(1);
            let comes = beat.tvalid & !is_waiting;
            let goes = ready | !is_there;
        }
        is_there.load_when(goes, is_waiting | comes);
        is_waiting.load_when(goes | comes, !goes);
        let carried = (beat.tdest, beat.tuser, beat.tdata);
        let waiting = carried.registered_when(comes & !goes);
        let (tdest, tuser, tdata) = is_waiting.select(waiting, carried).registered_when(goes);
        let beat = Beat {
            tvalid: is_there,
            tdest,
            tuser,
            tdata,
        };
        (("m", beat), ("s_tready", !is_waiting))
    })
}
