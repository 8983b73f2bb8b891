//! What cannot be fitted.

use ga_body::{BodyError, BodyFit, BodyModel, JointPixel, Lengths, Observation, fit_lengths};

use super::{biped, heads, moved_biped, rig, seen};

#[test]
fn what_is_not_an_observation_is_refused() {
    let skeleton = biped();
    let names = ["hips", "elbow"];
    assert!(matches!(
        BodyModel::of_joints(skeleton.clone(), &names),
        Err(BodyError::NoJoint { name, .. }) if name == "elbow"
    ));
    let model = BodyModel::of_distinct_joints(skeleton.clone()).unwrap();
    let truth = heads(&skeleton, &moved_biped(&skeleton));
    let cameras = rig(std::slice::from_ref(&truth), 2);
    assert_eq!(BodyFit::new(&model, &[]).unwrap_err(), BodyError::NoViews);
    let fit = BodyFit::new(&model, &cameras).unwrap();
    let good = seen(&cameras, &truth, 1.0, 0.0, 2);
    let refused = |change: &dyn Fn(&mut Observation)| {
        let mut bad = good.clone();
        change(&mut bad);
        fit.frame(&bad).unwrap_err()
    };
    let (expected, found) = (2, 1);
    assert_eq!(
        refused(&|o| drop(o.views.pop())),
        BodyError::Views { expected, found }
    );
    let (view, expected, found) = (1, 9, 8);
    assert_eq!(
        refused(&|o| o.views[1].truncate(8)),
        BodyError::Points {
            view,
            expected,
            found
        }
    );
    let pixel = |position: [f64; 2], deviation: f64| {
        Some(JointPixel {
            position,
            deviation,
        })
    };
    let error = refused(&|o| o.views[1][2] = pixel([f64::NAN, 0.0], 1.0));
    assert!(matches!(error, BodyError::Pixel { view: 1, point, .. } if point == "head"));
    let error = refused(&|o| o.views[0][1] = pixel([1.0, 0.0], 0.0));
    assert!(matches!(error, BodyError::Deviation { view: 0, point, .. } if point == "neck"));
    let error = refused(&|o| o.views.iter_mut().for_each(|view| view[2..].fill(None)));
    assert_eq!(error, BodyError::TooFewPoints { seen: 2, needed: 3 });
    // Views exchanged: rays meet behind the cameras.
    let error = refused(&|o| o.views.swap(0, 1));
    assert!(matches!(error, BodyError::Behind { point, .. } if point == "hips"));
    let clip = fit
        .clip(&[good.clone(), Observation::unseen(1, 9)], 60.0)
        .unwrap_err();
    assert!(matches!(clip, BodyError::Frame { frame: 1, .. }));
    assert_eq!(
        fit.clip(&[good], 0.0).unwrap_err(),
        BodyError::Frame {
            frame: 0,
            error: Box::new(BodyError::FrameRate(0.0)),
        }
    );
}

#[test]
fn lengths_need_two_views_and_a_bone() {
    let skeleton = biped();
    let model = BodyModel::of_distinct_joints(skeleton.clone()).unwrap();
    let truth = heads(&skeleton, &moved_biped(&skeleton));
    let cameras = rig(std::slice::from_ref(&truth), 2);
    let observed = [seen(&cameras, &truth, 1.0, 0.0, 2)];
    let of_one = fit_lengths(&model, &cameras[..1], &observed, Lengths::OneFactor);
    assert_eq!(of_one, Err(BodyError::OneView(1)));
    let unseen = [Observation::unseen(2, truth.len())];
    let of_none = fit_lengths(&model, &cameras, &unseen, Lengths::OneFactor);
    assert_eq!(of_none, Err(BodyError::NoBone));
}
