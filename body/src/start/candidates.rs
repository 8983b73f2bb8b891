//! Where a point of the body may be: candidates on the lines on which views show it.

use ga_runtime::vga3::Vector;
use nalgebra_035::{Matrix3, SymmetricEigen, Vector3};

use crate::JointPixel;
use ga_camera::Camera;

/// How many standard deviations candidates of a triangulated point are from it at most, and how
/// many candidates it has.
const EXTENT: f64 = 3.3;
const OF_TRIANGULATED: usize = 33;
/// How many candidates a point has that one view sees.
const OF_RAY: usize = 49;

/// A pixel with its camera.
pub(super) type Sight<'a> = (&'a Camera, JointPixel);

/// Candidates at equal distances on one line or more.
#[derive(Clone, Debug, Default)]
pub(super) struct Candidates {
    lines: Vec<Line>,
    all: Vec<Candidate>,
    /// A sphere around the candidates.
    pub(super) centre: Vector<f64>,
    pub(super) radius: f64,
}

#[derive(Clone, Copy, Debug)]
struct Candidate {
    place: Vector<f64>,
    /// The sum of squared errors of pixels, in standard deviations.
    cost: f64,
    line: usize,
}

#[derive(Clone, Copy, Debug)]
struct Line {
    /// Which of the views that show the point is wrong on this line.
    wrong: Option<usize>,
    direction: Vector<f64>,
    /// The variance of the place across the line.
    across: f64,
    /// The variance along the line by which candidates stand for the places between them.
    along: f64,
}

