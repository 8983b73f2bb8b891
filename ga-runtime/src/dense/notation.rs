//! Multivectors as text.

use alloc::format;
use alloc::string::String;
use core::fmt;

use super::Multivector;
use crate::scalar::Ring;

/// The sum of blades that are not zero, in the order of their bitmasks: `1 + 2 e1 - 3 e12`. A
/// precision, as in `{:.3}`, applies to each coefficient.
impl<S: Ring + fmt::Display> fmt::Display for Multivector<S> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let precision = formatter.precision();
        write_sum(self, formatter, |value| match precision {
            Some(digits) => format!("{value:.digits$}"),
            None => format!("{value}"),
        })
    }
}

/// The same notation as [`Display`](fmt::Display), with the coefficients in their own
/// [`Debug`](fmt::Debug) form.
impl<S: Ring> fmt::Debug for Multivector<S> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_sum(self, formatter, |value| format!("{value:?}"))
    }
}

fn write_sum<S: Ring>(
    multivector: &Multivector<S>,
    formatter: &mut fmt::Formatter<'_>,
    text_of: impl Fn(S) -> String,
) -> fmt::Result {
    let mut empty = true;
    for (blade, value) in multivector.terms() {
        let text = text_of(value);
        let (negative, magnitude) = match text.strip_prefix('-') {
            Some(magnitude) => (true, magnitude),
            None => (false, text.as_str()),
        };
        formatter.write_str(match (empty, negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        })?;
        empty = false;
        let unit = value == S::one() || -value == S::one();
        match (blade, unit) {
            (0, _) => formatter.write_str(magnitude)?,
            (_, true) => formatter.write_str(&multivector.algebra().blade_name(blade))?,
            (_, false) => write!(
                formatter,
                "{magnitude} {}",
                multivector.algebra().blade_name(blade)
            )?,
        }
    }
    if empty {
        formatter.write_str("0")
    } else {
        Ok(())
    }
}
