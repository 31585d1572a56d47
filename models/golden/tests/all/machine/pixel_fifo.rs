use imogene_golden::machine::pixel_fifo::PixelFifo;

#[test]
fn a_word_is_seen_three_clocks_after_its_push() {
    let mut fifo = PixelFifo::new(8);
    fifo.clock(true, None, false);
    assert_eq!(fifo.clock(false, Some((7, true)), false).word, None);
    assert_eq!(fifo.clock(false, None, false).word, None);
    assert_eq!(fifo.clock(false, None, false).word, Some((7, true)));
    assert_eq!(fifo.clock(false, None, false).word, Some((7, true)));
    assert_eq!(fifo.clock(false, None, true).word, None);
}

#[test]
fn places_are_promised_until_words_are_taken() {
    let mut fifo = PixelFifo::new(2);
    assert!(fifo.clock(true, None, false).room);
    assert!(!fifo.clock(true, Some((1, false)), false).room);
    assert!(!fifo.clock(false, Some((2, false)), false).room);
    assert!(!fifo.clock(false, None, true).room);
    assert!(fifo.clock(false, None, true).room);
}
