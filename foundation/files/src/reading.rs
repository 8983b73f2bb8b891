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
        let is_like =
            |known: &P| known.is_like(&problem) || (is_full && known.kind() == problem.kind());
        match self.list.iter().rposition(|known| is_like(&known.problem)) {
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
