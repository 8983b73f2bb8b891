//! A person in views, as several commands read it: joints, cameras, and the character that is
//! fitted.

mod cameras;
mod character;
mod dotted;
mod film_rate;
mod findings;
mod joints;
mod lengths;

pub(crate) use cameras::{CameraFiles, ViewCamera};
pub(crate) use character::{CharacterFile, MANNEQUIN, at_rest};
pub(crate) use dotted::{Dotted, DottedCharacter, HueSeed};
pub(crate) use film_rate::{is_other_rate, stated_rate};
pub(crate) use findings::{judged, noted};
pub(crate) use joints::JointFiles;
pub(crate) use lengths::FitLengths;
