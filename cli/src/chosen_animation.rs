//! The animation of a glTF document that a command plays.

use std::path::Path;

use anyhow::{Result, bail};
use ga_mesh::gltf::{Animation, Document};
use serde::Serialize;

use crate::frame::Warning;

/// What stands for the pose of the nodes alone.
const REST: &str = "rest";

#[derive(Clone, Debug, Serialize, clap::Args)]
pub(crate) struct ChosenAnimation {
    /// The animation: its name, or its number from 0. `rest` is the pose of the nodes alone.
    ///
    /// The default is the first, and `rest` for a model without animations.
    #[arg(long, value_name = "NAME|N")]
    animation: Option<String>,
}

impl ChosenAnimation {
    pub(crate) fn is_given(&self) -> bool {
        self.animation.is_some()
    }

    /// The number of the animation; `None` for the pose of the nodes.
    pub(crate) fn number(&self, document: &Document) -> Result<Option<usize>> {
        let animations = &document.animations;
        let Some(text) = self.animation.as_deref() else {
            return Ok((!animations.is_empty()).then_some(0));
        };
        if text == REST {
            return Ok(None);
        }
        let numbered = animations.iter().enumerate();
        let mut named = numbered.filter(|(_, found)| found.name.as_deref() == Some(text));
        let number = match (named.next(), named.next()) {
            (Some((number, _)), None) => Some(number),
            (Some(_), Some(_)) => bail!(
                "--animation {text}: several animations have this name; choose one by its number"
            ),
            (None, _) => text.parse().ok().filter(|&n: &usize| n < animations.len()),
        };
        if number.is_some() {
            return Ok(number);
        }
        let list = animations.iter().enumerate().map(|(number, animation)| {
            let name = animation.name.as_deref().unwrap_or("no name");
            format!("{number} ({name})")
        });
        let list: Vec<String> = list.collect();
        let list = match list.is_empty() {
            true => String::new(),
            false => format!(": {}", list.join(", ")),
        };
        let count = animations.len();
        bail!("--animation {text}: there is no animation {text}: the file has {count}{list}")
    }
}

/// Warns where times are before the beginning of an animation or after its last key.
pub(crate) fn warn_of_times(
    file: &Path,
    animation: Option<&Animation>,
    times: [f64; 2],
    warnings: &mut Vec<Warning>,
) {
    let Some(animation) = animation else { return };
    let duration = animation.duration();
    // Keys are in single precision.
    let most = duration + f64::from(f32::EPSILON) * duration.abs();
    if times[0] < 0.0 || times[1] > most {
        let message = format!(
            "the animation goes from 0 to {} s; before its first key and after its last one, \
             nothing moves",
            duration as f32
        );
        warnings.push(Warning::new("time_out_of_range", message).in_file(file));
    }
}
