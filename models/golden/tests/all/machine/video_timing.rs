use imogene_contract::video::VideoMode;
use imogene_golden::machine::video_timing::{Shown, Timing, VideoTiming};

/// Every clock of a frame.
fn frame(mode: VideoMode) -> Vec<Timing> {
    let mut timing = VideoTiming::new(mode, 0);
    (0..mode.clocks()).map(|_| timing.clock(true)).collect()
}

#[test]
fn every_pixel_once_and_the_published_sync_widths() {
    let [small, vga, hd, full_hd] = VideoMode::ALL;
    for (mode, pixels, hsync, vsync) in [
        (small, 160 * 120, 3 * 122, 168),
        (vga, 640 * 480, 96 * 525, 2 * 800),
        (hd, 1280 * 720, 40 * 750, 5 * 1650),
        (full_hd, 1920 * 1080, 44 * 1125, 5 * 2200),
    ] {
        let frame = frame(mode);
        let count = |holds: fn(&VideoMode, &Timing) -> bool| {
            frame.iter().filter(|clock| holds(&mode, clock)).count()
        };
        assert_eq!(count(|_, at| at.now.active), pixels);
        assert_eq!(count(|mode, at| at.hsync == mode.hsync_high), hsync);
        assert_eq!(count(|mode, at| at.vsync == mode.vsync_high), vsync);
    }
}

#[test]
fn a_frame_begins_after_its_last_pixel() {
    for mode in VideoMode::ALL {
        let frame = frame(mode);
        let last = Shown {
            active: true,
            x: mode.line.active as u16 - 1,
            y: mode.frame.active as u16 - 1,
            ..Shown::default()
        };
        assert_eq!(frame[frame.len() - 1].now, last);
        assert_eq!(frame[0].now, Shown::default());
    }
}

#[test]
fn a_delayed_request_is_the_picture() {
    let mut timing = VideoTiming::new(VideoMode::SMALL, 21);
    let shown: Vec<_> = (0..30_000).map(|_| timing.clock(true)).collect();
    for (later, now) in shown.iter().skip(21).zip(&shown) {
        assert_eq!(later.now, now.ahead);
    }
}
