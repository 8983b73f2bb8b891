//! Equivalent forms of programs, so that the spelling of a formula does not matter.
//!
//! A program is taken apart into *classes* of equal multivectors. Each has one or more *ways*,
//! operations that give it. Rules, in `rules/`, add ways, until nothing new comes out or a bound is
//! reached. Then a program is put together again from one way for each class: by estimates first,
//! and of those that look cheapest the search takes the one whose graph is cheapest.
//!
//! What is equal is decided by evaluation, see `classes.rs`. So formulas with the same meaning meet
//! in one class however they are written, and what a wrong rule proposes joins another class. Every
//! expansion is checked once more when it is done, at the same points. Programs with choices, with
//! `min` and with `max` are compiled as they are written, since comparisons are random there.
//!
//! # Adding a rule
//!
//! 1. Give it a name in [`FormRule`], with its identity.
//! 2. Write a file in `rules/` with the proof, and a function that looks at one way and proposes
//!    others by `Classes::product`, `sandwich`, `sum` and so on. It matches
//!    structure and what classes know (grades, unit versors), never names.
//! 3. List it in `rules/mod.rs`, and in `tests/compiler/forms.rs` a function where it applies: the
//!    test breaks the rule there, and the compiler must notice.

mod class;
mod classes;
mod estimate;
mod extract;
mod form;
mod frame;
mod import;
mod make;
mod rules;
mod selection;
mod shared;
mod source;
mod unnormalised;

pub(crate) use form::Form;
pub(crate) use source::Source;

pub use crate::lower::FormRule;

use crate::define::{Role, TypeDefinition};
use crate::limit::SearchLimit;
use crate::lower::{Choices, Rule};
use crate::program::Step;
use class::{ClassId, Term};
use classes::Classes;
use extract::{Known, extract};
use selection::Costs;

/// The forms of a program that were found, and the limits that were reached.
#[derive(Default)]
pub(crate) struct Found<'a> {
    pub(crate) forms: Vec<Form<'a>>,
    pub(crate) limits: Vec<SearchLimit>,
}

/// The largest program that is taken apart.
const MOST_STEPS: usize = 320;

/// How many forms are taken of a program that is seen from a point.
const MOST_IN_FRAME: usize = 2;

/// The forms of a program that look cheapest, the best first, and some as they are seen from its
/// points.
pub(crate) fn cheapest<'a>(source: &Source<'_, 'a>, most: usize) -> Found<'a> {
    let mut found = match cheapest_of(source, most) {
        Ok(found) => found,
        Err(limits) => {
            return Found {
                limits,
                ..Found::default()
            };
        }
    };
    for (place, (rule, moved)) in others(source).iter().enumerate() {
        let other = cheapest_of(&moved.source(source), MOST_IN_FRAME).unwrap_or_default();
        let forms = other.forms.into_iter();
        found
            .forms
            .extend(forms.map(|form| led_to(form, *rule, place + 1)));
    }
    found
}

/// Programs that give the same by rules for whole programs.
fn others<'a>(source: &Source<'_, 'a>) -> Vec<(FormRule, frame::Moved<'a>)> {
    let frames = frame::frames(source).into_iter();
    let frames = frames.map(|moved| (FormRule::Frame, moved));
    let unnormalised = unnormalised::unnormalised(source);
    let unnormalised = unnormalised.map(|moved| (FormRule::Unnormalised, moved));
    frames.chain(unnormalised).collect()
}

/// The forms of a program that look cheapest; otherwise the limits for which there are none.
fn cheapest_of<'a>(source: &Source<'_, 'a>, most: usize) -> Result<Found<'a>, Vec<SearchLimit>> {
    let (mut classes, known, terms) = classes_of(source)?;
    let ids: Vec<ClassId> = terms.iter().flatten().map(|term| term.class).collect();
    let costs = Costs::new(&mut classes);
    let selections = costs.selections(&classes, &ids, Some(most));
    let operands = &source.program.operands;
    let forms = selections
        .iter()
        .map(|selection| extract(&mut classes, operands, &known, selection, &terms, None))
        .collect();
    Ok(Found {
        forms,
        limits: classes.reached,
    })
}

