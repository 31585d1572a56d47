//! The units in the built-in simulation, on vectors derived by hand.

use imogene_rtl::machine::decider::Decider;
use imogene_rtl::machine::raster_control::RasterControl;
use imogene_rtl::machine::visibility_node::VisibilityNode;
use imogene_rtl::simulator::{BeamInputs, BeamSimulator, QuadricWords, beam_simulator};
use imogene_rtl::step::step;
use imogene_rtl::unit::cut_plane::CutPlane;
use imogene_rtl::unit::depth_interval::DepthInterval;
use imogene_rtl::unit::pe1::Pe1;
use imogene_rtl::unit::pe2::Pe2;
use imogene_rtl::unit::square_root::SquareRoot;
use imogene_rtl::unit::two_volume_merge::TwoVolumeMerge;
use imogene_rtl::word::{Int, Word};
use rust_hdl::core::prelude::Block;

/// Raster flags `valid, start, line` of a zone.
fn zone(columns: usize, lines: usize) -> impl Iterator<Item = [bool; 3]> {
    (0..columns * lines).map(move |pixel| [true, pixel == 0, pixel > 0 && pixel % columns == 0])
}

fn pe1(coefficients: [i64; 3], columns: usize, lines: usize) -> Vec<i64> {
    let mut unit = Pe1::<24>::default();
    unit.connect_all();
    let mut values = Vec::new();
    for flags in zone(columns, lines) {
        // A clock without a pixel between any two changes nothing, whatever the other inputs say.
        for flags in [flags, [false, true, true]] {
            [unit.valid.next, unit.start.next, unit.line.next] = flags;
            // The coefficients count only with the first flags.
            let read = flags == [true, true, false];
            let words = if read { coefficients } else { [11, 22, 33] };
            [unit.a.next, unit.b.next, unit.c.next] = words.map(Int::new);
            step(&mut unit);
        }
        values.push(unit.value.val().get());
    }
    values
}

#[test]
fn pe1_is_linear_and_wraps() {
    assert_eq!(
        pe1([3, -5, 7], 5, 3),
        [7, 10, 13, 16, 19, 2, 5, 8, 11, 14, -3, 0, 3, 6, 9]
    );
    assert_eq!(
        pe1([8_388_607, -8_388_608, 1], 4, 2),
        [1, -8_388_608, -1, 8_388_606, -8_388_607, 0, 8_388_607, -2]
    );
}

fn pe2([a, b, c, d, e, f]: [i64; 6], columns: usize, lines: usize) -> Vec<i64> {
    let mut unit = Pe2::<48>::default();
    unit.connect_all();
    let mut values = Vec::new();
    for flags in zone(columns, lines) {
        [unit.valid.next, unit.start.next, unit.line.next] = flags;
        [unit.a2.next, unit.b2.next, unit.c.next] = [2 * a, 2 * b, c].map(Int::new);
        [unit.p0.next, unit.i0.next, unit.f.next] = [d + a, e + b, f].map(Int::new);
        step(&mut unit);
        values.push(unit.value.val().get());
        unit.valid.next = false;
        step(&mut unit);
    }
    values
}

#[test]
fn pe2_is_quadratic_and_wraps() {
    assert_eq!(
        pe2([2, 3, 1, -4, 5, 6], 5, 3),
        [6, 4, 6, 12, 22, 14, 13, 16, 23, 34, 28, 28, 32, 40, 52]
    );
    assert_eq!(
        pe2(
            [(1 << 47) - 1, -(1 << 47), 1 << 40, -(1 << 46), 1 << 46, -1],
            4,
            2
        ),
        [
            -1,
            70_368_744_177_662,
            140_737_488_355_323,
            -70_368_744_177_674,
            -70_368_744_177_665,
            1_099_511_627_774,
            72_567_767_433_211,
            -137_438_953_472_010
        ]
    );
}

