//! From where a model is seen, as text and in a number of pictures around it.

use std::str::FromStr;

use ga_runtime::cga3::{Motor, Point, Rotor};

use crate::model::Model;
use crate::{RenderError, View, ViewDirection};

/// From where a model is seen.
///
/// As text it is `front`, `side`, `top` or `three-quarter`, or the words
/// `eye X,Y,Z target X,Y,Z [up X,Y,Z] fov DEGREES`, whose pairs may come in any order but for the
/// eye. The upward direction is `0,1,0` where it is not given.
///
/// ```
/// use ga_render::{Viewpoint, ViewpointError};
///
/// let above: Viewpoint = "eye 0,5,0 target 0,0,0 up 0,0,-1 fov 40".parse()?;
/// assert!(matches!(above, Viewpoint::Towards { eye: [0.0, 5.0, 0.0], .. }));
/// assert_eq!("behind".parse::<Viewpoint>(), Err(ViewpointError::Unknown("behind".into())));
/// # Ok::<(), ViewpointError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Viewpoint {
    /// From a side, so that the whole model is seen.
    Side(ViewDirection),
    /// From a place towards another.
    Towards {
        /// The place.
        eye: [f64; 3],
        /// What is in the middle of the picture.
        target: [f64; 3],
        /// What points up in the picture.
        up: [f64; 3],
        /// The vertical field of view in radians.
        field_of_view: f64,
    },
    /// As this view sees it.
    View(View),
}

/// A text that is not a [`Viewpoint`].
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ViewpointError {
    /// It is not a known side and does not begin with `eye`.
    #[error(
        "{0}: not front, side, top, three-quarter, or of the form \"eye X,Y,Z target X,Y,Z fov \
         DEGREES\""
    )]
    Unknown(String),
    /// A word stands at the end where a value belongs to it.
    #[error("there is nothing after {0}")]
    NoValue(String),
    /// A word has no meaning.
    #[error("{0:?} is not eye, target, up or fov")]
    Word(String),
    /// What is needed is missing.
    #[error("the {0} is missing")]
    Missing(&'static str),
    /// A place or a direction has another number of coordinates than three.
    #[error("{word} {text} has {found} numbers, not 3")]
    Count {
        /// What it is.
        word: String,
        /// Its text.
        text: String,
        /// How many numbers there are.
        found: usize,
    },
    /// A text is not a number, or not a finite one.
    #[error("{text:?} after {word} is not a finite number")]
    Number {
        /// What it is.
        word: String,
        /// Its text.
        text: String,
    },
}

/// The vertical field of view from a side, in radians.
const FIELD_OF_VIEW: f64 = 0.6;

/// The free border of a view from a side, as a fraction of half the picture.
const MARGIN: f64 = 0.08;

/// The near depth of a view from a place, as a share of the distance to its target.
const NEAR: f64 = 1e-3;

impl Viewpoint {
    /// The views of a number of pictures with this quotient of width and height, the first from the
    /// viewpoint, the others around the vertical axis through the middle of the model. From a side
    /// the model is seen whole in all of them.
    ///
    /// # Errors
    ///
    /// As [`View::fit`] and [`View::look_at`].
    pub fn turntable(
        &self,
        model: &Model,
        aspect: f64,
        count: u32,
    ) -> Result<Vec<View>, RenderError> {
        let [low, high] = model.bounds();
        let middle = Point::new((low.e1 + high.e1) / 2.0, 0.0, (low.e3 + high.e3) / 2.0);
        let steps = (0..count).map(|step| {
            let angle = std::f64::consts::TAU * f64::from(step) / f64::from(count);
            let rotor = Rotor::from_axis_angle([0.0, 1.0, 0.0], angle).unwrap_or_default();
            Motor::about(middle, rotor)
        });
        // Seen from a camera that has moved, the model has moved in the opposite way.
        let shown = steps.clone().flat_map(|motion| {
            let back = motion.reverse();
            let points = model.points();
            points.map(move |point| back.transform(Point::from(point)).coordinates())
        });
        let first = self.view(shown, aspect)?;
        Ok(steps.map(|motion| first.moved(motion)).collect())
    }

    /// The view of a picture with this quotient of width and height. From a side it shows all
    /// points.
    ///
    /// # Errors
    ///
    /// As [`View::fit`] and [`View::look_at`].
    pub fn view(
        &self,
        points: impl IntoIterator<Item = [f64; 3]>,
        aspect: f64,
    ) -> Result<View, RenderError> {
        match *self {
            Self::Side(side) => View::fit(points, side, FIELD_OF_VIEW, aspect, MARGIN),
            Self::Towards {
                eye,
                target,
                up,
                field_of_view,
            } => {
                let squares = (0..3).map(|axis| (eye[axis] - target[axis]).powi(2));
                let near = NEAR * squares.sum::<f64>().sqrt();
                let near = near.max(f64::MIN_POSITIVE);
                View::look_at(eye, target, up, field_of_view, near)
            }
            Self::View(view) => Ok(view),
        }
    }
}

impl FromStr for Viewpoint {
    type Err = ViewpointError;

    fn from_str(text: &str) -> Result<Self, ViewpointError> {
        let side = |azimuth: f64, elevation: f64| {
            Ok(Self::Side(ViewDirection {
                azimuth: azimuth.to_radians(),
                elevation: elevation.to_radians(),
            }))
        };
        match text.trim() {
            "front" => side(0.0, 0.0),
            "side" => side(90.0, 0.0),
            "top" => side(0.0, 90.0),
            "three-quarter" => side(35.0, 20.0),
            words if words.starts_with("eye ") => towards(words),
            _ => Err(ViewpointError::Unknown(text.to_owned())),
        }
    }
}

fn towards(text: &str) -> Result<Viewpoint, ViewpointError> {
    let (mut eye, mut target, mut up, mut field_of_view) = (None, None, None, None);
    let mut words = text.split_whitespace();
    while let Some(word) = words.next() {
        let value = words.next();
        let value = value.ok_or_else(|| ViewpointError::NoValue(word.to_owned()))?;
        match word {
            "eye" => eye = Some(triple(word, value)?),
            "target" => target = Some(triple(word, value)?),
            "up" => up = Some(triple(word, value)?),
            "fov" => field_of_view = Some(number(word, value)?),
            _ => return Err(ViewpointError::Word(word.to_owned())),
        }
    }
    let missing = |what| move || ViewpointError::Missing(what);
    Ok(Viewpoint::Towards {
        eye: eye.ok_or_else(missing("eye"))?,
        target: target.ok_or_else(missing("target"))?,
        up: up.unwrap_or([0.0, 1.0, 0.0]),
        field_of_view: field_of_view
            .map(f64::to_radians)
            .ok_or_else(missing("field of view (fov)"))?,
    })
}

fn triple(word: &str, text: &str) -> Result<[f64; 3], ViewpointError> {
    let numbers = text.split(',').map(|part| number(word, part));
    let numbers = numbers.collect::<Result<Vec<_>, _>>()?;
    <[f64; 3]>::try_from(numbers).map_err(|numbers| ViewpointError::Count {
        word: word.to_owned(),
        text: text.to_owned(),
        found: numbers.len(),
    })
}

fn number(word: &str, text: &str) -> Result<f64, ViewpointError> {
    let number = text.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| ViewpointError::Number {
        word: word.to_owned(),
        text: text.to_owned(),
    })
}
