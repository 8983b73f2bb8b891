//! Solids as signed distances, and their smooth union.

use super::loft::Loft;
use crate::{Vector, mirror};

/// A solid known by the signed distance to its surface, negative inside.
#[derive(Clone, Debug)]
pub(crate) enum Shape {
    /// Cross-sections along an axis.
    Loft(Loft),
    /// Half-axes along three orthonormal directions.
    Ellipsoid {
        centre: Vector,
        axes: [Vector; 3],
        radii: Vector,
    },
    /// Ball whose radius goes from the first to the second while its centre goes from `from` to
    /// `to`.
    Cone {
        from: Vector,
        to: Vector,
        radii: [f64; 2],
    },
}

/// Ellipsoid with its half-axes along the coordinate axes.
pub(crate) fn ellipsoid(centre: Vector, radii: Vector) -> Shape {
    Shape::Ellipsoid {
        centre,
        axes: [Vector::X, Vector::Y, Vector::Z],
        radii,
    }
}

impl Shape {
    fn distance(&self, point: Vector) -> f64 {
        match self {
            Shape::Loft(loft) => loft.distance(point),
            Shape::Ellipsoid {
                centre,
                axes,
                radii,
            } => {
                let offset = point - *centre;
                let mut scaled = 0.0;
                let mut gradient = 0.0;
                for (axis, radius) in axes.iter().zip(radii.coordinates()) {
                    let t = offset.dot(*axis) / radius;
                    scaled += t * t;
                    gradient += (t / radius) * (t / radius);
                }
                if scaled < 1e-12 {
                    return -radii.e1.min(radii.e2).min(radii.e3);
                }
                let scaled = scaled.sqrt();
                scaled * (scaled - 1.0) / gradient.sqrt()
            }
            Shape::Cone { from, to, radii } => {
                let axis = *to - *from;
                let t = ((point - *from).dot(axis) / axis.length_squared()).clamp(0.0, 1.0);
                point.distance(from.lerp(*to, t)) - radii[0] - t * (radii[1] - radii[0])
            }
        }
    }

    fn bounds(&self) -> [Vector; 2] {
        match self {
            Shape::Loft(loft) => loft.bounds(),
            Shape::Ellipsoid {
                centre,
                axes,
                radii,
            } => {
                let reach = [0, 1, 2].map(|k| {
                    let parts = Vector::from(axes.map(|axis| axis[k]));
                    parts.component_product(*radii).length()
                });
                let reach = Vector::from(reach);
                [*centre - reach, *centre + reach]
            }
            Shape::Cone { from, to, radii } => {
                let [first, last] = radii.map(|radius| Vector::new(radius, radius, radius));
                [
                    (*from - first).min(*to - last),
                    (*from + first).max(*to + last),
                ]
            }
        }
    }
}

/// Smooth union of shapes, in order.
#[derive(Clone, Debug, Default)]
pub(crate) struct Solid {
    members: Vec<Member>,
    bounds: Option<[Vector; 2]>,
    /// The width of the widest fillet.
    widest: f64,
}

#[derive(Clone, Debug)]
struct Member {
    shape: Shape,
    /// Whether the mirror image is there as well.
    paired: bool,
    /// Width of the fillet to what came before.
    fillet: f64,
    bounds: [Vector; 2],
}

impl Solid {
    /// Adds a shape, joined to what is there by a fillet of the given width in metres.
    pub(crate) fn join(&mut self, fillet: f64, shape: Shape) {
        self.push(fillet, shape, false);
    }

    /// Adds a shape and its mirror image in the plane x = 0, joined to each other too.
    pub(crate) fn join_pair(&mut self, fillet: f64, shape: Shape) {
        self.push(fillet, shape, true);
    }

    fn push(&mut self, fillet: f64, shape: Shape, paired: bool) {
        let mut bounds = shape.bounds();
        if paired {
            let reach = bounds[1].e1.max(-bounds[0].e1);
            bounds[0].e1 = -reach;
            bounds[1].e1 = reach;
        }
        self.bounds = Some(match self.bounds {
            None => bounds,
            Some([low, high]) => [low.min(bounds[0]), high.max(bounds[1])],
        });
        self.widest = self.widest.max(fillet);
        self.members.push(Member {
            shape,
            paired,
            fillet,
            bounds,
        });
    }

    /// Signed distance, to first order, up to a limit: a value above `limit` may be replaced
    /// by any lower bound that is itself above `limit`.
    pub(crate) fn distance(&self, point: Vector, limit: f64) -> f64 {
        let far = self
            .bounds
            .map_or(f64::INFINITY, |bounds| box_distance(&bounds, point));
        if far > limit {
            return far;
        }
        let mut distance = f64::INFINITY;
        for member in &self.members {
            let least = box_distance(&member.bounds, point);
            if least > limit + self.widest || least > distance + self.widest {
                distance = distance.min(least);
                continue;
            }
            let mut own = member.shape.distance(point);
            if member.paired {
                let image = member.shape.distance(mirror(point));
                own = smooth_minimum(own, image, member.fillet);
            }
            distance = smooth_minimum(distance, own, member.fillet);
        }
        distance
    }