#[test]
fn square_root_is_right_at_the_edges() {
    let edges = [
        (0, 0, 0),
        (1, 1, 0),
        (2, 1, 1),
        (3, 1, 2),
        (4, 2, 0),
        ((1 << 46) - 1, 8_388_607, 16_777_214),
        (1 << 46, 8_388_608, 0),
        ((1 << 47) - 1, 11_863_283, 4_817_238),
        ((1 << 48) - (1 << 25), 16_777_214, 33_554_428),
        ((1 << 48) - (1 << 25) + 1, 16_777_215, 0),
        ((1 << 48) - 1, 16_777_215, 33_554_430),
    ];
    for rows in [1, 3, 24] {
        let mut unit = SquareRoot::<48, 24, 25, 26>::new(rows);
        unit.connect_all();
        let latency = SquareRoot::<48, 24, 25, 26>::latency(rows);
        for clock in 0..edges.len() + latency - 1 {
            // One radicand each clock; the network is never given time.
            unit.radicand.next = Word::new(edges.get(clock).map_or(0, |edge| edge.0));
            step(&mut unit);
            if let Some(&(radicand, root, remainder)) =
                (clock + 1).checked_sub(latency).and_then(|i| edges.get(i))
            {
                let found = (unit.root.val().get(), unit.remainder.val().get());
                assert_eq!(
                    found,
                    (root, remainder),
                    "radicand {radicand}, {rows} rows per stage"
                );
            }
        }
    }
}

const FAR: i64 = 32_767;
const LOW: i64 = -32_767;
/// zf, nf, zb, nb.
type Half = (i64, u64, i64, u64);
const ABSENT: Half = (FAR, 0, FAR, 0);

fn interval(near: i64, far: i64, is_inside: bool, in_box: bool, class: u64) -> [Half; 2] {
    let mut unit = DepthInterval::<16, 18>::new();
    unit.connect_all();
    unit.near_sum.next = Int::new(near);
    unit.far_sum.next = Int::new(far);
    unit.is_inside.next = is_inside;
    unit.in_box.next = in_box;
    unit.object_class.next = Word::new(class);
    step(&mut unit);
    let half = |zf: Int<16>, nf: Word<4>, zb: Int<16>, nb: Word<4>| {
        (zf.get(), nf.get(), zb.get(), nb.get())
    };
    [
        half(
            unit.zf_a.val(),
            unit.nf_a.val(),
            unit.zb_a.val(),
            unit.nb_a.val(),
        ),
        half(
            unit.zf_b.val(),
            unit.nf_b.val(),
            unit.zb_b.val(),
            unit.nb_b.val(),
        ),
    ]
}

#[test]
fn depth_interval_follows_its_table() {
    let [side, front, patch, prism] = [0, 1, 2, 3];
    let a = |half| [half, ABSENT];
    let inside = |near, far, class| interval(near, far, true, true, class);
    assert_eq!(inside(-5, 9, side), a((-5, 0, 9, 1)));
    assert_eq!(inside(LOW, FAR + 9, side), a((LOW, 0, FAR, 1)));
    assert_eq!(inside(LOW - 1, LOW, side), a((LOW, 15, LOW, 1)));
    assert_eq!(inside(LOW - 9, LOW - 1, side), a(ABSENT));
    assert_eq!(inside(FAR - 1, FAR, side), a((FAR - 1, 0, FAR, 1)));
    assert_eq!(inside(FAR, FAR + 1, side), a(ABSENT));
    assert_eq!(inside(-131_072, 131_071, side), a((LOW, 15, FAR, 1)));
    assert_eq!(inside(-5, 9, front), [(LOW, 15, -5, 0), (9, 1, FAR, 15)]);
    assert_eq!(inside(LOW, FAR, front), [(LOW, 15, LOW, 0), ABSENT]);
    assert_eq!(
        inside(LOW - 1, FAR - 1, front),
        [ABSENT, (FAR - 1, 1, FAR, 15)]
    );
    assert_eq!(
        inside(LOW - 2, LOW - 1, front),
        [ABSENT, (LOW, 15, FAR, 15)]
    );
    assert_eq!(inside(FAR + 1, FAR + 2, front), [(LOW, 15, FAR, 0), ABSENT]);
    assert_eq!(inside(-5, 9, patch), a((-5, 0, 9, 1)));
    assert_eq!(inside(LOW - 1, 9, patch), a((9, 1, 9, 1)));
    assert_eq!(inside(-5, FAR, patch), a((-5, 0, -5, 0)));
    assert_eq!(inside(LOW - 1, FAR, patch), a(ABSENT));
    assert_eq!(inside(7, 8, prism), a((LOW, 15, FAR, 15)));
    let outside = |class| interval(-5, 9, false, true, class);
    assert_eq!(outside(side), a(ABSENT));
    assert_eq!(outside(front), a((LOW, 15, FAR, 15)));
    assert_eq!(outside(patch), a(ABSENT));
    assert_eq!(outside(prism), a(ABSENT));
    for class in 0..4 {
        assert_eq!(
            interval(-5, 9, true, false, class),
            [ABSENT; 2],
            "outside the box"
        );
        assert_eq!(
            interval(-5, 9, false, false, class),
            [ABSENT; 2],
            "outside the box"
        );
    }
}

