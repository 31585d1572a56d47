//! Records with places of their own.

/// Records that are taken and given back, and how many there were at most.
pub struct Store<T> {
    pub records: Vec<T>,
    pub free: Vec<usize>,
    pub most: usize,
}

impl<T> Default for Store<T> {
    fn default() -> Self {
        Store {
            records: vec![],
            free: vec![],
            most: 0,
        }
    }
}

impl<T> Store<T> {
    /// The place of a new record.
    pub fn take(&mut self, record: T) -> usize {
        let index = match self.free.pop() {
            Some(index) => {
                self.records[index] = record;
                index
            }
            None => {
                self.records.push(record);
                self.records.len() - 1
            }
        };
        self.most = self.most.max(self.records.len() - self.free.len());
        index
    }
}
