//! The names that variables, type parameters and items of blocks have inside a function, where they
//! hide those of the module.

#[derive(Default)]
pub(crate) struct Scope {
    names: Vec<String>,
}

impl Scope {
    /// What [`Scope::close`] takes to forget the names that are added from here on.
    pub(crate) fn open(&self) -> usize {
        self.names.len()
    }

    pub(crate) fn close(&mut self, opened: usize) {
        self.names.truncate(opened);
    }

    pub(crate) fn add(&mut self, name: impl ToString) {
        self.names.push(name.to_string());
    }

    pub(crate) fn has(&self, name: &str) -> bool {
        self.names.iter().any(|known| known == name)
    }
}
