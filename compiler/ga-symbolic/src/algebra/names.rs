//! How blades are written: the names of the basis vectors joined after their common prefix.

use super::Blade;

/// The names of the basis vectors: `e1`, `e2`, `eo` make the blades `e12`, `e1o`, `e21`.
#[derive(Clone, Debug)]
pub struct BladeNames {
    prefix: String,
    suffixes: Vec<String>,
}

/// What a written blade name means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedBlade {
    /// The blade in rising order.
    pub blade: Blade,
    /// Whether the written order has the opposite sign, as in `e31 = −e13`.
    pub is_negative: bool,
}

/// Why a written name is not a blade.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NameError {
    /// Some part of the name is not a basis vector.
    Unknown,
    /// The name can be read in several ways.
    Ambiguous(Vec<String>),
    /// A basis vector occurs twice; the name is that of the vector.
    Repeated(String),
}

/// The name under which the scalar coefficient is written.
pub const SCALAR: &str = "scalar";

impl BladeNames {
    /// Finds the common prefix of the basis vectors' names.
    #[must_use]
    pub fn new(basis: &[String]) -> Self {
        let first = basis.first().map_or("", String::as_str);
        let mut length = first.len();
        for name in basis {
            let common = first
                .bytes()
                .zip(name.bytes())
                .take_while(|(a, b)| a == b)
                .count();
            // A vector needs a part of its own after the prefix.
            length = length.min(common).min(name.len().saturating_sub(1));
        }
        while !first.is_char_boundary(length) {
            length -= 1;
        }
        Self {
            prefix: first[..length].to_owned(),
            suffixes: basis.iter().map(|name| name[length..].to_owned()).collect(),
        }
    }

    /// The name of a blade in rising order.
    #[must_use]
    pub fn name(&self, blade: Blade) -> String {
        if blade == Blade::SCALAR {
            return SCALAR.to_owned();
        }
        let mut name = self.prefix.clone();
        for index in blade.vectors() {
            name.push_str(&self.suffixes[index]);
        }
        name
    }

    /// Reads a blade name.
    ///
    /// # Errors
    /// The name contains something other than basis vectors, contains one of them twice, or can be
    /// read in several ways.
    pub fn resolve(&self, name: &str) -> Result<NamedBlade, NameError> {
        if name == SCALAR {
            return Ok(NamedBlade {
                blade: Blade::SCALAR,
                is_negative: false,
            });
        }
        let Some(rest) = name.strip_prefix(&self.prefix) else {
            return Err(NameError::Unknown);
        };
        let mut readings = Vec::new();
        self.split(rest, &mut Vec::new(), &mut readings);
        match readings.as_slice() {
            [] => Err(NameError::Unknown),
            [vectors] => self.join(vectors),
            several => Err(NameError::Ambiguous(
                several
                    .iter()
                    .map(|vectors| {
                        let names: Vec<_> = vectors
                            .iter()
                            .map(|&index| format!("{}{}", self.prefix, self.suffixes[index]))
                            .collect();
                        names.join("^")
                    })
                    .collect(),
            )),
        }
    }

    fn split(&self, rest: &str, taken: &mut Vec<usize>, readings: &mut Vec<Vec<usize>>) {
        if rest.is_empty() {
            if !taken.is_empty() {
                readings.push(taken.clone());
            }
            return;
        }
        for (index, suffix) in self.suffixes.iter().enumerate() {
            if let Some(next) = rest.strip_prefix(suffix.as_str()) {
                taken.push(index);
                self.split(next, taken, readings);
                taken.pop();
            }
        }
    }

    fn join(&self, vectors: &[usize]) -> Result<NamedBlade, NameError> {
        let mut result = NamedBlade {
            blade: Blade::SCALAR,
            is_negative: false,
        };
        for &index in vectors {
            let vector = Blade::vector(index);
            if result.blade.contains(index) {
                return Err(NameError::Repeated(self.name(vector)));
            }
            result.is_negative ^= result.blade.wedge_is_negative(vector);
            result.blade = Blade(result.blade.0 | vector.0);
        }
        Ok(result)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(basis: &[&str]) -> BladeNames {
        BladeNames::new(&basis.iter().map(ToString::to_string).collect::<Vec<_>>())
    }

    #[test]
    fn names_join_after_the_prefix() {
        let cga = names(&["e1", "e2", "e3", "eo", "ei"]);
        assert_eq!(cga.name(Blade(0b11001)), "e1oi");
        let e31 = cga.resolve("e31").unwrap();
        assert_eq!((e31.blade, e31.is_negative), (Blade(0b101), true));
        assert_eq!(
            cga.resolve("e11"),
            Err(NameError::Repeated("e1".to_owned()))
        );
        assert_eq!(cga.resolve("e4"), Err(NameError::Unknown));
        assert_eq!(cga.resolve("e"), Err(NameError::Unknown));
    }

    #[test]
    fn names_without_a_prefix() {
        let axes = names(&["x", "y", "z"]);
        assert_eq!(axes.name(Blade(0b110)), "yz");
        assert!(axes.resolve("zx").unwrap().is_negative);
    }

    #[test]
    fn several_readings_are_refused() {
        let many = names(&["e1", "e2", "e12"]);
        assert!(matches!(many.resolve("e12"), Err(NameError::Ambiguous(_))));
    }
}
