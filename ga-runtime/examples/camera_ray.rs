//! Casts rays from a camera at a sphere and a disc, and draws what they hit in letters.
//!
//! A ray is a line. `sphere & line` are the two points where it goes in and out, `plane & line` the
//! one where it goes through. A disc is a circle with its inside.
//!
//! Run it with `cargo run -p ga-runtime --example camera_ray`.

use ga_runtime::cga3::{Circle, Line, Point, Sphere};

const WIDTH: usize = 64;
const HEIGHT: usize = 20;

struct Scene {
    ball: Sphere<f64>,
    disc: Circle<f64>,
    lamp: Point<f64>,
}

/// Where a ray from a point first meets a sphere ahead of it.
fn hit_sphere(sphere: Sphere<f64>, from: Point<f64>, through: Point<f64>) -> Option<Point<f64>> {
    let line = Line::through(from, through);
    // A line that passes by meets the sphere in an imaginary pair, which has no endpoints.
    let points = (sphere & line).endpoints()?;
    let ahead = points
        .into_iter()
        .filter(|&point| is_ahead(line, from, point));
    ahead.min_by(|p, q| from.distance(*p).total_cmp(&from.distance(*q)))
}

/// Where a ray from a point meets a disc.
fn hit_disc(disc: Circle<f64>, from: Point<f64>, through: Point<f64>) -> Option<Point<f64>> {
    let line = Line::through(from, through);
    let point = (disc.carrier() & line).to_point()?;
    let inside = point.distance(disc.centre()?) <= disc.radius()?;
    (inside && is_ahead(line, from, point)).then_some(point)
}

fn is_ahead(line: Line<f64>, from: Point<f64>, point: Point<f64>) -> bool {
    dot(line.direction(), difference(point, from)) > 0.0
}

impl Scene {
    /// A letter for what is seen through a place, the darker the more ink.
    fn letter(&self, eye: Point<f64>, through: Point<f64>) -> char {
        if let Some(point) = hit_sphere(self.ball, eye, through) {
            let centre = self.ball.centre().unwrap_or_default();
            let (normal, to_lamp) = (difference(point, centre), difference(self.lamp, point));
            let sizes = (dot(normal, normal) * dot(to_lamp, to_lamp)).sqrt();
            let light = (dot(normal, to_lamp) / sizes).max(0.0);
            let shades = ['@', '%', '#', '*', '+', '=', '-', ':'];
            shades[(light * 7.999) as usize]
        } else if let Some(point) = hit_disc(self.disc, eye, through) {
            // In the shadow, the ball is between here and the lamp.
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
            // The picture is an upright rectangle two units before the eye. Letters are twice as
            // high as wide.
            let x = (column as f64 + 0.5 - WIDTH as f64 / 2.0) / 35.0;
            let z = (HEIGHT as f64 / 2.0 - row as f64 - 0.5) / 17.5;
            let through = Point::new(x, -4.0, 1.5 + z);
            letters.push(scene.letter(eye, through));

            // The same question asked without conformal geometry: is the line nearer to the centre
            // than the radius?
            let hit = hit_sphere(scene.ball, eye, through);
            let centre = Point::new(0.0, 0.0, 1.0);
            let (ray, to_centre) = (difference(through, eye), difference(centre, eye));
            let along = dot(ray, to_centre) / dot(ray, ray).sqrt();
            let missed_by = (dot(to_centre, to_centre) - along * along).sqrt() - 1.0;
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

fn difference(a: Point<f64>, b: Point<f64>) -> [f64; 3] {
    let ([x, y, z], [u, v, w]) = (a.coordinates(), b.coordinates());
    [x - u, y - v, z - w]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[test]
fn it_runs() {
    main();
}
