//! Casts rays from a camera at a sphere and a disc, and draws the result with letters.
//!
//! A ray is a line. `sphere & line` is the pair of points where it enters and leaves the sphere,
//! `plane & line` the point where it passes through the plane. A disc is a circle with its inside.
//!
//! Run it with `cargo run -p ga-runtime --example camera_ray`.

use ga_runtime::cga3::{Circle, Line, Point, Sphere};
use ga_runtime::vga3::Vector;

const WIDTH: usize = 64;
const HEIGHT: usize = 20;

struct Scene {
    ball: Sphere<f64>,
    disc: Circle<f64>,
    lamp: Point<f64>,
}

/// The first point of a sphere on the ray from one point through another.
fn hit_sphere(sphere: Sphere<f64>, from: Point<f64>, through: Point<f64>) -> Option<Point<f64>> {
    let line = Line::through(from, through);
    // A line that misses the sphere meets it in an imaginary pair, which has no endpoints.
    let points = (sphere & line).endpoints()?;
    let ahead = points
        .into_iter()
        .filter(|&point| is_ahead(line, from, point));
    ahead.min_by(|p, q| from.distance(*p).total_cmp(&from.distance(*q)))
}

/// The point of a disc on the ray from one point through another.
fn hit_disc(disc: Circle<f64>, from: Point<f64>, through: Point<f64>) -> Option<Point<f64>> {
    let line = Line::through(from, through);
    let point = (disc.carrier() & line).to_point()?;
    let inside = point.distance(disc.centre()?) <= disc.radius()?;
    (inside && is_ahead(line, from, point)).then_some(point)
}

fn is_ahead(line: Line<f64>, from: Point<f64>, point: Point<f64>) -> bool {
    Vector::from(line.direction()).dot(from.vector_to(point)) > 0.0
}

impl Scene {
    /// A letter for the colour that is seen through a point; darker colours have denser letters.
    fn letter(&self, eye: Point<f64>, through: Point<f64>) -> char {
        if let Some(point) = hit_sphere(self.ball, eye, through) {
            let centre = self.ball.centre().unwrap_or_default();
            let (normal, to_lamp) = (centre.vector_to(point), point.vector_to(self.lamp));
            let light = (normal.dot(to_lamp) / (normal.length() * to_lamp.length())).max(0.0);
            let shades = ['@', '%', '#', '*', '+', '=', '-', ':'];
            shades[(light * 7.999) as usize]
        } else if let Some(point) = hit_disc(self.disc, eye, through) {
            // In the shadow the ball is between the point and the lamp.
            let shadow = hit_sphere(self.ball, point, self.lamp).is_some();
            if shadow { 'o' } else { '.' }
        } else {
            ' '
        }
    }
}

fn main() {
    let scene = Scene {
        ball: Sphere::from_centre_radius(Point::new(0.0, 0.0, 1.0), 1.0),
        disc: Circle::from_centre_normal_radius(Point::new(0.0, 0.0, 0.0), [0.0, 0.0, 1.0], 2.5)
            .expect("the normal is not zero"),
        lamp: Point::new(-3.0, -3.0, 6.0),
    };
    let eye = Point::new(0.0, -6.0, 2.0);

    let mut hits = 0;
    for row in 0..HEIGHT {
        let mut letters = String::new();
        for column in 0..WIDTH {
            // The picture is an upright rectangle at distance 2 from the eye. Letters are twice as
            // high as wide.
            let x = (column as f64 + 0.5 - WIDTH as f64 / 2.0) / 35.0;
            let z = (HEIGHT as f64 / 2.0 - row as f64 - 0.5) / 17.5;
            let through = Point::new(x, -4.0, 1.5 + z);
            letters.push(scene.letter(eye, through));

            // The same test without conformal geometry: is the distance of the line from the centre
            // less than the radius?
            let hit = hit_sphere(scene.ball, eye, through);
            let centre = Point::new(0.0, 0.0, 1.0);
            let (ray, to_centre) = (eye.vector_to(through), eye.vector_to(centre));
            let along = ray.dot(to_centre) / ray.length();
            let missed_by = (to_centre.dot(to_centre) - along * along).sqrt() - 1.0;
            assert_eq!(hit.is_some(), missed_by < 0.0);
            if let Some(point) = hit {
                hits += 1;
                assert!((point.distance(centre) - 1.0).abs() < 1e-9);
            }
        }
        println!("{}", letters.trim_end());
    }
    println!("{hits} of {} rays hit the ball", WIDTH * HEIGHT);
}

#[test]
fn it_runs() {
    main();
}
