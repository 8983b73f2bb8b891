//! Elements as sums of blades in text: written, and read again.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::{self, Display, Formatter};
use core::str::FromStr;

use super::{Element, NotMember, default_tolerance, member};
use crate::scalar::{Real, Ring};

/// Writes a sum of blades such as `1 + 2 e12 - 0.5 e1i`; blades with the coefficient zero are left
/// out. A precision, as in `{:.3}`, applies to each coefficient.
///
/// # Errors
/// Those of the formatter.
pub fn write<T: Element<Scalar: Display>>(element: T, f: &mut Formatter<'_>) -> fmt::Result {
    let mut is_first = true;
    for (name, coefficient) in element.coefficients() {
        let text = match f.precision() {
            Some(digits) => format!("{coefficient:.digits$}"),
            None => format!("{coefficient}"),
        };
        write_term(f, &mut is_first, name, &text)?;
    }
    if is_first { f.write_str("0") } else { Ok(()) }
}

fn write_term(f: &mut Formatter<'_>, is_first: &mut bool, name: &str, text: &str) -> fmt::Result {
    let (is_negative, size) = match text.strip_prefix('-') {
        Some(size) => (true, size),
        None => (false, text),
    };
    if size.bytes().all(|byte| byte == b'0' || byte == b'.') {
        return Ok(());
    }
    let sign = match (*is_first, is_negative) {
        (true, false) => "",
        (true, true) => "-",
        (false, false) => " + ",
        (false, true) => " - ",
    };
    *is_first = false;
    match (name, size) {
        (SCALAR, _) => write!(f, "{sign}{size}"),
        (_, "1") => write!(f, "{sign}{name}"),
        _ => write!(f, "{sign}{size} {name}"),
    }
}

/// The name of the blade of grade 0.
const SCALAR: &str = "scalar";

/// Why a text is not an element of a type: the error of `FromStr`.
///
/// Columns count characters from 1.
///
/// ```
/// use ga_runtime::cga3::Line;
/// let error = "e12i + 2 e45 - e1oi".parse::<Line<f64>>().unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "`e45` at column 10 is not a term of a Line, whose blades are e12i, e13i, e23i, e1oi, \
///      e2oi, e3oi"
/// );
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ParseElementError {
    /// The text is empty.
    Empty,
    /// A word is neither a number nor the name of a blade of the type.
    UnknownTerm {
        /// The word.
        term: String,
        /// Where it begins.
        column: usize,
        /// The name of the type.
        type_name: &'static str,
        /// The names of its blades.
        blades: &'static [&'static str],
    },
    /// There is no `+` or `-` between two terms.
    MissingSign {
        /// The second of them.
        term: String,
        /// Where it begins.
        column: usize,
    },
    /// There is no term behind a sign.
    MissingTerm {
        /// The column of the sign.
        column: usize,
    },
    /// A blade occurs twice.
    Repeated {
        /// The blade.
        term: String,
        /// Where its name occurs for the second time.
        column: usize,
    },
    /// The coefficients are not those of a member of the type.
    NotMember(NotMember),
}

impl Display for ParseElementError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("an empty text is not an element; zero is `0`"),
            Self::UnknownTerm {
                term,
                column,
                type_name,
                blades,
            } => write!(
                f,
                "`{term}` at column {column} is not a term of a {type_name}, whose blades are {}",
                blades.join(", ")
            ),
            Self::MissingSign { term, column } => {
                write!(
                    f,
                    "there is no ` + ` or ` - ` before `{term}` at column {column}"
                )
            }
            Self::MissingTerm { column } => {
                write!(f, "there is no term behind the sign at column {column}")
            }
            Self::Repeated { term, column } => {
                write!(f, "the blade `{term}` at column {column} occurs before")
            }
            Self::NotMember(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for ParseElementError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::NotMember(error) => Some(error),
            _ => None,
        }
    }
}

/// Reads what [`write`] writes: terms with ` + ` or ` - ` between them, each a number, the name of
/// a blade, or both.
///
/// # Errors
/// [`ParseElementError`].
pub fn parse<T>(text: &str) -> Result<T, ParseElementError>
where
    T: Element,
    T::Scalar: Real<Mask = bool> + FromStr,
{
    let terms = terms::<T>(text)?;
    let coefficient = |blade: usize| {
        let term = terms.iter().find(|(other, _)| *other == blade);
        term.map_or(T::Scalar::zero(), |(_, value)| *value)
    };
    let blades: Vec<_> = terms.iter().map(|(blade, _)| *blade).collect();
    member(&blades, &coefficient, default_tolerance()).map_err(ParseElementError::NotMember)
}

/// The blades of a text with their coefficients.
fn terms<T: Element<Scalar: FromStr>>(
    text: &str,
) -> Result<Vec<(usize, T::Scalar)>, ParseElementError> {
    let mut words = words(text).peekable();
    if words.peek().is_none() {
        return Err(ParseElementError::Empty);
    }
    let mut terms: Vec<(usize, T::Scalar)> = Vec::new();
    while let Some((mut word, mut column)) = words.next() {
        let start = column;
        let is_negative = word.starts_with('-');
        let is_sign = word == "+" || word == "-";
        if is_sign {
            (word, column) = words
                .next()
                .ok_or(ParseElementError::MissingTerm { column: start })?;
        } else if !terms.is_empty() {
            let term = word.to_string();
            return Err(ParseElementError::MissingSign { term, column });
        } else {
            word = word.strip_prefix('-').unwrap_or(word);
        }
        let (name, value) = match word.parse::<T::Scalar>() {
            _ if T::NAMES.contains(&word) => (word, T::Scalar::one()),
            Ok(number) => match words.peek() {
                Some(&(name, place)) if T::NAMES.contains(&name) => {
                    words.next();
                    column = place;
                    (name, number)
                }
                Some(&(other, place)) if is_word::<T::Scalar>(other) => {
                    return Err(unknown::<T>(other, place));
                }
                _ => (SCALAR, number),
            },
            Err(_) => return Err(unknown::<T>(word, column)),
        };
        let value = if is_negative { -value } else { value };
        let blade = match T::NAMES
            .iter()
            .zip(T::BLADES)
            .find(|(other, _)| **other == name)
        {
            Some((_, &blade)) => blade,
            None if value == T::Scalar::zero() => continue,
            None => return Err(unknown::<T>(word, column)),
        };
        if terms.iter().any(|(other, _)| *other == blade) {
            let term = name.to_string();
            return Err(ParseElementError::Repeated { term, column });
        }
        let is_reversed = T::REVERSED.contains(&blade);
        terms.push((blade, if is_reversed { -value } else { value }));
    }
    Ok(terms)
}

/// Whether a text is a name and not a number such as `inf`.
fn is_word<S: FromStr>(text: &str) -> bool {
    let is_name = text.starts_with(|first: char| first.is_alphabetic() || first == '_');
    is_name && text.parse::<S>().is_err()
}

fn unknown<T: Element>(word: &str, column: usize) -> ParseElementError {
    ParseElementError::UnknownTerm {
        term: word.to_string(),
        column,
        type_name: T::NAME,
        blades: T::NAMES,
    }
}

/// The words of a text with the columns where they begin.
fn words(text: &str) -> impl Iterator<Item = (&str, usize)> {
    let mut rest = text;
    core::iter::from_fn(move || {
        rest = rest.trim_start();
        let column = text[..text.len() - rest.len()].chars().count() + 1;
        let end = rest.find(char::is_whitespace).unwrap_or(rest.len());
        let (word, behind) = rest.split_at(end);
        rest = behind;
        (!word.is_empty()).then_some((word, column))
    })
}
