//! Has a machine what scenes need? If not, the lines of a description that has.

use super::beam::{
    DisplayError, Result, beam_slots, frame_words, members, placed, volumes, zone_slots,
};
use super::description::{
    MachineDescription, MachineKind, Mode, Output, OwnMode, SMALLEST_SIDE, ZoneSize,
};
use super::zone::plan::{Pass, PlanError, ZonePlan};
use imogene_contract::object::{Kind, ProductSlots};
use imogene_contract::slots::{FittedSlot, Slots};
use imogene_golden::machine::shader::MOST_LIGHTS;
use imogene_golden::machine::zone::ID_BITS;
use imogene_golden::object::quadric::MAX_PLANES;
use imogene_golden::object::slot::Slot;
use imogene_prepare::lit_sphere::shadowed_lights;
use imogene_prepare::shader::ShaderError;
use imogene_prepare::{PreparedScene, Product};
use imogene_scene::FramedScene;
use std::cmp::Reverse;

type Scene<'a, 'b> = (&'a FramedScene, &'b PreparedScene);

/// A product before it has slots.
const NO_SLOTS: ProductSlots = ProductSlots {
    intersected: 0,
    subtracted: 0,
};

/// Zone of a machine that takes the place of a beam machine.
const ZONE: ZoneSize = ZoneSize {
    width: 32,
    height: 32,
};

/// Checks that a machine can show scenes, one after the other.
/// Fails when it has too few processors, planes, lights or words: the error has the lines that would do for all of the
/// scenes. Fails, too, when no machine shows one of them.
pub fn check(machine: &MachineDescription, scenes: &[Scene]) -> Result<()> {
    let enough = enough(machine, scenes)?;
    match enough == *machine {
        true => Ok(()),
        false => Err(DisplayError::Needs(lines(machine, &enough))),
    }
}

/// The machine with what it lacks for the scenes; one of zones if no beam machine is large enough.
/// Fails when no machine shows one of them.
pub fn enough(machine: &MachineDescription, scenes: &[Scene]) -> Result<MachineDescription> {
    let mut enough = machine.clone();
    // Twice: in a product that a later scene enlarges, an earlier one fills more slots.
    for scene in scenes.iter().chain(scenes) {
        add(&mut enough, *scene)?;
    }
    if enough.machine == MachineKind::Beam {
        for scene in scenes {
            make_room(&mut enough, *scene)?;
        }
        // More pixels per clock than its lines take are not why objects are shared.
        let of_one_lane = MachineDescription {
            pixels_per_clock: 1,
            modules: 1,
            ..enough.clone()
        };
        if of_one_lane.check("").is_err() {
            share_processors(&mut enough, machine);
            for scene in scenes {
                add(&mut enough, *scene)?;
            }
        }
    }
    Ok(enough)
}

/// A machine with the slots that it has, each in as few bits as hold what the scenes need of it. A zone machine takes
/// as many passes as before.
/// Fails when it does not show one of them.
pub fn narrowed(machine: &MachineDescription, scenes: &[Scene]) -> Result<MachineDescription> {
    let slots = machine.slots();
    let mut slots: Vec<FittedSlot> = slots.iter().map(FittedSlot::in_all_bits).collect();
    let with = |slots: &[FittedSlot]| MachineDescription {
        slots: Some(Slots(slots.to_vec())),
        ..machine.clone()
    };
    let wide = with(&slots);
    let plans = match machine.machine {
        MachineKind::Beam => vec![],
        MachineKind::Zone => zone_plans(&wide, scenes)?,
    };
    let mut needs: Vec<(usize, FittedSlot)> = plans.iter().flat_map(shared_needs).collect();
    if machine.machine == MachineKind::Beam {
        for (_, prepared) in scenes {
            let parts = placed(prepared, &wide)?.into_iter();
            needs.extend(parts.map(|(place, part)| (place, part.needed)));
        }
    }
    let mut most: Vec<Option<FittedSlot>> = vec![None; slots.len()];
    for (place, needed) in needs {
        most[place] = Some(most[place].map_or(needed, |most| most.or(&needed)));
    }
    for (slot, most) in slots.iter_mut().zip(most) {
        if let Some(FittedSlot { root, plane, .. }) = most {
            (slot.root, slot.plane) = (root, plane);
        }
    }
    let narrow = with(&slots);
    let passes = |plans: &[ZonePlan]| -> usize { plans.iter().map(ZonePlan::draw_passes).sum() };
    let is_slower = !plans.is_empty() && passes(&zone_plans(&narrow, scenes)?) > passes(&plans);
    Ok(if is_slower { machine.clone() } else { narrow })
}

