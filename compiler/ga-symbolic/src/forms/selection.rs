//! Which way is taken to each class: by estimates of the cost, first one class after the other,
//! then with single changes.

use super::class::{ClassId, Operation};
use super::classes::Classes;
use super::estimate::Estimates;
use super::{FormRule, rules};
use crate::algebra::{Product, Ratio};
use crate::order::Order as _;

/// By how much a product of images that takes differences of them counts more.
pub(super) const IMAGES: usize = 16;

/// Whether an operation is an outer product or a commutator of images that have a weight in common.
fn is_rounded(classes: &Classes<'_>, operation: &Operation) -> bool {
    let Operation::Product(Product::Wedge | Product::Commutator, factors) = operation else {
        return false;
    };
    let is_image = |id: &ClassId| {
        let class = classes.class(*id);
        !class.is_constant && classes.has_action(*id)
    };
    let images: Vec<ClassId> = factors.iter().copied().filter(is_image).collect();
    rules::cancels(classes, &images)
}

/// Which way is taken to each class.
#[derive(Clone, PartialEq, Eq)]
pub(super) struct Selection {
    /// The place of the way in its class; for classes that are not needed, any place.
    pub(super) ways: Vec<usize>,
    /// The needed classes, each after what it reads.
    pub(super) order: Vec<ClassId>,
    pub(super) cost: usize,
}

/// The costs of all ways.
pub(super) struct Costs {
    pub(super) own: Vec<Vec<usize>>,
    /// Whether a way takes differences of rounded images, though the whole can be moved.
    pub(super) rounded: Vec<Vec<bool>>,
    /// The cheapest way to each class, and its cost as a tree.
    pub(super) best: Vec<(usize, usize)>,
}

impl Costs {
    pub(super) fn new(classes: &mut Classes<'_>) -> Self {
        let mut estimates = Estimates::new(classes);
        let (mut own, mut rounded) = (Vec::new(), Vec::new());
        for id in classes.ids() {
            let operations: Vec<(Operation, Ratio)> = classes
                .class(id)
                .ways
                .iter()
                .map(|way| (way.operation.clone(), way.factor))
                .collect();
            let costs: Vec<usize> = operations
                .iter()
                .map(|(operation, factor)| {
                    let scale = usize::from(factor.abs() != Ratio::ONE);
                    estimates.cost(classes, id, operation) + scale
                })
                .collect();
            own.push(costs);
            let is_moved = classes.has_action(id);
            let operations = operations.iter();
            let of =
                |(operation, _): &(Operation, Ratio)| is_moved && is_rounded(classes, operation);
            rounded.push(operations.map(of).collect::<Vec<bool>>());
        }
        let mut best = vec![(0, usize::MAX); classes.len()];
        loop {
            let mut has_changed = false;
            for id in classes.ids() {
                for (place, way) in classes.class(id).ways.iter().enumerate() {
                    let mut cost = own[id.index()][place];
                    if rounded[id.index()][place] {
                        cost = cost.saturating_mul(IMAGES);
                    }
                    for read in way.operation.reads() {
                        cost = cost.saturating_add(best[read.index()].1);
                    }
                    if cost < best[id.index()].1 {
                        best[id.index()] = (place, cost);
                        has_changed = true;
                    }
                }
            }
            if !has_changed {
                return Self { own, rounded, best };
            }
        }
    }

    /// The selection that departs from the cheapest ways in some classes; `None` where it goes in a
    /// circle.
    fn select(
        &self,
        classes: &Classes<'_>,
        wanted: &[ClassId],
        others: &[(ClassId, usize)],
    ) -> Option<Selection> {
        let mut ways: Vec<usize> = self.best.iter().map(|(place, _)| *place).collect();
        for (id, place) in others {
            ways[id.index()] = *place;
        }
        self.settled(classes, wanted, ways)
    }

    /// The selection of some ways. Images of which differences are taken are computed by moved
    /// differences, where there is a way to that.
    fn settled(
        &self,
        classes: &Classes<'_>,
        wanted: &[ClassId],
        ways: Vec<usize>,
    ) -> Option<Selection> {
        let selection = self.visited(classes, wanted, ways)?;
        let mut ways = selection.ways.clone();
        for id in &selection.order {
            let place = ways[id.index()];
            if self.rounded[id.index()][place]
                && let Some(exact) =
                    by_differences(classes, &classes.class(*id).ways[place].operation)
            {
                for (id, place) in exact {
                    ways[id.index()] = place;
                }
            }
        }
        if ways == selection.ways {
            return Some(selection);
        }
        Some(self.visited(classes, wanted, ways).unwrap_or(selection))
    }

    fn visited(
        &self,
        classes: &Classes<'_>,
        wanted: &[ClassId],
        ways: Vec<usize>,
    ) -> Option<Selection> {
        let mut order = Vec::new();
        let mut states = vec![State::New; classes.len()];
        let mut cost = 0;
        for &id in wanted {
            self.visit(classes, &ways, id, &mut states, &mut order, &mut cost)?;
        }
        for id in &order {
            let place = ways[id.index()];
            if !self.rounded[id.index()][place] {
                continue;
            }
            let exact = by_differences(classes, &classes.class(*id).ways[place].operation);
            let is_exact = |(id, place): &(ClassId, usize)| ways[id.index()] == *place;
            if !exact.is_some_and(|exact| exact.iter().all(is_exact)) {
                cost += (IMAGES - 1) * self.own[id.index()][place];
            }
        }
        Some(Selection { ways, order, cost })
    }

