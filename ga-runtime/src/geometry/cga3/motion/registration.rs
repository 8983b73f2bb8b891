//! The rotation that takes vectors to vectors, by least squares.

use super::moments::horn;
use crate::cga3::{MotorGenerator, Point, Rotor};
use crate::geometry::FitError;
use crate::geometry::cga3::matrix::{Matrix, solve, symmetric_eigen};
use crate::scalar::Real;
use crate::vga3::Vector;

/// Two vectors, of which the first is to be rotated to the second.
pub(super) struct Pair<S> {
    pub(super) weight: S,
    pub(super) from: Vector<S>,
    pub(super) to: Vector<S>,
}

/// The lengths of the longest first vector and of the longest second vector.
#[derive(Clone, Copy)]
pub(super) struct Sides<S> {
    pub(super) extents: [S; 2],
}

impl<S: Real<Mask = bool>> Sides<S> {
    /// Measures vectors, given the largest numbers from whose differences they were computed; an
    /// error where all first or all second vectors vanish or lie on a line.
    pub(super) fn measured(pairs: &[Pair<S>], largest: [S; 2]) -> Result<Self, FitError<S>> {
        let side = |of: fn(&Pair<S>) -> Vector<S>, largest: S| {
            let rounding = largest * S::epsilon() * S::from_integer(4);
            let longest = pairs
                .iter()
                .map(of)
                .map(|vector| (vector, vector.length()))
                .reduce(|most, next| if most.1.less_than(next.1) { next } else { most });
            let Some((vector, extent)) = longest.filter(|(_, extent)| rounding.less_than(*extent))
            else {
                return Err(FitError::PairsCoincident);
            };
            let along = vector.divided(extent);
            let width = pairs.iter().fold(S::zero(), |most, pair| {
                let unit = of(pair).divided(extent);
                most.max(along.cross(unit).length())
            });
            let thinnest = S::epsilon().sqrt() * S::from_integer(8) + rounding / extent;
            if !thinnest.less_than(width) {
                return Err(FitError::PairsCollinear);
            }
            Ok(extent)
        };
        let extents = [
            side(|pair| pair.from, largest[0])?,
            side(|pair| pair.to, largest[1])?,
        ];
        Ok(Self { extents })
    }
}

/// The rotor R for which `Σ w |y − R x|²` is least, which is where `Σ w y·R x` is largest.
pub(super) fn fixed_rotation<S: Real<Mask = bool>>(
    pairs: &[Pair<S>],
    sides: Sides<S>,
) -> Result<Rotor<S>, FitError<S>> {
    // Scaled to lengths up to one, so that products stay in range; the rotation does not depend on
    // the factors.
    let [from, to] = sides.extents;
    let units = || {
        pairs.iter().map(move |pair| {
            let (x, y) = (pair.from.divided(from), pair.to.divided(to));
            (pair.weight, x, y)
        })
    };
    let mut moments = [[S::zero(); 3]; 3];
    let mut squares = [S::zero(); 2];
    for (weight, x, y) in units() {
        add_products(&mut moments, weight, x, y);
        squares[0] += x.dot(x) * weight;
        squares[1] += y.dot(y) * weight;
    }
    let [(first, quaternion), (second, _), ..] = symmetric_eigen(horn(moments));
    let rounding = (squares[0] * squares[1]).sqrt() * S::epsilon() * S::from_integer(16);
    if !rounding.less_than(first - second) {
        return Err(FitError::RotationNotUnique);
    }
    let [w, x, y, z] = quaternion;
    let mut rotor = Rotor::from_quaternion([x, y, z], w).ok_or(FitError::OutOfRange)?;
    for _ in 0..2 {
        rotor = improved(rotor, units());
    }
    Ok(if rotor.scalar().less_than(S::zero()) {
        -rotor
    } else {
        rotor
    })
}

/// A Newton step. With `p = R x` a rotation by δ changes `Σ w y·p` by `δ·τ − ½ δᵀ(tr K − K)δ`,
/// where `τ = Σ w p × y` and K is the symmetric part of `Σ w p yᵀ`. The torque τ is computed from
/// differences, so that it stays accurate where the fit is good.
fn improved<S: Real<Mask = bool>>(
    rotor: Rotor<S>,
    units: impl Iterator<Item = (S, Vector<S>, Vector<S>)> + Clone,
) -> Rotor<S> {
    let turned =
        units.map(|(weight, x, y)| (weight, Vector::from(rotor.transform(Point::from(x))), y));
    let mut moments = [[S::zero(); 3]; 3];
    let mut square = S::zero();
    for (weight, p, y) in turned.clone() {
        add_products(&mut moments, weight, p, y);
        square += p.dot(p) * weight;
    }
    let trace = moments[0][0] + moments[1][1] + moments[2][2];
    let scale = trace / square;
    let mut torque = [S::zero(); 3];
    for (weight, p, y) in turned {
        let part = p.cross(y - p * scale);
        torque = core::array::from_fn(|k| part[k].mul_add(weight, torque[k]));
    }
    let half = S::from_ratio(1, 2);
    let stiffness: Matrix<S, 3> = core::array::from_fn(|row| {
        core::array::from_fn(|column| {
            let symmetric = (moments[row][column] + moments[column][row]) * half;
            if row == column {
                trace - symmetric
            } else {
                -symmetric
            }
        })
    });
    let step = solve(stiffness, torque).map_or(Vector::default(), Vector::from);
    // A larger step does not come from a good start, but from a stiffness lost in rounding.
    if !step.length().less_than(S::from_ratio(1, 4)) {
        return rotor;
    }
    let [x, y, z] = (step * half).coordinates();
    let zero = S::zero();
    let turn = MotorGenerator::new(-z, y, -x, zero, zero, zero).exp();
    turn.rotor() * rotor
}

fn add_products<S: Real>(moments: &mut Matrix<S, 3>, weight: S, x: Vector<S>, y: Vector<S>) {
    for (row, a) in moments.iter_mut().zip(x.coordinates()) {
        for (entry, b) in row.iter_mut().zip(y.coordinates()) {
            *entry = (a * weight).mul_add(b, *entry);
        }
    }
}
