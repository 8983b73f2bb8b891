//! Figures as plain vectors of glam, with the same numbers as ours.

use ga_runtime::cga3;
use glam::DVec3;

/// The points x with `normal · x = distance`, where the normal may have any length.
#[derive(Clone, Copy)]
pub(crate) struct Plane {
    pub(crate) normal: DVec3,
    pub(crate) distance: f64,
}

/// A direction of any length and the moment `p × direction` of the points p.
#[derive(Clone, Copy)]
pub(crate) struct Line {
    pub(crate) direction: DVec3,
    pub(crate) moment: DVec3,
}

/// A sphere of a weight.
#[derive(Clone, Copy)]
pub(crate) struct Sphere {
    pub(crate) weight: f64,
    pub(crate) centre: DVec3,
    pub(crate) radius_squared: f64,
}

/// A circle with its normal, or a pair of points with its direction, whose length is the weight.
#[derive(Clone, Copy)]
pub(crate) struct Round {
    pub(crate) centre: DVec3,
    pub(crate) direction: DVec3,
    pub(crate) radius_squared: f64,
}

/// A centre and a radius.
#[derive(Clone, Copy)]
pub(crate) struct Ball {
    pub(crate) centre: DVec3,
    pub(crate) radius: f64,
}

/// The angle of two vectors of any length, accurate for small ones too.
#[inline]
pub(crate) fn angle(u: DVec3, v: DVec3) -> Option<f64> {
    let angle = u.cross(v).length().atan2(u.dot(v));
    angle.is_finite().then_some(angle)
}

pub(crate) fn point(p: cga3::Point<f64>) -> DVec3 {
    p.coordinates().into()
}

pub(crate) fn plane(plane: cga3::Plane<f64>) -> Plane {
    let dual = plane.dual();
    Plane {
        normal: dual.normal().into(),
        distance: dual.ei,
    }
}

pub(crate) fn line(line: cga3::Line<f64>) -> Line {
    Line {
        direction: line.direction().into(),
        moment: line.moment().into(),
    }
}

pub(crate) fn sphere(sphere: cga3::Sphere<f64>) -> Sphere {
    Sphere {
        weight: sphere.weight,
        centre: point(sphere.centre),
        radius_squared: sphere.radius_squared,
    }
}

pub(crate) fn circle(circle: cga3::Circle<f64>) -> Round {
    Round {
        centre: point(circle.centre),
        direction: circle.normal.vector().into(),
        radius_squared: circle.radius_squared,
    }
}

pub(crate) fn pair(pair: cga3::PointPair<f64>) -> Round {
    Round {
        centre: point(pair.centre),
        direction: pair.direction.vector().into(),
        radius_squared: pair.radius_squared,
    }
}

impl Plane {
    #[inline]
    pub(crate) fn through(p: DVec3, q: DVec3, r: DVec3) -> Self {
        let normal = (q - p).cross(r - p);
        Self {
            normal,
            distance: normal.dot(p),
        }
    }

    /// With a normal of length 1.
    #[inline]
    pub(crate) fn normalized(&self) -> Option<Self> {
        let inverse = self.normal.length_recip();
        inverse.is_finite().then(|| Self {
            normal: self.normal * inverse,
            distance: self.distance * inverse,
        })
    }
}

impl Line {
    #[inline]
    pub(crate) fn through(p: DVec3, q: DVec3) -> Self {
        let direction = q - p;
        Self {
            direction,
            moment: p.cross(direction),
        }
    }

    /// Its point nearest to the origin and its unit direction.
    #[inline]
    pub(crate) fn parts(&self) -> Option<(DVec3, DVec3)> {
        let inverse = self.direction.length_recip();
        let direction = self.direction * inverse;
        let place = direction.cross(self.moment * inverse);
        inverse.is_finite().then_some((place, direction))
    }
}

impl Sphere {
    /// The sphere through four points. The sides from the first and halves of their squares give
    /// the way to the centre times the determinant of the sides, which is the weight.
    #[inline]
    pub(crate) fn through([p, q, r, s]: [DVec3; 4]) -> Self {
        let sides = [q - p, r - p, s - p];
        let halves = sides.map(|side| 0.5 * side.length_squared());
        let across = sides[1].cross(sides[2]);
        let weight = sides[0].dot(across);
        let way = halves[0] * across
            + halves[1] * sides[2].cross(sides[0])
            + halves[2] * sides[0].cross(sides[1]);
        let way = way * weight.recip();
        Self {
            weight,
            centre: p + way,
            radius_squared: way.length_squared(),
        }
    }

    #[inline]
    pub(crate) fn centre(&self) -> Option<DVec3> {
        (self.weight != 0.0 && self.centre.is_finite()).then_some(self.centre)
    }

    #[inline]
    pub(crate) fn ball(&self) -> Option<Ball> {
        let centre = self.centre()?;
        (self.radius_squared >= 0.0).then(|| Ball {
            centre,
            radius: self.radius_squared.sqrt(),
        })
    }
}

impl Round {
    /// The pair of two points.
    #[inline]
    pub(crate) fn pair(p: DVec3, q: DVec3) -> Self {
        let direction = q - p;
        Self {
            centre: (p + q) * 0.5,
            direction,
            radius_squared: 0.25 * direction.length_squared(),
        }
    }

    /// The circle through three points: with the sides u and v and the normal n = u × v, the way
    /// from p to the centre is `(u² v × n + v² n × u)/(2 n²)`.
    #[inline]
    pub(crate) fn circle(p: DVec3, q: DVec3, r: DVec3) -> Self {
        let (u, v) = (q - p, r - p);
        let normal = u.cross(v);
        let way = u.length_squared() * v.cross(normal) + v.length_squared() * normal.cross(u);
        let way = way * (0.5 / normal.length_squared());
        Self {
            centre: p + way,
            direction: normal,
            radius_squared: way.length_squared(),
        }
    }

    /// The centre of a round whose direction is not zero.
    #[inline]
    pub(crate) fn centre(&self) -> Option<DVec3> {
        (self.direction != DVec3::ZERO && self.centre.is_finite()).then_some(self.centre)
    }

    /// The two points of a pair.
    #[inline]
    pub(crate) fn endpoints(&self) -> Option<[DVec3; 2]> {
        let factor = self.radius_squared / self.direction.length_squared();
        let reach = self.direction * factor.sqrt();
        let ends = [self.centre - reach, self.centre + reach];
        ends.iter().all(|end| end.is_finite()).then_some(ends)
    }

    /// Centre, normal and radius of a circle.
    #[inline]
    pub(crate) fn figure(&self) -> Option<(DVec3, DVec3, f64)> {
        let centre = self.centre()?;
        let normal = self.direction.try_normalize()?;
        (self.radius_squared >= 0.0).then(|| (centre, normal, self.radius_squared.sqrt()))
    }
}
