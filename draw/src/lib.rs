//! Draws conformal geometric algebra: points, point pairs, circles, spheres, lines, planes, free
//! vectors, frames and paths.
//!
//! A [`Scene`] takes elements of [`cga3`](ga_runtime::cga3) and becomes a picture
//! ([`Scene::to_svg`]) or a page that turns under the mouse ([`Scene::to_html`]). Each element is
//! first read as Euclidean geometry, a [`Shape`]; see [`Drawable`].
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
//! # How things look
//!
//! What a sphere or plane hides is dotted and paler. Imaginary elements have long dashes and are
//! drawn as their real counterparts: the radius is √−r². A flat point is a square, an imaginary
//! point a hollow dot, a tangent vector a dot with an arrow, a tangent bivector a dot with a small
//! circle. Lines and planes are cut off around the finite elements. The axes x, y, z of frames are
//! orange, green and blue.
//!
//! # Scenes in JSON
//!
//! [`Scene::from_json`] and `nullcone draw` read an object with these members, all optional but
//! `elements`. Others are errors.
//!
//! | member | value |
//! | --- | --- |
//! | `title`, `description` | texts; the description is for those who cannot see the picture |
//! | `view` | `{"turn": [azimuth, elevation], "zoom": 1, "projection": "perspective" or "orthographic", "up": "z" or "y"}`; degrees |
//! | `size` | `[width, height]` in pixels, each from 64 to 8192; [800, 600] without it |
//! | `axes`, `grid`, `legend` | `true` or `false`; without them there is only the legend |
//! | `elements` | a list of elements |
//!
//! An element may have a `name`, by which later ones refer to it and which is its label, a `label`
//! of its own, a `colour` (`"#0072b2"`), a `width` in pixels, an `opacity` from 0 to 1, and
//! `"hidden": true` where it is only referred to. It has exactly one of these members, in which a
//! place or vector is `[x, y, z]`:
//!
//! | kind | value |
//! | --- | --- |
//! | `point`, `flat_point` | a place |
//! | `point_pair` | two places |
//! | `circle` | `{"through": three places}`, a line where they are on one, or `{"centre", "normal", "radius"}` |
//! | `sphere` | `{"through": four places}` or `{"centre", "radius"}` |
//! | `line` | `{"through": two places}` or `{"point", "direction"}` |
//! | `plane` | `{"through": three places}`, `{"point", "normal"}` or `{"normal", "distance"}`, the distance along the normal from the origin |
//! | `direction` | a vector |
//! | `motor` | `{"axis", "through", "degrees", "translation"}`: a turn about an axis through a place, then a shift; drawn as a frame |
//! | `trajectory` | `{"points": places}`, `{"motors": list}` or `{"screw": {"axis", "through", "degrees", "shift"}}`; the last two take `steps`, the `point` that is carried, and the number of `frames` to be shown |
//! | `blade` | coefficients by blade, as `{"e123o": 1, "e123i": 0.5}`; drawn as what it is |
//! | `meet` | the names of two elements: `a ∨ b`, for two lines or circles also where they lie in one plane |
//! | `join` | the names of two elements: `a ∧ b` |
//! | `moved` | `{"element": name, "by": motor}` |
//!
//! Motors of a trajectory are joined along screws by the short way round; a `screw` may turn more
//! than once. The examples are in `draw/examples`.

mod camera;
mod colour;
mod escape;
mod extent;
mod file;
mod label;
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
pub use file::{ElementError, SceneError};
pub use scene::Scene;
pub use shape::{Drawable, NotDrawable, Shape, Trajectory};
pub use style::Style;
pub use view::{Projection, Up, View};
