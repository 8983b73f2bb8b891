//! Which rules make the cheapest graph.
//!
//! The kinds of rules are tried one after the other, each with the best rules of the kinds before,
//! since all combinations would be too many. Then rules of single steps in which a versor acts are
//! tried.

use std::cmp::Ordering;
use std::collections::HashSet;

use crate::algebra::{Product, Unary};
use crate::define::{Role, TypeDefinition};
use crate::kernel::Kernel;
use crate::lower::{Choice, Choices, InnerRule, JoinRule, SandwichRule};
use crate::program::{Program, Step, StepId};
use crate::task::Task;

/// The largest number of actions of versors that may have rules of their own.
const MOST_SITES: usize = 8;

impl Task<'_> {
    /// The kernel by the given rules, or else the one of fewest operations that any rules give; of
    /// equals the first, or the one that works with differences.
    #[must_use]
    pub fn compile(&self) -> Kernel {
        match &self.choices {
            Some(choices) => self.finish(self.draft(choices)),
            None => cheapest(self),
        }
    }
}

fn cheapest(task: &Task<'_>) -> Kernel {
    let draft = task.draft(&Choices::default());
    let mut search = Search {
        task,
        tried: HashSet::from([draft.fingerprint()]),
        acted: draft.acted.clone(),
        best: task.finish(draft),
    };
    let program = &*task.program;
    if has_sandwich(program) {
        for sandwich in SandwichRule::ALL {
            search.improve(|choice| choice.sandwich = sandwich);
        }
    }
    if has_product(program, &[Product::Wedge]) {
        for join in JoinRule::ALL {
            search.improve(|choice| choice.join = join);
        }
    }
    let inner = [
        Product::LeftContraction,
        Product::RightContraction,
        Product::ScalarProduct,
    ];
    if has_product(program, &inner) {
        for inner in InnerRule::ALL {
            search.improve(|choice| choice.inner = inner);
        }
    }
    if program.has_kinds() {
        search.improve(|choice| choice.rederive = true);
        for sandwich in SandwichRule::ALL {
            search.improve(|choice| {
                choice.rederive = true;
                choice.sandwich = sandwich;
            });
        }
    }
    if program.operands.iter().any(is_derived) {
        search.improve(|choice| choice.held = true);
    }
    search.improve_sites();
    search.best
}

struct Search<'t, 'a> {
    task: &'t Task<'a>,
    best: Kernel,
    acted: Vec<StepId>,
    /// The fingerprints of the graphs that were compiled: where a rule does not apply, it gives a
    /// graph that is known.
    tried: HashSet<u64>,
}

impl Search<'_, '_> {
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
        if *choices == self.best.choices {
            return;
        }
        let draft = self.task.draft(choices);
        if !self.tried.insert(draft.fingerprint()) {
            return;
        }
        let acted = draft.acted.clone();
        let next = self.task.finish(draft);
        let is_exacter = |choice: Choice| {
            choice.inner == InnerRule::Distance || choice.join == JoinRule::Difference
        };
        let is_better = match next.rank().cmp(&self.best.rank()) {
            Ordering::Less => true,
            Ordering::Equal => is_exacter(choices.all) && !is_exacter(self.best.choices.all),
            Ordering::Greater => false,
        };
        if is_better {
            (self.best, self.acted) = (next, acted);
        }
    }
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
