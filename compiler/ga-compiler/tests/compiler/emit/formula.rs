//! Formulas, read back from their text and evaluated over the prime field.

use std::collections::HashMap;

use ga_compiler::define::Definition;
use ga_compiler::emit::formula;
use ga_compiler::function::CompiledFunction;
use ga_compiler::ir::{Function, Residue};
use proptest::prelude::*;

use super::{random, source};
use crate::algebras::{cga3, compile};

/// Evaluates the expression after each label in the text of a function.
fn evaluate(text: &str, names: &[(String, usize)], inputs: &[Residue]) -> Vec<(String, Residue)> {
    let mut known: HashMap<String, Residue> = names
        .iter()
        .zip(inputs)
        .map(|((name, _), &value)| (name.clone(), value))
        .collect();
    let mut results = Vec::new();
    // Named parts may refer to each other in any order.
    let mut definitions: HashMap<String, String> = HashMap::new();
    for line in text.lines().skip(1) {
        // Comparisons have the same sign, but in parentheses.
        if let Some((name, definition)) = line
            .split_once(" = ")
            .filter(|(name, _)| !line.starts_with("where") && !name.contains([' ', '(']))
        {
            definitions.insert(name.to_owned(), definition.to_owned());
        } else if let Some((label, expression)) = line.split_once(": ") {
            let value = Reader::value(expression, &mut known, &definitions);
            results.push((label.to_owned(), value));
            // Derived blades are written in terms of the blades before them, without a path.
            let blade = label.rsplit('.').next().unwrap_or(label);
            known.insert(blade.to_owned(), value);
        }
    }
    results
}

/// A recursive descent through one expression.
struct Reader<'a> {
    rest: &'a str,
    known: &'a mut HashMap<String, Residue>,
    definitions: &'a HashMap<String, String>,
}

impl Reader<'_> {
    fn value(
        text: &str,
        known: &mut HashMap<String, Residue>,
        definitions: &HashMap<String, String>,
    ) -> Residue {
        let mut reader = Reader {
            rest: text,
            known,
            definitions,
        };
        let value = reader.sum();
        assert_eq!(reader.rest, "", "of {text}");
        value
    }

    fn take(&mut self, start: &str) -> bool {
        match self.rest.strip_prefix(start) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn sum(&mut self) -> Residue {
        let mut sum = if self.take("-") {
            -self.term()
        } else {
            self.term()
        };
        loop {
            if self.take(" < ") {
                return self.compared(Function::Less, sum);
            } else if self.take(" ≤ ") {
                return self.compared(Function::LessOrEqual, sum);
            } else if self.take(" = ") {
                return self.compared(Function::Equal, sum);
            } else if self.take(" and ") {
                return self.compared(Function::And, sum);
            } else if self.take(" or ") {
                return self.compared(Function::Or, sum);
            } else if self.take(" + ") {
                sum = sum + self.term();
            } else if self.take(" - ") {
                sum = sum - self.term();
            } else {
                return sum;
            }
        }
    }

    fn compared(&mut self, function: Function, left: Residue) -> Residue {
        let right = self.sum();
        function.evaluate(&[left, right]).expect("total")
    }

    fn term(&mut self) -> Residue {
        let mut product = self.power();
        loop {
            if self.take(" / ") {
                product = product * self.power().recip();
            } else if self.rest.starts_with(' ')
                && !self.rest.starts_with(" + ")
                && !self.rest.starts_with(" - ")
                && ![" < ", " ≤ ", " = ", " and ", " or "]
                    .iter()
                    .any(|sign| self.rest.starts_with(sign))
            {
                self.rest = &self.rest[1..];
                product = product * self.power();
            } else {
                return product;
            }
        }
    }

    fn power(&mut self) -> Residue {
        let base = self.atom();
        let digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
        let mut exponent = 0;
        while let Some(next) = self.rest.chars().next()
            && let Some(digit) = digits.chars().position(|digit| digit == next)
        {
            exponent = 10 * exponent + digit;
            self.rest = &self.rest[next.len_utf8()..];
        }
        (0..exponent.max(1)).fold(Residue::ONE, |power, _| power * base)
    }

    fn atom(&mut self) -> Residue {
        if self.take("(") {
            let value = self.sum();
            assert!(self.take(")"), "at {}", self.rest);
            return value;
        }
        if self.take("nonzero(") {
            return self.call(Function::Divisor);
        }
        if self.take("recip_or_zero(") {
            return self.call(Function::Reciprocal);
        }
        if self.take("√(") {
            return self.call(Function::SquareRoot);
        }
        if self.take("not (") {
            return self.call(Function::Not);
        }
        if self.take("select(") {
            return self.call(Function::Select);
        }
        if self.take("min(") {
            return self.call(Function::Minimum);
        }
        if self.take("max(") {
            return self.call(Function::Maximum);
        }
        if self.take("atan2(") {
            return self.call(Function::ArcTangent);
        }
        let end = self
            .rest
            .find(|c: char| !(c.is_ascii_alphanumeric() || "._[]".contains(c)))
            .unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        let word = word.to_owned();
        self.rest = rest;
        if let Ok(number) = word.parse::<u64>() {
            return Residue::new(number);
        }
        if let Some(definition) = self.definitions.get(&word)
            && !self.known.contains_key(&word)
        {
            let value = Self::value(definition, self.known, self.definitions);
            self.known.insert(word.clone(), value);
        }
        match self.known.get(&word) {
            Some(&value) => value,
            None => panic!("unknown {word:?} before {:?}", self.rest),
        }
    }

    fn call(&mut self, function: Function) -> Residue {
        let mut arguments = vec![self.sum()];
        while self.take(", ") {
            arguments.push(self.sum());
        }
        assert!(self.take(")"), "at {}", self.rest);
        function.evaluate(&arguments).unwrap_or(Residue::ZERO)
    }
}

