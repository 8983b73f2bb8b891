use super::BvhProblem;
use crate::file_error::MotionFileError;

/// The words of a text, each with its line.
pub(super) struct Words<'a> {
    /// The words of the current line that have not been taken.
    words: std::str::SplitWhitespace<'a>,
    lines: std::str::Lines<'a>,
    line: usize,
}

impl<'a> Words<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            words: "".split_whitespace(),
            lines: text.lines(),
            line: 0,
        }
    }

    /// The number of the current line, from 1.
    pub(super) fn line(&self) -> usize {
        self.line.max(1)
    }

    pub(super) fn error(&self, problem: BvhProblem) -> MotionFileError {
        MotionFileError::Bvh {
            line: self.line(),
            problem,
        }
    }

    /// The next word, on this line or a later one.
    pub(super) fn next(&mut self, expected: &'static str) -> Result<&'a str, MotionFileError> {
        loop {
            if let Some(word) = self.words.next() {
                return Ok(word);
            }
            if self.next_line().is_none() {
                return Err(self.error(BvhProblem::EndOfFile { expected }));
            }
        }
    }

    /// Goes to the next line and gives the words on it.
    pub(super) fn next_line(&mut self) -> Option<std::str::SplitWhitespace<'a>> {
        let line = self.lines.next()?;
        self.line += 1;
        self.words = line.split_whitespace();
        Some(self.words.clone())
    }

    /// Takes the next word, which must be `expected` in small or capital letters.
    pub(super) fn expect(&mut self, expected: &'static str) -> Result<(), MotionFileError> {
        let found = self.next(expected)?;
        if found.eq_ignore_ascii_case(expected) {
            return Ok(());
        }
        Err(self.expected(expected, found))
    }

    /// Nothing may be left on this line.
    pub(super) fn expect_end_of_line(&self) -> Result<(), MotionFileError> {
        match self.words.clone().next() {
            None => Ok(()),
            Some(word) => Err(self.expected("the end of the line", word)),
        }
    }

    pub(super) fn expected(&self, expected: &'static str, found: &str) -> MotionFileError {
        self.error(BvhProblem::Expected {
            expected,
            found: found.to_owned(),
        })
    }

    /// The rest of this line up to an opening brace: a name, which may be of several words.
    pub(super) fn name(&mut self) -> Result<String, MotionFileError> {
        let mut name = self.next("a name")?.to_owned();
        let mut ahead = self.words.clone();
        while let Some(word) = ahead.next().filter(|&word| word != "{") {
            name.push(' ');
            name.push_str(word);
            self.words = ahead.clone();
        }
        if matches!(name.as_str(), "{" | "}") {
            Err(self.expected("a name", &name))
        } else {
            Ok(name)
        }
    }

    pub(super) fn number(&mut self) -> Result<f64, MotionFileError> {
        let word = self.next("a number")?;
        number(word).map_err(|problem| self.error(problem))
    }

    pub(super) fn count(&mut self) -> Result<usize, MotionFileError> {
        let word = self.next("a count")?;
        word.parse().map_err(|_| self.expected("a count", word))
    }

    pub(super) fn vector(&mut self) -> Result<[f64; 3], MotionFileError> {
        Ok([self.number()?, self.number()?, self.number()?])
    }
}

pub(super) fn number(word: &str) -> Result<f64, BvhProblem> {
    let value: f64 = word.parse().map_err(|_| BvhProblem::NotANumber {
        word: word.to_owned(),
    })?;
    if value.is_finite() {
        Ok(value)
    } else {
        Err(BvhProblem::NotFinite {
            word: word.to_owned(),
        })
    }
}
