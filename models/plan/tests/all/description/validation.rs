use imogene_contract::slots::print;
use imogene_golden::format::Format;
use imogene_plan::description::MachineDescription;

const BEAM: &str = "machine = \"beam\"\nobjects = 10\nplanes = 3\nmode = \"640x480\"\n";

fn refusal(text: &str) -> String {
    MachineDescription::parse(text, "m.toml")
        .unwrap_err()
        .to_string()
}

#[test]
fn a_description_needs_little() {
    let beam = MachineDescription::parse(BEAM, "m.toml").unwrap();
    assert_eq!(
        (beam.depth_word, beam.rows_per_stage, beam.lights),
        (24, 1, 1)
    );
    assert_eq!(beam.format(), Ok(Format::BASE));
    assert_eq!(beam.loader_words(), 1024);
    assert_eq!(beam.video_mode().unwrap().clocks(), 800 * 525);
    let own = BEAM.replace(
        "\"640x480\"",
        "{ columns = [160, 4, 4, 4], lines = [120, 2, 2, 12] }",
    );
    let own = MachineDescription::parse(&own, "m.toml").unwrap();
    assert_eq!(own.video_mode().unwrap().clocks(), 172 * 136);
}

#[test]
fn what_is_refused_names_the_key_and_what_is_accepted() {
    let refused = |old: &str, new: &str| refusal(&BEAM.replace(old, new));
    assert!(refused("10", "0").contains("objects is 0; accepted: 1 to 256"));
    let dark = format!("{BEAM}lights = 0\n");
    assert!(MachineDescription::parse(&dark, "m.toml").is_ok());
    let zone = "\"zone\"\nzone = { width = 8, height = 8 }";
    let zone = dark.replace("\"beam\"", zone);
    assert!(MachineDescription::parse(&zone, "m.toml").is_ok());
    assert!(refusal(&format!("{BEAM}lights = 17\n")).contains("lights is 17; accepted: 0 to 16"));
    assert!(refusal(&format!("{BEAM}suns = 2\n")).contains("suns is 2; accepted: 0 to 1"));
    assert!(refused("640x480", "640x481").contains("\"1280x720\""));
    assert!(refused("beam", "zone").contains("zone is missing"));
    assert!(refused("planes", "plans").starts_with("m.toml:3:1: unknown field `plans`"));
    assert!(
        refusal(&format!("{BEAM}output = \"stream\"\noverlay = true\n"))
            .contains("output is stream")
    );
    assert!(refused("= 3", "= 13").contains("0 to 12"));
    for word in [7, 33, 40] {
        let text = refusal(&format!("{BEAM}depth_word = {word}\n"));
        let accepted = format!("depth word of {word} bits: accepted are 8 to 32");
        assert!(text.contains(&accepted), "{text}");
    }
    let widths = |list: &str| refusal(&format!("{BEAM}widths = {{ {list} }}\n"));
    assert!(widths("g1 = 17").contains("at most 16 each are accepted"));
    assert!(widths("root = 30").contains("root of 30 bits: accepted are 4 to 24"));
    assert!(widths("g3 = 1").contains("unknown field `g3`"));
    let slotted = BEAM.replace("objects = 10\nplanes = 3", "slots = \"3,0v,2\"");
    let beam = MachineDescription::parse(&slotted, "m.toml").unwrap();
    assert_eq!((beam.objects, beam.planes), (3, 3));
    assert_eq!(print(&beam.slots()), "3,0,2");
    assert!(refusal(&slotted.replace("0v", "13")).contains("'13' is no slot"));
    let own = |slot: &str| refusal(&slotted.replace("0v", slot));
    assert!(own("0v:r25").contains("slots is 0:r25; accepted: root of a slot of 4 to 24 bits"));
    assert!(own("0v:p20").contains("plane word of a slot of 24 to 36 bits"));
    assert!(own("sphere:r9").contains("slots is sphere:r9; accepted: no bits of its own"));
    assert!(refusal(&format!("{slotted}objects = 4\n")).contains("accepted: 3, as slots has"));
    let shared = slotted.replace("beam", "zone") + "zone = { width = 8, height = 8 }\n";
    let other = MachineDescription::parse(&shared.replace("0v", "facet4"), "m.toml").unwrap();
    assert_eq!(print(&other.zone_machine().slots), "3,facet4,2");
    let own = shared.replace("0v", "0:r20");
    let short = MachineDescription::parse(&own, "m.toml").unwrap();
    assert_eq!(print(&short.zone_machine().slots), "3,0:r20,2");
    assert!(refusal(&format!("{own}products = \"1-1\"\n")).contains(
        "slots is 0:r20; accepted: no bits of its own in a slot of a product of a zone machine"
    ));
    let rows = "widths = { root = 16, dropped = 4 }\nrows_per_stage = 13\n";
    assert!(refusal(&format!("{BEAM}{rows}")).contains("accepted: 1 to 12"));
    let text = format!("{BEAM}depth_word = 30\nwidths = {{ g2 = 5 }}\n");
    assert!(refusal(&text).contains("a depth word of 30 bits accepts at most 4"));
    assert!(
        refusal(&format!("{BEAM}zone = {{ width = 8, height = 8 }}\n"))
            .contains("zone machine alone")
    );
    assert!(refusal(&format!("{BEAM}loader_words = 1\n")).contains("2 to 65536"));
    assert!(refusal(&format!("{BEAM}supersampling = 2\n")).contains("1 in a beam machine"));
    let zone = BEAM.replace("beam", "zone") + "zone = { width = 8, height = 8 }\n";
    assert!(refusal(&format!("{zone}supersampling = 3\n")).contains("1, 2 or 4"));
    // Products are the last of the ten object processors, and may be all of them.
    let one = zone.replace("objects = 10", "objects = 2");
    assert!(refusal(&format!("{one}layers = 2\n")).contains("fewer than the 2 slots"));
    let products = |list: &str| format!("{zone}products = \"{list}\"\n");
    assert!(refusal(&products("8-1,2-0")).contains("products of 10 slots in all"));
    let solids = MachineDescription::parse(&products("2-4,1-2"), "m.toml").unwrap();
    assert_eq!(
        (solids.slots_alone(), solids.zone_machine().slots.len()),
        (1, 10)
    );
    assert!(MachineDescription::parse(&products("8-1,1-0"), "m.toml").is_ok());
    let wide = zone.replace("640x480", "1280x720");
    assert!(refusal(&format!("{wide}supersampling = 4\n")).contains("up to 1024 x 1024"));
}
