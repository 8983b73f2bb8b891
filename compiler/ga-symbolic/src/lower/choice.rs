//! Which rules a lowering uses.

use super::{FormRule, InnerRule, JoinRule, MeetRule, ProjectionRule, SandwichRule};
use crate::program::StepId;

/// A rule for each kind of step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// For the action of a versor.
    pub sandwich: SandwichRule,
    /// For outer products of vectors.
    pub join: JoinRule,
    /// For inner products of vectors, and of their outer products.
    pub inner: InnerRule,
    /// For meets of outer products of vectors.
    pub meet: MeetRule,
    /// Whether constant and derived coefficients of steps that are known members of a type are
    /// taken from the type: a moved point has weight 1 again, and its coefficient of infinity is
    /// half its square.
    pub rederive: bool,
    /// Whether derived coefficients of operands keep their constant factors instead of passing them
    /// on.
    pub held: bool,
    /// For the image of a point divided by its weight.
    pub projection: ProjectionRule,
    /// Whether the uniform coefficients of what varies are collected; see
    /// [`Rule::UniformCoefficients`].
    pub staged: bool,
    /// A rule that is broken on purpose, to test that the check of expansions notices it.
    pub broken: Option<Rule>,
}

/// The rules of a program: one choice for all its steps, and steps in which versors act by other
/// rules.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Choices {
    /// The rules of all other steps.
    pub all: Choice,
    /// Steps with rules of their own.
    pub sites: Vec<(StepId, SandwichRule)>,
    /// The rules by which the program was brought into another form first. None leave it as it is.
    pub forms: Vec<FormRule>,
    /// Whether each operation is compiled by itself, with rules of its own.
    pub is_stepwise: bool,
}

impl From<Choice> for Choices {
    fn from(all: Choice) -> Self {
        Self {
            all,
            sites: Vec::new(),
            forms: Vec::new(),
            is_stepwise: false,
        }
    }
}

/// The named identities by which the compiler departs from the plain meaning of a formula. Each is
/// stated and proved where it is implemented.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// A [`SandwichRule`].
    Sandwich(SandwichRule),
    /// A [`JoinRule`].
    Join(JoinRule),
    /// An [`InnerRule`].
    Inner(InnerRule),
    /// A [`MeetRule`].
    Meet(MeetRule),
    /// A [`ProjectionRule`].
    Projection(ProjectionRule),
    /// [`Choice::rederive`].
    Rederive,
    /// A [`FormRule`].
    Form(FormRule),
    /// What varies is written as a sum of monomials whose coefficients depend on uniform operands
    /// alone, by the distributive law; see `passes/coefficients.rs`.
    UniformCoefficients,
}

impl Default for Choice {
    fn default() -> Self {
        Self {
            sandwich: SandwichRule::LeftFirst,
            join: JoinRule::LeftFirst,
            inner: InnerRule::Plain,
            meet: MeetRule::Plain,
            rederive: false,
            held: false,
            projection: ProjectionRule::Division,
            staged: false,
            broken: None,
        }
    }
}

impl From<SandwichRule> for Choice {
    fn from(sandwich: SandwichRule) -> Self {
        Self {
            sandwich,
            ..Self::default()
        }
    }
}

impl Choices {
    /// The rules in words, the plain ones left out.
    #[must_use]
    pub fn names(&self) -> Vec<&'static str> {
        let mut names: Vec<_> = self.forms.iter().map(|rule| rule.name()).collect();
        names.extend(self.all.names());
        let own = self
            .sites
            .iter()
            .filter_map(|(_, rule)| sandwich_name(*rule));
        for name in own {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        if self.is_stepwise {
            names.push("step by step");
        }
        names
    }
}

fn sandwich_name(rule: SandwichRule) -> Option<&'static str> {
    match rule {
        SandwichRule::LeftFirst => None,
        SandwichRule::RightFirst => Some("right first"),
        SandwichRule::UnitCommutator => Some("unit commutator"),
        SandwichRule::LinearMap => Some("linear map"),
        SandwichRule::Split => Some("split"),
        SandwichRule::ReflectionInner => Some("reflection by contraction"),
        SandwichRule::ReflectionOuter => Some("reflection by wedge"),
        SandwichRule::NullImage => Some("null image"),
        SandwichRule::NullImageCommutator => Some("null image by commutator"),
        SandwichRule::ScaledSplit => Some("split with scaling"),
        SandwichRule::ScaledSplitMap => Some("linear map with scaling"),
    }
}

impl Choice {
    /// The rules in words, the plain ones left out.
    #[must_use]
    pub fn names(&self) -> Vec<&'static str> {
        let sandwich = sandwich_name(self.sandwich);
        let join = match self.join {
            JoinRule::LeftFirst => None,
            JoinRule::RightFirst => Some("join right first"),
            JoinRule::Minors => Some("shared minors"),
            JoinRule::Difference => Some("difference"),
        };
        let inner = match self.inner {
            InnerRule::Plain => None,
            InnerRule::Distance => Some("distance"),
            InnerRule::Gram => Some("Gram determinant"),
        };
        let meet = (self.meet == MeetRule::Factors).then_some("meet by factors");
        let rederive = self.rederive.then_some("rederived coefficients");
        let held = self.held.then_some("held factors");
        let projection = match self.projection {
            ProjectionRule::Division => None,
            ProjectionRule::Reciprocal => Some("reciprocal weight"),
            ProjectionRule::Image => Some("image of weight 1"),
        };
        let staged = self.staged.then_some("uniform coefficients");
        [
            sandwich, join, inner, meet, rederive, held, projection, staged,
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}
