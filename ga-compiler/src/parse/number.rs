//! Numbers, exact as they are written.

use syn::{Error, Lit, Result};

use crate::algebra::Ratio;

/// The fraction that a literal writes.
pub(super) fn number(literal: &Lit) -> Result<Ratio> {
    let (digits, suffix) = match literal {
        Lit::Int(number) => (
            number.base10_digits().to_owned(),
            number.suffix().to_owned(),
        ),
        Lit::Float(number) => (
            number.base10_digits().to_owned(),
            number.suffix().to_owned(),
        ),
        other => return Err(Error::new_spanned(other, "expected a number")),
    };
    if !suffix.is_empty() {
        let message = "a number takes the scalar type of the function; leave out the suffix";
        return Err(Error::new_spanned(literal, message));
    }
    decimal(&digits)
        .ok_or_else(|| Error::new_spanned(literal, "the number has too many digits for 64 bits"))
}

fn decimal(text: &str) -> Option<Ratio> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let fraction = fraction.trim_end_matches('0');
    let numerator: i64 = format!("{whole}{fraction}").parse().ok()?;
    let shift = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    let power = 10_i64.checked_pow(shift.unsigned_abs())?;
    if shift < 0 {
        return Ratio::new(i128::from(numerator), i128::from(power));
    }
    numerator
        .checked_mul(power)
        .map(|value| Ratio::integer(i128::from(value)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_exact() {
        let read = |text: &str| syn::parse_str(text).and_then(|literal| number(&literal));
        for (text, numerator, denominator) in [
            ("0.5", 1, 2),
            ("2", 2, 1),
            ("1.25e2", 125, 1),
            ("3e-1", 3, 10),
            ("10.0", 10, 1),
        ] {
            let expected = Ratio::new(numerator, denominator);
            assert_eq!(read(text).ok(), expected, "{text}");
        }
        assert!(read("1.0f32").is_err() && read("123456789012345678901").is_err());
    }
}