    fn visit(
        &self,
        classes: &Classes<'_>,
        ways: &[usize],
        id: ClassId,
        states: &mut [State],
        order: &mut Vec<ClassId>,
        cost: &mut usize,
    ) -> Option<()> {
        match states[id.index()] {
            State::Done => return Some(()),
            State::Open => return None,
            State::New => {}
        }
        states[id.index()] = State::Open;
        let place = ways[id.index()];
        let way = classes.class(id).ways.get(place)?;
        for read in way.operation.reads() {
            self.visit(classes, ways, read, states, order, cost)?;
        }
        *cost += self.own[id.index()][place];
        states[id.index()] = State::Done;
        order.push(id);
        Some(())
    }

    /// The selections that look cheapest, the best first: all, or a given number that differ.
    pub(super) fn selections(
        &self,
        classes: &Classes<'_>,
        wanted: &[ClassId],
        most: Option<usize>,
    ) -> Vec<Selection> {
        let Some(mut best) = self.select(classes, wanted, &[]) else {
            return Vec::new();
        };
        let mut found: Vec<Selection> = vec![best.clone()];
        if let Some(next) = self.settled(classes, wanted, self.shared(classes)) {
            if next.cost < best.cost {
                best = next.clone();
            }
            found.push(next);
        }
        for _ in 0..4 {
            let start = best.clone();
            for next in self.neighbours(classes, wanted, &start) {
                if next.cost < best.cost {
                    best = next.clone();
                }
                if !found.iter().any(|other| other.is_same(&next)) {
                    found.push(next);
                }
            }
            if best.cost == start.cost {
                break;
            }
        }
        let least = best.cost;
        found.retain(|selection| selection.cost <= least + least);
        found.order_by_key(|selection| selection.cost);
        let Some(most) = most else { return found };
        // Of forms that differ in the grouping of products only, the first.
        let mut seen: Vec<Vec<Operation>> = Vec::new();
        found.retain(|selection| {
            let next = selection.operations(classes);
            let is_new = !seen.contains(&next);
            if is_new {
                seen.push(next);
            }
            is_new
        });
        found.truncate(most);
        found
    }

    /// The selections that differ in one class.
    fn neighbours(
        &self,
        classes: &Classes<'_>,
        wanted: &[ClassId],
        from: &Selection,
    ) -> Vec<Selection> {
        let mut found = Vec::new();
        for &id in &from.order {
            for place in 0..classes.class(id).ways.len() {
                if place == from.ways[id.index()] {
                    continue;
                }
                let mut ways = from.ways.clone();
                ways[id.index()] = place;
                found.extend(self.settled(classes, wanted, ways));
            }
        }
        found
    }
}

/// The ways to the images in a product, all but the first, by which they are sums of the first and
/// of moved differences; `None` where there is no such way to one of them.
fn by_differences(classes: &Classes<'_>, operation: &Operation) -> Option<Vec<(ClassId, usize)>> {
    let Operation::Product(Product::Wedge, factors) = operation else {
        return None;
    };
    let images = rules::Images::of(classes, factors)?;
    let place = |id: ClassId| {
        let mut ways = classes.class(id).ways.iter();
        ways.position(|way| {
            let reads = way.operation.reads();
            way.rule == Some(FormRule::Difference) && reads.contains(&images.first)
        })
    };
    let others = images.others.iter();
    others.map(|(id, _)| Some((*id, place(*id)?))).collect()
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    New,
    Open,
    Done,
}

impl Selection {
    /// The operations in the order of their classes, with all factors of associative products
    /// together, however they are grouped. A group that is read twice is a factor.
    fn operations(&self, classes: &Classes<'_>) -> Vec<Operation> {
        let mut order = self.order.clone();
        order.order();
        let operation = |id: ClassId| &classes.class(id).ways[self.ways[id.index()]].operation;
        let associative = |id: ClassId| match operation(id) {
            Operation::Product(product @ (Product::Geometric | Product::Wedge), factors) => {
                Some((*product, factors))
            }
            _ => None,
        };
        let mut readers = vec![0_usize; self.ways.len()];
        let mut is_inner = vec![false; self.ways.len()];
        for id in &order {
            for read in operation(*id).reads() {
                readers[read.index()] += 1;
            }
            if let Some((product, factors)) = associative(*id) {
                for factor in factors {
                    let inner = associative(*factor);
                    is_inner[factor.index()] = inner.is_some_and(|(p, _)| p == product);
                }
            }
        }
        for (is_inner, readers) in is_inner.iter_mut().zip(readers) {
            *is_inner &= readers == 1;
        }
        let mut operations = Vec::new();
        for &id in order.iter().filter(|id| !is_inner[id.index()]) {
            let Some((product, factors)) = associative(id) else {
                operations.push(operation(id).clone());
                continue;
            };
            let mut flat = Vec::new();
            let mut open: Vec<ClassId> = factors.iter().rev().copied().collect();
            while let Some(next) = open.pop() {
                match associative(next) {
                    Some((_, factors)) if is_inner[next.index()] => {
                        open.extend(factors.iter().rev());
                    }
                    _ => flat.push(next),
                }
            }
            operations.push(Operation::Product(product, flat));
        }
        operations
    }

    fn is_same(&self, other: &Self) -> bool {
        let ways = |selection: &Self| -> Vec<(ClassId, usize)> {
            let mut ways: Vec<_> = selection
                .order
                .iter()
                .map(|id| (*id, selection.ways[id.index()]))
                .collect();
            ways.order();
            ways
        };
        self.cost == other.cost && ways(self) == ways(other)
    }
}
