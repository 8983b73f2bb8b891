//! The conformal algebra of the crate `clifford`. Its motors are general even elements; its points
//! have all five coefficients.

use clifford::ops::{Antiwedge, Sandwich, Wedge};
use clifford::scalar::Float;
use clifford::specialized::conformal::dim3::{
    Circle, Dipole, Line, Motor, Plane, RoundPoint, Sphere,
};

use crate::comparison::Comparison;
use crate::inputs::{self, Numbers};
use crate::precision::Precision;

const NAME: &str = "clifford";

fn motor<S: Precision + Float>(numbers: &mut Numbers) -> Motor<S> {
    let [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = numbers.numbers();
    Motor::new_unchecked(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p)
}

fn point<S: Precision + Float>(numbers: &mut Numbers) -> RoundPoint<S> {
    let [x, y, z] = numbers.numbers();
    RoundPoint::from_euclidean(x, y, z)
}

fn plane<S: Precision + Float>(numbers: &mut Numbers) -> Plane<S> {
    let [x, y, z, w] = numbers.numbers();
    Plane::new(x, y, z, w)
}

fn line<S: Precision + Float>(numbers: &mut Numbers) -> Line<S> {
    let [a, b, c, d, e, f] = numbers.numbers();
    Line::new_unchecked(a, b, c, d, e, f)
}

fn pair<S: Precision + Float>(numbers: &mut Numbers) -> Dipole<S> {
    point(numbers).wedge(&point(numbers))
}

fn circle<S: Precision + Float>(numbers: &mut Numbers) -> Circle<S> {
    pair(numbers).wedge(&point(numbers))
}

fn sphere<S: Precision + Float>(numbers: &mut Numbers) -> Sphere<S> {
    circle(numbers).wedge(&point(numbers))
}

fn moved<S, X>(group: &mut Comparison<'_>, make: fn(&mut Numbers) -> X)
where
    S: Precision + Float,
    Motor<S>: Sandwich<X>,
{
    let (motors, things) = (inputs::list(1, motor::<S>), inputs::list(2, make));
    group.zip(NAME, &motors, &things, Motor::sandwich);
}

pub(super) fn motor_point<S: Precision + Float>(group: &mut Comparison<'_>) {
    moved::<S, _>(group, point);
}

pub(super) fn motor_round_vector<S: Precision + Float>(group: &mut Comparison<'_>) {
    moved::<S, _>(group, point);
}

pub(super) fn motor_plane<S: Precision + Float>(group: &mut Comparison<'_>) {
    moved::<S, _>(group, plane);
}

pub(super) fn motor_sphere<S: Precision + Float>(group: &mut Comparison<'_>) {
    moved::<S, _>(group, sphere);
}

pub(super) fn motor_line<S: Precision + Float>(group: &mut Comparison<'_>) {
    moved::<S, _>(group, line);
}

pub(super) fn motor_circle<S: Precision + Float>(group: &mut Comparison<'_>) {
    moved::<S, _>(group, circle);
}

pub(super) fn motor_point_pair<S: Precision + Float>(group: &mut Comparison<'_>) {
    moved::<S, _>(group, pair);
}

pub(super) fn motor_motor<S: Precision + Float>(group: &mut Comparison<'_>) {
    let (left, right) = (inputs::list(1, motor::<S>), inputs::list(2, motor::<S>));
    group.zip(NAME, &left, &right, |a, b| *a * *b);
}

pub(super) fn three_points<S: Precision + Float>(group: &mut Comparison<'_>) {
    let points = inputs::list(1, |numbers| [(); 3].map(|()| point::<S>(numbers)));
    group.map(NAME, &points, |[p, q, r]| p.wedge(q).wedge(r));
}

pub(super) fn four_points<S: Precision + Float>(group: &mut Comparison<'_>) {
    let points = inputs::list(1, |numbers| [(); 4].map(|()| point::<S>(numbers)));
    group.map(NAME, &points, |[p, q, r, s]| p.wedge(q).wedge(r).wedge(s));
}

pub(super) fn sphere_plane<S: Precision + Float>(group: &mut Comparison<'_>) {
    let (spheres, planes) = (inputs::list(1, sphere::<S>), inputs::list(2, plane::<S>));
    group.zip(NAME, &spheres, &planes, |s, p| s.antiwedge(p));
}

pub(super) fn line_sphere<S: Precision + Float>(group: &mut Comparison<'_>) {
    let (lines, spheres) = (inputs::list(1, line::<S>), inputs::list(2, sphere::<S>));
    group.zip(NAME, &lines, &spheres, |l, s| l.antiwedge(s));
}
