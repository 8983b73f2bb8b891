//! Bounds of joints that are known by name.

use std::str::FromStr;

/// The bound of the joints of a name, as it is written in words: `LeftHand=0.00005`, or
/// `LeftHand=0.00005,0.2` for a shell of its own. See [`Options::bound_by_name`].
///
/// [`Options::bound_by_name`]: super::Options::bound_by_name
#[derive(Clone, Debug, PartialEq)]
pub struct NamedBound {
    /// The name of the joint.
    pub name: String,
    /// Its greatest error in metres.
    pub tolerance: f64,
    /// The radius of its ball of points in metres, where it is not that of all joints.
    pub shell: Option<f64>,
}

/// A text that is not a [`NamedBound`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("must be a name, `=`, a tolerance and perhaps `,` and a shell")]
pub struct NamedBoundError;

impl FromStr for NamedBound {
    type Err = NamedBoundError;

    fn from_str(text: &str) -> Result<Self, NamedBoundError> {
        let (name, numbers) = text.rsplit_once('=').ok_or(NamedBoundError)?;
        let (tolerance, shell) = match numbers.split_once(',') {
            Some((tolerance, shell)) => (tolerance, Some(shell)),
            None => (numbers, None),
        };
        let number = |text: &str| text.trim().parse().map_err(|_| NamedBoundError);
        Ok(Self {
            name: name.to_owned(),
            tolerance: number(tolerance)?,
            shell: shell.map(number).transpose()?,
        })
    }
}
