//! Declarations and functions that stand in the repository, as lists of tokens.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// A program: its tokens, brackets included.
pub type Tokens = Vec<String>;

/// A block of functions with the name of its algebra.
pub struct Functions {
    pub algebra: String,
    pub tokens: Tokens,
}

macro_rules! files {
    ($($path:literal),* $(,)?) => { [$(include_str!(concat!("../../../", $path))),*] };
}

const DECLARING: [&str; 14] = files![
    "ga-runtime/src/algebras/cga2.rs",
    "ga-runtime/src/algebras/cga3.rs",
    "ga-runtime/src/algebras/pga2.rs",
    "ga-runtime/src/algebras/pga3.rs",
    "ga-runtime/src/algebras/sta.rs",
    "ga-runtime/src/algebras/vga2.rs",
    "ga-runtime/src/algebras/vga3.rs",
    "tests/tests/declared/blades.rs",
    "tests/tests/declared/conformal.rs",
    "tests/tests/declared/metrics.rs",
    "tests/tests/declared/places.rs",
    "tests/tests/declared/versors.rs",
    "tests/crates/ui/tests/ui/facts.rs",
    "tests/crates/ui/tests/ui/types.rs",
];

const COMPUTING: [&str; 12] = files![
    "tests/tests/ga/conditions.rs",
    "tests/tests/ga/elementary.rs",
    "tests/tests/ga/exact.rs",
    "tests/tests/ga/language.rs",
    "tests/tests/ga/places.rs",
    "tests/tests/ga/places_of_figures.rs",
    "tests/tests/ga/real.rs",
    "tests/tests/ga/scalars.rs",
    "tests/tests/ga/uniform.rs",
    "tests/crates/ui/tests/ui/functions_grammar.rs",
    "tests/crates/ui/tests/ui/functions_meaning.rs",
    "tests/crates/ui/tests/ui/always_zero.rs",
];

/// The declarations, without their documentation.
pub fn declarations() -> Vec<Tokens> {
    bodies(&DECLARING, "algebra")
        .into_iter()
        .map(flat)
        .collect()
}

/// The functions, one by one, and those blocks whole that are short.
pub fn functions() -> Vec<Functions> {
    let mut found = Vec::new();
    for body in bodies(&COMPUTING, "ga") {
        let tokens: Vec<TokenTree> = body.into_iter().collect();
        let is_end = |token: &TokenTree| token.to_string() == ";";
        let Some(end) = tokens.iter().position(is_end) else {
            continue;
        };
        let Some(TokenTree::Ident(algebra)) = end.checked_sub(1).map(|last| &tokens[last]) else {
            continue;
        };
        let mut add = |tokens: &[TokenTree]| {
            let tokens = flat(tokens.iter().cloned().collect());
            found.push(Functions {
                algebra: algebra.to_string(),
                tokens,
            });
        };
        let rest = &tokens[end + 1..];
        let is_body = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
        rest.split_inclusive(is_body).for_each(&mut add);
        if rest.len() < 100 {
            add(rest);
        }
    }
    found
}

/// The tokens in the braces after `name!`, wherever it stands.
fn bodies(files: &[&str], name: &str) -> Vec<TokenStream> {
    let mut found = Vec::new();
    for file in files {
        let tokens = file.parse().expect("a file of the repository");
        collect(tokens, name, &mut found);
    }
    found
}

fn collect(tokens: TokenStream, name: &str, found: &mut Vec<TokenStream>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (place, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else {
            continue;
        };
        let is_called = place >= 2
            && tokens[place - 1].to_string() == "!"
            && tokens[place - 2].to_string() == name;
        if is_called {
            found.push(group.stream());
        } else {
            collect(group.stream(), name, found);
        }
    }
}

/// The tokens with brackets as tokens of their own, without comments.
fn flat(tokens: TokenStream) -> Tokens {
    let mut list = Vec::new();
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(mark) if mark.as_char() == '#' => {
                let is_doc = |token: &TokenTree| {
                    matches!(token, TokenTree::Group(group)
                        if group.stream().to_string().starts_with("doc"))
                };
                if tokens.next_if(is_doc).is_none() {
                    list.push("#".to_owned());
                }
            }
            TokenTree::Group(group) => {
                let [open, close] = match group.delimiter() {
                    Delimiter::Parenthesis => ["(", ")"],
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Bracket => ["[", "]"],
                    Delimiter::None => ["", ""],
                };
                list.push(open.to_owned());
                list.extend(flat(group.stream()));
                list.push(close.to_owned());
            }
            // A mark that belongs to the next one stays joined to it in the text.
            token => list.push(token.to_string()),
        }
    }
    list
}
