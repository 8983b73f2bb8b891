//! Contact sheets: the frames of an animation side by side, with key frames marked.
//!
//! [`contact_sheet`] draws every frame with one camera direction and one scale, chosen so that the
//! whole figure with its shadow is in every picture, and puts the pictures under each other in rows
//! with captions. A [`Frame`] is the mesh at one moment: plain positions, however they were found.
//! A [`Sequence`] does so for scenes of any kind, one after the other, as a sheet or as a film.
//! [`captioned_sheet`] puts pictures of any origin side by side.
//!
//! ```
//! use ga_render::sheet::{Caption, Frame, Kind, Options, contact_sheet};
//!
//! let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
//! let corners = |x: f64| [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
//! let places = [corners(0.0), corners(0.3), corners(0.6)];
//! let frames: Vec<_> = places
//!     .iter()
//!     .enumerate()
//!     .map(|(number, positions)| Frame {
//!         caption: Caption {
//!             number,
//!             time: number as f64 / 30.0,
//!             kind: if number == 1 { Kind::InBetween { step: 1, steps: 2 } } else { Kind::Key },
//!         },
//!         positions,
//!         bones: &[],
//!     })
//!     .collect();
//! let sheet = contact_sheet(&frames, &triangles, &Options::default())?;
//! assert_eq!(sheet.pictures.len(), 3);
//! ga_image::png::write(std::env::temp_dir().join("nullcone-doctest-sheet.png"), &sheet.image)?;
//! # std::fs::remove_file(std::env::temp_dir().join("nullcone-doctest-sheet.png"))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod captioned;
mod error;
mod frame;
mod framing;
mod layout;
mod options;
mod paint;
mod plan;
mod sequence;

use rayon::prelude::*;

use crate::Scene;
pub use captioned::{Captioned, captioned_sheet};
pub use error::SheetError;
pub use frame::{Caption, Frame, Kind};
pub use options::{Framing, Layout, Options};
pub use plan::{Plan, Sheet};
pub use sequence::{Sequence, Shooting};

/// Draws the frames of one mesh and lays them out on a sheet.
///
/// All frames stand on one ground and are drawn at one scale, the largest that shows each of them
/// whole.
///
/// # Errors
///
/// [`SheetError`] when there is nothing to be drawn or a frame holds numbers that are not finite.
pub fn contact_sheet(
    frames: &[Frame],
    triangles: &[[u32; 3]],
    options: &Options,
) -> Result<Sheet, SheetError> {
    let mut sequence = Sequence::new(options.clone());
    for frame in frames {
        sequence.add(frame)?;
    }
    let shooting = sequence.shoot()?;
    let plan = shooting.plan()?;
    let pictures = frames.par_iter().enumerate().map(|(index, frame)| {
        let scene = Scene {
            bones: frame.bones,
            ..Scene::new(frame.positions, triangles)
        };
        shooting.picture(index, &scene)
    });
    Ok(plan.sheet(pictures.collect::<Result<_, _>>()?))
}
