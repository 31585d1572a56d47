//! The design space.

use crate::kit::words::widest;
use imogene_contract::{MachineWords, RootForm};
use imogene_prepare::lit_sphere::SphereForm;
use serde::{Deserialize, Serialize};

/// What decides the pixels of a machine.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub struct Accuracy {
    /// Depth word.
    pub depth: u32,
    /// Bits of a normal component.
    pub normal: u32,
    /// Guard bits of f1.
    pub guard_linear: u32,
    /// Guard bits of f2.
    pub guard_quadratic: u32,
    /// Last digits of the root that are not computed.
    pub dropped_rows: u32,
    /// How the root is taken.
    #[serde(default)]
    pub root_form: RootForm,
    /// Entries along each side of the tables of lit-sphere shading; 0 with a shading processor.
    #[serde(default)]
    pub table_side: u32,
    /// The nearest entry of a table is the colour.
    #[serde(default)]
    pub nearest_entry: bool,
    /// A machine of the catalogue: all widths follow from the depth word, and all slots are alike.
    pub catalogue: bool,
    /// Samples of a pixel along each side, 1, 2 or 4.
    pub supersampling: u32,
    /// Pixels along each side that show one that is drawn, 1, 2 or 4: a preview.
    pub undersampling: u32,
    /// Fields: every other line is drawn, and shown twice.
    #[serde(default)]
    pub interlaced: bool,
}

/// Processors that share the objects, zone by zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct Zones {
    /// Object processors.
    pub processors: usize,
    /// Columns and lines of a zone.
    pub side: u32,
}

/// A point of the design space: what decides the pixels, and what decides speed and area alone.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub struct Design {
    /// What decides the pixels.
    pub accuracy: Accuracy,
    /// A zone machine; else a beam machine, with a processor for each object.
    pub zones: Option<Zones>,
    /// Rows of the root network between registers.
    pub rows_per_stage: u32,
    /// Pixels of a line that a beam machine draws at once.
    pub pixels_per_clock: u32,
}

/// Clocks of a line at least where several pixels per clock are measured: all processors take fewer.
const LEAST_LINE: u32 = 40;

/// Which points are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// Some twenty.
    Quick,
    /// More than five hundred.
    Full,
    /// Every form of the root.
    Roots,
}

impl Accuracy {
    /// A fitted machine of a depth word, drawing every pixel once with normals of 16 bits.
    pub fn of_depth(depth: u32) -> Accuracy {
        Accuracy {
            depth,
            normal: 16,
            supersampling: 1,
            undersampling: 1,
            ..Accuracy::default()
        }
    }

    /// The widths before it is known what the scene requires.
    pub fn widest(&self) -> MachineWords {
        let guards = (self.guard_linear, self.guard_quadratic);
        MachineWords {
            root_form: self.root_form,
            ..widest(self.depth, self.normal, guards, self.dropped_rows)
        }
    }

    /// Its tables of lit-sphere shading; none with a shading processor.
    pub fn tables(&self) -> Option<SphereForm> {
        (self.table_side > 0).then(|| SphereForm {
            places: self.table_side.ilog2(),
            nearest: self.nearest_entry,
        })
    }

    /// Several pixels per clock are measured where the words are the plainest of some depths.
    fn has_lanes(&self) -> bool {
        let plain = Accuracy {
            table_side: self.table_side,
            nearest_entry: self.nearest_entry,
            undersampling: self.undersampling,
            interlaced: self.interlaced,
            ..Accuracy::of_depth(self.depth)
        };
        [12, 16, 20, 24].contains(&self.depth) && *self == plain && self.undersampling < 4
    }

    /// A short name, which is that of its files.
    pub fn name(&self) -> String {
        let mut name = format!(
            "w{}-n{}-g{}.{}-d{}",
            self.depth, self.normal, self.guard_linear, self.guard_quadratic, self.dropped_rows
        );
        for (letter, number) in [('s', self.supersampling), ('p', self.undersampling)] {
            if number > 1 {
                name += &format!("-{letter}{number}");
            }
        }
        if self.interlaced {
            name += "-i";
        }
        if self.table_side > 0 {
            let nearest = if self.nearest_entry { "n" } else { "" };
            name += &format!("-t{}{nearest}", self.table_side);
        }
        if !self.root_form.is_usual() {
            name += &format!("-{}", self.root_form);
        }
        if self.catalogue {
            name += "-catalogue";
        }
        name
    }
}

