//! Curves, divided where they pass behind a surface.

use ga_runtime::vga3::Vector;

use crate::camera::{Camera, Pixel};
use crate::picture::{Curve, Picture, heading};
use crate::surface::{Piece, Surface, outline};

/// The largest number of points of a visible part of a curve. Parts are short so that crossing
/// curves can be painted in the order of their depth.
const LONGEST: usize = 24;

/// A part of a curve that is either completely visible or completely hidden.
#[derive(Clone, Debug)]
pub(crate) struct Stroke {
    pub(crate) points: Vec<Pixel>,
    /// The index of the piece before which it is painted; `None` where nothing hides it.
    pub(crate) before: Option<usize>,
    pub(crate) depth: f64,
    /// The index of its curve in [`all_curves`].
    pub(crate) curve: usize,
    /// The corners of the arrow's head at its end.
    pub(crate) head: Option<[Pixel; 3]>,
}

/// The curves of a picture, followed by the outlines of its balls.
pub(crate) fn all_curves(picture: &Picture, camera: &Camera) -> Vec<Curve> {
    let outlines = picture.balls.iter().map(|ball| Curve {
        element: ball.element,
        colour: ball.colour,
        points: outline(ball, camera).points(96),
        width: ball.width,
        opacity: 1.0,
        dashed: ball.imaginary,
        arrow: false,
    });
    picture.curves.iter().cloned().chain(outlines).collect()
}

/// The surfaces that hide points of a picture.
pub(crate) struct Hiding<'a> {
    picture: &'a Picture,
    camera: &'a Camera,
    /// Each surface with the index of its first piece.
    first: Vec<(Surface, usize)>,
}

impl<'a> Hiding<'a> {
    pub(crate) fn new(picture: &'a Picture, camera: &'a Camera, pieces: &[Piece]) -> Self {
        let mut first: Vec<(Surface, usize)> = Vec::new();
        for (place, piece) in pieces.iter().enumerate() {
            let known = first.iter().any(|(surface, _)| *surface == piece.surface);
            let opacity = match piece.surface {
                Surface::Ball(index) if picture.balls[index].imaginary => 0.0,
                Surface::Ball(index) => picture.balls[index].opacity,
                Surface::Patch(index) => picture.patches[index].opacity,
            };
            // What a translucent surface hides is painted over it, so that it keeps its colour.
            let place = if opacity > 0.9 { place } else { pieces.len() };
            if opacity > 0.02 && !known {
                first.push((piece.surface, place));
            }
        }
        Self {
            picture,
            camera,
            first,
        }
    }

    /// The index of the piece before which a point is painted; `None` where nothing hides it.
    pub(crate) fn before(&self, point: Vector<f64>) -> Option<usize> {
        let hiding = self.first.iter().filter(|(surface, _)| match *surface {
            Surface::Ball(index) => self
                .camera
                .is_behind_ball(point, &self.picture.balls[index]),
            Surface::Patch(index) => self
                .camera
                .is_behind_patch(point, &self.picture.patches[index]),
        });
        hiding.map(|(_, place)| *place).min()
    }

    /// The parts of a curve.
    pub(crate) fn strokes(&self, index: usize, curve: &Curve) -> Vec<Stroke> {
        let mut strokes = Vec::new();
        let mut state = self.before(curve.points[0]);
        let mut part = vec![curve.points[0]];
        let finish = |part: &mut Vec<Vector<f64>>, state, strokes: &mut Vec<Stroke>| {
            if part.len() > 1 {
                strokes.push(self.stroke(index, part, state));
            }
            part.clear();
        };
        for pair in curve.points.windows(2) {
            let next = self.before(pair[1]);
            if next != state {
                let between = self.border(pair[0], pair[1], state);
                part.push(between);
                finish(&mut part, state, &mut strokes);
                part.push(between);
                state = next;
            } else if state.is_none() && !curve.dashed && part.len() >= LONGEST {
                let last = part[part.len() - 1];
                finish(&mut part, state, &mut strokes);
                part.push(last);
            }
            part.push(pair[1]);
        }
        finish(&mut part, state, &mut strokes);
        if let (true, Some(last), Some(direction)) =
            (curve.arrow, strokes.last_mut(), heading(&curve.points))
        {
            let tip = curve.points[curve.points.len() - 1];
            let behind = tip - direction * 0.05;
            let head = [behind, tip].map(|point| self.camera.project(point));
            last.head = arrow_head(head, curve.width);
        }
        strokes
    }

