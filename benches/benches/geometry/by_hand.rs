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

/// The points x with `weight x² − 2 middle · x + 2 constant = 0`.
#[derive(Clone, Copy)]
pub(crate) struct Sphere {
    pub(crate) weight: f64,
    pub(crate) middle: DVec3,
    pub(crate) constant: f64,
}

/// A circle or a pair of points by Plücker coordinates: with the axis n, the centre c and a number
/// β, it is n, `c × n`, `c·n` and `(c·n) c − β n`, all of them times a weight.
#[derive(Clone, Copy)]
pub(crate) struct Round {
    pub(crate) axis: DVec3,
    pub(crate) moment: DVec3,
    pub(crate) along: f64,
    pub(crate) last: DVec3,
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
    let dual = cga3::RoundVector::from(sphere.dual());
    Sphere {
        weight: dual.eo,
        middle: DVec3::new(dual.e1, dual.e2, dual.e3),
        constant: dual.ei,
    }
}

pub(crate) fn round(b: cga3::Bivector<f64>) -> Round {
    Round {
        axis: -DVec3::new(b.e1o, b.e2o, b.e3o),
        moment: DVec3::new(b.e23, -b.e13, b.e12),
        along: b.eoi,
        last: DVec3::new(b.e1i, b.e2i, b.e3i),
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
    /// the way to the centre times the determinant of the sides.
    #[inline]
    pub(crate) fn through([p, q, r, s]: [DVec3; 4]) -> Self {
        let sides = [q - p, r - p, s - p];
        let halves = sides.map(|side| 0.5 * side.length_squared());
        let across = sides[1].cross(sides[2]);
        let weight = sides[0].dot(across);
        let way = halves[0] * across
            + halves[1] * sides[2].cross(sides[0])
            + halves[2] * sides[0].cross(sides[1]);
        let middle = p * weight + way;
        Self {
            weight,
            middle,
            constant: middle.dot(p) - 0.5 * weight * p.length_squared(),
        }
    }

    #[inline]
    pub(crate) fn centre(&self) -> Option<DVec3> {
        let inverse = self.weight.recip();
        inverse.is_finite().then(|| self.middle * inverse)
    }

    /// The centre and the squared radius.
    #[inline]
    pub(crate) fn parts(&self) -> Option<(DVec3, f64)> {
        let inverse = self.weight.recip();
        let centre = self.middle * inverse;
        let squared = centre.length_squared() - 2.0 * self.constant * inverse;
        inverse.is_finite().then_some((centre, squared))
    }

    #[inline]
    pub(crate) fn ball(&self) -> Option<Ball> {
        let (centre, squared) = self.parts()?;
        (squared >= 0.0).then(|| Ball {
            centre,
            radius: squared.sqrt(),
        })
    }
}

impl Round {
    /// The pair of two points.
    #[inline]
    pub(crate) fn pair(p: DVec3, q: DVec3) -> Self {
        let (p_half, q_half) = (0.5 * p.length_squared(), 0.5 * q.length_squared());
        Self {
            axis: q - p,
            moment: p.cross(q),
            along: q_half - p_half,
            last: p * q_half - q * p_half,
        }
    }

    /// The circle through three points. Its centre c has `c · u = a` and `c · v = b` for the sides
    /// u and v, so that `c × (u × v) = b u − a v`.
    #[inline]
    pub(crate) fn circle(p: DVec3, q: DVec3, r: DVec3) -> Self {
        let (u, v) = (q - p, r - p);
        let [p_half, q_half, r_half] = [p, q, r].map(|x| 0.5 * x.length_squared());
        let axis = u.cross(v);
        let moment = u * (r_half - p_half) - v * (q_half - p_half);
        Self {
            axis,
            moment,
            along: axis.dot(p),
            last: p.cross(moment) + axis * p_half,
        }
    }

    /// The circle with a centre, a unit normal and a squared radius, or the pair with a centre, a
    /// unit axis and minus a squared radius.
    #[inline]
    pub(crate) fn around(centre: DVec3, axis: DVec3, squared: f64) -> Self {
        let along = centre.dot(axis);
        let infinite = 0.5 * (centre.length_squared() - squared);
        Self {
            axis,
            moment: centre.cross(axis),
            along,
            last: centre * along - axis * infinite,
        }
    }

    /// The two points of a pair.
    #[inline]
    pub(crate) fn endpoints(&self) -> Option<[DVec3; 2]> {
        let (centre, twice) = self.parts()?;
        let squared = twice - centre.length_squared();
        let reach = self.axis.normalize() * squared.sqrt();
        (squared >= 0.0).then(|| [centre - reach, centre + reach])
    }

    /// Centre, normal and radius of a circle.
    #[inline]
    pub(crate) fn figure(&self) -> Option<(DVec3, DVec3, f64)> {
        let (centre, twice) = self.parts()?;
        let squared = centre.length_squared() - twice;
        (squared >= 0.0).then(|| (centre, self.axis.normalize(), squared.sqrt()))
    }

    /// Centre and twice β.
    #[inline]
    pub(crate) fn parts(&self) -> Option<(DVec3, f64)> {
        let inverse = self.axis.length_squared().recip();
        let centre = (self.axis * self.along + self.axis.cross(self.moment)) * inverse;
        let twice = 2.0 * (self.along * self.along - self.axis.dot(self.last)) * inverse;
        inverse.is_finite().then_some((centre, twice))
    }
}
