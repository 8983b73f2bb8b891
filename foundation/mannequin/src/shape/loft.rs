//! A solid through a row of cross-sections, given the way a body is measured: breadth and depth at
//! each height.

use crate::Vector;
use crate::frame::Frame;

/// One cross-section: where along the axis it stands and how far it reaches across it, in metres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Section {
    /// Position along the axis.
    pub(crate) along: f64,
    /// Least and greatest reach in the first direction across the axis.
    pub(crate) across: [f64; 2],
    /// Least and greatest reach in the second direction across the axis.
    pub(crate) depth: [f64; 2],
    /// Exponent of the superellipse |u|ⁿ + |v|ⁿ = 1: 2 is an ellipse, more is squarer.
    pub(crate) exponent: f64,
}

/// Shorthand for tables: along, across, depth, exponent.
pub(crate) const fn section(
    along: f64,
    across: [f64; 2],
    depth: [f64; 2],
    exponent: f64,
) -> Section {
    Section {
        along,
        across,
        depth,
        exponent,
    }
}

/// Smooth solid through cross-sections, its two ends closed by half ellipsoids.
#[derive(Clone, Debug)]
pub(crate) struct Loft {
    frame: Frame,
    knots: Vec<Knot>,
    /// How far the rounded ends stand out beyond the first and the last section.
    caps: [f64; 2],
}

/// A section as the channels that are interpolated, with their slopes: centre and half-width of
/// both reaches, exponent.
#[derive(Clone, Copy, Debug)]
struct Knot {
    along: f64,
    value: [f64; CHANNELS],
    slope: [f64; CHANNELS],
}

const CHANNELS: usize = 5;

impl Loft {
    /// Joins `sections`, which stand in rising order along the axis.
    pub(crate) fn new(frame: Frame, sections: &[Section], caps: [f64; 2]) -> Self {
        let mut knots: Vec<Knot> = sections
            .iter()
            .map(|s| Knot {
                along: s.along,
                value: [
                    0.5 * (s.across[0] + s.across[1]),
                    0.5 * (s.across[1] - s.across[0]),
                    0.5 * (s.depth[0] + s.depth[1]),
                    0.5 * (s.depth[1] - s.depth[0]),
                    s.exponent,
                ],
                slope: [0.0; CHANNELS],
            })
            .collect();
        for channel in 0..CHANNELS {
            let slopes = slopes(&knots, channel);
            for (knot, slope) in knots.iter_mut().zip(slopes) {
                knot.slope[channel] = slope;
            }
        }
        Loft { frame, knots, caps }
    }

    /// Distance to the surface to first order: exact on it, negative inside.
    pub(crate) fn distance(&self, point: Vector) -> f64 {
        let local = point - self.frame.origin;
        let along = local.dot(self.frame.along);
        let (value, slope, over, cap) = self.at(along);
        let [centre_u, half_u, centre_v, half_v, exponent] = value;
        let u = (local.dot(self.frame.across) - centre_u) / half_u;
        let v = (local.dot(self.frame.depth) - centre_v) / half_v;

        let (pu, pv) = (power(u.abs(), exponent), power(v.abs(), exponent));
        let ring = power(pu + pv, 1.0 / exponent);
        let radius = ring.hypot(over / cap);
        if radius < 1e-6 {
            return -half_u.min(half_v);
        }
        let (mut du, mut dv) = (0.0, 0.0);
        if ring > 1e-9 {
            let rest = ring * ring / (radius * (pu + pv));
            du = if u == 0.0 { 0.0 } else { rest * pu / u };
            dv = if v == 0.0 { 0.0 } else { rest * pv / v };
        }
        let d_along = over / (cap * cap * radius)
            - du * (slope[0] + u * slope[1]) / half_u
            - dv * (slope[2] + v * slope[3]) / half_v;
        let gradient = (du / half_u).hypot(dv / half_v).hypot(d_along);
        (radius - 1.0) / gradient.max(1e-3 / half_u.max(half_v))
    }

    /// Corners of a box that holds the solid.
    pub(crate) fn bounds(&self) -> [Vector; 2] {
        let mut bounds: Option<[Vector; 2]> = None;
        let last = self.knots.len() - 1;
        for (i, knot) in self.knots.iter().enumerate() {
            let before = if i == 0 { self.caps[0] } else { 0.0 };
            let after = if i == last { self.caps[1] } else { 0.0 };
            let [cu, hu, cv, hv, _] = knot.value;
            for along in [knot.along - before, knot.along + after] {
                for across in [cu - hu, cu + hu] {
                    for depth in [cv - hv, cv + hv] {
                        let p = self.frame.point(along, across, depth);
                        let [low, high] = bounds.unwrap_or([p; 2]);
                        bounds = Some([low.min(p), high.max(p)]);
                    }
                }
            }
        }
        bounds.unwrap_or([self.frame.origin; 2])
    }