impl Candidates {
    /// Around a triangulated point, along the axis on which it is least certain.
    pub(super) fn around(place: Vector<f64>, sights: &[Sight<'_>]) -> Option<Self> {
        let mut information = Matrix3::zeros();
        let mut cost = 0.0;
        for (camera, pixel) in sights {
            let seen = camera.project_with_derivatives(place.into()).ok()?;
            for (k, row) in seen.by_point.into_iter().enumerate() {
                let row = Vector3::from(row) / pixel.deviation;
                information += row * row.transpose();
                cost += ((seen.pixel[k] - pixel.position[k]) / pixel.deviation).powi(2);
            }
        }
        let eigen = SymmetricEigen::new(information);
        let weakest = eigen.eigenvalues.imin();
        let weak = eigen.eigenvalues[weakest];
        let strong = (eigen.eigenvalues.sum() - weak) / 2.0;
        if !(weak > 0.0 && strong.is_finite()) {
            return None;
        }
        let axis: [f64; 3] = eigen.eigenvectors.column(weakest).into();
        let axis = Vector::from(axis);
        // Away from the first camera, so that the order does not depend on the coordinates.
        let away = place - Vector::from(sights.first()?.0.centre());
        let axis = if axis.dot(away) < 0.0 { -axis } else { axis };
        let deviation = 1.0 / weak.sqrt();
        let step = 2.0 * EXTENT / (OF_TRIANGULATED - 1) as f64;
        let all = (0..OF_TRIANGULATED).map(|k| {
            let at = k as f64 * step - EXTENT;
            Candidate {
                place: place + axis * (at * deviation),
                cost: cost + at * at,
                line: 0,
            }
        });
        Some(Self {
            lines: vec![Line {
                wrong: None,
                direction: axis,
                across: 1.0 / strong,
                along: (step * deviation).powi(2) / 6.0,
            }],
            all: all.collect(),
            centre: place,
            radius: EXTENT * deviation,
        })
    }

    /// On the ray of a pixel, within a sphere or as near to it as the ray comes.
    pub(super) fn on_ray(
        (camera, pixel): Sight<'_>,
        centre: Vector<f64>,
        radius: f64,
    ) -> Option<Self> {
        /// The least length of the part of the ray beside the radius.
        const LEAST: f64 = 0.2;
        let ray = camera.ray(pixel.position).ok()?;
        let (origin, direction) = (Vector::from(ray.origin()), Vector::from(ray.direction()));
        let middle = (centre - origin).dot(direction);
        let beside = (origin + direction * middle).distance(centre);
        let half = (radius * radius - beside * beside).max(0.0).sqrt();
        let half = half.max(LEAST * radius);
        let from = (middle - half).max(LEAST * middle);
        let to = middle + half;
        if !(from > 0.0 && to > from && to.is_finite()) {
            return None;
        }
        let foot = origin + direction * middle;
        let seen = camera.project_with_derivatives(foot.into()).ok()?;
        let squares = seen.by_point.map(|row| Vector::from(row).length_squared());
        let information = (squares[0] + squares[1]) / (2.0 * pixel.deviation.powi(2));
        let step = (to - from) / (OF_RAY - 1) as f64;
        let all = (0..OF_RAY).map(|k| Candidate {
            place: origin + direction * (from + step * k as f64),
            cost: 0.0,
            line: 0,
        });
        Some(Self {
            lines: vec![Line {
                wrong: None,
                direction,
                across: 1.0 / information,
                along: step * step / 6.0,
            }],
            all: all.collect(),
            centre: origin + direction * (0.5 * (from + to)),
            radius: 0.5 * (to - from),
        })
    }

    /// These and others for which a view is wrong, which costs an amount.
    pub(super) fn or(mut self, other: Self, wrong: usize, cost: f64) -> Self {
        let lines = self.lines.len();
        let wrong = Some(wrong);
        self.lines
            .extend(other.lines.into_iter().map(|own| Line { wrong, ..own }));
        self.all.extend(other.all.into_iter().map(|own| Candidate {
            cost: own.cost + cost,
            line: own.line + lines,
            ..own
        }));
        if self.radius < other.radius {
            (self.centre, self.radius) = (other.centre, other.radius);
        }
        self
    }

    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    pub(super) fn place(&self, index: usize) -> Vector<f64> {
        self.all[index].place
    }

    /// Which of the views that show the point is wrong where a candidate is right.
    pub(super) fn wrong(&self, index: usize) -> Option<usize> {
        self.lines[self.all[index].line].wrong
    }

    pub(super) fn costs(&self) -> Vec<f64> {
        self.all.iter().map(|candidate| candidate.cost).collect()
    }

    /// The costs of the distances from the candidates of another point, in rows for these: minus
    /// twice the logarithm of the density of distances, which have to lie in a range.
    pub(super) fn distances(&self, other: &Self, [least, greatest]: [f64; 2]) -> Vec<f64> {
        let mut costs = Vec::with_capacity(self.len() * other.len());
        for a in &self.all {
            let own = self.lines[a.line];
            for b in &other.all {
                let others = other.lines[b.line];
                let way = a.place - b.place;
                let squared = way.length_squared().max(f64::MIN_POSITIVE);
                let length = squared.sqrt();
                let error = (least - length).max(length - greatest).max(0.0);
                let [along, along_other] =
                    [own, others].map(|line| way.dot(line.direction).powi(2) / squared);
                let variance = own.across
                    + others.across
                    + (own.along - own.across) * along
                    + (others.along - others.across) * along_other;
                costs.push(error * error / variance + variance.ln());
            }
        }
        costs
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example;

    #[test]
    fn candidates_cost_what_their_pixels_say() {
        let cameras = [example::camera(0.0), example::camera(1.0)];
        let place = Vector::new(0.2, -0.1, 3.5);
        let pixels = cameras.each_ref().map(|camera| {
            let [u, v] = camera.project(place.into()).unwrap();
            // A little up and down: nothing that a motion of the point explains.
            let sign = if camera == &cameras[0] { 0.1 } else { -0.1 };
            JointPixel {
                position: [u, v + sign],
                deviation: 0.2,
            }
        });
        let sights = [(&cameras[0], pixels[0]), (&cameras[1], pixels[1])];
        let found = Candidates::around(place, &sights).unwrap();
        let cost_at = |at: Vector<f64>| -> f64 {
            let of_view = sights.iter().map(|(camera, pixel)| {
                let seen = camera.project(at.into()).unwrap();
                let [u, v] = [0, 1].map(|k| seen[k] - pixel.position[k]);
                (u * u + v * v) / 0.04
            });
            of_view.sum()
        };
        let costs: Vec<f64> = found.all.iter().map(|candidate| candidate.cost).collect();
        let least = costs.iter().copied().fold(f64::INFINITY, f64::min);
        assert!((least - 0.5).abs() < 0.01);
        for candidate in &found.all {
            // The projection is not linear.
            let expected = cost_at(candidate.place);
            let error = (candidate.cost - expected).abs();
            assert!(error < 0.05 * expected, "{} {expected}", candidate.cost);
        }
    }
}
