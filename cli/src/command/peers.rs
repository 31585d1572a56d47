//! `imogene peers`.

use crate::arguments::Peers;
use crate::failure::Result;
use crate::output;
use imogene_synth::Target;
use imogene_synth::peer::{Peer, compare};

pub fn run(options: &Peers, json: bool) -> Result {
    let request = options.shape.request(&options.against)?;
    request.check()?;
    let target = Target::from_name(&options.target)?;
    let peer = Peer {
        files: options.rtl.clone(),
        top: options.top.clone(),
        clock: options.clock.clone(),
        include: options.include.clone(),
        parameters: options.parameter.clone(),
    };
    let comparison = compare(&peer, &request, target, options.seeds)?;
    output::told(json, &comparison, include_str!("peers.txt"))
}
