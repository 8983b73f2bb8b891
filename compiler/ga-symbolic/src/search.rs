//! Which form of a program, and which rules, make the cheapest graph.
//!
//! Forms come first: those that look cheapest by estimate are lowered by a few rules, and of the
//! cheapest of these all the passes are run. For the form that wins, the kinds of rules are tried
//! one after the other, each with the best rules of the kinds before, since all combinations would
//! be too many. Then rules of single steps in which a versor acts are tried.
//!
//! Lowering is much quicker than the passes. So a graph that was seen before, or that is much
//! larger than that of the best rules so far, does not go through them.

use std::borrow::Cow;
use std::cmp::Ordering;

use rustc_hash::FxHashSet;

use crate::algebra::{NamedBlade, Product, Unary};
use crate::define::{Role, TypeDefinition};
use crate::forms::{self, Form, FormRule};
use crate::kernel::Kernel;
use crate::limit::SearchLimit;
use crate::lower::{Choice, Choices, InnerRule, JoinRule, MeetRule, ProjectionRule, SandwichRule};
use crate::order::Order as _;
use crate::program::{Program, Step, StepId};
use crate::staging::{self, staged};
use crate::stepwise::{Known, Types};
use crate::task::Task;

/// The largest number of actions of versors that may have rules of their own.
const MOST_SITES: usize = 8;

/// How many forms are lowered, and of how many the passes are run.
const MOST_FORMS: usize = 12;
const MOST_FINISHED: usize = 3;

/// How many operations all graphs together may have with which rules are tried.
const MOST_OPERATIONS: usize = 1 << 16;

/// How deep operations are compiled by themselves: those of a function, and those of their forms.
const DEPTH: usize = 2;

/// The rules for actions that are tried together with each rule for what is divided by a weight.
const PROJECTED: [SandwichRule; 2] = [
    SandwichRule::UnitCommutator,
    SandwichRule::NullImageCommutator,
];

/// How often the kinds of rules are gone through.
const MOST_ROUNDS: usize = 3;

impl<'a> Task<'a> {
    /// The kernel by the given rules, or else the one of fewest operations that any rules give; of
    /// equals the first, or the one that works with differences.
    #[must_use]
    pub fn compile(&self) -> Kernel {
        match &self.choices {
            Some(choices) => {
                let other = match choices.forms.as_slice() {
                    [] => None,
                    _ => self.forms(MOST_FORMS, Some(choices)).0.pop(),
                };
                let task = other.as_ref().map_or(self, |other| &other.task);
                let stepwise = match choices.is_stepwise {
                    true => self.stepwise(&[Candidate::as_written(task)], DEPTH, |_| true),
                    false => None,
                };
                stepwise.unwrap_or_else(|| task.by_choices(choices))
            }
            None => self.searched(DEPTH),
        }
    }

    /// The cheapest kernel. The operations of forms are compiled by themselves too, and those of
    /// their forms, up to some depth. An operation costs the same as a function and as a part.
    fn searched(&self, depth: usize) -> Kernel {
        let (forms, limits) = self.forms(MOST_FORMS, None);
        let found = cheapest(self, forms.clone(), limits);
        let depth = match is_one_operation(&self.program, &self.wanted) {
            true => depth.min(DEPTH - 1),
            false => depth,
        };
        if depth == 0 || self.is_one_operation {
            return found;
        }
        // Where the search was complete, operations are compiled one by one only if they are
        // cheaper before their graphs are merged. Otherwise other spellings of the same, which have
        // other operations, would cost more.
        let is_complete = !found.limits.iter().any(|limit| limit.is_cut());
        let mut tasks = vec![Candidate::as_written(self)];
        tasks.extend(forms);
        let is_accepted = |price| !is_complete || price < found.rank();
        match self.stepwise(&tasks, depth, is_accepted) {
            Some(kernel) if kernel.rank() < found.rank() => Kernel {
                limits: found.limits,
                ..kernel
            },
            _ => found,
        }
    }