fn zone_plans(machine: &MachineDescription, scenes: &[Scene]) -> Result<Vec<ZonePlan>> {
    let plan = |(_, prepared): &Scene| ZonePlan::of(prepared, machine.zone_machine());
    Ok(scenes.iter().map(plan).collect::<Result<_, _>>()?)
}

/// What the passes of a zone machine need of its slots that are of no product: of each pass the part that needs the
/// most bits goes to the first slot that has its planes.
fn shared_needs(plan: &ZonePlan) -> Vec<(usize, FittedSlot)> {
    let slots = &plan.machine.slots[..plan.machine.alone()];
    let fewest_planes = |needed: &FittedSlot| {
        let holding = slots.iter().filter(|slot| slot.holds(needed));
        holding.map(|slot| slot.planes).min()
    };
    let of_layers = plan.layers.iter().map(|layer| layer.needed);
    let mut all: Vec<(usize, FittedSlot)> = (plan.machine.slots.len()..).zip(of_layers).collect();
    let passes = plan.zones.iter().flat_map(|zone| plan.passes(zone, false));
    for pass in passes {
        let Pass::Draw { parts, .. } = pass else {
            continue;
        };
        let alone = parts.iter().filter(|(place, _)| *place < slots.len());
        let needs = alone.map(|(_, part)| plan.parts[*part as usize].needed);
        let mut needs: Vec<FittedSlot> = needs.collect();
        needs.sort_by_key(|needed| Reverse((fewest_planes(needed), needed.bits())));
        let mut free = vec![true; slots.len()];
        for needed in needs {
            let mut places = (0..slots.len()).filter(|&place| free[place]);
            let place = places.find(|&place| slots[place].holds(&needed));
            let place = place.expect("as many slots as parts");
            free[place] = false;
            all.push((place, needed));
        }
    }
    all
}

/// Checks that there are machines of a kind that show a scene.
/// Fails when it has too many lights or objects, or what no processor of such a machine draws.
pub fn check_any(kind: MachineKind, framed: &FramedScene, prepared: &PreparedScene) -> Result<()> {
    check_counts((framed, prepared))?;
    match kind {
        MachineKind::Beam => {
            beam_slots(prepared, &prepared.slots_alone(), &[])?;
        }
        MachineKind::Zone => zone_slots(prepared, &[]).map(|_| ())?,
    }
    beam_slots(prepared, &prepared.layers, &[])?;
    volumes(prepared, MAX_PLANES).map(|_| ())
}

fn check_counts((framed, prepared): Scene) -> Result<()> {
    let lights = framed.lights.len();
    if lights > MOST_LIGHTS {
        return Err(ShaderError::Lights(lights).into());
    }
    if prepared.objects.len() > 1 << ID_BITS {
        return Err(PlanError::Objects(prepared.objects.len()).into());
    }
    Ok(())
}

/// Gives a machine the processors, planes and lights that it lacks for a scene.
fn add(machine: &mut MachineDescription, (framed, prepared): Scene) -> Result<()> {
    check_counts((framed, prepared))?;
    let volumes = volumes(prepared, MAX_PLANES)?;
    add_tables(machine, (framed, prepared))?;
    let (objects, planes, bodies) = match machine.machine {
        MachineKind::Beam => {
            let planes = add_slots(machine, prepared)?;
            (planes.len(), planes.into_iter().max(), volumes.len())
        }
        MachineKind::Zone => {
            let planes = add_shared(machine, prepared)?;
            (machine.objects, planes, volumes.len().min(1))
        }
    };
    // A machine without lights shows plain colours, whatever shines in the scene, or has all of it in its tables.
    let lights = match machine.lit_sphere {
        Some(_) => machine.lights,
        None => framed.lights.len() * usize::from(machine.lights > 0),
    };
    let volume_planes = volumes.iter().map(|words| words.planes.len()).max();
    for (given, needed) in [
        (&mut machine.objects, objects),
        (&mut machine.planes, planes.unwrap_or(0)),
        (&mut machine.volumes, bodies),
        (&mut machine.volume_planes, volume_planes.unwrap_or(0)),
        (&mut machine.lights, lights),
    ] {
        *given = needed.max(*given);
    }
    let points = framed.lights.iter().filter(|light| light.is_at_a_point);
    let directional = machine.lights - points.count().min(lights);
    machine.suns = machine.suns.min(directional);
    Ok(())
}

