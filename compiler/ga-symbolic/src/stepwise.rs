//! Programs step by step: every operation as it is written becomes a graph of its own, which is
//! optimised for the types of its operands, and these graphs are put together.
//!
//! What is bound to a name is computed once, and no step costs more than the same operation as a
//! function by itself. So this is the bound of what any program costs, whatever the search for
//! other forms finds. Equal operations on equal types share a graph, and the time is linear in the
//! length of the program.

use crate::order::Order as _;
use std::rc::Rc;

use proc_macro2::{Ident, Span};
use rustc_hash::FxHashMap;

use crate::algebra::{Algebra, Blade};
use crate::define::{Coefficient, Role, TypeDefinition};
use crate::ir::{Arena, Facts, Value};
use crate::kernel::{self, Kernel};
use crate::lower::{Piece, Pieces};
use crate::program::build::Builder;
use crate::program::{Program, Step, StepId, Witness};
use crate::task::Task;

/// The greatest number of steps of one operation.
const LONGEST: usize = 64;

/// The types of the steps of some programs.
pub(crate) struct Types<'a> {
    algebra: &'a Algebra,
    scalar: TypeDefinition,
    declared: &'a [TypeDefinition],
    operands: Vec<&'a TypeDefinition>,
    /// Types that are not declared, for values that are members of none that is.
    made: Vec<TypeDefinition>,
    by_blades: FxHashMap<Vec<Blade>, usize>,
}

/// A type of steps.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Kind {
    Scalar,
    /// That of an operand, by its number.
    Operand(usize),
    Declared(usize),
    Made(usize),
}

/// The operations of a program.
pub(crate) struct Operations {
    /// The types of the steps that operations read or give.
    kinds: FxHashMap<StepId, Kind>,
    /// The types by which some of them are declared, where these are others.
    written: FxHashMap<StepId, Kind>,
    /// For each step, whether it depends on uniform operands alone.
    uniform: Vec<bool>,
    /// The results of the operations, each after what it reads.
    order: Vec<StepId>,
}

/// The types of steps, and others that go before.
#[derive(Clone, Copy)]
struct Typing<'k>(
    &'k FxHashMap<StepId, Kind>,
    Option<&'k FxHashMap<StepId, Kind>>,
);

impl Typing<'_> {
    fn of(self, id: StepId) -> Kind {
        let other = self.1.and_then(|others| others.get(&id));
        other.copied().unwrap_or_else(|| self.0[&id])
    }
}

/// An operation by itself. Equal ones have equal graphs.
#[derive(PartialEq, Eq, Hash)]
struct Operation {
    steps: Vec<Step>,
    /// The types of the operands, and whether they are uniform.
    operands: Vec<(Kind, bool)>,
    result: Kind,
}

/// The operations of a program, compiled.
pub(crate) struct Stepwise<'o> {
    pub(crate) pieces: Pieces<'o>,
    /// What they cost together, each by itself: the operations of each call, then those of the
    /// prologue.
    pub(crate) price: (usize, usize),
}

/// The graph of an operation, and what it costs.
#[derive(Clone)]
struct Graph {
    graph: Rc<(Arena, Vec<Value>)>,
    price: (usize, usize),
}

/// Operations that were compiled; none where one has no value for all members of the types of its
/// operands, or its numbers are out of range.
#[derive(Default)]
pub(crate) struct Known(FxHashMap<Operation, Option<Graph>>);

impl<'a> Types<'a> {
    /// No types but those of a task.
    pub(crate) fn new(task: &Task<'a>) -> Self {
        Self {
            algebra: task.algebra,
            scalar: TypeDefinition::scalar(),
            declared: task.types,
            operands: task.program.operands.clone(),
            made: Vec::new(),
            by_blades: FxHashMap::default(),
        }
    }

