//! A figure in motion: read from files, shown, measured and written.
//!
//! A [`Figure`] is a [`Character`](ga_anim::character::Character) with a name and a painted skin.
//! An [`Animation`] is its motion, with the [`Storyboard`] of the moments that are shown.
//!
//! | module | what it does |
//! | --- | --- |
//! | [`storyboard`] | chooses the moments: key frames and in-betweens along screws |
//! | [`overlay`] | bones and the paths of joints over pictures |
//! | [`pictures`] | draws the contact sheet and the film |
//! | [`model`], [`gltf`] | the model as files: OBJ at rest, binary glTF with the motion |
//! | [`animated_scene`] | a glTF document at any time of its animations, ready to be drawn |
//! | [`two_views`] | how accurately two cameras find the joints |
//! | [`report`] | what is said of a figure and its animation |
//!
//! Lengths are in metres with y up, a figure at rest looks along z, times are in seconds, and the
//! ground is at the height 0.
//!
//! ```
//! use ga_character::{Figure, Storyboard, TwoViews, model};
//! use ga_mannequin::{Human, walk};
//!
//! let figure = Figure::new("mannequin", Human::new().into());
//! let keys = walk(1);
//! let storyboard = Storyboard::of_keys(&keys, 1);
//! assert_eq!(storyboard.moments.len(), 5);
//!
//! let seen = TwoViews::new(&figure.character, &keys, 1)?;
//! assert!(seen.noise_free.joint_position_error_max_metres < 1e-9);
//! let (files, _) = model::files(&figure, &keys, "walk")?;
//! assert_eq!(files[1].name, "model.glb");
//! # Ok::<(), ga_character::CharacterError>(())
//! ```

pub mod animated_scene;
mod error;
mod figure;
pub mod gltf;
pub mod model;
pub mod overlay;
pub mod pictures;
mod read;
pub mod report;
mod staging;
pub mod storyboard;
pub mod two_views;

pub use animated_scene::AnimatedScene;
pub use error::CharacterError;
pub use figure::Figure;
pub use overlay::Overlay;
pub use report::Animation;
pub use storyboard::Storyboard;
pub use two_views::TwoViews;
