//! Three spheres, the circle in which two of them meet, and the points that all three have in
//! common.
//!
//! `cargo run -p ga-draw --example spheres > spheres.svg`

use ga_draw::{NotDrawable, Scene, Style};
use ga_runtime::cga3::{Point, Sphere};

fn main() -> Result<(), NotDrawable> {
    let mut scene = Scene::new("Three spheres meet in two points");
    let places = [[-0.6, -0.35, 0.0], [0.6, -0.35, 0.0], [0.0, 0.7, 0.0]];
    let [a, b, c] = places.map(|place| Sphere::from_centre_radius(Point::from(place), 1.0));
    for (sphere, name) in [(a, "A"), (b, "B"), (c, "C")] {
        scene.add(sphere, Style::labelled(name))?;
    }
    scene.add(a & b, Style::labelled("A ∨ B").with_width(2.5))?;
    scene.add((a & b) & c, Style::labelled("A ∨ B ∨ C"))?;
    print!("{}", scene.to_svg());
    Ok(())
}
