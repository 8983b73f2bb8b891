//! How a mean of affine maps moves points and directions.

use super::palette::Columns;
use super::scalar::SkinScalar;
use crate::cga3::Point;
use crate::geometry::Affine;
use crate::vga3::Vector;

/// The affine map of the columns. Here and below no array is mapped, since the compiler does not
/// always inline that.
#[inline(always)]
pub(super) fn affine<S: SkinScalar>(m: &Columns<S>) -> Affine<S> {
    let m = &m.0;
    Affine::new(
        [[m[0], m[4], m[8]], [m[1], m[5], m[9]], [m[2], m[6], m[10]]],
        [m[12], m[13], m[14]],
    )
}

#[inline(always)]
pub(super) fn point<S: SkinScalar>([x, y, z, _]: [S; 4]) -> Point<S> {
    Point::new(x, y, z)
}

#[inline(always)]
pub(super) fn vector<S: SkinScalar>([x, y, z, _]: [S; 4]) -> Vector<S> {
    Vector::new(x, y, z)
}

/// The image of a normal: the cofactors of the linear part act on it, which are the products of the
/// columns.
#[inline(always)]
pub(super) fn normal<S: SkinScalar>(map: Affine<S>, normal: Vector<S>) -> Vector<S> {
    let [[a, b, c], [d, e, f], [g, h, i]] = map.linear;
    let (x, y, z) = (
        Vector::new(a, b, c),
        Vector::new(d, e, f),
        Vector::new(g, h, i),
    );
    let image = |u: Vector<S>, v: Vector<S>| u.cross(v).dot(normal);
    unit(Vector::new(image(y, z), image(z, x), image(x, y)))
}

/// The image of a tangent.
#[inline(always)]
pub(super) fn tangent<S: SkinScalar>(map: Affine<S>, tangent: Vector<S>) -> Vector<S> {
    let [[a, b, c], [d, e, f], [g, h, i]] = map.linear;
    unit(Vector::new(
        Vector::new(a, b, c).dot(tangent),
        Vector::new(d, e, f).dot(tangent),
        Vector::new(g, h, i).dot(tangent),
    ))
}

/// The vector with length 1; zero for one whose square is zero or not finite.
#[inline(always)]
pub(super) fn unit<S: SkinScalar>(vector: Vector<S>) -> Vector<S> {
    let square = vector.length_squared();
    let scale = square.sqrt().recip();
    let is_regular = S::zero().less_than(square) & scale.is_finite() & S::zero().less_than(scale);
    vector * S::select(is_regular, scale, S::zero())
}