impl Design {
    /// A short name, which is that of its file.
    pub fn name(&self) -> String {
        let zones = self.zones.map_or(String::new(), |zones| {
            format!("-z{}k{}", zones.side, zones.processors)
        });
        let lanes = match self.pixels_per_clock {
            0 | 1 => String::new(),
            lanes => format!("-c{lanes}"),
        };
        let accuracy = self.accuracy.name();
        format!("{accuracy}{zones}{lanes}-r{}", self.rows_per_stage)
    }
}

impl Space {
    /// Its points of a picture of so many columns, those of the same pixels side by side.
    pub fn designs(self, columns: u32) -> Vec<Design> {
        let mut designs = match self {
            Space::Quick => quick(),
            Space::Full => full(),
            Space::Roots => roots(),
        };
        designs.retain(|design| {
            let lanes = design.pixels_per_clock;
            let clocks = columns / design.accuracy.undersampling / lanes;
            lanes == 1 || (clocks >= LEAST_LINE && columns.is_multiple_of(lanes))
        });
        designs
    }
}

/// Processors and sides of the zone machines that are measured.
type InZones = (&'static [usize], &'static [u32]);

const NO_ZONES: InZones = (&[], &[]);

/// The points of the same pixels: beam machines of so many pixels per clock, zone machines of all these processors and
/// sides, each with these rows to a stage.
fn points(accuracy: Accuracy, lanes: &[u32], shared: InZones, rows: &[u32]) -> Vec<Design> {
    let mut all = vec![];
    let mut add = |zones, lanes: &[u32]| {
        for &rows_per_stage in rows {
            all.extend(lanes.iter().map(|&pixels_per_clock| Design {
                accuracy,
                zones,
                rows_per_stage,
                pixels_per_clock,
            }));
        }
    };
    add(None, lanes);
    for &side in shared.1 {
        for &processors in shared.0 {
            add(Some(Zones { processors, side }), &[1]);
        }
    }
    all
}

fn changed(depth: u32, change: impl FnOnce(&mut Accuracy)) -> Accuracy {
    let mut accuracy = Accuracy::of_depth(depth);
    change(&mut accuracy);
    accuracy
}

fn guarded(depth: u32, guards: (u32, u32), dropped_rows: u32) -> Accuracy {
    changed(depth, |a| {
        (a.guard_linear, a.guard_quadratic) = guards;
        a.dropped_rows = dropped_rows;
    })
}

fn supersampled(depth: u32, samples: u32, table_side: u32) -> Accuracy {
    changed(depth, |a| {
        (a.supersampling, a.table_side) = (samples, table_side);
    })
}

fn preview(depth: u32, side: u32, table_side: u32) -> Accuracy {
    changed(depth, |a| {
        (a.undersampling, a.table_side) = (side, table_side);
    })
}

fn interlaced(depth: u32, table_side: u32) -> Accuracy {
    changed(depth, |a| (a.interlaced, a.table_side) = (true, table_side))
}

fn lit(depth: u32, table_side: u32) -> Accuracy {
    changed(depth, |a| a.table_side = table_side)
}

fn nearest(mut accuracy: Accuracy) -> Accuracy {
    accuracy.nearest_entry = true;
    accuracy
}

/// A machine that draws a pixel in as many clocks as roots have digits.
fn serial(mut accuracy: Accuracy) -> Vec<Design> {
    accuracy.root_form = RootForm::Iterative;
    points(accuracy, &[1], NO_ZONES, &[1])
}

fn quick() -> Vec<Design> {
    let of = Accuracy::of_depth;
    let (guards, dropped) = (guarded(16, (2, 4), 0), guarded(20, (0, 0), 3));
    let beams = [of(10), of(12), guards, of(20), dropped, of(24)];
    let beams = beams.map(|accuracy| points(accuracy, &[1], NO_ZONES, &[1, 2]));
    let others = [
        points(of(16), &[1], (&[1], &[16]), &[1, 2]),
        points(supersampled(16, 2, 0), &[], (&[2], &[16]), &[1]),
        points(preview(16, 2, 0), &[1], NO_ZONES, &[1]),
        points(interlaced(16, 0), &[1], NO_ZONES, &[1]),
        serial(of(12)),
        points(lit(16, 32), &LANES, (&[2], &[16]), &[1]),
    ];
    [beams.concat(), others.concat()].concat()
}

