//! Tables of cases for tests.

/// The fields of each line of a table, parted by ` | `; `\n` in a field is the end of a line.
pub fn cases<const N: usize>(table: &str) -> Vec<[String; N]> {
    let field = |text: &str| text.replace("\\n", "\n");
    let case = |line: &str| -> [String; N] {
        let fields: Vec<String> = line.split(" | ").map(field).collect();
        fields.try_into().expect(line)
    };
    table.trim_matches('\n').lines().map(case).collect()
}
