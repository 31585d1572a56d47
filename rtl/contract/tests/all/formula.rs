use imogene_contract::formula::evaluate;

#[test]
fn formulas_are_read_as_they_are_printed() {
    let value = |symbol: &str| match symbol {
        "W" => 24,
        "R" => 5,
        "M" => 9,
        _ => 2,
    };
    for (text, expected) in [
        ("7", 7),
        ("ceil(W / R) + C + 7", 14),
        ("1 + 2 C", 5),
        ("W / 2", 12),
        ("1 - C", -1),
        ("ceil(log2 M)", 4),
        ("max(1, ceil(log8 M))", 2),
        ("max(1, ceil(log8 C))", 1),
        ("ceil(log2 C) + 1 + ceil(log2(C (C + 1)))", 5),
    ] {
        assert_eq!(evaluate(text, &value), expected, "{text}");
    }
}