fn roots() -> Vec<Design> {
    let mut forms = vec![
        RootForm::Restoring,
        RootForm::NonRestoring,
        RootForm::Iterative,
    ];
    forms.extend((0..=2).flat_map(|count| [RootForm::Linear(count), RootForm::Quadratic(count)]));
    forms.extend([4, 6, 8, 12].map(RootForm::Leading));
    let mut all = vec![];
    for depth in [24, 16] {
        for &form in &forms {
            let accuracy = changed(depth, |a| a.root_form = form);
            all.extend(points(accuracy, &[1], NO_ZONES, &[4]));
        }
    }
    all
}

const LANES: [u32; 3] = [1, 2, 4];
const ROWS: [u32; 2] = [1, 4];
/// Guard bits of f1 and f2, and digits not computed.
const EXACTNESS: [((u32, u32), u32); 5] = [
    ((0, 0), 0),
    ((1, 2), 0),
    ((2, 4), 0),
    ((0, 0), 4),
    ((1, 2), 4),
];

fn full() -> Vec<Design> {
    let mut all = vec![];
    let mut add = |accuracy: Accuracy, has_beam: bool, zones| {
        let lanes = match (has_beam, accuracy.has_lanes()) {
            (false, _) => &LANES[..0],
            (true, false) => &LANES[..1],
            (true, true) => &LANES,
        };
        all.extend(points(accuracy, lanes, zones, &ROWS));
    };
    let shared: InZones = (&[1, 2, 4, 8], &[16, 32, 64]);
    for depth in [8, 10, 12, 14, 16, 18, 20, 22, 24] {
        for (guards, dropped) in EXACTNESS {
            let zones = match (guards, dropped) {
                ((0, 0), 0) if depth >= 12 && depth != 22 => shared,
                _ => NO_ZONES,
            };
            add(guarded(depth, guards, dropped), true, zones);
            if depth < 12 {
                break;
            }
        }
    }
    for depth in [12, 16, 20, 24] {
        add(changed(depth, |a| a.normal = 10), true, NO_ZONES);
    }
    for depth in [16, 20, 24] {
        add(changed(depth, |a| a.catalogue = true), true, NO_ZONES);
    }
    for samples in [2, 4] {
        for depth in [12, 14, 16, 20, 24] {
            add(supersampled(depth, samples, 0), false, shared);
        }
    }
    for side in [2, 4] {
        for depth in [8, 10, 12, 14, 16] {
            add(preview(depth, side, 0), true, (&[1, 2], &[16]));
        }
    }
    for depth in [12, 16, 20] {
        add(interlaced(depth, 0), true, NO_ZONES);
        add(interlaced(depth, 64), true, NO_ZONES);
        add(nearest(interlaced(depth, 64)), true, NO_ZONES);
    }
    for depth in [12, 14, 16, 18, 20, 24] {
        add(lit(depth, 64), true, shared);
    }
    for side in [16, 32, 128] {
        add(lit(16, side), true, (&[1, 4], &[16]));
    }
    for depth in [12, 16, 20] {
        add(nearest(lit(depth, 64)), true, shared);
        add(nearest(lit(depth, 128)), true, (&[1, 4], &[16]));
    }
    for depth in [12, 16, 20] {
        add(supersampled(depth, 2, 64), false, shared);
        add(nearest(supersampled(depth, 2, 64)), false, shared);
        add(preview(depth, 2, 64), true, (&[1, 2], &[16]));
        add(preview(depth, 4, 32), true, (&[1, 2], &[16]));
        add(nearest(preview(depth, 4, 64)), true, (&[1, 2], &[16]));
    }
    for depth in [12, 16, 20, 24] {
        for accuracy in [lit(depth, 0), lit(depth, 64), nearest(lit(depth, 64))] {
            all.extend(serial(accuracy));
        }
    }
    all
}
