//! What can be wrong with a scene in JSON.

use crate::colour::NotAColour;
use crate::shape::NotDrawable;

/// A JSON text that holds no scene.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// It is no JSON, or not of the format; the message has line and column.
    #[error("{0}")]
    Json(#[from] serde_json::Error),
    /// A member of the scene itself makes no sense.
    #[error("`{member}` is {value}, but must be {expected}")]
    Member {
        /// The member.
        member: &'static str,
        /// What it is.
        value: String,
        /// What it may be.
        expected: &'static str,
    },
    /// An element makes no sense.
    #[error("element {index}{}: {problem}", name.as_ref().map(|name| format!(" (`{name}`)")).unwrap_or_default())]
    Element {
        /// The element, counted from 0.
        index: usize,
        /// Its name, where it has one.
        name: Option<String>,
        /// What is wrong.
        problem: ElementError,
    },
}

/// What is wrong with an element of a scene.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ElementError {
    /// It names no kind, or more than one.
    #[error("it must name one kind of element and names {0}")]
    Kinds(String),
    /// A name that no earlier element has.
    #[error("no element before it is named `{0}`")]
    UnknownName(String),
    /// A name that an earlier element has already.
    #[error("an element before it has the same name")]
    DuplicateName,
    /// The element that it names is no blade, so that it cannot be met, joined or moved.
    #[error("`{0}` is not a blade")]
    NotABlade(String),
    /// A coefficient of a blade that the algebra has not.
    #[error("`{0}` is no blade of cga3: blades are written as in scalar, e1, e12, e1o, e12oi, eoi")]
    UnknownBlade(String),
    /// A number that makes no sense where it is.
    #[error("`{member}` is {value}, but must be {expected}")]
    Number {
        /// The member.
        member: &'static str,
        /// What it is.
        value: f64,
        /// What it may be.
        expected: &'static str,
    },
    /// A direction of length zero.
    #[error("`{0}` is zero and has no direction")]
    NoDirection(&'static str),
    /// Two elements that do not meet, not even in imaginary points.
    #[error("`{0}` and `{1}` do not meet: they have nothing in common that could be drawn")]
    NoMeet(String, String),
    /// Not the name of a colour.
    #[error(transparent)]
    Colour(#[from] NotAColour),
    /// The element has no picture.
    #[error(transparent)]
    NotDrawable(#[from] NotDrawable),
}
