use ga_files::text::line_end;
use ga_files::{Deviation, Deviations, Reading};

use super::BvhProblem;
use crate::file_error::MotionFileError;

/// The words of a text, each with its line, and what in it deviates from the format.
pub(super) struct Words<'a> {
    /// The words of the current line that have not been taken.
    words: std::str::SplitWhitespace<'a>,
    /// The lines after the current one.
    rest: &'a str,
    line: usize,
    deviations: Deviations<BvhProblem>,
}

impl<'a> Words<'a> {
    pub(super) fn new(text: &'a str, reading: Reading) -> Self {
        Self {
            words: "".split_whitespace(),
            rest: text,
            line: 0,
            deviations: Deviations::new(reading),
        }
    }

    /// How the text is read.
    pub(super) fn reading(&self) -> Reading {
        self.deviations.reading()
    }

    /// Adds a problem of the current line where the text is read tolerantly.
    pub(super) fn tolerate(&mut self, problem: BvhProblem) -> Result<(), MotionFileError> {
        self.tolerate_at(self.line(), 1, problem)
    }

    /// Adds a problem of several lines where the text is read tolerantly.
    pub(super) fn tolerate_at(
        &mut self,
        line: usize,
        count: usize,
        problem: BvhProblem,
    ) -> Result<(), MotionFileError> {
        let tolerated = self.deviations.tolerate_times(line, count, problem);
        tolerated.map_err(|problem| MotionFileError::Bvh { line, problem })
    }

    pub(super) fn into_deviations(self) -> Vec<Deviation<BvhProblem>> {
        self.deviations.into_list()
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
            if self.next_line()?.is_none() {
                return Err(self.error(BvhProblem::EndOfFile { expected }));
            }
        }
    }

    /// The next word without taking it, on this line or a later one; `None` at the end.
    pub(super) fn peek(&mut self) -> Result<Option<&'a str>, MotionFileError> {
        loop {
            if let Some(word) = self.words.clone().next() {
                return Ok(Some(word));
            }
            if self.next_line()?.is_none() {
                return Ok(None);
            }
        }
    }

    /// Goes to the next line and gives the words on it.
    pub(super) fn next_line(
        &mut self,
    ) -> Result<Option<std::str::SplitWhitespace<'a>>, MotionFileError> {
        if self.rest.is_empty() {
            return Ok(None);
        }
        let rest = self.rest;
        self.line += 1;
        let mut line = rest;
        self.rest = "";
        if let Some(end) = line_end(rest.as_bytes()) {
            (line, self.rest) = (&rest[..end.start], &rest[end.end..]);
            if rest.as_bytes()[end.end - 1] == b'\r' {
                self.tolerate(BvhProblem::CarriageReturns)?;
            }
        }
        self.words = line.split_whitespace();
        Ok(Some(self.words.clone()))
    }

    /// The words of the current line that have not been taken.
    pub(super) fn rest_of_line(&self) -> std::str::SplitWhitespace<'a> {
        self.words.clone()
    }

    /// Takes the next word, which must be `expected` in small or capital letters.
    pub(super) fn expect(&mut self, expected: &'static str) -> Result<(), MotionFileError> {
        let found = self.next(expected)?;
        if found.eq_ignore_ascii_case(expected) {
            return Ok(());
        }
        Err(self.expected(expected, found))
    }

    /// Leaves out what is left on this line, unless it begins with a number.
    pub(super) fn leave_out_text(&mut self) -> Result<(), MotionFileError> {
        let Some(word) = self.words.clone().next() else {
            return Ok(());
        };
        if word.parse::<f64>().is_ok() {
            return Err(self.expected("the end of the line", word));
        }
        self.words = "".split_whitespace();
        let word = word.to_owned();
        self.tolerate(BvhProblem::ExtraText { word })
    }

    /// Takes the words of `label`, as `Frame Time`, with the colon behind them, and gives what
    /// follows as one word. Blanks around the colon, and the colon itself, may be missing.
    pub(super) fn labelled(
        &mut self,
        label: [&'static str; 2],
    ) -> Result<&'a str, MotionFileError> {
        let [first, last] = label;
        if !first.is_empty() {
            self.expect(first)?;
        }
        let word = self.next(last)?;
        let name = last.trim_end_matches(':');
        let after = word.get(name.len()..);
        let is_label = |after: &&str| {
            let has_end = after.is_empty() || after.starts_with(':');
            has_end && word[..name.len()].eq_ignore_ascii_case(name)
        };
        let Some(after) = after.filter(is_label) else {
            return Err(self.expected(last, word));
        };
        if after == ":" {
            return self.next("a number");
        }
        self.tolerate(BvhProblem::Expected {
            expected: last,
            found: word.to_owned(),
        })?;
        // The colon and the value may be words of their own.
        let value = after.trim_start_matches(':');
        if !value.is_empty() {
            return Ok(value);
        }
        match self.next("a number")? {
            ":" => self.next("a number"),
            word => Ok(word.trim_start_matches(':')),
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

    /// The words of this line before the opening brace of an End Site.
    pub(super) fn name_of_end_site(&mut self) -> Result<String, MotionFileError> {
        let mut name = String::new();
        while let Some(word) = self.rest_of_line().next().filter(|&word| word != "{") {
            self.next("{")?;
            name.push_str(if name.is_empty() { "" } else { " " });
            name.push_str(word);
        }
        Ok(name)
    }

    pub(super) fn number(&mut self) -> Result<f64, MotionFileError> {
        let word = self.next("a number")?;
        number(word).map_err(|problem| self.error(problem))
    }

    pub(super) fn count(&mut self) -> Result<usize, MotionFileError> {
        let word = self.next("a count")?;
        self.as_count(word)
    }

    /// The number of elements that a word stands for.
    pub(super) fn as_count(&self, word: &str) -> Result<usize, MotionFileError> {
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