    /// Corners of a box that holds the solid, up to the fillets.
    pub(crate) fn bounds(&self) -> Option<[Vector; 2]> {
        self.bounds
    }
}

/// The lesser of two distances, the corner between them filled by a parabola where they differ by
/// less than `width`.
pub(crate) fn smooth_minimum(a: f64, b: f64, width: f64) -> f64 {
    let overlap = (width - (a - b).abs()).max(0.0);
    if overlap > 0.0 {
        a.min(b) - overlap * overlap / (4.0 * width)
    } else {
        a.min(b)
    }
}

/// A rounded dent (negative height) or bump: adds `height` metres at the centre, falling off as a
/// Gaussian.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bump {
    pub(crate) centre: Vector,
    pub(crate) radii: Vector,
    pub(crate) height: f64,
}

impl Bump {
    pub(crate) fn height_at(&self, point: Vector) -> f64 {
        let mut square = 0.0;
        for k in [1, 0, 2] {
            let offset = (point[k] - self.centre[k]) / self.radii[k];
            square += offset * offset;
            // Beyond this it is under 0.01 mm for every bump here.
            if square > 9.0 {
                return 0.0;
            }
        }
        self.height * ((-square).exp() - (-9.0_f64).exp())
    }
}

/// Moves a point onto the surface of zero distance along the gradient.
pub(crate) fn project(distance: impl Fn(Vector) -> f64, point: Vector) -> Vector {
    const STEP: f64 = 1e-6;
    let mut p = point;
    for _ in 0..4 {
        let d = distance(p);
        if d.abs() < 1e-7 {
            break;
        }
        let gradient =
            [Vector::X, Vector::Y, Vector::Z].map(|axis| (distance(p + axis * STEP) - d) / STEP);
        let gradient = Vector::from(gradient);
        let square = gradient.length_squared();
        if square < 1e-6 {
            break;
        }
        p -= gradient * (d / square);
    }
    p
}

fn box_distance(&[low, high]: &[Vector; 2], point: Vector) -> f64 {
    let outside = (low - point).max(point - high).max(Vector::ZERO);
    outside.length()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_smooth_minimum_is_between_the_minimum_and_a_quarter_width_below(
            a in -1.0..1.0f64,
            b in -1.0..1.0f64,
            width in 0.001..1.0f64,
        ) {
            let found = smooth_minimum(a, b, width);
            prop_assert!(found <= a.min(b) && found >= a.min(b) - 0.25 * width - 1e-15);
            prop_assert_eq!(found, smooth_minimum(b, a, width));
            prop_assert!((a - b).abs() < width || found == a.min(b));
        }

        #[test]
        fn a_pair_is_symmetric(x in -1.0..1.0f64, y in -1.0..1.0f64, z in -1.0..1.0f64) {
            let mut solid = Solid::default();
            solid.join(0.0, ellipsoid(Vector::new(0.0, 0.2, 0.0), Vector::new(0.3, 0.4, 0.2)));
            let shape = Shape::Cone { from: Vector::new(0.2, 0.0, 0.1), to: Vector::new(0.6, 0.5, 0.0), radii: [0.2, 0.1] };
            solid.join_pair(0.1, shape);
            let (here, there) = (solid.distance(Vector::new(x, y, z), 10.0), solid.distance(Vector::new(-x, y, z), 10.0));
            prop_assert_eq!(here, there);
        }
    }

    #[test]
    fn passing_over_what_is_far_changes_nothing_near() {
        let mut solid = Solid::default();
        solid.join(0.0, ellipsoid(Vector::ZERO, Vector::new(0.3, 0.4, 0.2)));
        let cone = Shape::Cone {
            from: Vector::new(0.3, 0.0, 0.0),
            to: Vector::new(0.9, 0.0, 0.0),
            radii: [0.15, 0.1],
        };
        solid.join(0.05, cone);
        for i in 0..200 {
            let t = f64::from(i) * 0.01;
            let point = Vector::new(t - 1.0, 0.3 * (7.0 * t).sin(), 0.3 * (5.0 * t).cos());
            let exact = solid.distance(point, f64::INFINITY);
            let short = solid.distance(point, 0.1);
            assert!(
                if exact <= 0.1 {
                    short == exact
                } else {
                    short > 0.1
                },
                "{exact} {short} at {point:?}"
            );
        }
    }

    #[test]
    fn projection_ends_on_the_surface() {
        let mut solid = Solid::default();
        solid.join(
            0.0,
            ellipsoid(Vector::new(0.1, 0.0, 0.0), Vector::new(0.3, 0.4, 0.2)),
        );
        let distance = |p| solid.distance(p, f64::INFINITY);
        for start in [
            Vector::new(0.5, 0.1, 0.1),
            Vector::new(0.1, 0.3, 0.05),
            Vector::new(-0.1, -0.2, 0.2),
        ] {
            assert!(distance(project(distance, start)).abs() < 1e-7);
        }
    }
}
