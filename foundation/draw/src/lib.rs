//! Draws conformal geometric algebra: points, point pairs, circles, spheres, lines, planes, free
//! vectors, frames and paths.
//!
//! A [`Scene`] holds elements of [`cga3`](ga_runtime::cga3). It is written as a picture in SVG
//! ([`Scene::to_svg`]) or as an HTML page on which the mouse rotates it ([`Scene::to_html`]). Each
//! element is first read as Euclidean geometry, a [`Shape`]; see [`Drawable`].
//!
//! ```
//! use ga_draw::{Scene, Style};
//! use ga_runtime::cga3::{Plane, Point, Sphere};
//!
//! let sphere = Sphere::from_centre_radius(Point::new(0.0, 0.0, 0.0), 1.0);
//! let plane = Plane::from_point_normal(Point::new(0.0, 0.0, 0.5), [0.0, 0.0, 1.0]);
//! let mut scene = Scene::new("A sphere and a plane meet in a circle");
//! scene.add(sphere, Style::labelled("S"))?;
//! scene.add(plane, Style::labelled("π"))?;
//! scene.add(sphere & plane, Style::labelled("S ∨ π"))?;
//! let page = scene.to_html();
//! # assert!(page.contains("S ∨ π"));
//! # Ok::<(), ga_draw::NotDrawable>(())
//! ```
//!
//! # How elements look
//!
//! Lines that a sphere or a plane hides are dotted and paler.
//!
//! - An imaginary element has long dashes, and is drawn as its real counterpart: the radius is
//!   √−r².
//! - A point is a dot, a flat point a square, and the points of an imaginary pair are hollow dots.
//! - A tangent vector is a dot with an arrow, a tangent bivector a dot with a small circle.
//! - Lines and planes are cut off around the finite elements.
//! - The axes x, y, z of a frame are orange, green and blue.
//!
//! # Scenes in JSON
//!
//! [`Scene::decode`] and `nullcone draw` read an object with the following members. Only
//! `elements` is required; a member that is not listed is an error.
//!
//! - `title`, `description`: texts. The description is for readers who cannot see the picture.
//! - `view`: an object with
//!   - `turn`: `[azimuth, elevation]` in degrees,
//!   - `zoom`: a factor, 1 by default,
//!   - `projection`: `"perspective"` (the default) or `"orthographic"`,
//!   - `up`: the upward axis, `"z"` (the default) or `"y"`.
//! - `size`: `[width, height]` in pixels, each from 64 to 8192; `[800, 600]` by default.
//! - `axes`, `grid`, `legend`: `true` or `false`. By default only the legend is drawn.
//! - `elements`: a list of elements.
//!
//! Every element may have these members:
//!
//! - `name`: later elements refer to it by this name, which is also its label.
//! - `label`: a label instead of the name.
//! - `colour`: for instance `"#0072b2"`.
//! - `width`: the width of lines in pixels.
//! - `opacity`: of surfaces, from 0 to 1.
//! - `hidden`: `true` for an element that is not drawn, and to which others only refer.
//!
//! It has exactly one of the following members. A place or a vector is `[x, y, z]`.
//!
//! - `point`, `flat_point`: a place.
//! - `point_pair`: two places.
//! - `circle`: `{"through": three places}`, which is a line where they are collinear, or
//!   `{"centre", "normal", "radius"}`.
//! - `sphere`: `{"through": four places}` or `{"centre", "radius"}`.
//! - `line`: `{"through": two places}` or `{"point", "direction"}`.
//! - `plane`: `{"through": three places}`, `{"point", "normal"}` or `{"normal", "distance"}`, where
//!   the distance is that from the origin along the normal.
//! - `direction`: a vector.
//! - `motor`: `{"axis", "through", "degrees", "translation"}`, a rotation about an axis through a
//!   place, followed by a translation. It is drawn as a frame.
//! - `trajectory`: `{"points": places}`, `{"motors": list}` or
//!   `{"screw": {"axis", "through", "degrees", "shift"}}`, where `shift` is the distance along the
//!   axis. Motors and a screw also take the number of `steps`, the `point` that is moved, and the
//!   number of `frames` to be drawn.
//! - `blade`: coefficients of basis blades, such as `{"e123o": 1, "e123i": 0.5}`.
//! - `meet`: the names of two elements, `a ∨ b`. Two lines or circles may also lie in one plane.
//! - `join`: the names of two elements, `a ∧ b`.
//! - `moved`: `{"element": name, "by": motor}`.
//!
//! The motors of a trajectory are joined by screw motions with a rotation of at most 180 degrees; a
//! `screw` may rotate by more than 360 degrees. Examples are in `foundation/draw/examples`.

mod camera;
mod colour;
pub mod document;
mod escape;
mod extent;
mod file;
mod label;
#[cfg(test)]
mod node;
mod page;
mod picture;
mod plane;
mod render;
mod ring;
mod scene;
mod shape;
mod stroke;
mod style;
mod surface;
mod svg;
mod view;

pub use colour::{Colour, NotAColour, PALETTE};
pub use file::{ElementProblem, SceneError};
pub use scene::Scene;
pub use shape::{Drawable, NotDrawable, Shape, Trajectory};
pub use style::Style;
pub use view::{Projection, Up, View};