    /// The kernel of one of some forms with each operation compiled by itself: of the form whose
    /// operations cost least together, if that is accepted.
    fn stepwise(
        &self,
        forms: &[Candidate<'a>],
        depth: usize,
        is_accepted: impl Fn((usize, usize)) -> bool,
    ) -> Option<Kernel> {
        let given = self
            .witness
            .filter(|witness| witness.points().next().is_some())?;
        let mut types = Types::new(self);
        let mut found = Vec::new();
        for Candidate { task, rules, .. } in forms {
            let witness = given.of_other(self.algebra, &task.program);
            let operations = witness.and_then(|witness| types.operations(task, &witness));
            found.extend(operations.map(|operations| (task, rules, operations)));
        }
        let compile = |task: &Task<'_>| task.searched(depth - 1);
        let mut known = Known::default();
        let compiled = found.iter().map(|(task, rules, operations)| {
            let stepwise = types.compiled(task, operations, &mut known, compile);
            (stepwise, *task, *rules)
        });
        let (stepwise, task, rules) = compiled.min_by_key(|(stepwise, ..)| stepwise.price)?;
        if !is_accepted(stepwise.price) {
            return None;
        }
        let choices = Choices {
            is_stepwise: true,
            forms: rules.clone(),
            ..Choices::default()
        };
        Some(task.optimised(task.with_pieces(&choices, &stepwise.pieces)))
    }

    /// The kernel by some rules.
    fn by_choices(&self, choices: &Choices) -> Kernel {
        let staged = match choices.all.staged {
            true => staging::cheapest(self.staged(self.lowered(choices))),
            false => None,
        };
        staged.unwrap_or_else(|| self.optimised(self.lowered(choices)))
    }

    /// Tasks for other forms of the program, with the rules that lead to them; with choices, for
    /// those that their rules lead to. Also the limits that were reached.
    fn forms(
        &self,
        most: usize,
        choices: Option<&Choices>,
    ) -> (Vec<Candidate<'a>>, Vec<SearchLimit>) {
        let Some(witness) = self.witness else {
            return Default::default();
        };
        let steps: Vec<StepId> = self.wanted.iter().map(|(step, _)| *step).collect();
        let source = forms::Source {
            algebra: self.algebra,
            program: &self.program,
            witness,
            uniform: &self.uniform,
            wanted: &steps,
        };
        let found = match choices {
            None => forms::cheapest(&source, most),
            Some(choices) => forms::by_rules(&source, choices),
        };
        let task = |form: Form<'a>| {
            let wanted = form.wanted.iter().zip(&self.wanted);
            let wanted = wanted.map(|(step, (_, blades))| (*step, blades.clone()));
            let task = Task {
                wanted: wanted.collect(),
                program: Cow::Owned(form.program),
                witness: None,
                ..self.clone()
            };
            Candidate {
                task,
                rules: form.rules,
                frame: form.frame,
            }
        };
        (found.forms.into_iter().map(task).collect(), found.limits)
    }
}

/// A task for another form of a program.
#[derive(Clone)]
struct Candidate<'a> {
    task: Task<'a>,
    /// The rules that lead to it.
    rules: Vec<FormRule>,
    /// From which point it is seen.
    frame: usize,
}

impl<'a> Candidate<'a> {
    fn as_written(task: &Task<'a>) -> Self {
        Self {
            task: task.clone(),
            rules: Vec::new(),
            frame: 0,
        }
    }
}

/// The cheapest kernel of some forms of a task.
fn cheapest<'a>(
    task: &Task<'a>,
    mut forms: Vec<Candidate<'a>>,
    limits: Vec<SearchLimit>,
) -> Kernel {
    // Of a long program there may be no form as cheap as it is as it is written.
    if forms.is_empty() || limits.iter().any(|limit| limit.is_cut()) {
        forms.push(Candidate::as_written(task));
    }
    let best = match forms.len() {
        1 => forms,
        _ => cheapest_forms(forms),
    };
    let kernels = best.into_iter().map(|best| {
        let mut kernel = by_best_choices(&best.task);
        kernel.choices.forms = best.rules;
        kernel
    });
    let mut kernel = kernels.min_by_key(Kernel::rank).expect("a form");
    // A form that is cheap as it is may hide that terms vanish when coefficients are collected.
    if !kernel.choices.forms.is_empty() {
        kernel = staged(task, kernel);
    }
    kernel.limits.extend(limits);
    kernel.limits.order();
    kernel.limits.dedup();
    kernel
}

