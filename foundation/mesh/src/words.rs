//! Words of a line, and the numbers they stand for.

/// What can be wrong with a word.
#[derive(Debug)]
pub(crate) enum WordError {
    /// It is not UTF-8, or holds a null byte.
    Encoding,
    /// It stands in the place of a number.
    Word(String),
    /// It is a number that is infinite, not a number, or too large.
    Infinite(String),
}

/// The words of a line up to a comment, which begins with a word that begins with `#`.
#[derive(Clone)]
pub(crate) struct Words<'a> {
    rest: &'a [u8],
}

impl<'a> Words<'a> {
    pub(crate) fn new(line: &'a [u8]) -> Self {
        Self { rest: line }
    }

    /// What follows the white space, or `None` at the end of the line or at a comment.
    pub(crate) fn rest(&mut self) -> Option<&'a [u8]> {
        while let [first, rest @ ..] = self.rest {
            if !first.is_ascii_whitespace() {
                return (*first != b'#').then_some(self.rest);
            }
            self.rest = rest;
        }
        None
    }

    /// Goes on `length` bytes further, if a word ends there.
    pub(crate) fn advance(&mut self, length: usize) -> bool {
        let ends = self
            .rest
            .get(length)
            .is_none_or(|byte| byte.is_ascii_whitespace());
        if ends {
            self.rest = &self.rest[length..];
        }
        ends
    }

    /// The words, with one space between two of them.
    pub(crate) fn joined(self) -> Result<String, WordError> {
        let words: Vec<&str> = self.map(text).collect::<Result<_, _>>()?;
        Ok(words.join(" "))
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest()?;
        let end = rest.iter().position(u8::is_ascii_whitespace);
        let (word, rest) = rest.split_at(end.unwrap_or(rest.len()));
        self.rest = rest;
        Some(word)
    }
}

/// A word as text.
pub(crate) fn text(word: &[u8]) -> Result<&str, WordError> {
    match std::str::from_utf8(word) {
        Ok(text) if !text.contains('\0') => Ok(text),
        _ => Err(WordError::Encoding),
    }
}

/// The numbers on the rest of a line: the first `N` of them, 0 where there are fewer, and how many
/// there are.
pub(crate) fn numbers<const N: usize>(
    words: &mut Words<'_>,
) -> Result<([f64; N], usize), WordError> {
    let mut values = [0.0; N];
    let mut count = 0;
    while let Some(value) = number(words)? {
        if let Some(slot) = values.get_mut(count) {
            *slot = value;
        }
        count += 1;
    }
    Ok((values, count))
}

/// The next word as a finite number, or `None` at the end of the line.
pub(crate) fn number(words: &mut Words<'_>) -> Result<Option<f64>, WordError> {
    let Some(rest) = words.rest() else {
        return Ok(None);
    };
    if let Some((value, length)) = short_decimal(rest)
        && words.advance(length)
    {
        return Ok(Some(value));
    }
    let word = words.next().map_or(Ok(""), text)?;
    let value: f64 = word.parse().map_err(|_| WordError::Word(word.to_owned()))?;
    if !value.is_finite() {
        return Err(WordError::Infinite(word.to_owned()));
    }
    Ok(Some(value))
}

/// The decimal number at the start of `bytes` and its length, where the digits without the point
/// form an integer below 2⁵³ and the power of ten is at most 10²². Both are then exact in `f64`, so
/// that one multiplication or division rounds correctly (Clinger, *How to Read Floating Point
/// Numbers Accurately*, 1990). `None` stands for any other text.
fn short_decimal(bytes: &[u8]) -> Option<(f64, usize)> {
    let negative = bytes.first() == Some(&b'-');
    let mut at = usize::from(negative);
    let mut digits = 0u64;
    let mut take_digits = |at: &mut usize| {
        let start = *at;
        while let Some(digit) = bytes.get(*at).map(|byte| byte.wrapping_sub(b'0'))
            && digit < 10
        {
            digits = digits.wrapping_mul(10).wrapping_add(u64::from(digit));
            *at += 1;
        }
        *at - start
    };
    let whole = take_digits(&mut at);
    let mut fraction = 0;
    if bytes.get(at) == Some(&b'.') {
        at += 1;
        fraction = take_digits(&mut at);
    }
    // Nineteen digits are below 2⁶⁴.
    if whole + fraction == 0 || whole + fraction > 19 || digits > 1 << 53 {
        return None;
    }
    let mut power = -(fraction as i32);
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let (exponent, length) = integer(&bytes[at + 1..])?;
        power = power.checked_add(i32::try_from(exponent).ok()?)?;
        at += 1 + length;
    }
    let scale = *POWERS_OF_TEN.get(power.unsigned_abs() as usize)?;
    let value = if power < 0 {
        digits as f64 / scale
    } else {
        digits as f64 * scale
    };
    Some((if negative { -value } else { value }, at))
}

const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// The integer of at most 18 digits at the start of `bytes` and its length.
pub(crate) fn integer(bytes: &[u8]) -> Option<(i64, usize)> {
    let negative = bytes.first() == Some(&b'-');
    let start = usize::from(negative);
    let mut at = start;
    let mut value = 0i64;
    while let Some(digit) = bytes.get(at).map(|byte| byte.wrapping_sub(b'0'))
        && digit < 10
    {
        if at - start == 18 {
            return None;
        }
        value = 10 * value + i64::from(digit);
        at += 1;
    }
    (at > start).then_some((if negative { -value } else { value }, at))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_end_at_white_space_and_at_comments() {
        let words: Vec<&[u8]> = Words::new(b" a\tbc#d  e #f g").collect();
        assert_eq!(words, [&b"a"[..], b"bc#d", b"e"]);
    }

    /// The standard library rounds correctly.
    #[test]
    fn numbers_are_those_of_the_standard_library() {
        let mut texts: Vec<String> = [
            "0",
            "-0",
            "1.",
            ".5",
            "-.25",
            "+3",
            "1e22",
            "1e23",
            "1e-22",
            "1.5E+3",
            "1e-400",
            "9007199254740992",
            "9007199254740993",
            "0.1234567890123456789",
            "00000000000000000000000000001",
            "123456789.123456789e-30",
            "1e5",
            "2.5e-3",
            "-1e+05",
        ]
        .map(str::to_owned)
        .to_vec();
        let mut state = 1u64;
        for _ in 0..20_000 {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            let value = (state >> 11) as f64 / (1u64 << (state & 63)) as f64;
            texts.push(format!("{:.*}", (state >> 60) as usize, value));
            texts.push(format!("{:.*e}", (state >> 61) as usize, value));
        }
        for text in texts {
            let expected: f64 = text.parse().unwrap();
            let value = number(&mut Words::new(text.as_bytes())).unwrap();
            assert_eq!(value.map(f64::to_bits), Some(expected.to_bits()), "{text}");
        }
        for text in ["-", ".", "e5", "1e", "1.2.3", "--1", "1-", "0x10", "1e5.5"] {
            assert!(number(&mut Words::new(text.as_bytes())).is_err(), "{text}");
        }
    }
}
