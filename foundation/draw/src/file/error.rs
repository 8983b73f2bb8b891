//! What can be wrong with a scene in JSON.

use crate::colour::NotAColour;
use crate::shape::NotDrawable;

/// The reason why a JSON text is not a scene.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// It is not JSON, or not in the format of scenes; the message has line and column.
    #[error("{0}")]
    Json(#[from] serde_json::Error),
    /// A member of the scene itself has a value out of range.
    #[error("`{member}` is {value}, but must be {expected}")]
    Member {
        /// The name of the member.
        member: &'static str,
        /// Its value.
        value: String,
        /// The values that are allowed.
        expected: &'static str,
    },
    /// An element is wrong.
    #[error("element {index}{}: {problem}", name.as_ref().map(|name| format!(" (`{name}`)")).unwrap_or_default())]
    Element {
        /// The index of the element, counted from 0.
        index: usize,
        /// Its name, where it has one.
        name: Option<String>,
        /// What is wrong.
        problem: ElementProblem,
    },
}

/// The reason why an element of a scene is wrong.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ElementProblem {
    /// It has a member for none of the kinds, or for more than one.
    #[error("it must have exactly one kind of element, but has {0}")]
    Kinds(String),
    /// It refers to a name that no earlier element has.
    #[error("no element before it is named `{0}`")]
    UnknownName(String),
    /// An earlier element has the same name.
    #[error("an element before it has the same name")]
    DuplicateName,
    /// It refers to an element that is not a blade and cannot be met, joined or moved.
    #[error("`{0}` is not a blade")]
    NotABlade(String),
    /// It names a basis blade that the algebra does not have.
    #[error(
        "`{0}` is not a basis blade of cga3: these are written as scalar, e1, e12, e1o, e12oi, eoi"
    )]
    UnknownBlade(String),
    /// A number is out of range.
    #[error("`{member}` is {value}, but must be {expected}")]
    Number {
        /// The name of the member.
        member: &'static str,
        /// Its value.
        value: f64,
        /// The values that are allowed.
        expected: &'static str,
    },
    /// A direction has length zero.
    #[error("`{0}` is zero and has no direction")]
    NoDirection(&'static str),
    /// The two elements do not meet, not even in imaginary points.
    #[error("`{0}` and `{1}` do not meet: they have nothing in common that could be drawn")]
    NoMeet(String, String),
    /// The text is not a colour.
    #[error(transparent)]
    Colour(#[from] NotAColour),
    /// The element cannot be drawn.
    #[error(transparent)]
    NotDrawable(#[from] NotDrawable),
}
