//! What is known of a multivector beyond its blades.

use crate::algebra::Blade;

/// Facts of an operand or a result. `false` means that a fact is not known to hold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Facts {
    /// `M ~M = 1` in every grade, and M is a product of vectors.
    pub unit_versor: bool,
    /// `X² = 0`.
    pub null: bool,
    /// X is an outer product of vectors.
    pub blade: bool,
    /// The coefficient of that blade is 1.
    pub weight: Option<Blade>,
}

impl Facts {
    /// What is known of the product of two multivectors: unit versors form a group.
    #[must_use]
    pub fn of_product(self, right: Self) -> Self {
        Self {
            unit_versor: self.unit_versor && right.unit_versor,
            ..Self::default()
        }
    }

    /// What is known of the reverse: all that is known of the operand, since `~(ab) = ~b ~a`.
    #[must_use]
    pub fn of_reverse(self) -> Self {
        self
    }

    /// What is known of `M X ~M`: for a unit versor M the map is an automorphism, so every fact of
    /// X that does not refer to a basis stays true. A weight refers to a basis blade, and not every
    /// versor keeps it.
    #[must_use]
    pub fn of_sandwich(self, operand: Self) -> Self {
        if self.unit_versor {
            Self {
                weight: None,
                ..operand
            }
        } else {
            Self::default()
        }
    }

    /// What is known of a value that is one of two: what is known of both.
    #[must_use]
    pub fn common(self, other: Self) -> Self {
        Self {
            unit_versor: self.unit_versor && other.unit_versor,
            null: self.null && other.null,
            blade: self.blade && other.blade,
            weight: self.weight.filter(|_| self.weight == other.weight),
        }
    }

    /// What is known if both sets of facts hold.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            unit_versor: self.unit_versor || other.unit_versor,
            null: self.null || other.null,
            blade: self.blade || other.blade,
            weight: self.weight.or(other.weight),
        }
    }

    /// Whether everything in `other` is known here too.
    #[must_use]
    pub fn include(self, other: Self) -> bool {
        (self.unit_versor || !other.unit_versor)
            && (self.null || !other.null)
            && (self.blade || !other.blade)
            && (other.weight.is_none() || self.weight == other.weight)
    }

    /// Whether nothing is known.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self == Self::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_versors_form_a_group_that_keeps_facts() {
        let unit = Facts {
            unit_versor: true,
            ..Facts::default()
        };
        let null = Facts {
            null: true,
            ..Facts::default()
        };
        assert_eq!(unit.of_product(unit), unit);
        assert!(unit.of_product(null).is_empty());
        assert_eq!(unit.of_sandwich(null), null);
        assert!(null.of_sandwich(null).is_empty());
        let weighted = Facts {
            weight: Some(Blade(1)),
            ..null
        };
        assert_eq!(unit.of_sandwich(weighted), null);
        assert!(weighted.include(null) && !null.include(weighted));
    }
}