fn led_to(mut form: Form<'_>, rule: FormRule, frame: usize) -> Form<'_> {
    form.rules.push(rule);
    form.frame = frame;
    form
}

/// The cheapest form that uses one of some rules, if there is one.
pub(crate) fn by_rules<'a>(source: &Source<'_, 'a>, choices: &Choices) -> Found<'a> {
    let broken = match choices.all.broken {
        Some(Rule::Form(rule)) => Some(rule),
        _ => None,
    };
    let others = others(source).into_iter();
    if let Some((rule, moved)) = { others }.find(|(rule, _)| choices.forms.contains(rule)) {
        let found = cheapest_of(&moved.source(source), 1).unwrap_or_default();
        let forms = found.forms.into_iter();
        let forms = forms.map(|form| led_to(form, rule, 1));
        return Found {
            forms: match broken == Some(rule) {
                true => forms.map(negated).collect(),
                false => forms.collect(),
            },
            limits: Vec::new(),
        };
    }
    let Ok((mut classes, known, terms)) = classes_of(source) else {
        return Found::default();
    };
    let ids: Vec<ClassId> = terms.iter().flatten().map(|term| term.class).collect();
    let costs = Costs::new(&mut classes);
    let operands = &source.program.operands;
    let selections = costs.selections(&classes, &ids, None);
    let mut forms = selections
        .iter()
        .map(|selection| extract(&mut classes, operands, &known, selection, &terms, broken));
    let form = forms.find(|form| form.rules.iter().any(|rule| choices.forms.contains(rule)));
    Found {
        forms: form.into_iter().collect(),
        limits: Vec::new(),
    }
}

/// The negative of a form, as a broken rule gives it.
fn negated(mut form: Form<'_>) -> Form<'_> {
    for wanted in &mut form.wanted {
        *wanted = form.program.push(Step::Negative(*wanted));
    }
    form
}

/// The classes of a program, what is known of them, and the wanted ones.
type Imported<'s, 'a> = (Classes<'s>, Known<'a>, Vec<Option<Term>>);

/// The classes of a program; otherwise the limits for which there are none.
fn classes_of<'a, 's>(source: &Source<'s, 'a>) -> Result<Imported<'s, 'a>, Vec<SearchLimit>> {
    let Source {
        algebra,
        program,
        witness,
        uniform,
        wanted,
    } = *source;
    if program.len() > MOST_STEPS {
        return Err(vec![SearchLimit::Steps]);
    }
    if witness.points().next().is_none() {
        return Err(Vec::new());
    }
    let mut classes = Classes::new(algebra);
    let made = import::import(&mut classes, program, witness, uniform, wanted);
    let made = made.ok_or_else(Vec::new)?;
    rules::saturate(&mut classes);
    let mut known = Known {
        facts: Vec::new(),
        kinds: Vec::new(),
    };
    let is_derived = |kind: &TypeDefinition| {
        let mut roles = kind.coefficients.iter().map(|c| &c.role);
        roles.any(|role| matches!(role, Role::Derived(_)))
    };
    let stated = program.steps().filter_map(|(id, _)| program.kind(id));
    for kind in program.operands.iter().copied().chain(stated) {
        if is_derived(kind) && !known.kinds.iter().any(|other| std::ptr::eq(*other, kind)) {
            known.kinds.push(kind);
        }
    }
    for (id, _) in program.steps() {
        if let Some(term) = made[id.index()]
            && term.factor == crate::algebra::Ratio::ONE
        {
            known.facts.push((term.class, program.stated(id)));
        }
    }
    let terms = wanted.iter().map(|id| made[id.index()]).collect();
    Ok((classes, known, terms))
}
