//! Left and right: frames in which a detector took one side of a person for the other.
//!
//! A detector that sees a person from behind, or for a moment does not see the face, may name the
//! joints of the left side as those of the right one, for a while and without less confidence. In
//! each view every frame is as it should be or exchanged; the most likely sequence of both is found
//! exactly (A. Viterbi, "Error bounds for convolutional codes and an asymptotically optimum
//! decoding algorithm", 1967). It is likely that
//!
//! - nothing is exchanged, and that this seldom changes,
//! - joints are near to where they were in the frame before,
//! - the rays of a joint from two views meet, or joints are seen near to those of a fitted body.

use ga_anim::clip::opposite_name;
use ga_camera::Camera;
use ga_numerics::least_squares::Loss;
use ga_numerics::order_statistics::median;
use ga_runtime::geometry::ray::Ray;

use crate::Observation;
use crate::gap::{deviations, gap_in_pixels, pairs_of_views};
use crate::model::BodyPoint;

/// The cost of an exchange that begins or ends, in squared standard deviations.
const CHANGE: f64 = 16.0;
/// The cost of a frame in which a view is exchanged.
const EXCHANGED: f64 = 0.25;
/// What is farther away than this, in standard deviations, is wrong: no matter how far.
const LOSS: Loss = Loss::GemanMcClure(3.0);
/// Sequences of more views together are too many; there, a fitted body decides view by view.
const TOGETHER: usize = 6;

/// The left and the right one of points that both sides have.
pub(crate) fn pairs(points: &[BodyPoint]) -> Vec<[usize; 2]> {
    let index = |name: &str| points.iter().position(|point| point.name == name);
    let pairs = points.iter().enumerate().filter_map(|(one, point)| {
        let other = index(&opposite_name(&point.name)?)?;
        (one < other).then_some([one, other])
    });
    pairs.collect()
}

/// For each view and each frame whether left and right are exchanged.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Exchanged(pub(crate) Vec<Vec<bool>>);

impl Exchanged {
    /// Nothing is exchanged.
    pub(crate) fn none(observations: &[Observation]) -> Self {
        let views = observations.first().map_or(0, |first| first.views.len());
        Self(vec![vec![false; observations.len()]; views])
    }

    /// By the views alone: joints move little from frame to frame, and rays of two views meet.
    pub(crate) fn by_views(
        cameras: &[Camera],
        observations: &[Observation],
        pairs: &[[usize; 2]],
    ) -> Self {
        if pairs.is_empty() || cameras.len() > TOGETHER {
            return Self::none(observations);
        }
        let meetings = Meetings::new(cameras, observations, pairs);
        let changes = changes(cameras.len(), observations, pairs);
        Self(likeliest(&changes, |frame, state| {
            meetings.cost(frame, state)
        }))
    }

    /// By a body: for each view, frame and point, the pixel at which it should be seen.
    pub(crate) fn by_body(
        observations: &[Observation],
        expected: &[Vec<Vec<Option<[f64; 2]>>>],
        pairs: &[[usize; 2]],
    ) -> Self {
        let views = observations.first().map_or(0, |first| first.views.len());
        let changes = changes(views, observations, pairs);
        let of_view = |view: usize| {
            let cost = |frame: usize, state: usize| {
                let pixels = &observations[frame].views[view];
                let distance = |seen: usize, at: usize| {
                    let (Some(seen), Some(at)) = (pixels[seen], expected[view][frame][at]) else {
                        return 0.0;
                    };
                    LOSS.of(squared(seen.position, at) / seen.deviation.powi(2))
                        .0
                };
                let of_pairs = pairs.iter().map(|&[left, right]| match state {
                    0 => distance(left, left) + distance(right, right),
                    _ => distance(left, right) + distance(right, left),
                });
                of_pairs.sum()
            };
            likeliest(&changes[view..=view], cost)
        };
        Self((0..views).flat_map(of_view).collect())
    }

    /// What views show with the names of the sides put right.
    pub(crate) fn put_right(
        &self,
        observations: &[Observation],
        pairs: &[[usize; 2]],
    ) -> Vec<Observation> {
        let mut right = observations.to_vec();
        for (view, frames) in self.0.iter().enumerate() {
            for (frame, _) in frames
                .iter()
                .enumerate()
                .filter(|(_, exchanged)| **exchanged)
            {
                for &[left, other] in pairs {
                    right[frame].views[view].swap(left, other);
                }
            }
        }
        right
    }
}

/// For each of some views and each frame whether it is exchanged, as is most likely for all of them
/// together. `changes` has for each view what [`changes`] says, and `cost` says what a state costs
/// in a frame: the number whose bits are the views that are exchanged.
fn likeliest(changes: &[Vec<[f64; 2]>], cost: impl Fn(usize, usize) -> f64) -> Vec<Vec<bool>> {
    let frames = changes.first().map_or(0, Vec::len);
    let unary =
        |frame: usize, state: usize| EXCHANGED * f64::from(state.count_ones()) + cost(frame, state);
    let change = |frame: usize, changed: usize| {
        let views = changes.iter().enumerate();
        views
            .map(|(view, costs)| costs[frame][changed >> view & 1])
            .sum()
    };
    let path = least_path(frames, 1 << changes.len(), unary, change);
    let of_view = |view: usize| path.iter().map(|state| state >> view & 1 == 1).collect();
    (0..changes.len()).map(of_view).collect()
}

