//! What is within a radius of a key.

use std::fmt;
use std::str::FromStr;

use crate::capture::CaptureError;

/// The part of a surface within a radius of a key along the surface, written `chin:0.04`.
///
/// ```
/// use ga_vision::capture::KeyArea;
/// let area: KeyArea = "chin:0.04".parse()?;
/// assert_eq!((area.key.as_str(), area.radius), ("chin", 0.04));
/// assert!("chin:-1".parse::<KeyArea>().is_err());
/// # Ok::<(), ga_vision::capture::CaptureError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct KeyArea {
    /// The name of the point, or its number from 0.
    pub key: String,
    /// The radius in the unit of the mesh.
    pub radius: f64,
}

impl FromStr for KeyArea {
    type Err = CaptureError;

    fn from_str(text: &str) -> Result<Self, CaptureError> {
        let (key, radius) = text.rsplit_once(':').ok_or(CaptureError::AreaText)?;
        let radius = radius.parse().ok();
        let radius = radius.filter(|r: &f64| r.is_finite() && *r > 0.0 && !key.is_empty());
        Ok(Self {
            key: key.to_owned(),
            radius: radius.ok_or(CaptureError::AreaText)?,
        })
    }
}

impl fmt::Display for KeyArea {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.key, self.radius)
    }
}
