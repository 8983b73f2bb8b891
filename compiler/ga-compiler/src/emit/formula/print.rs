//! Polynomials as text.

use std::collections::{BTreeMap, BTreeSet};

use super::expand::Expander;
use super::polynomial::{Monomial, Polynomial};
use crate::algebra::Ratio;
use crate::ir::{Arena, Function, Node, NodeId};

/// Writes polynomials over the nodes of a graph.
pub(super) struct Printer<'a> {
    pub(super) arena: &'a Arena,
    pub(super) expander: Expander<'a>,
    /// The names of the inputs, and for each the operand that it belongs to.
    pub(super) inputs: &'a [(String, usize)],
    /// The names of parts that have lines of their own.
    pub(super) bound: BTreeMap<NodeId, String>,
    /// The functions that have been written and need an explanation.
    pub(super) explained: BTreeSet<Function>,
}

impl Printer<'_> {
    /// A polynomial as a sum, grouped by the coefficients of an operand that it is linear in.
    pub(super) fn sum(&mut self, polynomial: &Polynomial) -> String {
        let groups = self
            .groups(polynomial)
            .unwrap_or_else(|| vec![(Monomial::new(), polynomial.clone())]);
        let mut terms: Vec<(bool, String)> = Vec::new();
        for (by, coefficient) in groups {
            if by.is_empty() || coefficient.len() == 1 {
                for (monomial, factor) in sorted(&coefficient) {
                    let mut whole = monomial;
                    whole.extend(&by);
                    let mut text = self.term(&whole, factor.abs(), String::new());
                    if factor == Ratio::ONE && !bare(&text).starts_with('-') {
                        text = bare(&text).to_owned();
                    }
                    terms.push((factor.is_negative(), text));
                }
            } else {
                let (content, mut rest) = coefficient.split_content();
                let is_negative = sorted(&rest).iter().all(|(_, factor)| factor.is_negative());
                if is_negative {
                    let mut negative = Polynomial::default();
                    negative.add_scaled(&rest, Ratio::integer(-1));
                    rest = negative;
                }
                let inner = format!("({})", self.sum(&rest));
                terms.push((is_negative, self.term(&by, content, inner)));
            }
        }
        // A sum begins with a positive term where there is one.
        if let Some(first) = terms.iter().position(|(is_negative, _)| !is_negative) {
            terms[..=first].rotate_right(1);
        }
        let mut text = String::new();
        for (place, (is_negative, term)) in terms.iter().enumerate() {
            text.push_str(match (place, is_negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            });
            text.push_str(term);
        }
        if text.is_empty() {
            "0".to_owned()
        } else {
            text
        }
    }

    /// A polynomial as a sum, with its common factor taken out.
    pub(super) fn whole(&mut self, polynomial: &Polynomial) -> String {
        let (content, rest) = polynomial.split_content();
        if content == Ratio::ONE || rest.len() < 2 {
            return self.sum(polynomial);
        }
        let inner = format!("({})", self.sum(&rest));
        self.term(&Monomial::new(), content, inner)
    }

    /// The coefficients of the variables of the last operand that the polynomial is linear in, if
    /// that makes it shorter.
    fn groups(&self, polynomial: &Polynomial) -> Option<Vec<(Monomial, Polynomial)>> {
        if polynomial.len() < 3 {
            return None;
        }
        let operand = |node: NodeId| match self.arena.node(node) {
            Node::Input(number) => self.inputs.get(*number).map(|(_, operand)| *operand),
            _ => None,
        };
        let operands: BTreeSet<usize> = polynomial.variables().filter_map(operand).collect();
        for chosen in operands.into_iter().rev() {
            let mut groups: BTreeMap<Monomial, Polynomial> = BTreeMap::new();
            let mut is_linear = true;
            for (monomial, &factor) in &polynomial.terms {
                let (by, rest): (Monomial, Monomial) = monomial
                    .iter()
                    .partition(|(node, _)| operand(*node) == Some(chosen));
                is_linear &= matches!(by.as_slice(), [] | [(_, 1)]);
                let group = groups.entry(by).or_default();
                group.add_scaled(&Polynomial::term(rest, factor), Ratio::ONE);
            }
            if is_linear && groups.len() < polynomial.len() {
                // What is free of the operand comes last.
                let mut groups: Vec<_> = groups.into_iter().collect();
                groups.sort_by_key(|(by, _)| by.is_empty());
                return Some(groups);
            }
        }
        None
    }

    /// A product of a positive factor, an optional sum in parentheses, and powers.
    fn term(&mut self, monomial: &Monomial, factor: Ratio, inner: String) -> String {
        let (mut above, mut below) = (Vec::new(), Vec::new());
        if factor.numerator() != 1 {
            above.push(factor.numerator().to_string());
        }
        if factor.denominator() != 1 {
            below.push(factor.denominator().to_string());
        }
        if !inner.is_empty() {
            above.push(inner);
        }
        for &(node, power) in monomial {
            let text = self.variable(node);
            let text = match power.unsigned_abs() {
                1 => text,
                power => format!("{text}{}", superscript(power)),
            };
            if power > 0 {
                above.push(text);
            } else {
                below.push(text);
            }
        }
        if above.is_empty() {
            above.push("1".to_owned());
        }
        let above = above.join(" ");
        match below.as_slice() {
            [] => above,
            [single] => format!("{above} / {single}"),
            _ => format!("{above} / ({})", below.join(" ")),
        }
    }

    fn variable(&mut self, node: NodeId) -> String {
        match self.bound.get(&node) {
            Some(name) => name.clone(),
            None => self.definition(node),
        }
    }

    /// What a variable stands for.
    pub(super) fn definition(&mut self, node: NodeId) -> String {
        match self.arena.node(node) {
            Node::Input(number) => {
                let input = self.inputs.get(*number);
                input.map_or_else(|| "?".to_owned(), |(name, _)| name.clone())
            }
            Node::Function(function, arguments) => {
                let texts: Vec<_> = arguments
                    .iter()
                    .map(|&argument| {
                        let expanded = self.expander.value(argument);
                        self.whole(&expanded)
                    })
                    .collect();
                let text = texts.join(", ");
                if function.properties().explanation.is_some() {
                    self.explained.insert(*function);
                }
                match function {
                    Function::Not => format!("not ({text})"),
                    Function::And | Function::Or => {
                        let texts: Vec<_> = texts.iter().map(|text| format!("({text})")).collect();
                        format!(
                            "({})",
                            texts.join(&format!(" {} ", function.properties().symbol))
                        )
                    }
                    Function::Less | Function::LessOrEqual | Function::Equal => {
                        format!(
                            "({})",
                            texts.join(&format!(" {} ", function.properties().symbol))
                        )
                    }
                    Function::Absolute => format!("|{text}|"),
                    Function::SquareRoot => format!("√({text})"),
                    other => format!("{}({text})", other.properties().symbol),
                }
            }
            Node::One | Node::Sum(_) | Node::Product(..) | Node::Quotient(..) => {
                format!("({})", self.part(node))
            }
        }
    }

    /// A part as a sum of its own.
    pub(super) fn part(&mut self, node: NodeId) -> String {
        let expanded = self.expander.node(node).clone();
        self.whole(&expanded)
    }
}

/// The terms of a polynomial: those of low degree first.
fn sorted(polynomial: &Polynomial) -> Vec<(Monomial, Ratio)> {
    let mut terms: Vec<_> = polynomial
        .terms
        .iter()
        .map(|(monomial, &factor)| (monomial.clone(), factor))
        .collect();
    terms.sort_by_key(|(monomial, _)| monomial.iter().map(|(_, power)| power).sum::<i32>());
    terms
}

fn superscript(power: u32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = power.to_string();
    digits
        .bytes()
        .map(|digit| DIGITS[usize::from(digit - b'0')])
        .collect()
}

/// A text without the parentheses around all of it.
pub(super) fn bare(text: &str) -> &str {
    let Some(inner) = text.strip_prefix('(').and_then(|t| t.strip_suffix(')')) else {
        return text;
    };
    let mut depth = 0;
    for letter in inner.chars() {
        match letter {
            '(' => depth += 1,
            ')' if depth == 0 => return text,
            ')' => depth -= 1,
            _ => {}
        }
    }
    inner
}
