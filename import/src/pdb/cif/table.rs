//! A category as rows of texts.

/// A value and where it begins in its file; nothing where the file has `?` or `.`.
pub type Cell<'a> = (&'a [u8], usize);

/// Items, and a row of values for each entry of the category.
#[derive(Debug, Default)]
pub struct Table {
    items: Vec<String>,
    values: Vec<(String, usize)>,
}

#[derive(Clone, Copy)]
pub struct Row<'a> {
    table: &'a Table,
    values: &'a [(String, usize)],
}

impl Table {
    pub fn new(items: Vec<String>) -> Table {
        Table {
            items,
            values: vec![],
        }
    }

    pub fn push_row<'a>(&mut self, row: impl IntoIterator<Item = Cell<'a>>) {
        let text = |(bytes, at)| (String::from_utf8_lossy(bytes).into_owned(), at);
        self.values.extend(row.into_iter().map(text));
    }

    /// Adds an item to a table of one row.
    pub fn push_item(&mut self, item: String, value: Cell) {
        self.items.push(item);
        self.push_row([value]);
    }

    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        let rows = self.values.chunks_exact(self.items.len().max(1));
        rows.map(|values| Row {
            table: self,
            values,
        })
    }
}

impl<'a> Row<'a> {
    /// A value and where it begins; nothing if the table has no such item.
    pub fn value(&self, item: &str) -> (&'a str, usize) {
        let column = self.table.items.iter().position(|name| name == item);
        column.map_or(("", 0), |k| (self.values[k].0.as_str(), self.values[k].1))
    }

    pub fn text(&self, item: &str) -> &'a str {
        self.value(item).0
    }

    /// The text of the first item that has one.
    pub fn first_of(&self, items: [&str; 2]) -> &'a str {
        let [first, second] = items.map(|item| self.text(item));
        if first.is_empty() { second } else { first }
    }
}
