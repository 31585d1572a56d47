use imogene_golden::object::quadric::ScreenBox;
use imogene_plan::culling::blocks::{BLOCK, everywhere};
use std::cell::RefCell;

#[test]
fn the_last_windows_cover_each_pixel_once() {
    for (columns, lines) in [(1, 1), (8, 8), (9, 3), (64, 64), (83, 61), (200, 2)] {
        let window = ScreenBox::of([5, 4 + columns], [7, 6 + lines]);
        let seen = RefCell::new(vec![0; (columns * lines) as usize]);
        let small = |w: &ScreenBox| {
            let small = w.x1 - w.x0 < BLOCK && w.y1 - w.y0 < BLOCK;
            for y in w.y0..=w.y1 {
                for x in w.x0..=w.x1 {
                    let at = ((y - 7) * columns + x - 5) as usize;
                    seen.borrow_mut()[at] += u32::from(small);
                }
            }
            small
        };
        assert!(everywhere(&window, &small));
        assert!(seen.borrow().iter().all(|&n| n == 1), "{columns} x {lines}");
        assert!(!everywhere(&window, &|_| false));
    }
    assert!(everywhere(&ScreenBox::EMPTY, &|_| false));
}