    /// The operations that the wanted steps of a task need; none where there is only one.
    pub(crate) fn operations(&mut self, task: &Task<'a>, witness: &Witness) -> Option<Operations> {
        let program = &*task.program;
        let mut is_needed = vec![false; program.len()];
        for (id, _) in &task.wanted {
            is_needed[id.index()] = true;
        }
        for (id, _) in program.steps().rev() {
            if is_needed[id.index()] {
                for read in program.operands_of(id) {
                    is_needed[read.index()] = true;
                }
            }
        }
        let mut by_place: FxHashMap<*const TypeDefinition, Kind> = FxHashMap::default();
        for (number, kind) in self.operands.iter().enumerate().rev() {
            by_place.insert(std::ptr::from_ref(*kind), Kind::Operand(number));
        }
        for (place, kind) in self.declared.iter().enumerate() {
            by_place.insert(std::ptr::from_ref(kind), Kind::Declared(place));
        }
        let mut operations = Operations {
            kinds: FxHashMap::default(),
            written: FxHashMap::default(),
            uniform: uniform_steps(task),
            order: Vec::new(),
        };
        for (id, step) in program.steps().filter(|(id, _)| is_needed[id.index()]) {
            let kind = match step {
                Step::Operand(number) => {
                    let kind = std::ptr::from_ref(program.operands[*number]);
                    by_place.get(&kind).copied()
                }
                Step::Function(function, _) if function.is_condition() => None,
                _ if program.is_constant(id) => None,
                _ => self.kind(id, witness),
            };
            let Some(kind) = kind else { continue };
            operations.kinds.insert(id, kind);
            if let Some(written) = program.written(id)
                && let Some(other) = by_place.get(&std::ptr::from_ref(written))
                && *other != kind
            {
                operations.written.insert(id, *other);
            }
            let mut reads = operands(program, id).into_iter();
            let is_typed = |id: StepId| operations.kinds.contains_key(&id);
            if !matches!(step, Step::Operand(_)) && reads.all(is_typed) {
                operations.order.push(id);
            }
        }
        (operations.order.len() > 1).then_some(operations)
    }

    /// Of the declared types the smallest that a step is always a member of, those with facts
    /// first; or else one of its blades; none of zero.
    fn kind(&mut self, id: StepId, witness: &Witness) -> Option<Kind> {
        let blades = witness.blades(id);
        if blades.is_empty() {
            return None;
        }
        if blades == [Blade::SCALAR] {
            return Some(Kind::Scalar);
        }
        let is_member = |kind: &TypeDefinition| {
            let mut blades = blades.iter();
            kind.parameters.is_none()
                && blades.all(|blade| kind.coefficient(*blade).is_some())
                && witness.is_member(self.algebra, id, kind)
        };
        // The smallest come first, since it takes long to see whether a value is a member.
        let mut types: Vec<_> = self.declared.iter().enumerate().collect();
        types.order_by_key(|(_, kind)| (kind.stored().count(), kind.is_linear()));
        if let Some((place, _)) = types.into_iter().find(|(_, kind)| is_member(kind)) {
            return Some(Kind::Declared(place));
        }
        let made = &mut self.made;
        let place = *self.by_blades.entry(blades).or_insert_with_key(|blades| {
            made.push(of_blades(blades));
            made.len() - 1
        });
        Some(Kind::Made(place))
    }

    fn definition(&self, kind: Kind) -> &TypeDefinition {
        match kind {
            Kind::Scalar => &self.scalar,
            Kind::Operand(number) => self.operands[number],
            Kind::Declared(place) => &self.declared[place],
            Kind::Made(place) => &self.made[place],
        }
    }

    /// The operations of a task's program, compiled one by one.
    pub(crate) fn compiled(
        &self,
        task: &Task<'_>,
        operations: &Operations,
        known: &mut Known,
        compile: impl Fn(&Task<'_>) -> Kernel,
    ) -> Stepwise<'_> {
        let mut stepwise = Stepwise {
            pieces: Pieces::default(),
            price: (0, 0),
        };
        for &id in &operations.order {
            let reads = operands(&task.program, id);
            // A smaller type than the declared one is nearly always cheaper.
            let mut typings = vec![Typing(&operations.kinds, None)];
            if reads
                .iter()
                .chain([&id])
                .any(|id| operations.written.contains_key(id))
            {
                typings.push(Typing(&operations.kinds, Some(&operations.written)));
            }
            let pieces = typings.into_iter().filter_map(|typing| {
                let operation = self.operation(&task.program, operations, typing, id, &reads)?;
                let graph = match known.0.get(&operation) {
                    Some(graph) => graph.clone(),
                    None => {
                        let graph = self.graph(&operation, &compile);
                        known.0.insert(operation, graph.clone());
                        graph
                    }
                };
                let Graph { graph, price } = graph?;
                let typed = |id: &StepId| (*id, self.definition(typing.of(*id)));
                let piece = Piece {
                    operands: reads.iter().map(typed).collect(),
                    kind: self.definition(typing.of(id)),
                    graph,
                };
                Some((price, piece))
            });
            if let Some((price, piece)) = pieces.min_by_key(|(price, _)| *price) {
                stepwise.price.0 += price.0;
                stepwise.price.1 += price.1;
                stepwise.pieces.insert(id, piece);
            }
        }
        stepwise
    }

