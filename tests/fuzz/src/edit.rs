//! Edits of a list of tokens that bytes describe, so that what libFuzzer makes of bytes makes
//! programs that are nearly valid.

use crate::programs::Tokens;

/// Marks and numbers at which grammars and bounds break.
const SPECIAL: [&str; 40] = [
    "(",
    ")",
    "{",
    "}",
    "[",
    "]",
    ",",
    ";",
    "-",
    "!",
    "*",
    "^",
    "|",
    "&",
    "/",
    "+",
    "=",
    "==",
    "<",
    "..",
    "->",
    "#",
    "0",
    "1",
    "2",
    "16",
    "17",
    "1024",
    "65536",
    "4294967296",
    "1e36",
    "0.5",
    "340282366920938463463374607431768211456",
    "scalar",
    "let",
    "fn",
    "struct",
    "mod",
    "uniform",
    "blade",
];

/// The largest program that is made.
const LARGEST: usize = 20_000;

/// The bytes of an input, read one after the other; zero where they end.
pub struct Bytes<'a>(pub &'a [u8]);

impl Bytes<'_> {
    /// Whether there are no more.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The next byte.
    pub fn byte(&mut self) -> usize {
        let Some((first, rest)) = self.0.split_first() else {
            return 0;
        };
        self.0 = rest;
        usize::from(*first)
    }

    /// A number below a bound, of the next two bytes.
    pub fn below(&mut self, bound: usize) -> usize {
        (self.byte() << 8 | self.byte()) % bound.max(1)
    }
}

/// Makes the edits that the bytes describe. `pool` are programs from which tokens are taken.
pub fn edited(mut tokens: Tokens, pool: &[&Tokens], bytes: &mut Bytes<'_>) -> Tokens {
    while !bytes.is_empty() && tokens.len() < LARGEST {
        let place = bytes.below(tokens.len() + 1);
        let length = (bytes.byte() % 16).min(tokens.len() - place);
        let end = place + length;
        match bytes.byte() % 8 {
            0 => drop(tokens.drain(place..end)),
            1 => {
                // A piece of the same program, many times.
                let piece: Tokens = tokens[place..end].to_vec();
                let times = 1 << (bytes.byte() % 11);
                let repeated = piece.iter().cycle().take(piece.len() * times);
                let repeated: Tokens = repeated.take(LARGEST).cloned().collect();
                tokens.splice(end..end, repeated);
            }
            2 => {
                let special = SPECIAL[bytes.byte() % SPECIAL.len()].to_owned();
                tokens.splice(place..(place + 1).min(tokens.len()), [special]);
            }
            3 => tokens.insert(place, SPECIAL[bytes.byte() % SPECIAL.len()].to_owned()),
            4 | 5 => {
                // A token of any program, in place of one.
                let other = pool[bytes.below(pool.len())];
                let token = other.get(bytes.below(other.len())).cloned();
                tokens.splice(place..(place + 1).min(tokens.len()), token);
            }
            6 => {
                // A piece of any program.
                let other = pool[bytes.below(pool.len())];
                let start = bytes.below(other.len());
                let piece = other[start..(start + length).min(other.len())].to_vec();
                tokens.splice(place..place, piece);
            }
            _ => {
                // Brackets around a piece, many deep.
                let [open, close] = [["(", ")"], ["{", "}"], ["[", "]"]][bytes.byte() % 3];
                let levels = 1 << (bytes.byte() % 12);
                let brackets = |bracket: &str| vec![bracket.to_owned(); levels];
                tokens.splice(end..end, brackets(close));
                tokens.splice(place..place, brackets(open));
            }
        }
    }
    balanced(tokens)
}

/// The tokens without brackets that close nothing, and with those that are missing.
fn balanced(tokens: Tokens) -> Tokens {
    let mut open: Vec<&'static str> = Vec::new();
    let mut list = Vec::with_capacity(tokens.len());
    for token in tokens {
        match token.as_str() {
            "(" => open.push(")"),
            "{" => open.push("}"),
            "[" => open.push("]"),
            ")" | "}" | "]" => {
                if open.last() != Some(&token.as_str()) {
                    continue;
                }
                open.pop();
            }
            _ => {}
        }
        list.push(token);
    }
    list.extend(open.into_iter().rev().map(str::to_owned));
    list
}

/// The text of a list of tokens. Marks stay joined, so that `->` and `&&` are one.
pub fn text(tokens: &Tokens) -> String {
    let mut text = String::new();
    for token in tokens {
        let is_mark = |token: &str| token.chars().all(|c| c.is_ascii_punctuation() && c != '_');
        let joins =
            is_mark(token) && text.ends_with(['-', '=', '<', '>', '&', '|', '!', '\'', ':', '.']);
        if !text.is_empty() && !joins {
            text.push(' ');
        }
        text.push_str(token);
    }
    text
}
