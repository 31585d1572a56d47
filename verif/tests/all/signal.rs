use imogene_verif::signal::{Delay, Signal};

#[test]
fn values_and_wires_agree() {
    let s = Signal::new("zf", 24, true);
    assert_eq!(s.bits(-1), 0xff_ffff);
    assert_eq!(s.value(0x80_0000), -8_388_608);
    assert_eq!(Signal::new("id", 8, false).value(0xff), 255);
}

#[test]
fn a_delay_of_two() {
    let mut delay = Delay::new(2);
    let late = [1, 2, 3, 4].map(|v| delay.push(v));
    assert_eq!(late, [None, None, Some(1), Some(2)]);
    assert_eq!(Delay::new(0).push(7), Some(7));
}
