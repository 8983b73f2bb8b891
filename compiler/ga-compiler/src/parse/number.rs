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
    decimal(&digits).ok_or_else(|| {
        let message = "the number is too large or too small: the limits are 1e36 and 1e-36";
        Error::new_spanned(literal, message)
    })
}

/// How many digits are read. Double precision has 17, so that what is left out does not matter.
const MOST_DIGITS: usize = 30;

/// The largest power of ten of a numerator or denominator.
const MOST_ZEROS: i32 = 37;

fn decimal(text: &str) -> Option<Ratio> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let fraction = fraction.trim_end_matches('0');
    let digits = format!("{whole}{fraction}");
    let mut digits = digits.trim_start_matches('0').to_owned();
    if digits.is_empty() {
        return Some(Ratio::ZERO);
    }
    let mut shift = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    // Digits are cut until both the digits and the power of ten have room.
    let too_long = digits.len().saturating_sub(MOST_DIGITS);
    let too_small = usize::try_from(shift.saturating_neg().saturating_sub(MOST_ZEROS)).unwrap_or(0);
    let cut = too_long.max(too_small);
    if cut > 0 {
        let kept = digits.len().checked_sub(cut).filter(|&kept| kept >= 17)?;
        let is_up = digits.as_bytes()[kept] >= b'5';
        digits.truncate(kept);
        shift = shift.checked_add(i32::try_from(cut).ok()?)?;
        let rounded = digits.parse::<i128>().ok()? + i128::from(is_up);
        digits = rounded.to_string();
    }
    let numerator: i128 = digits.parse().ok()?;
    let power = 10_i128.checked_pow(shift.unsigned_abs())?;
    let value = if shift < 0 {
        Ratio::new(numerator, power)?
    } else {
        Ratio::integer(numerator.checked_mul(power)?)
    };
    (!value.is_out_of_range()).then_some(value)
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
        assert!(read("1.0f32").is_err() && read("1e60").is_err() && read("1e-60").is_err());
        for text in [
            "1e-2147483648",
            "1.5e-2147483647",
            "1e2147483647",
            "1e-2147483649",
        ] {
            assert!(read(text).is_err(), "{text}");
        }
        let long = read("123456789012345678901").expect("a number");
        assert_eq!(long, Ratio::integer(123_456_789_012_345_678_901));
        // Digits that do not matter are rounded away.
        let pi = read("3.14159265358979323846264338327950288419716939937510").expect("pi");
        assert!((pi.to_f64() - std::f64::consts::PI).abs() < 1e-15);
        assert!(pi.height() < 10_i128.pow(31));
        assert!(read("0.00000000000000000001234567890123456789012345").is_ok());
    }
}
