//! Which pictures of several views were taken at one time, and the frames between them.
//!
//! The lists of detectors leave out pictures without people. The numbers of pictures say where such
//! frames are: those that are missing between the first and the last are frames in which no
//! joint is seen.

use std::collections::HashMap;

use super::keys::sorted;
use super::{
    Detections, DetectorOptions, FrameKey, JointView, JointViews, JointsError, JointsNote,
};

/// Numbers of which more than nine of ten are missing are not those of frames.
const MOST_FRAMES_A_PICTURE: i128 = 10;

/// How far two statements of one frame rate may differ, relatively: 29.97 is 30000/1001.
const RATE_TOLERANCE: f64 = 1e-4;

impl JointViews {
    /// The joints of one person in views with detections of the same joints, by the names of the
    /// views.
    ///
    /// Pictures of several views belong together where their keys are equal; a picture that a view
    /// does not have shows no joint. Where no picture of a view has its key in the views before, as
    /// where pictures are numbered on from one view to the next, they belong together by their
    /// order.
    ///
    /// Where pictures are numbered, numbers that are missing between the first and the last are
    /// frames without joints. The numbers of a slower film, such as 0, 10, 20, have a step: the
    /// greatest common divisor of all differences. Numbers of which more than nine of ten would be
    /// missing are not those of frames. [`notes`](Self::notes) say all that.
    ///
    /// # Errors
    /// [`JointsError`] for views of different joints or frame rates, views of nobody, a person that
    /// a picture does not have, views without common keys and of different numbers of frames, and
    /// as [`new`](Self::new).
    ///
    /// ```
    /// use ga_body::format::{DetectorOptions, JointViews, coco};
    ///
    /// let numbers = vec!["5, 7, 1"; 17].join(",");
    /// let picture = |id| format!(r#"{{"image_id": {id}, "keypoints": [{numbers}]}}"#);
    /// // Nobody was found in picture 2.
    /// let text = format!("[{}, {}, {}]", picture(0), picture(1), picture(3));
    /// let people = coco::decode(text.as_bytes(), None)?;
    /// let views = [("left".to_owned(), people)];
    /// let joints = JointViews::from_detections(&views, &DetectorOptions::default())?;
    /// assert_eq!(joints.frame_count(), 4);
    /// assert_eq!(joints.views()[0].frames[2][0], None);
    /// assert_eq!(joints.notes().len(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_detections(
        views: &[(String, Detections)],
        options: &DetectorOptions,
    ) -> Result<Self, JointsError> {
        let deviation = options.deviation_px;
        if !(deviation > 0.0 && deviation.is_finite()) {
            return Err(JointsError::Deviation(deviation));
        }
        let joints = common_joints(views)?;
        let rate = match options.frames_per_second {
            Some(rate) => Some(rate),
            None => common_rate(views)?,
        };
        let mut notes = Vec::new();
        let timeline = timeline(views, &mut notes);
        let mut joined = Vec::with_capacity(views.len());
        for ((name, detections), frames) in views.iter().zip(timeline) {
            let unseen = || vec![None; joints.len()];
            let frame = |picture: &Option<usize>| {
                let seen = picture.map(|picture| detections.person(picture, options));
                Ok(seen.transpose()?.flatten().unwrap_or_else(unseen))
            };
            let missing = frames.iter().filter(|picture| picture.is_none()).count();
            if missing > 0 {
                notes.push(JointsNote::FramesWithoutPeople {
                    view: name.clone(),
                    missing,
                    frames: frames.len(),
                });
            }
            if detections.negative_confidences > 0 {
                notes.push(JointsNote::NegativeConfidences {
                    view: name.clone(),
                    joints: detections.negative_confidences,
                });
            }
            joined.push(JointView {
                name: name.clone(),
                frames: frames
                    .iter()
                    .map(frame)
                    .collect::<Result<_, JointsError>>()?,
            });
        }
        Ok(Self::new(joints, rate, joined)?.with_notes(notes))
    }
}