    /// Channels and slopes at a position, how far it lies beyond the nearer end, and the height of
    /// that end's cap.
    fn at(&self, along: f64) -> ([f64; CHANNELS], [f64; CHANNELS], f64, f64) {
        let first = &self.knots[0];
        let last = &self.knots[self.knots.len() - 1];
        if along <= first.along {
            return (
                first.value,
                [0.0; CHANNELS],
                along - first.along,
                self.caps[0],
            );
        }
        if along >= last.along {
            return (
                last.value,
                [0.0; CHANNELS],
                along - last.along,
                self.caps[1],
            );
        }
        let after = self.knots.partition_point(|knot| knot.along <= along);
        let (a, b) = (&self.knots[after - 1], &self.knots[after]);
        let width = b.along - a.along;
        let t = (along - a.along) / width;
        let mut value = [0.0; CHANNELS];
        let mut slope = [0.0; CHANNELS];
        for c in 0..CHANNELS {
            let rise = b.value[c] - a.value[c];
            let (ma, mb) = (a.slope[c] * width, b.slope[c] * width);
            let (c2, c3) = (3.0 * rise - 2.0 * ma - mb, ma + mb - 2.0 * rise);
            value[c] = a.value[c] + t * (ma + t * (c2 + t * c3));
            slope[c] = (ma + t * (2.0 * c2 + t * 3.0 * c3)) / width;
        }
        (value, slope, 0.0, 1.0)
    }
}

/// `base` to the `exponent`, quickly for the plain ellipse.
fn power(base: f64, exponent: f64) -> f64 {
    if exponent == 2.0 {
        base * base
    } else if exponent == 0.5 {
        base.sqrt()
    } else {
        base.powf(exponent)
    }
}

/// Slopes that make the cubics between the knots meet with equal curvature; zero at the ends, to
/// meet the caps smoothly.
///
/// Continuity of the second derivative at each inner knot is one row of a tridiagonal system with a
/// dominant diagonal.
fn slopes(knots: &[Knot], channel: usize) -> Vec<f64> {
    let mut slopes = vec![0.0; knots.len()];
    // Forward elimination: slope[i] = value[i] - factor[i] slope[i + 1].
    let mut factors = vec![0.0; knots.len()];
    for i in 1..knots.len().saturating_sub(1) {
        let (a, b, c) = (&knots[i - 1], &knots[i], &knots[i + 1]);
        let (before, after) = (b.along - a.along, c.along - b.along);
        let rise_before = (b.value[channel] - a.value[channel]) / before;
        let rise_after = (c.value[channel] - b.value[channel]) / after;
        let right = 3.0 * (rise_before * after + rise_after * before);
        let diagonal = 2.0 * (before + after) - after * factors[i - 1];
        factors[i] = before / diagonal;
        slopes[i] = (right - after * slopes[i - 1]) / diagonal;
    }
    for i in (1..knots.len().saturating_sub(1)).rev() {
        slopes[i] -= factors[i] * slopes[i + 1];
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball of radius 1 and centre 0 as two half caps about its equator.
    fn ball() -> Loft {
        let equator = |along| section(along, [-1.0, 1.0], [-1.0, 1.0], 2.0);
        Loft::new(Frame::UPRIGHT, &[equator(-1e-9), equator(1e-9)], [1.0, 1.0])
    }

    #[test]
    fn a_ball_has_the_distance_of_a_ball() {
        for point in [
            Vector::new(0.6, 0.2, 0.3),
            Vector::new(1.5, 0.4, -0.2),
            Vector::new(0.0, 2.0, 0.0),
            Vector::new(0.0, -0.9, 0.1),
        ] {
            let expected = point.length() - 1.0;
            assert!(
                (ball().distance(point) - expected).abs() < 1e-6,
                "{point:?}"
            );
        }
    }

    #[test]
    fn a_cone_has_the_distance_of_a_cone_near_its_surface() {
        // Radius 2 − y; its surface leans by 45°.
        let ring = |along: f64| {
            section(
                along,
                [along - 2.0, 2.0 - along],
                [along - 2.0, 2.0 - along],
                2.0,
            )
        };
        let sections: Vec<Section> = (-20..=10).map(|i| ring(f64::from(i) * 0.1)).collect();
        let cone = Loft::new(Frame::UPRIGHT, &sections, [0.1, 0.1]);
        let found = cone.distance(Vector::new(2.01 * 0.6, 0.0, 2.01 * 0.8));
        assert!((found - 0.01 / 2.0_f64.sqrt()).abs() < 1e-4, "{found}");
    }

    #[test]
    fn the_surface_goes_through_the_sections() {
        let sections = [
            section(0.0, [-1.0, 2.0], [-0.5, 0.5], 2.0),
            section(1.0, [-2.0, 2.5], [-0.7, 0.3], 2.5),
            section(3.0, [-1.0, 1.0], [-0.4, 0.6], 3.0),
        ];
        let loft = Loft::new(Frame::UPRIGHT, &sections, [0.5, 0.5]);
        for s in &sections {
            let middle = |[low, high]: [f64; 2]| 0.5 * (low + high);
            for across in s.across {
                let place = Vector::new(across, s.along, middle(s.depth));
                assert!(loft.distance(place).abs() < 1e-12);
            }
            for depth in s.depth {
                let place = Vector::new(middle(s.across), s.along, depth);
                assert!(loft.distance(place).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_straight_row_stays_straight_and_curvature_is_continuous() {
        let widths = [1.0, 1.4, 1.1, 0.7, 1.3];
        let sections: Vec<Section> = widths
            .iter()
            .zip([0.0, 1.0, 1.7, 3.0, 4.0])
            .map(|(w, along)| section(along, [-w, *w], [-1.0, 1.0], 2.0))
            .collect();
        let loft = Loft::new(Frame::UPRIGHT, &sections, [1.0, 1.0]);
        let slope = |along: f64| loft.at(along).1[1];
        for along in [1.0, 1.7, 3.0] {
            let (before, after) = (
                slope(along) - slope(along - 1e-6),
                slope(along + 1e-6) - slope(along),
            );
            assert!((before - after).abs() < 1e-9, "{before} {after} at {along}");
        }
        assert!(loft.at(2.0).1[3].abs() < 1e-15);
    }
}