fn cut(kind: u64, surface: bool, zp: i64, half: Half) -> Half {
    let mut unit = CutPlane::<16>::new();
    unit.connect_all();
    unit.kind.next = Word::new(kind);
    unit.surface.next = surface;
    unit.number.next = Word::new(5);
    unit.zp.next = Int::new(zp);
    unit.zf.next = Int::new(half.0);
    unit.nf.next = Word::new(half.1);
    unit.zb.next = Int::new(half.2);
    unit.nb.next = Word::new(half.3);
    step(&mut unit);
    (
        unit.cut_zf.val().get(),
        unit.cut_nf.val().get(),
        unit.cut_zb.val().get(),
        unit.cut_nb.val().get(),
    )
}

#[test]
fn cut_plane_follows_its_table() {
    let half = (-10, 0, 20, 1);
    let [none, front, back, perpendicular] = [0, 1, 2, 3];
    for (surface, front_cut, back_cut) in [
        (false, |zp| (zp, 5, 20, 1), |zp| (-10, 0, zp, 5)),
        (true, |_| (20, 1, 20, 1), |_| (-10, 0, -10, 0)),
    ] as [(bool, fn(i64) -> Half, fn(i64) -> Half); 2]
    {
        let cut = |kind, zp| cut(kind, surface, zp, half);
        for zp in [-32_768, -11, -10, 0, 20, 21, FAR] {
            assert_eq!(cut(none, zp), half);
            assert_eq!(cut(perpendicular, zp), if zp < 0 { ABSENT } else { half });
        }
        assert_eq!(cut(front, -32_768), half);
        assert_eq!(cut(front, -10), half, "a tie at the front changes nothing");
        assert_eq!(cut(front, -9), front_cut(-9));
        assert_eq!(
            cut(front, 20),
            front_cut(20),
            "a tie at the back keeps a sheet"
        );
        assert_eq!(cut(front, 21), ABSENT);
        assert_eq!(cut(back, FAR), half);
        assert_eq!(cut(back, 20), half, "a tie at the back changes nothing");
        assert_eq!(cut(back, 19), back_cut(19));
        assert_eq!(
            cut(back, -10),
            back_cut(-10),
            "a tie at the front keeps a sheet"
        );
        assert_eq!(cut(back, -11), ABSENT);
        assert_eq!(cut(back, -32_768), ABSENT);
    }
    for kind in 0..4 {
        for zp in [-32_768, 0, FAR] {
            assert_eq!(cut(kind, false, zp, ABSENT), ABSENT, "absent stays absent");
        }
    }
}

fn merged(a: Half, b: Half) -> Half {
    let mut unit = TwoVolumeMerge::<16>::default();
    unit.connect_all();
    (unit.zf_a.next, unit.zb_a.next) = (Int::new(a.0), Int::new(a.2));
    (unit.nf_a.next, unit.nb_a.next) = (Word::new(a.1), Word::new(a.3));
    (unit.zf_b.next, unit.zb_b.next) = (Int::new(b.0), Int::new(b.2));
    (unit.nf_b.next, unit.nb_b.next) = (Word::new(b.1), Word::new(b.3));
    step(&mut unit);
    (
        unit.zf.val().get(),
        unit.nf.val().get(),
        unit.zb.val().get(),
        unit.nb.val().get(),
    )
}

