//! Basis blades as lists of vectors, and their products with one vector.

use alloc::string::String;

/// The largest number of basis vectors.
pub(super) const MAXIMUM_DIMENSION: usize = 16;

/// The vectors of a blade in rising order.
pub(super) fn vectors(blade: usize) -> Vectors {
    Vectors { remaining: blade }
}

/// The number of vectors of a blade.
pub(super) fn grade(blade: usize) -> usize {
    vectors(blade).count()
}

/// `vector ∧ blade` as a sign and a blade, or `None` if it is zero.
pub(super) fn wedge(vector: usize, blade: usize) -> Option<(Sign, usize)> {
    let mut sign = Sign::Plus;
    for passed in vectors(blade) {
        if passed == vector {
            return None;
        }
        if passed > vector {
            break;
        }
        sign = sign.flipped();
    }
    Some((sign, blade | 1 << vector))
}

/// The terms of `vector ⌋ blade`: each vector of the blade, the sign of its removal and the
/// remaining blade.
pub(super) fn contraction(blade: usize) -> impl Iterator<Item = (usize, Sign, usize)> {
    let mut sign = Sign::Minus;
    vectors(blade).map(move |met| {
        sign = sign.flipped();
        (met, sign, blade ^ 1 << met)
    })
}

/// The sign of an odd or even number of swaps.
#[derive(Clone, Copy)]
pub(super) enum Sign {
    Plus,
    Minus,
}

impl Sign {
    pub(super) fn flipped(self) -> Self {
        match self {
            Self::Plus => Self::Minus,
            Self::Minus => Self::Plus,
        }
    }

    /// The sign of that many swaps.
    pub(super) fn of_swaps(swaps: usize) -> Self {
        if swaps.is_multiple_of(2) {
            Self::Plus
        } else {
            Self::Minus
        }
    }

    pub(super) fn times<S: core::ops::Neg<Output = S>>(self, value: S) -> S {
        match self {
            Self::Plus => value,
            Self::Minus => -value,
        }
    }
}

/// The iterator of [`vectors`].
pub(super) struct Vectors {
    remaining: usize,
}

impl Iterator for Vectors {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        if self.remaining == 0 {
            return None;
        }
        let vector = self.remaining.trailing_zeros() as usize;
        self.remaining ^= 1 << vector;
        Some(vector)
    }
}

/// The name of a blade from the names of the basis vectors: see
/// [`Algebra::blade_name`](super::Algebra::blade_name).
pub(crate) fn blade_name<N: AsRef<str>>(names: &[N], blade: usize) -> String {
    let mut members = vectors(blade).filter_map(|vector| names.get(vector));
    let Some(first) = members.next() else {
        return String::from("1");
    };
    let shared = shared_beginning(names);
    let is_long = |name: &N| name.as_ref()[shared..].chars().count() > 1;
    let separator = if names.iter().any(is_long) { "_" } else { "" };
    members.fold(String::from(first.as_ref()), |joined, name| {
        joined + separator + &name.as_ref()[shared..]
    })
}

/// The length in bytes of the common prefix of all names, leaving at least one character of each.
fn shared_beginning<N: AsRef<str>>(names: &[N]) -> usize {
    let Some(first) = names.first().map(N::as_ref) else {
        return 0;
    };
    first
        .char_indices()
        .map(|(position, _)| position)
        .take_while(|&position| {
            names.iter().map(N::as_ref).all(|name| {
                name.len() > position && name.as_bytes()[..position] == first.as_bytes()[..position]
            })
        })
        .last()
        .unwrap_or(0)
}
