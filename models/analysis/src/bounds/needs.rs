//! What a scene requires of a machine: the narrowest words that are loaded with the same integers, and the slots.

use super::accumulators::plane_bits;
use imogene_contract::MachineWords;
use imogene_contract::slots;
use imogene_golden::format::Format;
use imogene_golden::widths;
use imogene_prepare::{PreparedScene, prepare};
use imogene_scene::FramedScene;
use serde::Serialize;

/// The narrowest machine of the scene at its depth word.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MachineNeeds {
    /// Widths as `--widths` takes them: fewest root and plane bits in which the scene prepares to the same integers, so
    /// that its picture is the same.
    pub widths: String,
    /// Slots as `--slots` takes them.
    pub slots: String,
    /// Why the root cannot be a bit shorter.
    pub root_limit: String,
    /// Why the plane word cannot be a bit shorter.
    pub plane_limit: String,
}

/// Searches the narrowest machine; `None` if other processors than quadric and patch draw a part of the scene, which
/// have no fitted machine.
pub fn machine_needs(scene: &FramedScene, prepared: &PreparedScene) -> Option<MachineNeeds> {
    if prepared.objects.iter().any(|o| o.quadric().is_none()) {
        return None;
    }
    let search = Search { scene, prepared };
    let mut widths = search.guess();
    let root_limit = search.narrow(&mut widths, |less| less.root -= 1);
    let plane_limit = search.narrow(&mut widths, |less| less.plane -= 1);
    Some(MachineNeeds {
        widths: widths::print(&widths),
        slots: slots::print(&prepared.fitted_slots()),
        root_limit,
        plane_limit,
    })
}

struct Search<'a> {
    scene: &'a FramedScene,
    prepared: &'a PreparedScene,
}

impl Search<'_> {
    /// What the preparation said that the words need, if the scene prepares to the same integers in that; else the
    /// format's own.
    fn guess(&self) -> MachineWords {
        let wide = self.prepared.format.widths();
        let guess = self.prepared.needed().narrowed(&wide);
        match self.keeps(&guess) {
            Ok(()) => guess,
            Err(_) => wide,
        }
    }

    /// Shortens a word as far as it goes, and says why no further.
    fn narrow(&self, widths: &mut MachineWords, shorten: fn(&mut MachineWords)) -> String {
        loop {
            let mut less = *widths;
            shorten(&mut less);
            match self.keeps(&less) {
                Ok(()) => *widths = less,
                Err(why) => return why,
            }
        }
    }

    /// Whether the scene prepares to the same integers in other widths; if not, why.
    fn keeps(&self, widths: &MachineWords) -> Result<(), String> {
        let format = Format::fitted(widths).map_err(|e| e.to_string())?;
        let other = prepare(self.scene, format).map_err(|e| e.to_string())?;
        let scaled =
            |name| format!("{name}: its words are scaled to their widths and would be others");
        let objects = self.prepared.objects.iter().zip(&other.objects);
        for (mine, others) in objects {
            if mine.words() != others.words() {
                return Err(scaled(format!("object '{}'", mine.name())));
            }
        }
        // The preparation proves the exact depth of a plane, not what its rounded words reach.
        for (_, object) in other.quadrics() {
            if plane_bits(&object.words).iter().any(|&b| b > format.plane) {
                let name = &object.name;
                return Err(format!("object '{name}': the words of a plane would wrap"));
            }
        }
        for (mine, others) in self.prepared.volumes.iter().zip(&other.volumes) {
            if mine.words != others.words {
                return Err(scaled(mine.name.clone()));
            }
        }
        Ok(())
    }
}