    /// An operation by itself; none where it reads more than its operands.
    fn operation(
        &self,
        whole: &Program<'_>,
        operations: &Operations,
        typing: Typing<'_>,
        id: StepId,
        operands: &[StepId],
    ) -> Option<Operation> {
        let kinds = operands.iter().map(|id| typing.of(*id));
        let kinds: Vec<Kind> = kinds.collect();
        let types: Vec<_> = kinds.iter().map(|kind| self.definition(*kind)).collect();
        let mut program = Program::new(&types);
        let mut images: FxHashMap<StepId, StepId> = FxHashMap::default();
        for (operand, (image, _)) in operands.iter().zip(program.steps()) {
            images.insert(*operand, image);
        }
        let mut inner = Vec::new();
        let mut open = vec![id];
        while let Some(next) = open.pop() {
            if images.contains_key(&next) || inner.contains(&next) {
                continue;
            }
            if matches!(whole.step(next), Step::Operand(_)) || inner.len() == LONGEST {
                return None;
            }
            inner.push(next);
            open.extend(whole.step(next).reads());
        }
        inner.order();
        for id in inner {
            let step = whole.step(id).mapped(|read| images[&read]);
            images.insert(id, program.push(step));
        }
        let is_uniform = operands.iter().map(|id| operations.uniform[id.index()]);
        Some(Operation {
            steps: program.steps().map(|(_, step)| step.clone()).collect(),
            operands: kinds.into_iter().zip(is_uniform).collect(),
            result: typing.of(id),
        })
    }

    fn graph(&self, operation: &Operation, compile: impl Fn(&Task<'_>) -> Kernel) -> Option<Graph> {
        let algebra = self.algebra;
        let operands = operation.operands.iter();
        let (types, uniform): (Vec<_>, Vec<bool>) = operands
            .map(|(kind, is_uniform)| (self.definition(*kind), *is_uniform))
            .unzip();
        let mut builder = Builder {
            algebra,
            program: Program::new(&types),
            witness: Witness::default(),
            operands: Vec::new(),
        };
        if !builder.witness.extend(algebra, &builder.program) {
            return None;
        }
        let mut result = None;
        for step in &operation.steps[types.len()..] {
            result = Some(builder.push(step.clone()).ok()?);
        }
        let result = result?;
        let kind = self.definition(operation.result);
        let is_declared = matches!(operation.result, Kind::Declared(_));
        if is_declared && builder.witness.is_member(algebra, result, kind) {
            builder.program.state(result, kind.facts);
            let mut roles = kind.coefficients.iter().map(|c| &c.role);
            if roles.any(|role| matches!(role, Role::Derived(_))) {
                builder.program.state_kind(result, kind);
            }
        }
        let wanted = vec![(result, kernel::wanted(Some(kind)))];
        let task = Task::of_program(algebra, &builder.program, wanted)
            .with_uniform(&uniform)
            .with_witness(&builder.witness)
            .with_types(self.declared);
        let kernel = compile(&task);
        (!kernel.is_out_of_range()).then(|| Graph {
            price: kernel.rank(),
            graph: Rc::new((kernel.arena, kernel.outputs)),
        })
    }
}

/// The operands of an operation, constants left out, each once.
fn operands(program: &Program<'_>, id: StepId) -> Vec<StepId> {
    let mut operands = Vec::new();
    for read in program.operands_of(id) {
        if !operands.contains(&read) && !program.is_constant(read) {
            operands.push(read);
        }
    }
    operands
}

fn uniform_steps(task: &Task<'_>) -> Vec<bool> {
    let mut uniform: Vec<bool> = Vec::with_capacity(task.program.len());
    for (_, step) in task.program.steps() {
        let is_uniform = match step {
            Step::Operand(number) => task.uniform[*number],
            _ => step.reads().iter().all(|read| uniform[read.index()]),
        };
        uniform.push(is_uniform);
    }
    if !task.has_uniform() {
        uniform.fill(false);
    }
    uniform
}

/// A type of some blades, of which nothing more is known.
fn of_blades(blades: &[Blade]) -> TypeDefinition {
    let coefficient = |blade: &Blade| Coefficient {
        name: Ident::new("blade", Span::call_site()),
        blade: *blade,
        is_negative: false,
        role: Role::Stored,
    };
    TypeDefinition {
        coefficients: blades.iter().map(coefficient).collect(),
        facts: Facts::default(),
        ..TypeDefinition::scalar()
    }
}
