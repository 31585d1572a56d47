use imogene_board::{Screen, ScreenError, Shown, Tick};
use imogene_contract::video::VideoMode;
use imogene_golden::machine::video_timing::VideoTiming;

const MODE: VideoMode = VideoMode::SMALL;

fn colour(x: u16, y: u16) -> [u8; 3] {
    [x as u8, y as u8, 7]
}

fn seen(ticks: &[Tick]) -> Result<Shown, ScreenError> {
    let mut screen = Screen::new(&MODE);
    ticks.iter().try_for_each(|tick| screen.see(tick))?;
    screen.shown()
}

/// The clocks of two frames and a bit, by the golden raster.
fn ticks() -> Vec<Tick> {
    let mut timing = VideoTiming::new(MODE, 0);
    let tick = |_| {
        let at = timing.clock(true);
        let shown = at.now.active.then(|| colour(at.now.x, at.now.y));
        Tick {
            hsync: at.hsync,
            vsync: at.vsync,
            de: Some(at.now.active),
            colour: shown.unwrap_or_default(),
        }
    };
    (0..2 * MODE.clocks() + 400).map(tick).collect()
}

#[test]
fn the_pictures_of_frames_are_found() {
    for has_de in [true, false] {
        let mut ticks = ticks();
        for tick in &mut ticks {
            tick.de = tick.de.filter(|_| has_de);
        }
        let shown = seen(&ticks).expect("frames");
        assert_eq!(shown.clocks as u64, MODE.clocks());
        let pixels = (0..120).flat_map(|y| (0..160).map(move |x| colour(x, y)));
        let picture: Vec<u8> = pixels.flatten().collect();
        assert!(!shown.pictures.is_empty());
        assert!(shown.pictures.iter().all(|shown| *shown == picture));
    }
}

#[test]
fn pins_against_the_mode_are_refused() {
    let sound = ticks();
    assert!(seen(&sound[..9_000]).is_err());
    for (what, change) in [
        ("hsync", (|tick| tick.hsync ^= true) as fn(&mut Tick)),
        // A frame that begins where none does.
        ("against the mode", |tick| tick.vsync ^= true),
        ("de", |tick| tick.de = tick.de.map(|de| !de)),
        ("blank", |tick| tick.colour = [1; 3]),
    ] {
        let mut broken = sound.clone();
        // The first clock of the second frame is blank, and is not the beginning of its synchronisation.
        let blank = MODE.clocks() as usize + 2 * MODE.line.total() as usize + 1;
        change(&mut broken[blank + 4]);
        let error = seen(&broken).expect_err(what).to_string();
        assert!(error.contains(what), "{error}");
    }
}
