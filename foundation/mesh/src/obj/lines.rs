use std::borrow::Cow;

use ga_files::text::line_end;

/// The lines of an OBJ file, those that end in `\` joined with the next, each with the number of
/// its first line.
pub(super) struct Lines<'a> {
    rest: Option<&'a [u8]>,
    /// How many lines of the file have been taken.
    taken: usize,
    /// How many of them end in a carriage return alone, and the first.
    returns: usize,
    first_return: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self {
            rest: Some(bytes),
            taken: 0,
            returns: 0,
            first_return: 0,
        }
    }

    /// How many lines of the file have been taken so far.
    pub(super) fn taken(&self) -> usize {
        self.taken
    }

    /// The first line that ends in a carriage return alone, and how many do.
    pub(super) fn returns(&self) -> Option<(usize, usize)> {
        (self.returns > 0).then_some((self.first_return, self.returns))
    }

    /// One line of the file without its end, and whether the next line continues it.
    fn physical(&mut self) -> Option<(&'a [u8], bool)> {
        let rest = self.rest?;
        let line = match line_end(rest) {
            Some(end) => {
                if rest[end.end - 1] == b'\r' {
                    self.returns += 1;
                    if self.returns == 1 {
                        self.first_return = self.taken + 1;
                    }
                }
                self.rest = Some(&rest[end.end..]);
                &rest[..end.start]
            }
            // What follows the last line end is a line only if there is something.
            None => {
                self.rest = None;
                if rest.is_empty() {
                    return None;
                }
                rest
            }
        };
        self.taken += 1;
        // A comment ends with its line: otherwise a path like C:\ in it would hide the next vertex.
        Some(match line.strip_suffix(b"\\") {
            Some(start) if !has_comment(line) => (start, true),
            _ => (line, false),
        })
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, Cow<'a, [u8]>);

    fn next(&mut self) -> Option<Self::Item> {
        let (line, mut goes_on) = self.physical()?;
        let number = self.taken;
        if !goes_on {
            return Some((number, Cow::Borrowed(line)));
        }
        let mut joined = line.to_vec();
        while goes_on {
            let Some((line, again)) = self.physical() else {
                break;
            };
            joined.push(b' ');
            joined.extend_from_slice(line);
            goes_on = again;
        }
        Some((number, Cow::Owned(joined)))
    }
}

fn has_comment(line: &[u8]) -> bool {
    line.split(u8::is_ascii_whitespace)
        .any(|word| word.starts_with(b"#"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_keep_the_number_they_begin_at() {
        let lines: Vec<_> = Lines::new(b"a\r\nb \\\nc\\\r\nd\n\n e")
            .map(|(number, line)| (number, String::from_utf8(line.into_owned()).unwrap()))
            .collect();
        let expected = [(1, "a"), (2, "b  c d"), (5, ""), (6, " e")];
        assert_eq!(
            lines,
            expected.map(|(number, line)| (number, line.to_owned()))
        );
    }

    #[test]
    fn lines_that_end_in_a_carriage_return_alone_are_counted() {
        let mut lines = Lines::new(b"a\nb\\\rc\rd\r\n");
        let texts: Vec<_> = lines
            .by_ref()
            .map(|(line, text)| (line, text.into_owned()))
            .collect();
        assert_eq!(
            texts,
            [(1, b"a".to_vec()), (2, b"b c".to_vec()), (4, b"d".to_vec())]
        );
        assert_eq!(lines.returns(), Some((2, 2)));
    }

    #[test]
    fn a_comment_ends_with_its_line() {
        let lines: Vec<_> = Lines::new(b"# from C:\\\nv 1 # C:\\\ng a#b\\\nc")
            .map(|(_, line)| line.into_owned())
            .collect();
        assert_eq!(lines, [&b"# from C:\\"[..], b"v 1 # C:\\", b"g a#b c"]);
    }

    #[test]
    fn a_line_may_go_on_past_the_end_of_the_file() {
        assert_eq!(Lines::new(b"a\\").count(), 1);
        assert_eq!(Lines::new(b"").count(), 0);
        assert_eq!(Lines::new(b"\n").count(), 1);
    }
}
