//! What the camera of a model looks at.

use super::scale::extent;
use super::view::ModelView;

/// The radius in metres to which a smaller model is shown.
const LEAST_RADIUS: f64 = 1e-4;
/// How many times as large as in one frame the whole motion may be for the camera to stay at its
/// place; it follows a model that goes farther.
const STAYING: f64 = 1.35;

/// What the camera looks at.
pub(super) struct Sight {
    pub(super) centres: Vec<[f64; 3]>,
    pub(super) radius: f64,
    pub(super) across: f64,
}

impl Sight {
    /// The camera stays where the model does, and otherwise follows it along the floor.
    pub(super) fn of(model: &ModelView) -> Self {
        let mut used: Vec<usize> = model
            .triangles
            .iter()
            .flatten()
            .map(|&k| k as usize)
            .collect();
        used.sort_unstable();
        used.dedup();
        let places = |frame: usize| used.iter().map(move |&k| model.frames[frame][k]);
        let frames = 0..model.frames.len();
        let [low, high] = extent(frames.clone().flat_map(places));
        let middle = [0, 1, 2].map(|k| f64::midpoint(low[k], high[k]));
        // The greatest distances, horizontal and in space, from a centre of each frame.
        let reach = |centre: &dyn Fn(usize) -> [f64; 3]| {
            let mut most = [0.0_f64; 2];
            for frame in frames.clone() {
                let centre = centre(frame);
                for place in places(frame) {
                    let [x, y, z] = [0, 1, 2].map(|k| place[k] - centre[k]);
                    let across = x * x + z * z;
                    most = [most[0].max(across), most[1].max(across + y * y)];
                }
            }
            most.map(f64::sqrt)
        };
        let means: Vec<[f64; 3]> = frames
            .clone()
            .map(|frame| {
                let mut sum = [0.0; 2];
                for place in places(frame) {
                    sum = [sum[0] + place[0], sum[1] + place[2]];
                }
                let [x, z] = sum.map(|sum| sum / used.len() as f64);
                [x, middle[1], z]
            })
            .collect();
        let following = smooth(&means, model.frames_per_second);
        let [staying, followed] = [reach(&|_| middle), reach(&|frame| following[frame])];
        let (centres, [across, radius]) = if staying[1] <= STAYING * followed[1] {
            (vec![middle], staying)
        } else {
            (following, followed)
        };
        Self {
            centres,
            radius: radius.max(LEAST_RADIUS),
            across,
        }
    }
}

/// The means over a second, and less at the ends: a body that sways does not shake the camera. As
/// many frames before as after each are taken, so that a steady motion stays as it is.
fn smooth(places: &[[f64; 3]], rate: f64) -> Vec<[f64; 3]> {
    let last = places.len() - 1;
    let half = (rate / 2.0).min(last as f64) as usize;
    let smoothed = (0..=last).map(|frame| {
        let half = half.min(frame).min(last - frame);
        let near = &places[frame - half..=frame + half];
        let mean = |k: usize| near.iter().map(|place| place[k]).sum::<f64>() / near.len() as f64;
        [0, 1, 2].map(mean)
    });
    smoothed.collect()
}