#[track_caller]
fn assert_formula_agrees(definition: &Definition, function: &CompiledFunction) {
    let text = formula::function(definition, function);
    let names = formula::inputs(definition, &function.operands);
    let Some(inputs) = random::inputs(function, 3) else {
        return;
    };
    let found = evaluate(&text, &names, &inputs);
    let expected = function.kernel.evaluate(&inputs);
    // Points have eo and ei without storing them.
    let result = function.result.to_text(definition);
    let is_of_points = result == "Point" || result.starts_with("[Point;");
    let is_stored = |label: &str| {
        let is_fixed = label.ends_with("eo") || label.ends_with("ei");
        !((is_of_points || label.contains("centre.")) && is_fixed)
    };
    let stored: Vec<_> = found
        .iter()
        .filter(|(label, _)| is_stored(label))
        .map(|&(_, value)| value)
        .collect();
    assert_eq!(stored, expected, "{text}");
}

#[test]
fn formulas_mean_what_the_graph_does() {
    let definition = cga3();
    proptest!(|(recipe in random::functions(false))| {
        assert_formula_agrees(&definition, &recipe.build());
    });
}

#[test]
fn formulas_of_kernels_mean_what_the_graph_does() {
    let definition = cga3();
    for function in source::kernels(&definition) {
        assert_formula_agrees(&definition, &function);
    }
}

#[test]
fn formulas_read_as_in_a_textbook() {
    let definition = cga3();
    let text = |function| formula::function(&definition, &compile(&definition, function));
    assert_eq!(
        text("fn f(p: Point, q: Point) -> Point { p }"),
        "f(p: Point, q: Point) -> Point\ne1: p.e1\ne2: p.e2\ne3: p.e3\neo: 1\nei: (e1² + e2² + e3²) / 2\n"
    );
    assert_eq!(
        text("fn f(a: Direction, b: Rotor) -> Direction { sandwich(b, a) }"),
        "f(a: Direction, b: Rotor) -> Direction\n\
         e1i: (1 - 2 b.e12² - 2 b.e13²) a.e1i + 2 (b.scalar b.e12 - b.e13 b.e23) a.e2i + 2 (b.scalar b.e13 + b.e12 b.e23) a.e3i\n\
         e2i: (1 - 2 b.e12² - 2 b.e23²) a.e2i - 2 (b.scalar b.e12 + b.e13 b.e23) a.e1i + 2 (b.scalar b.e23 - b.e12 b.e13) a.e3i\n\
         e3i: 2 (b.e12 b.e23 - b.scalar b.e13) a.e1i - 2 (b.scalar b.e23 + b.e12 b.e13) a.e2i + (1 - 2 b.e13² - 2 b.e23²) a.e3i\n"
    );
    assert_eq!(
        text("fn f(x: Scalar, y: Scalar) -> Scalar { select(x > y + 1 && !(x == y), x, 2 * y) }"),
        "f(x: Scalar, y: Scalar) -> Scalar\n\
         scalar: select((1 + y < x) and (not (x = y)), x, 2 y)\n"
    );
}
