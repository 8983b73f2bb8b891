//! Lenses that are found by what remains of boards.

use ga_camera::{Camera, Fisheye, Intrinsics, Lens, LensModel, RadialTangential};
use ga_runtime::cga3::Motor;
use ga_vision::calibration::{LensFit, LensTerms, calibrate_lens};

use super::{SIZE, TILTS, boards, motor, places, views};

const NOISE: f64 = 0.15;

fn camera(focal: f64, lens: impl Into<Lens>) -> Camera {
    let plain = Intrinsics::new([focal, 1.01 * focal], [322.0, 236.5]).unwrap();
    Camera {
        intrinsics: plain.with_lens(lens),
        world_to_camera: Motor::default(),
    }
}

fn found(camera: &Camera, boards: &[Motor<f64>], given: Option<LensTerms>) -> LensFit {
    let seen = views(camera, boards, NOISE, 3);
    calibrate_lens(&seen, &places(), SIZE, given).unwrap()
}

/// The deviations say how far the parameters are from the truth.
fn assert_close(fit: &LensFit, truth: &Camera) {
    let values = fit.camera.intrinsics.parameters();
    let expected = truth.intrinsics.parameters();
    for parameter in fit.terms.free() {
        let apart = (values[parameter] - expected[parameter]).abs();
        let deviation = fit.camera.deviations[parameter];
        assert!(
            apart < 4.0 * deviation,
            "{parameter}: {apart} with ± {deviation}"
        );
    }
    // Of 432 corners and more, what remains is the noise of both coordinates.
    let expected = NOISE * 2.0_f64.sqrt();
    assert!(
        (fit.camera.rms / expected - 1.0).abs() < 0.1,
        "{}",
        fit.camera.rms
    );
}

/// Boards near a lens that sees far to the sides.
fn wide_boards() -> Vec<Motor<f64>> {
    let near = boards(&TILTS);
    let turned = |k: usize| {
        let angle = 0.9 * ((k % 4) as f64 - 1.5);
        let axis = if k.is_multiple_of(2) {
            [0.0, 1.0, 0.0]
        } else {
            [0.6, 0.8, 0.0]
        };
        motor(axis, angle, [0.0; 3])
    };
    near.iter()
        .enumerate()
        .map(|(k, board)| turned(k) * *board)
        .collect()
}

#[test]
fn a_fisheye_is_found_by_itself() {
    let truth = camera(180.0, Fisheye::new(&[0.03, -0.01, 0.004, -0.001]).unwrap());
    let boards = wide_boards();
    let fit = found(&truth, &boards, None);
    assert_eq!(fit.terms.model(), LensModel::Fisheye, "{:?}", fit.tried);
    assert!(fit.better.is_none());
    assert_close(&fit, &truth);
    // Where another lens is asked for, a hint names it.
    let forced = found(&truth, &boards, Some(LensTerms::none()));
    assert_eq!(forced.terms.model(), LensModel::Pinhole);
    assert_eq!(forced.better.unwrap().lens, "fisheye");
    let seen = views(&truth, &boards, NOISE, 3);
    let usual = Some(LensTerms::radial_tangential());
    match calibrate_lens(&seen, &places(), SIZE, usual) {
        Ok(forced) => assert_eq!(forced.better.unwrap().lens, "fisheye"),
        Err(error) => assert!(error.to_string().contains("fisheye leaves"), "{error}"),
    }
}

#[test]
fn an_ordinary_lens_stays_one() {
    let lens = RadialTangential::new(&[-0.25, 0.08, 0.001, -0.001, 0.0]).unwrap();
    for truth in [camera(540.0, lens), camera(540.0, Lens::Pinhole)] {
        let fit = found(&truth, &boards(&TILTS), None);
        assert_eq!(fit.terms, LensTerms::radial_tangential(), "{:?}", fit.tried);
        assert!(fit.better.is_none(), "{:?}", fit.tried);
        assert_close(&fit, &truth);
    }
    let forced = found(
        &camera(540.0, lens),
        &boards(&TILTS),
        Some(LensTerms::none()),
    );
    let better = forced.better.unwrap();
    assert!(
        better.rms_px.unwrap() < 0.25 && forced.camera.rms > 0.5,
        "{better:?}"
    );
}
