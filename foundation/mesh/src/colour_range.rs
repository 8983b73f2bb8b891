//! Which range the colours of a file have: 0 to 1, or 0 to 255.

/// What has been seen of the numbers of colours in a file. `P` is a place in it.
///
/// They are from 0 to 1. Where one is above 1 and all are whole numbers up to 255, the program that
/// wrote the file has meant bytes. Everything else is an error.
#[derive(Debug)]
pub(crate) struct ColourRange<P> {
    /// The first number that is not between 0 and 1.
    outside: Option<(P, f64)>,
    /// At how many places there is one.
    places: usize,
    /// The first number that is not a byte.
    no_byte: Option<(P, f64)>,
}

/// A colour that a file may not have: where it is, and the number.
#[derive(Debug, PartialEq)]
pub(crate) struct ColourOutOfRange<P> {
    pub(crate) place: P,
    pub(crate) value: f64,
}

/// Colours that are bytes: where the first of them is beyond 1, the number there, and at how many
/// places they are.
#[derive(Debug, PartialEq)]
pub(crate) struct ByteColours<P> {
    pub(crate) place: P,
    pub(crate) value: f64,
    pub(crate) places: usize,
}

/// The rounding of numbers with six digits.
const ROUNDING: f64 = 1e-5;

/// Stands for the brightest in any range.
pub(crate) const BRIGHTEST: f64 = f64::INFINITY;

/// The greatest byte.
const BYTE: f64 = 255.0;

impl<P> Default for ColourRange<P> {
    fn default() -> Self {
        Self {
            outside: None,
            places: 0,
            no_byte: None,
        }
    }
}

impl<P: Clone> ColourRange<P> {
    /// Looks at numbers of colours at a place.
    pub(crate) fn see(&mut self, numbers: &[f64], place: &P) {
        self.places += usize::from(!numbers.iter().all(|&number| is_part(number)));
        for &number in numbers {
            let seen = || Some((place.clone(), number));
            if !is_part(number) && self.outside.is_none() {
                self.outside = seen();
            }
            if !is_byte(number) && self.no_byte.is_none() {
                self.no_byte = seen();
            }
        }
    }

    /// The bytes; `None` where the brightest is 1.
    pub(crate) fn bytes(self) -> Result<Option<ByteColours<P>>, ColourOutOfRange<P>> {
        match (self.outside, self.no_byte) {
            (None, _) => Ok(None),
            (Some((place, value)), None) => Ok(Some(ByteColours {
                place,
                value,
                places: self.places,
            })),
            (Some(outside), Some(no_byte)) => {
                let (place, value) = if is_part(no_byte.1) { outside } else { no_byte };
                Err(ColourOutOfRange { place, value })
            }
        }
    }
}

/// The part of the brightest that a number stands for.
pub(crate) fn part(number: f64, is_byte: bool) -> f64 {
    let full_scale = if is_byte { BYTE } else { 1.0 };
    (number / full_scale).clamp(0.0, 1.0)
}

fn is_part(number: f64) -> bool {
    (-ROUNDING..=1.0 + ROUNDING).contains(&number)
}

fn is_byte(number: f64) -> bool {
    number.fract() == 0.0 && (0.0..=BYTE).contains(&number)
}
