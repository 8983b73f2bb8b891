//! Models that cannot be shown.

use super::model;
use crate::document::Page;
use crate::document::model::{ModelCoordinates, ModelError, ModelView};
use crate::document::motion::Encoding;

/// The error of a model after a change, which leaves the page as it was.
#[track_caller]
fn error(change: impl FnOnce(&mut ModelView)) -> ModelError {
    let mut model = model();
    change(&mut model);
    let mut page = Page::new("");
    let error = page.model(&model, "").unwrap_err();
    assert_eq!(page.into_html(), Page::new("").into_html());
    error
}

#[test]
fn there_is_something_to_show() {
    assert_eq!(
        error(|model| model.triangles.clear()),
        ModelError::NoTriangles
    );
    assert_eq!(error(|model| model.frames.clear()), ModelError::NoFrames);
    let nothing = error(|model| *model = ModelView::default());
    assert_eq!(nothing, ModelError::NoTriangles);
}

#[test]
fn numbers_are_numbers() {
    for rate in [0.0, -25.0, f64::INFINITY] {
        let error = error(|model| model.frames_per_second = rate);
        assert_eq!(error, ModelError::FramesPerSecond(rate));
    }
    for value in [f64::NEG_INFINITY, 1.1e5] {
        // Also at vertices that no triangle has.
        let error = error(|model| model.frames[1][4][2] = value);
        let element = "vertex 4 of frame 1".to_owned();
        assert_eq!(error, ModelError::Coordinate { element, value });
    }
    let floor = error(|model| model.floor = Some(f64::NAN));
    assert!(
        floor
            .to_string()
            .contains("the floor has the coordinate NaN")
    );
    let turn = error(|model| model.turn[1] = f64::INFINITY);
    assert_eq!(turn, ModelError::Turn(f64::INFINITY));
}

#[test]
fn lists_have_their_lengths() {
    let frame = error(|model| model.frames[1].truncate(4));
    let expected = ModelError::Positions {
        frame: 1,
        positions: 4,
        vertices: 6,
    };
    assert_eq!(frame, expected);
    let index = error(|model| model.triangles[3][1] = 6);
    let expected = ModelError::Index {
        triangle: 3,
        vertex: 6,
        vertices: 6,
    };
    assert_eq!(index, expected);
    let colours = error(|model| model.colours.as_mut().unwrap().truncate(2));
    let expected = ModelError::Colours {
        colours: 2,
        vertices: 6,
    };
    assert_eq!(colours, expected);
}

#[test]
fn textures_fit() {
    let with = |coordinates: ModelCoordinates| {
        error(|model| model.texture.as_mut().unwrap().coordinates = coordinates)
    };
    let corners = with(ModelCoordinates::Corners(vec![[[0.0; 2]; 3]; 5]));
    assert_eq!(
        corners.to_string(),
        "there are texture coordinates for 5 triangles, but 4 triangles"
    );
    let vertices = with(ModelCoordinates::Vertices(vec![[0.0; 2]; 4]));
    let expected = ModelError::TextureCoordinates {
        coordinates: 4,
        owners: "vertices",
        expected: 6,
    };
    assert_eq!(vertices, expected);
    let mut wrong = vec![[[0.0; 2]; 3]; 4];
    wrong[2][1][1] = f64::INFINITY;
    let expected = ModelError::TextureCoordinate {
        owner: "triangle",
        index: 2,
        value: f64::INFINITY,
    };
    assert_eq!(with(ModelCoordinates::Corners(wrong)), expected);
    let kind = error(|model| model.texture.as_mut().unwrap().encoding = Encoding::Png);
    assert_eq!(kind, ModelError::Picture(Encoding::Png));
    let empty = error(|model| model.texture.as_mut().unwrap().bytes.clear());
    assert_eq!(empty, ModelError::Picture(Encoding::Jpeg));
}