#[test]
fn merge_takes_the_front_half_and_a_at_a_tie() {
    let (a, b) = ((3, 0, 9, 1), (4, 2, 8, 3));
    assert_eq!(merged(a, b), a);
    assert_eq!(merged(b, a), a);
    let tie = (3, 4, 5, 6);
    assert_eq!(merged(a, tie), a);
    assert_eq!(merged(tie, a), tie);
    assert_eq!(merged(ABSENT, b), b);
    assert_eq!(
        merged((LOW, 15, 0, 0), (FAR - 1, 1, FAR, 15)),
        (LOW, 15, 0, 0)
    );
}

/// depth, id.
fn winner(a: (i64, u64), b: (i64, u64)) -> (i64, u64) {
    let mut unit = VisibilityNode::<16>::default();
    unit.connect_all();
    (unit.a_depth.next, unit.a_id.next) = (Int::new(a.0), Word::new(a.1));
    (unit.b_depth.next, unit.b_id.next) = (Int::new(b.0), Word::new(b.1));
    // The payload follows its owner.
    (unit.a_nx.next, unit.b_nx.next) = (Int::new(a.1 as i64), Int::new(b.1 as i64));
    (unit.a_number.next, unit.b_number.next) = (Word::new(a.1), Word::new(b.1));
    step(&mut unit);
    assert_eq!(unit.nx.val().get(), unit.id.val().get() as i64);
    assert_eq!(unit.number.val().get(), unit.id.val().get() % 16);
    (unit.depth.val().get(), unit.id.val().get())
}

#[test]
fn visibility_does_not_depend_on_the_order() {
    for (a, b, expected) in [
        ((5, 3), (6, 1), (5, 3)),
        ((5, 3), (5, 1), (5, 1)),
        ((-1, 200), (0, 7), (-1, 200)),
        ((FAR, 0), (FAR, 255), (FAR, 0)),
        ((LOW, 9), (FAR, 8), (LOW, 9)),
    ] {
        assert_eq!(winner(a, b), expected);
        assert_eq!(winner(b, a), expected);
    }
}

#[test]
fn decider_finds_the_nearest_of_any_number() {
    for inputs in [1, 2, 3, 5, 6, 7, 11] {
        let mut unit = Decider::<16>::new(inputs);
        unit.connect_all();
        for nearest in 0..inputs {
            for (input, depth) in unit.input_depth.iter_mut().enumerate() {
                depth.next = Int::new(if input == nearest {
                    -7
                } else {
                    100 - input as i64
                });
                unit.input_id[input].next = Word::new(input as u64);
                unit.input_nz[input].next = Int::new(-(input as i64));
            }
            for _ in 0..Decider::<16>::latency(inputs).max(1) {
                step(&mut unit);
            }
            let found = (
                unit.depth.val().get(),
                unit.id.val().get(),
                unit.nz.val().get(),
            );
            assert_eq!(
                found,
                (-7, nearest as u64, -(nearest as i64)),
                "{inputs} inputs"
            );
        }
    }
}

/// valid, start, line, x, y, last.
type Pixel = (bool, bool, bool, u64, u64, bool);

fn pixel(unit: &RasterControl) -> Pixel {
    (
        unit.valid.val(),
        unit.start.val(),
        unit.line.val(),
        unit.x.val().get(),
        unit.y.val().get(),
        unit.last.val(),
    )
}

