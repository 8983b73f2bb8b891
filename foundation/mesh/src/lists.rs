//! Lists of indices in one block of memory.

/// Lists of indices, one after the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Lists {
    /// Where in `items` each list begins, and the end of the last.
    offsets: Vec<u32>,
    items: Vec<u32>,
}

/// More items than 32-bit offsets can number: how many there would be.
#[derive(Debug)]
pub(crate) struct TooMany(pub(crate) usize);

impl Lists {
    /// Lists with these offsets, which begin with 0, never fall and end with the number of items.
    pub(crate) fn new(offsets: Vec<u32>, items: Vec<u32>) -> Self {
        debug_assert!(offsets.first() == Some(&0) && offsets.is_sorted());
        debug_assert_eq!(offsets.last().map(|&end| end as usize), Some(items.len()));
        Self { offsets, items }
    }

    pub(crate) fn push(&mut self, list: &[u32]) -> Result<(), TooMany> {
        let count = self.items.len() + list.len();
        let end = u32::try_from(count).map_err(|_| TooMany(count))?;
        self.items.extend_from_slice(list);
        self.offsets.push(end);
        Ok(())
    }

    pub(crate) fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    pub(crate) fn get(&self, index: usize) -> Option<&[u32]> {
        let end = *self.offsets.get(index + 1)? as usize;
        Some(&self.items[self.offsets[index] as usize..end])
    }

    pub(crate) fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    pub(crate) fn items(&self) -> &[u32] {
        &self.items
    }
}

impl Default for Lists {
    /// No list.
    fn default() -> Self {
        Self {
            offsets: vec![0],
            items: Vec::new(),
        }
    }
}