/// The states of the least sum of costs: of a state in a frame, and from the frame before with the
/// bits of the state that change.
fn least_path(
    frames: usize,
    states: usize,
    unary: impl Fn(usize, usize) -> f64,
    change: impl Fn(usize, usize) -> f64,
) -> Vec<usize> {
    let mut costs: Vec<f64> = vec![0.0; states];
    let mut before: Vec<Vec<usize>> = Vec::with_capacity(frames);
    for frame in 0..frames {
        let own: Vec<f64> = (0..states).map(|state| unary(frame, state)).collect();
        if frame == 0 {
            costs = own;
            continue;
        }
        let changes: Vec<f64> = (0..states).map(|bits| change(frame, bits)).collect();
        let best = |to: usize| {
            let all = (0..states).map(|from| (from, costs[from] + changes[from ^ to]));
            all.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default()
        };
        let found: Vec<(usize, f64)> = (0..states).map(best).collect();
        costs = found
            .iter()
            .zip(own)
            .map(|((_, cost), own)| cost + own)
            .collect();
        before.push(found.into_iter().map(|(from, _)| from).collect());
    }
    let last = (0..states).min_by(|&a, &b| costs[a].total_cmp(&costs[b]));
    let mut path = vec![last.unwrap_or_default(); frames];
    for frame in (1..frames).rev() {
        path[frame - 1] = before[frame - 1][path[frame]];
    }
    path
}

/// For each view and each frame what it costs to keep and to exchange the sides from the frame
/// before: joints move little. Where joints are missing it is not known.
fn changes(views: usize, observations: &[Observation], pairs: &[[usize; 2]]) -> Vec<Vec<[f64; 2]>> {
    let of_view = |view: usize| {
        let step = |frame: usize, [from, to]: [usize; 2]| {
            let now = observations[frame].views[view][to]?;
            let last = observations[frame.checked_sub(1)?].views[view][from]?;
            Some(squared(now.position, last.position))
        };
        let frames = 0..observations.len();
        let kept = frames.clone().flat_map(|frame| {
            let both = pairs.iter().flatten();
            both.filter_map(move |&point| step(frame, [point; 2]))
                .map(f64::sqrt)
        });
        let mut kept: Vec<f64> = kept.collect();
        let of_view = observations.iter().map(|o| Observation {
            views: vec![o.views[view].clone()],
        });
        let mut deviations = deviations(&of_view.collect::<Vec<_>>());
        let own = median(&mut deviations).unwrap_or(1.0);
        let scale = median(&mut kept).unwrap_or_default().hypot(own);
        let cost = |squared: f64| LOSS.of(squared / (scale * scale)).0;
        let of_frame = |frame: usize| {
            let of_pairs = pairs.iter().filter_map(|&[left, right]| {
                let all = [[left; 2], [right; 2], [left, right], [right, left]];
                let [a, b, c, d] = all.map(|way| step(frame, way).map(cost));
                Some([a? + b?, c? + d?])
            });
            of_pairs.fold([0.0, CHANGE], |[kept, changed], [a, b]| {
                [kept + a, changed + b]
            })
        };
        frames.map(of_frame).collect()
    };
    (0..views).map(of_view).collect()
}

/// For two views and each frame what it costs that their rays do not meet: with equal sides, and
/// with the sides of one of them exchanged.
struct Meetings(Vec<([usize; 2], Vec<[f64; 2]>)>);

impl Meetings {
    fn new(cameras: &[Camera], observations: &[Observation], pairs: &[[usize; 2]]) -> Self {
        let twos = pairs_of_views(cameras.len()).map(<[usize; 2]>::from);
        let twos: Vec<[usize; 2]> = twos.collect();
        // How far rays are apart, in pixels, for each pair of points: equal sides and exchanged.
        let apart = |views: [usize; 2], frame: usize, pair: [usize; 2]| {
            let ray = |view: usize, point: usize| {
                let pixel = observations[frame].views[view][point]?;
                cameras[view].ray(pixel.position).ok()
            };
            let [a, b] = views.map(|view| pair.map(|point| ray(view, point)));
            let gap = |one: Option<Ray<f64>>, other: Option<Ray<f64>>| {
                Some(gap_in_pixels(
                    views.map(|view| &cameras[view]),
                    [one?, other?],
                ))
            };
            let equal = [gap(a[0], b[0])?, gap(a[1], b[1])?];
            Some([equal, [gap(a[0], b[1])?, gap(a[1], b[0])?]])
        };
        let frames = 0..observations.len();
        let of_views = |views: [usize; 2]| -> Vec<Vec<[[f64; 2]; 2]>> {
            let of_frame = |frame| {
                pairs
                    .iter()
                    .filter_map(|&p| apart(views, frame, p))
                    .collect()
            };
            frames.clone().map(of_frame).collect()
        };
        let all: Vec<Vec<Vec<_>>> = twos.iter().map(|&views| of_views(views)).collect();
        let equal = all.iter().flatten().flatten().flat_map(|[equal, _]| *equal);
        let mut equal: Vec<f64> = equal.filter(|gap| gap.is_finite()).collect();
        let own = median(&mut deviations(observations)).unwrap_or(1.0);
        let scale = median(&mut equal).unwrap_or_default().max(own);
        let cost = |gap: f64| LOSS.of((gap / scale).powi(2).min(f64::MAX)).0;
        let of_frame = |gaps: &Vec<[[f64; 2]; 2]>| {
            let sum = |kind: usize| gaps.iter().flat_map(|gaps| gaps[kind]).map(cost).sum();
            [sum(0), sum(1)]
        };
        let costs = all
            .iter()
            .map(|frames| frames.iter().map(of_frame).collect());
        Self(twos.into_iter().zip(costs).collect())
    }

    /// Of views of which those with a bit of the state are exchanged.
    fn cost(&self, frame: usize, state: usize) -> f64 {
        let of_views = self.0.iter().map(|&([a, b], ref costs)| {
            let differ = (state >> a ^ state >> b) & 1;
            costs[frame][differ]
        });
        of_views.sum()
    }
}

fn squared(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)
}
