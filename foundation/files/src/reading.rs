//! What deviates from a format: an error, or read nevertheless with a warning.

use std::borrow::Cow;
use std::fmt;

/// What becomes of a deviation from a format that other programs read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reading {
    /// It is read as most programs read it, with a warning.
    #[default]
    Tolerant,
    /// It is an error.
    Strict,
}

/// A problem of a file that a tolerant reader passes over.
pub trait Tolerated: fmt::Display {
    /// What it is, as one word for programs.
    fn kind(&self) -> &'static str;

    /// What the reader does about it, as the end of a sentence.
    fn remedy(&self) -> Cow<'_, str>;

    /// Whether both are told in one warning.
    fn is_like(&self, other: &Self) -> bool {
        self.kind() == other.kind()
    }
}

/// Lines that deviate from a format in the same way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Deviation<P> {
    /// The first of them, from 1.
    pub line: usize,
    /// How many there are.
    pub count: usize,
    /// What is wrong with the first.
    pub problem: P,
}

impl<P: Tolerated> fmt::Display for Deviation<P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            line,
            count,
            problem,
        } = self;
        write!(f, "line {line}: {problem}; {}", problem.remedy())?;
        match count {
            0 | 1 => Ok(()),
            _ => write!(f, " ({count} such lines)"),
        }
    }
}

/// How many deviations are told one by one where their kinds are the same.
const MOST: usize = 32;

/// The deviations of a file so far, each kind once.
///
/// # Examples
///
/// ```
/// use std::borrow::Cow;
/// use ga_files::{Deviations, Reading, Tolerated};
///
/// #[derive(Debug, thiserror::Error)]
/// #[error("{0:?} means nothing")]
/// struct Unknown(&'static str);
///
/// impl Tolerated for Unknown {
///     fn kind(&self) -> &'static str {
///         "unknown"
///     }
///     fn remedy(&self) -> Cow<'_, str> {
///         "it is left out".into()
///     }
/// }
///
/// let mut found = Deviations::new(Reading::Tolerant);
/// found.tolerate(3, Unknown("a"))?;
/// found.tolerate(7, Unknown("b"))?;
/// let warnings = found.into_list();
/// let message = "line 3: \"a\" means nothing; it is left out (2 such lines)";
/// assert_eq!(warnings[0].to_string(), message);
/// assert!(Deviations::new(Reading::Strict).tolerate(3, Unknown("a")).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Deviations<P> {
    reading: Reading,
    list: Vec<Deviation<P>>,
    /// The last line of each in `list`.
    last_lines: Vec<usize>,
}

impl<P> Default for Deviations<P> {
    fn default() -> Self {
        Self::new(Reading::default())
    }
}

impl<P> Deviations<P> {
    /// None yet.
    #[must_use]
    pub fn new(reading: Reading) -> Self {
        Self {
            reading,
            list: Vec::new(),
            last_lines: Vec::new(),
        }
    }

    /// How the file is read.
    #[must_use]
    pub fn reading(&self) -> Reading {
        self.reading
    }

    /// The deviations in the order in which their kinds were found.
    #[must_use]
    pub fn into_list(self) -> Vec<Deviation<P>> {
        self.list
    }
}

impl<P: Tolerated> Deviations<P> {
    /// Adds a problem of a line where the file is read tolerantly.
    ///
    /// # Errors
    ///
    /// The problem itself where the file is read strictly.
    pub fn tolerate(&mut self, line: usize, problem: P) -> Result<(), P> {
        self.tolerate_times(line, 1, problem)
    }

    /// As [`tolerate`](Self::tolerate), for a problem of several lines.
    ///
    /// # Errors
    ///
    /// As [`tolerate`](Self::tolerate).
    pub fn tolerate_times(&mut self, line: usize, count: usize, problem: P) -> Result<(), P> {
        match self.reading {
            Reading::Strict => Err(problem),
            Reading::Tolerant => {
                self.add(line, count, problem);
                Ok(())
            }
        }
    }

    /// Adds a problem of a line that is no error in either reading.
    pub fn note(&mut self, line: usize, problem: P) {
        self.add(line, 1, problem);
    }

    fn add(&mut self, line: usize, count: usize, problem: P) {
        let is_full = self.list.len() >= MOST;
        let find =
            |is_it: &dyn Fn(&P) -> bool| self.list.iter().rposition(|known| is_it(&known.problem));
        let like = find(&|known| known.is_like(&problem));
        let of_kind = || find(&|known| is_full && known.kind() == problem.kind());
        match like.or_else(of_kind) {
            // A line with several of one kind counts once.
            Some(index) if self.last_lines[index] == line => {}
            Some(index) => {
                self.list[index].count += count;
                self.last_lines[index] = line;
            }
            None => {
                self.last_lines.push(line);
                self.list.push(Deviation {
                    line,
                    count,
                    problem,
                });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A problem of a kind, told once for each kind.
    struct Of(&'static str);

    impl fmt::Display for Of {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "odd {}", self.0)
        }
    }

    impl Tolerated for Of {
        fn kind(&self) -> &'static str {
            self.0
        }

        fn remedy(&self) -> Cow<'_, str> {
            "it is left out".into()
        }
    }

    /// A word, told once for each word.
    struct Word(usize);

    impl fmt::Display for Word {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "word {}", self.0)
        }
    }

    impl Tolerated for Word {
        fn kind(&self) -> &'static str {
            "word"
        }

        fn remedy(&self) -> Cow<'_, str> {
            "it is left out".into()
        }

        fn is_like(&self, other: &Self) -> bool {
            self.0 == other.0
        }
    }

    fn counts<P>(found: Deviations<P>) -> Vec<[usize; 2]> {
        let list = found.into_list().into_iter();
        list.map(|deviation| [deviation.line, deviation.count])
            .collect()
    }

    #[test]
    fn each_kind_is_told_once_and_a_line_counts_once() {
        let mut found = Deviations::new(Reading::Tolerant);
        for (line, kind) in [
            (2, "face"),
            (3, "name"),
            (5, "face"),
            (5, "face"),
            (6, "face"),
        ] {
            assert!(found.tolerate(line, Of(kind)).is_ok());
        }
        assert!(found.tolerate_times(9, 4, Of("name")).is_ok());
        assert_eq!(
            found.list[1].to_string(),
            "line 3: odd name; it is left out (5 such lines)"
        );
        assert_eq!(counts(found), [[2, 3], [3, 5]]);
        let mut one = Deviations::default();
        one.note(4, Of("end"));
        assert_eq!(one.list[0].to_string(), "line 4: odd end; it is left out");
    }

    #[test]
    fn a_strict_reading_has_errors_and_notes() {
        let mut found = Deviations::new(Reading::Strict);
        assert_eq!(found.reading(), Reading::Strict);
        assert!(found.tolerate(1, Of("face")).is_err());
        found.note(2, Of("end"));
        assert_eq!(counts(found), [[2, 1]]);
    }

    #[test]
    fn beyond_the_most_the_last_one_counts_for_all_of_its_kind() {
        let mut found = Deviations::default();
        for word in 0..MOST + 5 {
            found.note(word + 1, Word(word));
        }
        found.note(100, Word(3));
        let counts = counts(found);
        assert_eq!(counts.len(), MOST);
        assert_eq!(counts[MOST - 1], [MOST, 6]);
        // A word that is told by itself goes on being so.
        assert_eq!(counts[3], [4, 2]);
    }
}
