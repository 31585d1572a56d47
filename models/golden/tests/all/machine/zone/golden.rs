use imogene_contract::object::ProductSlots;
use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::machine::zone::beat::{Beat, OBJECT_ID, command, kind};
use imogene_golden::machine::zone::golden::{ShownPixel, StreamError, ZoneMachineModel};

fn machine() -> ZoneMachine {
    ZoneMachine {
        layers: vec![],
        slots: vec![FittedSlot::quadric(1); 5],
        products: vec![ProductSlots {
            intersected: 2,
            subtracted: 1,
        }],
        volume_processors: 1,
        volume_planes: 1,
        zone_width: 4,
        zone_height: 4,
        samples: 1,
    }
}

fn run(beats: &[Beat]) -> Result<Vec<ShownPixel>, StreamError> {
    let mut model = ZoneMachineModel::new(&Format::BASE, &machine());
    let mut shown = vec![];
    for beat in beats {
        model.beat(beat, |pixel| shown.push(pixel))?;
    }
    Ok(shown)
}

fn zone(x: u64, y: u64, width: u64, height: u64) -> [Beat; 2] {
    [
        Beat::command(command::ORIGIN, x | y << 12),
        Beat::command(command::SIZE, width | height << 12),
    ]
}

/// An object that is everywhere at a depth: a patch whose root is 0.
fn sheet(unit: u8, depth: u64, id: u64) -> Vec<Beat> {
    let word = |address, data| Beat::new(kind::OBJECT, unit, address, data);
    let mut beats: Vec<Beat> = (0..31).map(|address| word(address, 0)).collect();
    let set = [(2, depth), (21, 3 << 12), (22, 3 << 12), (23, 2)];
    beats.extend(set.map(|(address, data)| word(address, data)));
    beats.push(word(OBJECT_ID, id));
    beats
}

const DRAW_FIRST: Beat = Beat::command(command::DRAW, 1);
const DRAW: Beat = Beat::command(command::DRAW, 0);
const SHOW: Beat = Beat::command(command::SHOW, command::DRAWN);

#[test]
fn an_undrawn_zone_is_background() {
    let mut beats = zone(8, 12, 2, 2).to_vec();
    beats.push(Beat::command(command::SHOW, command::LAST_ZONE));
    let shown = run(&beats).unwrap();
    let places: Vec<_> = shown.iter().map(|p| (p.x, p.y)).collect();
    assert_eq!(places, [(8, 12), (9, 12), (8, 13), (9, 13)]);
    let last: Vec<_> = shown.iter().map(|p| p.last).collect();
    assert_eq!(last, [false, false, false, true]);
    assert!(shown.iter().all(|p| p.depth == Format::BASE.z_max()));
}

#[test]
fn equal_depths_go_to_the_smaller_id_in_any_batch() {
    let zone = &zone(0, 0, 1, 1)[..];
    let sheet = |unit, id| sheet(unit, 77, id);
    for [a, b] in [[5, 9], [9, 5]] {
        let one_batch = [zone, &sheet(0, a), &sheet(1, b), &[DRAW_FIRST, SHOW]];
        let [first, second] = [sheet(0, a), sheet(0, b)];
        let two_batches = [zone, &first, &[DRAW_FIRST], &second, &[DRAW, SHOW]];
        for beats in [one_batch.concat(), two_batches.concat()] {
            let shown = run(&beats).unwrap();
            assert_eq!((shown[0].id, shown[0].depth), (5, 77));
        }
    }
}

#[test]
fn a_processor_that_is_not_loaded_again_is_absent() {
    let beats = [
        &zone(0, 0, 1, 1)[..],
        &sheet(0, 50, 1),
        &sheet(1, 60, 2),
        &[DRAW_FIRST, SHOW],
        &zone(1, 0, 1, 1),
        &sheet(1, 60, 2),
        &[DRAW_FIRST, SHOW],
    ];
    let ids: Vec<u16> = run(&beats.concat()).unwrap().iter().map(|p| p.id).collect();
    assert_eq!(ids, [1, 2]);
}

/// Processors 2 and 3 are intersected, 4 is taken away, seen from behind: its depth is the complement.
#[test]
fn a_product_is_what_its_objects_have_in_common() {
    let draw = |sheets: &[Vec<Beat>]| {
        let beats = [&zone(0, 0, 1, 1)[..], &sheets.concat(), &[DRAW_FIRST, SHOW]];
        let pixel = run(&beats.concat()).unwrap()[0];
        (pixel.depth != Format::BASE.z_max()).then_some((pixel.id, pixel.depth))
    };
    let behind = |depth: u64| sheet(4, !depth, 3);
    // The first of them is seen, whatever the ids.
    assert_eq!(draw(&[sheet(2, 70, 9), sheet(3, 70, 8)]), Some((9, 70)));
    assert_eq!(draw(&[sheet(2, 70, 9), sheet(3, 71, 8)]), None);
    let common = [sheet(2, 70, 9), sheet(3, 70, 8)];
    let less = |depth| draw(&[&common[..], &[behind(depth)]].concat());
    let seen = [Some((9, 70)), None, Some((9, 70))];
    assert_eq!([69, 70, 71].map(less), seen);
    // Without one that is intersected there is nothing; what is nearer in another processor stays.
    assert_eq!(draw(&[sheet(2, 70, 9)]), None);
    assert_eq!(draw(&[behind(70)]), None);
    let with = |depth| draw(&[&common[..], &[sheet(1, depth, 11)]].concat());
    assert_eq!(with(69), Some((11, 69)));
    assert_eq!(with(70), Some((9, 70)));
}

#[test]
fn streams_without_a_meaning_are_refused() {
    let refused = |beats: &[Beat]| run(beats).unwrap_err().to_string();
    let [origin, size] = zone(0, 0, 1, 1);
    assert!(refused(&[origin, DRAW_FIRST]).contains("before origin and size"));
    assert!(refused(&[origin, size, DRAW]).contains("first draw pass"));
    assert!(refused(&[origin, size, DRAW_FIRST, DRAW_FIRST]).contains("first draw pass"));
    assert!(refused(&[origin, size, DRAW_FIRST, size]).contains("moves"));
    assert!(refused(&[origin, size, SHOW]).contains("show pass"));
    let light = Beat::command(command::LIGHT, 1);
    assert!(refused(&[origin, size, light]).contains("before a draw pass"));
    assert!(refused(&[origin, size, DRAW_FIRST, light, DRAW]).contains("after a light pass"));
    let stray = [
        Beat::new(kind::OBJECT, 5, 0, 0),
        Beat::new(kind::OBJECT, 0, 31, 0),
        Beat::new(kind::VOLUME, 0, 17, 0),
        Beat::new(kind::MATERIAL, 0, 4096, 0),
        Beat::command(5, 0),
        Beat::new(5, 0, 0, 0),
    ];
    for beat in stray {
        assert!(refused(&[beat]).contains("does not exist"), "{beat:?}");
    }
}