/// Gives a machine with tables those for the materials of a scene and for the lights that are in shadow somewhere,
/// smaller ones where there are many.
fn add_tables(machine: &mut MachineDescription, (framed, prepared): Scene) -> Result<()> {
    let Some(sphere) = &mut machine.lit_sphere else {
        return Ok(());
    };
    let lights = shadowed_lights(prepared).max(machine.lights);
    let materials = framed.materials.len().max(sphere.materials);
    (machine.lights, sphere.materials) = (lights, materials);
    while !sphere.has_room(lights) {
        if sphere.side <= SMALLEST_SIDE {
            let most = sphere.most_tables();
            return Err(DisplayError::Tables(materials, lights, most));
        }
        sphere.side /= 2;
    }
    Ok(())
}

/// Gives a zone machine the object processors that it lacks for a scene; the most planes of one of the scene's parts.
fn add_shared(machine: &mut MachineDescription, prepared: &PreparedScene) -> Result<Option<usize>> {
    let mut alone = machine.slots();
    let mut layers = alone.split_off(alone.len() - machine.layers);
    let members = alone.split_off(machine.slots_alone());
    let needed_layers = of_slots(prepared, &prepared.layers, &layers)?.into_iter();
    let needed_layers = needed_layers.enumerate().map(|(place, needed)| {
        let given = layers.get(place).filter(|given| given.holds(&needed));
        given.copied().unwrap_or(needed.in_all_bits())
    });
    let needed_layers: Vec<FittedSlot> = needed_layers.collect();
    let (needed, of_members) = zone_slots(prepared, &alone)?;
    let most = |slots: &[FittedSlot]| slots.iter().map(|slot| slot.planes).max();
    let planes = most(&needed).max(of_members);
    let of_members = most(&members).max(of_members);
    add_products(&mut machine.products.0, prepared);
    let members = machine.slots_of_products();
    let is_plain = layers.is_empty() && needed_layers.is_empty();
    let are_quadrics = needed.iter().all(|slot| slot.kind == Kind::Quadric);
    if machine.slots.is_none() && is_plain && are_quadrics {
        let fewest = usize::from(!needed.is_empty());
        machine.objects = alone.len().max(fewest) + members;
        return Ok(planes.map(|planes| planes as usize));
    }
    for needed in needed {
        if alone.iter().any(|slot| slot.holds(&needed)) {
            continue;
        }
        let own = alone.iter_mut().filter(|slot| slot.kind == needed.kind);
        match own.max_by_key(|slot| slot.planes) {
            Some(slot) => *slot = slot.or(&needed),
            None => alone.push(needed.in_all_bits()),
        }
    }
    // Any of these may be given any member.
    alone.extend(vec![FittedSlot::quadric(of_members.unwrap_or(0)); members]);
    if alone.is_empty() {
        alone.push(FittedSlot::NONE);
    }
    add_each(&mut layers, &needed_layers);
    machine.layers = layers.len();
    alone.extend(layers);
    machine.objects = alone.len();
    machine.planes = most(&alone).unwrap_or(0) as usize;
    if alone != machine.slots() {
        machine.slots = Some(Slots(alone));
    }
    Ok(None)
}

/// Adds to products one that is large enough for each of a scene.
fn add_products(products: &mut Vec<ProductSlots>, prepared: &PreparedScene) {
    for product in &prepared.solids.products {
        if products.iter().any(|slots| slots.hold(product.size())) {
            continue;
        }
        if products.is_empty() {
            products.push(NO_SLOTS);
        }
        if let Some(last) = products.last_mut() {
            let [intersected, subtracted] = product.size();
            last.intersected = last.intersected.max(intersected);
            last.subtracted = last.subtracted.max(subtracted);
        }
    }
}

/// Gives the slots of a beam machine what they lack for a scene; the planes or sides of each part.
fn add_slots(machine: &mut MachineDescription, prepared: &PreparedScene) -> Result<Vec<usize>> {
    let needed = of_slots(prepared, &prepared.slots_alone(), &machine.slots())?;
    let is_plain = machine.products.0.is_empty() && machine.layers == 0;
    let is_plain = is_plain && prepared.solids.products.is_empty() && prepared.layers.is_empty();
    let are_quadrics = needed.iter().all(|slot| slot.kind == Kind::Quadric);
    if machine.slots.is_none() && is_plain && are_quadrics {
        return Ok(needed.iter().map(|slot| slot.planes as usize).collect());
    }
    let mut slots = machine.slots();
    let mut layers = slots.split_off(slots.len() - machine.layers);
    let mut members = slots.split_off(machine.slots_alone());
    add_each(&mut slots, &needed);
    enlarge(&mut machine.products.0, &mut members, prepared);
    let needed = of_slots(prepared, &prepared.layers, &layers)?;
    add_each(&mut layers, &needed);
    if slots.len() + members.len() == 0 {
        slots.push(FittedSlot::NONE);
    }
    machine.layers = layers.len();
    slots.extend(members.into_iter().chain(layers));
    let planes = slots.iter().map(|slot| slot.planes as usize).collect();
    if slots != machine.slots() {
        machine.slots = Some(Slots(slots));
    }
    Ok(planes)
}