    fn stroke(&self, curve: usize, part: &[Vector<f64>], before: Option<usize>) -> Stroke {
        let depths = part.iter().map(|point| self.camera.depth(*point));
        let points: Vec<Pixel> = part
            .iter()
            .map(|point| self.camera.project(*point))
            .collect();
        Stroke {
            points: simplified(&points),
            before,
            depth: depths.sum::<f64>() / part.len() as f64,
            curve,
            head: None,
        }
    }

    /// The place between two points where the state of the first one ends, by bisection.
    fn border(&self, from: Vector<f64>, to: Vector<f64>, state: Option<usize>) -> Vector<f64> {
        let (mut low, mut high) = (0.0, 1.0);
        let at = |t| from + (to - from) * t;
        for _ in 0..10 {
            let middle = 0.5 * (low + high);
            if self.before(at(middle)) == state {
                low = middle;
            } else {
                high = middle;
            }
        }
        at(high)
    }
}

/// The corners of an arrow's head; `None` where it points to the eye.
fn arrow_head([behind, tip]: [Pixel; 2], width: f64) -> Option<[Pixel; 3]> {
    let [dx, dy] = [tip[0] - behind[0], tip[1] - behind[1]];
    let long = dx.hypot(dy);
    if long < 0.75 {
        return None;
    }
    let [dx, dy] = [dx / long, dy / long];
    let (size, half) = (6.0 + 2.4 * width, 2.4 + 1.1 * width);
    let tip = [tip[0] + 0.35 * size * dx, tip[1] + 0.35 * size * dy];
    let foot = [tip[0] - size * dx, tip[1] - size * dy];
    Some([
        tip,
        [foot[0] - half * dy, foot[1] + half * dx],
        [foot[0] + half * dy, foot[1] - half * dx],
    ])
}

/// A line without the points that are within a twentieth of a pixel of the rest (Douglas and
/// Peucker, 1973).
fn simplified(points: &[Pixel]) -> Vec<Pixel> {
    let mut keep = vec![false; points.len()];
    let last = points.len() - 1;
    (keep[0], keep[last]) = (true, true);
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let farthest = (from + 1..to)
            .map(|k| (k, distance(points[k], points[from], points[to])))
            .fold(
                (0, 0.05),
                |best, this| if this.1 > best.1 { this } else { best },
            );
        if farthest.0 > 0 {
            keep[farthest.0] = true;
            open.extend([(from, farthest.0), (farthest.0, to)]);
        }
    }
    let kept = points.iter().zip(keep).filter(|(_, keep)| *keep);
    kept.map(|(point, _)| *point).collect()
}

/// The distance of a point from a segment.
fn distance(point: Pixel, from: Pixel, to: Pixel) -> f64 {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let [x, y] = [point[0] - from[0], point[1] - from[1]];
    let square = dx * dx + dy * dy;
    let t = if square > 0.0 {
        ((x * dx + y * dy) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (x - t * dx).hypot(y - t * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_a_line_are_left_out() {
        let line: Vec<Pixel> = (0..9).map(|k| [f64::from(k), 2.0 * f64::from(k)]).collect();
        assert_eq!(simplified(&line), [[0.0, 0.0], [8.0, 16.0]]);
        let corner = [[0.0, 0.0], [4.0, 0.01], [8.0, 0.0], [8.0, 8.0]];
        assert_eq!(simplified(&corner), [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0]]);
    }
}
