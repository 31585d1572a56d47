use step21::decoded;

#[test]
fn directives_are_letters() {
    assert_eq!(decoded(b"it''s"), "it's");
    assert_eq!(decoded(b"\\X2\\00E40041\\X0\\b"), "\u{e4}Ab");
    assert_eq!(decoded(b"\\X4\\0001F600\\X0\\"), "\u{1f600}");
    assert_eq!(decoded(b"\\X\\E4 \\S\\d \\\\"), "\u{e4} \u{e4} \\");
    assert_eq!(decoded(b"\\PB\\x"), "x");
}

#[test]
fn what_is_no_directive_stays() {
    for text in r"\ \X2\00 \X2\zz\X0\ \X\ \S\ \X2\D800\X0\".split(' ') {
        assert_eq!(decoded(text.as_bytes()), text);
    }
    assert_eq!(decoded(b"\xff\n"), "\u{fffd} ");
}