/// What parts have to have in slots of their own, beside those that are given.
fn of_slots(
    prepared: &PreparedScene,
    parts: &[Slot],
    slots: &[FittedSlot],
) -> Result<Vec<FittedSlot>> {
    let parts = beam_slots(prepared, parts, slots)?;
    Ok(parts.iter().map(|part| part.needed).collect())
}

fn add_each(slots: &mut Vec<FittedSlot>, needed: &[FittedSlot]) {
    slots.resize(slots.len().max(needed.len()), FittedSlot::NONE);
    for (slot, needed) in slots.iter_mut().zip(needed) {
        *slot = slot.or(needed);
    }
}

/// Gives the products of a beam machine, and their slots, what they lack for a scene.
fn enlarge(
    products: &mut Vec<ProductSlots>,
    slots: &mut Vec<FittedSlot>,
    prepared: &PreparedScene,
) {
    let needed = prepared.solids.products.iter().map(Product::size);
    let needed: Vec<[usize; 2]> = needed.collect();
    let mut given = std::mem::take(slots).into_iter();
    products.resize(products.len().max(needed.len()), NO_SLOTS);
    for (place, product) in products.iter_mut().enumerate() {
        let needed = needed.get(place).copied().unwrap_or_default();
        let sizes = [&mut product.intersected, &mut product.subtracted];
        for (size, needed) in sizes.into_iter().zip(needed) {
            slots.extend(given.by_ref().take(*size));
            slots.extend(vec![FittedSlot::NONE; needed.saturating_sub(*size)]);
            *size = needed.max(*size);
        }
    }
    for (place, part) in members(prepared, products) {
        slots[place] = slots[place].or(&part.needed);
    }
}

/// Gives a beam machine room for the words of a scene, in its loader and in the vertical blanking in which they are
/// copied.
fn make_room(machine: &mut MachineDescription, (framed, prepared): Scene) -> Result<()> {
    let words = frame_words(framed, prepared, machine, &machine.fields()[0])?.len();
    if machine.loader_words() < words {
        machine.loader_words = Some(words);
    }
    let mode = machine.video_mode();
    let Some(mode) = mode.filter(|_| machine.output == Output::Pins) else {
        return Ok(());
    };
    let (line, frame) = (mode.line, mode.frame);
    let clocks = line.active + line.front + line.sync + line.back;
    let blank = frame.front + frame.sync + frame.back;
    // What the pipeline and a smoothing filter look ahead is less than two lines and a few hundred clocks.
    let needed = (words as u64 + 300).div_ceil(clocks) + 2;
    if needed > blank {
        let back = frame.back + needed - blank;
        machine.mode = Mode::Own(OwnMode {
            columns: [line.active, line.front, line.sync, line.back],
            lines: [frame.active, frame.front, frame.sync, back],
            hsync_high: mode.hsync_high,
            vsync_high: mode.vsync_high,
        });
    }
    Ok(())
}

/// No beam machine is large enough: the zone machine of its processors, which share objects and products.
fn share_processors(enough: &mut MachineDescription, beam: &MachineDescription) {
    *enough = MachineDescription {
        machine: MachineKind::Zone,
        objects: beam.objects,
        volumes: beam.volumes.max(enough.volumes.min(1)),
        zone: Some(ZONE),
        loader_words: None,
        slots: None,
        products: beam.products.clone(),
        layers: 0,
        pixels_per_clock: 1,
        modules: 1,
        interlaced: false,
        mode: beam.mode.clone(),
        ..enough.clone()
    };
}

/// The lines in which two descriptions differ, each with what it was.
fn lines(machine: &MachineDescription, enough: &MachineDescription) -> String {
    let [was, is] = [machine, enough].map(|description| {
        toml::Table::try_from(description).expect("a description is a table of plain values")
    });
    let changed = is
        .iter()
        .filter(|(key, value)| was.get(*key) != Some(value));
    let line = |(key, value): (&String, &toml::Value)| match was.get(key) {
        Some(was) => format!("{key} = {value} # was {was}"),
        None => format!("{key} = {value}"),
    };
    let left_out = was.keys().filter(|key| !is.contains_key(*key));
    let left_out = left_out.map(|key| format!("# and no {key}"));
    let lines: Vec<String> = changed.map(line).chain(left_out).collect();
    lines.join("\n")
}