/// The joints of all views that show people.
fn common_joints(views: &[(String, Detections)]) -> Result<Vec<String>, JointsError> {
    if views.is_empty() {
        return Err(JointsError::Empty("views"));
    }
    let mut with_people = views.iter().filter(|(_, view)| view.has_people());
    let Some((_, first)) = with_people.next() else {
        return Err(JointsError::Empty("people"));
    };
    match with_people.find(|(_, view)| view.joints != first.joints) {
        Some((name, _)) => Err(JointsError::Kinds { view: name.clone() }),
        None => Ok(first.joints.clone()),
    }
}

/// The frame rate that views state.
fn common_rate(views: &[(String, Detections)]) -> Result<Option<f64>, JointsError> {
    let mut rates = views
        .iter()
        .filter_map(|(name, view)| Some((name, view.frames_per_second?)));
    let Some((first, rate)) = rates.next() else {
        return Ok(None);
    };
    match rates.find(|(_, other)| (other - rate).abs() > RATE_TOLERANCE * rate) {
        Some((name, other)) => Err(JointsError::FrameRates {
            views: [first, name].map(Clone::clone),
            rates: [rate, other],
        }),
        None => Ok(Some(rate)),
    }
}

/// For each view which of its pictures each frame is, `None` where it has none.
fn timeline(
    views: &[(String, Detections)],
    notes: &mut Vec<JointsNote>,
) -> Vec<Vec<Option<usize>>> {
    let places = |(_, view): &(String, Detections)| -> HashMap<FrameKey, usize> {
        // Of pictures with equal keys the first.
        let frames = view.frames.iter().enumerate().rev();
        frames
            .map(|(index, frame)| (frame.key.clone(), index))
            .collect()
    };
    let places: Vec<HashMap<FrameKey, usize>> = views.iter().map(places).collect();
    let are_shared = (1..places.len()).all(|view| {
        let before = &places[..view];
        let mut keys = places[view].keys();
        keys.any(|key| before.iter().any(|other| other.contains_key(key)))
    });
    let mut frames: Vec<Vec<FrameKey>> = if are_shared {
        vec![sorted(places.iter().flat_map(HashMap::keys)); views.len()]
    } else {
        places.iter().map(|own| sorted(own.keys())).collect()
    };
    fill(&mut frames, views, notes);
    let of_view = |(frames, places): (&Vec<FrameKey>, &HashMap<FrameKey, usize>)| {
        frames.iter().map(|key| places.get(key).copied()).collect()
    };
    frames.iter().zip(&places).map(of_view).collect()
}

/// Adds the numbers that are missing in lists of frames, where all have numbers.
fn fill(frames: &mut [Vec<FrameKey>], views: &[(String, Detections)], notes: &mut Vec<JointsNote>) {
    let number = |key: &FrameKey| match key {
        FrameKey::Number(number) => Some(i128::from(*number)),
        FrameKey::Name(_) => None,
    };
    let numbers = frames.iter().map(|keys| keys.iter().map(number).collect());
    let Some(numbers) = numbers.collect::<Option<Vec<Vec<i128>>>>() else {
        return;
    };
    let differences = numbers.iter().flat_map(|view| view.windows(2));
    let step = differences.fold(0, |step, pair| common_divisor(step, pair[1] - pair[0]));
    if step == 0 {
        return;
    }
    let span = |view: &[i128]| match view {
        [first, .., last] => (last - first) / step + 1,
        _ => view.len() as i128,
    };
    let is_spread = |view: &(&Vec<i128>, &(String, Detections))| {
        span(view.0) > MOST_FRAMES_A_PICTURE * view.0.len() as i128
    };
    let unsigned = |number: i128| u64::try_from(number).unwrap_or(u64::MAX);
    if let Some((view, (name, _))) = numbers.iter().zip(views).find(is_spread) {
        notes.push(JointsNote::NotFrameNumbers {
            view: name.clone(),
            pictures: view.len(),
            span: unsigned(span(view)),
        });
        return;
    }
    if step > 1 {
        let step = unsigned(step);
        notes.push(JointsNote::Step { step });
    }
    for (keys, view) in frames.iter_mut().zip(&numbers) {
        let filled = (0..span(view)).map(|frame| view[0] + frame * step);
        // Between numbers of this type.
        let filled = filled.filter_map(|number| i64::try_from(number).ok());
        *keys = filled.map(FrameKey::Number).collect();
    }
}

fn common_divisor(a: i128, b: i128) -> i128 {
    match a {
        0 => b,
        a => common_divisor(b % a, a),
    }
}