/// The form that gives the cheapest graph by some common rules; where that is seen from a point,
/// also the cheapest that is not, which other rules may make cheaper yet.
fn cheapest_forms(forms: Vec<Candidate<'_>>) -> Vec<Candidate<'_>> {
    let mut lowered: Vec<_> = forms
        .into_iter()
        .filter_map(|form| {
            let tried = common_choices(&form.task).into_iter().map(|choices| {
                let graph = form.task.lowered(&choices);
                (graph.rank(), graph)
            });
            let (rank, graph) = tried.min_by_key(|(rank, _)| *rank)?;
            Some((rank, graph, form))
        })
        .collect();
    lowered.order_by_key(|(rank, ..)| *rank);
    let mut seen = FxHashSet::default();
    lowered.retain(|(_, graph, _)| seen.insert(graph.fingerprint()));
    // Of each frame the first besides, since terms may only cancel in the passes.
    let mut frames = FxHashSet::default();
    let mut number = 0;
    lowered.retain(|(.., form)| {
        number += 1;
        frames.insert(form.frame) || number <= MOST_FINISHED
    });
    let limit = lowered.first().map_or(0, |(rank, ..)| rank.0 + rank.0 / 2);
    let mut has_written = false;
    let mut is_first_as_written =
        |form: &Candidate<'_>| form.frame == 0 && !std::mem::replace(&mut has_written, true);
    let finished = lowered
        .into_iter()
        .filter(|(rank, _, form)| rank.0 <= limit || is_first_as_written(form))
        .map(|(_, graph, form)| {
            let kernel = staged(&form.task, form.task.optimised(graph));
            (kernel.rank(), form)
        });
    let mut finished: Vec<_> = finished.collect();
    finished.order_by_key(|(rank, _)| *rank);
    let mut finished = finished.into_iter();
    let Some((_, first)) = finished.next() else {
        return Vec::new();
    };
    let as_written = finished.find(|(_, form)| first.frame != 0 && form.frame == 0);
    let others = as_written.map(|(_, form)| form);
    std::iter::once(first).chain(others).collect()
}

/// Rules that are tried to compare forms.
fn common_choices(task: &Task<'_>) -> Vec<Choices> {
    let rederive = task.program.has_kinds();
    let sandwich = if has_sandwich(&task.program) {
        &SandwichRule::ALL[..]
    } else {
        &SandwichRule::ALL[..1]
    };
    sandwich
        .iter()
        .map(|&sandwich| {
            let choice = Choice {
                sandwich,
                rederive,
                join: JoinRule::Difference,
                inner: InnerRule::Distance,
                ..Choice::default()
            };
            choice.into()
        })
        .collect()
}

fn by_best_choices(task: &Task<'_>) -> Kernel {
    let first = task.lowered(&Choices::default());
    let mut search = Search {
        task,
        tried: vec![Choices::default()],
        seen: FxHashSet::from_iter([first.fingerprint()]),
        size: first.rank().0,
        acted: first.acted.clone(),
        best: task.optimised(first),
        is_limited: false,
        effort: 0,
    };
    // A rule may pay only together with one that is tried later.
    for _ in 0..MOST_ROUNDS {
        let before = search.best.rank();
        search.improve_kinds();
        search.improve_sites();
        if search.best.rank() == before {
            break;
        }
    }
    let is_limited = search.is_limited;
    let mut kernel = staged(task, search.best);
    if is_limited {
        kernel.limits.push(SearchLimit::Rules);
    }
    kernel
}

struct Search<'t, 'a> {
    task: &'t Task<'a>,
    best: Kernel,
    acted: Vec<StepId>,
    /// The rules that were tried.
    tried: Vec<Choices>,
    /// The graphs that went through the passes, or were too large.
    seen: FxHashSet<u64>,
    /// The operations of each call in the graph of the best kernel before the passes.
    size: usize,
    /// The operations of all graphs that were lowered so far.
    effort: usize,
    /// Whether rules were left out since these were too many.
    is_limited: bool,
}

impl Search<'_, '_> {
    /// Tries the kinds of rules one after the other.
    fn improve_kinds(&mut self) {
        let program = &*self.task.program;
        if has_sandwich(program) {
            for sandwich in SandwichRule::ALL {
                self.improve(|choice| choice.sandwich = sandwich);
            }
        }
        let has_quotient = program
            .steps()
            .any(|(_, step)| matches!(step, Step::Quotient(..)));
        if has_quotient {
            // Which action is cheapest depends on what it is divided by.
            for projection in ProjectionRule::ALL {
                self.improve(|choice| choice.projection = projection);
                for sandwich in PROJECTED {
                    if has_sandwich(program) && projection != ProjectionRule::Division {
                        self.improve(|choice| {
                            choice.projection = projection;
                            choice.sandwich = sandwich;
                        });
                    }
                }
            }
        }
        if has_product(program, &[Product::Wedge]) {
            for join in JoinRule::ALL {
                self.improve(|choice| choice.join = join);
            }
        }
        let inner = [
            Product::LeftContraction,
            Product::RightContraction,
            Product::ScalarProduct,
        ];
        if has_product(program, &inner) {
            for inner in InnerRule::ALL {
                self.improve(|choice| choice.inner = inner);
            }
        }
        if has_product(program, &[Product::Vee, Product::LeftContraction])
            && has_product(program, &[Product::Wedge])
        {
            for meet in MeetRule::ALL {
                self.improve(|choice| choice.meet = meet);
            }
        }
        if program.has_kinds() {
            self.improve(|choice| choice.rederive = !choice.rederive);
            for sandwich in SandwichRule::ALL {
                self.improve(|choice| {
                    choice.rederive = true;
                    choice.sandwich = sandwich;
                });
            }
        }
        if program.operands.iter().any(is_derived) {
            self.improve(|choice| choice.held = true);
        }
    }

    fn improve(&mut self, change: impl Fn(&mut Choice)) {
        let mut choices = self.best.choices.clone();
        change(&mut choices.all);
        self.try_choices(&choices);
    }

    fn improve_sites(&mut self) {
        if !(2..=MOST_SITES).contains(&self.acted.len()) {
            return;
        }
        for site in self.acted.clone() {
            for rule in SandwichRule::ALL {
                let mut choices = self.best.choices.clone();
                choices.sites.retain(|(other, _)| *other != site);
                if rule != choices.all.sandwich {
                    choices.sites.push((site, rule));
                }
                self.try_choices(&choices);
            }
        }
    }

    /// Takes other rules if they make a cheaper graph. Of equals, rules that work with differences
    /// are preferred, since they round less.
    fn try_choices(&mut self, choices: &Choices) {
        if self.tried.contains(choices) {
            return;
        }
        if self.effort > MOST_OPERATIONS {
            self.is_limited = true;
            return;
        }
        self.tried.push(choices.clone());
        let lowered = self.task.lowered(choices);
        self.effort += lowered.rank().1;
        let size = lowered.rank().0;
        if !self.seen.insert(lowered.fingerprint()) || size > self.size + self.size / 3 + 8 {
            return;
        }
        let acted = lowered.acted.clone();
        let next = self.task.optimised(lowered);
        let is_exacter = |choice: Choice| {
            choice.inner != InnerRule::Plain || choice.join == JoinRule::Difference
        };
        let is_better = match next.rank().cmp(&self.best.rank()) {
            Ordering::Less => true,
            Ordering::Equal => is_exacter(choices.all) && !is_exacter(self.best.choices.all),
            Ordering::Greater => false,
        };
        if is_better {
            (self.best, self.acted, self.size) = (next, acted, size);
        }
    }
}

/// Whether a program is one operation on its operands, as it is written.
fn is_one_operation(program: &Program<'_>, wanted: &[(StepId, Vec<NamedBlade>)]) -> bool {
    let is_given =
        |id: &StepId| program.is_constant(*id) || matches!(program.step(*id), Step::Operand(_));
    let [(result, _)] = wanted else { return false };
    program.operands_of(*result).iter().all(is_given)
}

/// Whether a program has an action of a versor, or a product that may be one.
fn has_sandwich(program: &Program<'_>) -> bool {
    program
        .steps()
        .any(|(_, step)| matches!(step, Step::Sandwich(..) | Step::Unary(Unary::Reverse, _)))
}

/// Whether a program has one of some products.
fn has_product(program: &Program<'_>, products: &[Product]) -> bool {
    program
        .steps()
        .any(|(_, step)| matches!(step, Step::Binary(product, ..) if products.contains(product)))
}

fn is_derived(kind: &&TypeDefinition) -> bool {
    let mut roles = kind.coefficients.iter().map(|c| &c.role);
    roles.any(|role| matches!(role, Role::Derived(_)))
}