#[test]
fn raster_scans_zones_without_a_bubble() {
    let mut unit = RasterControl::new();
    unit.connect_all();
    let mut clock = |go: bool, width: u64, height: u64| {
        unit.go.next = go;
        unit.width.next = Word::new(width);
        unit.height.next = Word::new(height);
        step(&mut unit);
        pixel(&unit)
    };
    assert!(!clock(false, 3, 2).0, "idle at power-up");
    assert_eq!(clock(true, 3, 2), (true, true, false, 0, 0, false));
    assert_eq!(
        clock(true, 9, 9),
        (true, false, false, 1, 0, false),
        "go is ignored in a zone"
    );
    assert_eq!(clock(false, 9, 9), (true, false, false, 2, 0, false));
    assert_eq!(
        clock(false, 9, 9),
        (true, false, true, 0, 1, false),
        "no bubble between lines"
    );
    assert_eq!(clock(false, 9, 9), (true, false, false, 1, 1, false));
    assert_eq!(clock(true, 9, 9), (true, false, false, 2, 1, true));
    assert_eq!(
        clock(true, 1, 2),
        (true, true, false, 0, 0, false),
        "no bubble between zones"
    );
    assert_eq!(clock(false, 0, 0), (true, false, true, 0, 1, true));
    assert_eq!(
        clock(true, 1, 1),
        (true, true, false, 0, 0, true),
        "one pixel is first and last"
    );
    assert_eq!(clock(true, 2, 1), (true, true, false, 0, 0, false));
    assert_eq!(clock(false, 0, 0), (true, false, false, 1, 0, true));
    assert_eq!(clock(false, 0, 0), (false, false, false, 1, 0, false));
    assert_eq!(clock(false, 0, 0), (false, false, false, 1, 0, false));
    assert_eq!(clock(true, 4095, 1), (true, true, false, 0, 0, false));
}

/// A bowl `f2 = value - x^2 - y^2` around the first pixel, at a constant depth.
fn bowl(depth: i64, value: i64) -> QuadricWords {
    QuadricWords {
        f1: [0, 0, depth],
        f2: [-2, -2, 0, -1, -1, value],
        g: [[0, 0, 256], [0, 0, 512], [0, 0, -768]],
        k: [64, 0, -64],
        box_x: (0, 6),
        box_y: (0, 4095),
        ..QuadricWords::default()
    }
}

#[test]
fn beam_draws_what_is_loaded() {
    let (width, height) = (9, 3);
    let mut beam = beam_simulator(16, 3, 1, 4).unwrap();
    let draw = |beam: &mut dyn BeamSimulator| {
        let mut image = Vec::new();
        for clock in 0..beam.latency() + width * height + 3 {
            let outputs = beam.clock(BeamInputs {
                go: clock == 0,
                width: 9,
                height: 3,
            });
            assert_eq!(
                outputs.valid,
                (beam.latency()..beam.latency() + width * height).contains(&(clock + 1))
            );
            if outputs.valid {
                image.push(outputs);
            }
        }
        image
    };
    assert!(
        draw(beam.as_mut()).iter().all(|pixel| pixel.depth == FAR),
        "a slot never loaded is absent"
    );
    for (object, words) in [(1, bowl(500, 50)), (2, bowl(400, 9))] {
        for (address, data) in words.load_words() {
            beam.load(object, address, data);
        }
    }
    let image = draw(beam.as_mut());
    let at = |x: usize, y: usize| (image[y * width + x].depth, image[y * width + x].id);
    // sqrt(9 - x^2 - y^2) and sqrt(50 - x^2 - y^2), rounded down.
    assert_eq!(
        [at(0, 0), at(1, 0), at(3, 0)],
        [(400 - 3, 2), (400 - 2, 2), (400, 2)]
    );
    assert_eq!(
        [at(4, 0), at(6, 0), at(7, 0)],
        [(500 - 5, 1), (500 - 3, 1), (FAR, 0)]
    );
    assert_eq!(
        [at(3, 1), at(2, 2), at(6, 2)],
        [(500 - 6, 1), (400 - 1, 2), (500 - 3, 1)]
    );
    let normal = image[0].normal;
    // -(64 * 3) >> 6 = -3 lowers 256 below one unit of the result; -(-64 * 3) >> 6 = 3 leaves -768 + 3 at -3.
    assert_eq!((normal, image[0].number), ([0, 2, -3], 0));
}
