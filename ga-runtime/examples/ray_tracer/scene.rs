//! The scene of the ray tracer, and the light that comes along a ray.

use ga_runtime::cga3::{Circle, Direction, Motor, Plane, Point, Sphere};
use ga_runtime::geometry::ray::{Hit, Ray, Surface};
use ga_runtime::vga3::Vector;

/// Linear light: red, green and blue.
pub(crate) type Colour = Vector<f64>;

/// A ray that leaves a surface begins this far beside it, so that it does not hit it again.
const BESIDE: f64 = 1e-9;
/// How often light is mirrored on its way to the eye, at most.
const REFLECTIONS: usize = 5;
/// The light of the lamp on a surface that faces it, and in a highlight.
pub(crate) const LAMP: f64 = 0.85;
pub(crate) const GLOSS: f64 = 0.5;
/// The distance at which half of the light of a surface is lost in the haze.
pub(crate) const HAZE: f64 = 40.0;
pub(crate) const HORIZON: Colour = Colour::new(0.66, 0.77, 0.90);
pub(crate) const ZENITH: Colour = Colour::new(0.07, 0.19, 0.48);

/// Where a thing is.
pub(crate) enum Shape {
    Ball(Sphere<f64>),
    Floor(Plane<f64>),
    Disc(Circle<f64>),
}

impl Surface<f64> for Shape {
    fn first_hit_by(&self, ray: Ray<f64>) -> Option<Hit<f64>> {
        match self {
            Shape::Ball(sphere) => ray.first_hit(sphere),
            Shape::Floor(plane) => ray.first_hit(plane),
            Shape::Disc(circle) => ray.first_hit(circle),
        }
    }
}

/// What a thing looks like.
#[derive(Clone, Copy)]
pub(crate) struct Material {
    pub(crate) colour: Colour,
    /// The other colour of a pattern of squares of length 1.
    pub(crate) squares: Option<Colour>,
    /// The share of light that is mirrored.
    pub(crate) mirror: f64,
}

pub(crate) struct Thing {
    pub(crate) shape: Shape,
    pub(crate) material: Material,
}

pub(crate) struct Scene {
    pub(crate) things: Vec<Thing>,
    pub(crate) lamp: Point<f64>,
}

impl Scene {
    /// The light that comes to the origin of a ray from where it points.
    pub(crate) fn light(&self, mut ray: Ray<f64>) -> Colour {
        let mut light = Colour::ZERO;
        let mut share = 1.0;
        for _ in 0..=REFLECTIONS {
            let sky = sky(ray.direction());
            let Some((hit, material)) = self.first_hit(ray) else {
                return light + sky * share;
            };
            let own = self.scattered(ray, &hit, material);
            let clear = 1.0 / (1.0 + (hit.distance / HAZE).powi(2));
            light += sky.lerp(own, clear) * (share * (1.0 - material.mirror));
            share *= material.mirror;
            if share == 0.0 {
                break;
            }
            ray = ray.reflect(&hit).advance(BESIDE);
        }
        light
    }

    fn first_hit(&self, ray: Ray<f64>) -> Option<(Hit<f64>, &Material)> {
        let mut nearest: Option<(Hit<f64>, &Material)> = None;
        for thing in &self.things {
            if let Some(hit) = ray.first_hit(&thing.shape)
                && nearest.is_none_or(|(best, _)| hit.distance < best.distance)
            {
                nearest = Some((hit, &thing.material));
            }
        }
        nearest
    }

    /// The light of lamp and sky that a surface scatters back along a ray.
    fn scattered(&self, ray: Ray<f64>, hit: &Hit<f64>, material: &Material) -> Colour {
        let colour = material.colour_at(hit.point);
        let from_sky = colour * ambient(hit.normal.z());
        let Some(to_lamp) = Ray::through(hit.point, self.lamp) else {
            return from_sky;
        };
        let cosine = hit.normal.dot(to_lamp.direction());
        if cosine <= 0.0 || self.is_in_shadow(to_lamp.advance(BESIDE)) {
            return from_sky;
        }
        // The highlight, where the lamp is nearly in the direction of the mirrored ray.
        let mirrored = ray.reflect(hit).direction();
        from_sky + from_lamp(colour, cosine, mirrored.dot(to_lamp.direction()))
    }

    fn is_in_shadow(&self, to_lamp: Ray<f64>) -> bool {
        let distance = to_lamp.depth(self.lamp);
        self.things.iter().any(|thing| {
            let hit = to_lamp.first_hit(&thing.shape);
            hit.is_some_and(|hit| hit.distance < distance)
        })
    }
}

impl Material {
    pub(crate) fn colour_at(&self, point: Point<f64>) -> Colour {
        let [x, y, _] = point.coordinates();
        match self.squares {
            Some(other) if (x.floor() + y.floor()) % 2.0 == 0.0 => other,
            _ => self.colour,
        }
    }
}

pub(crate) fn sky(direction: Direction<f64>) -> Colour {
    HORIZON.lerp(ZENITH, direction.z().max(0.0).sqrt())
}

/// The light from the sky on a surface, by the height of its normal.
pub(crate) fn ambient(upwards: f64) -> f64 {
    0.16 + 0.10 * upwards
}

/// The light of the lamp that a surface scatters, by the cosines of the angles from its direction
/// to the normal and to the mirrored ray.
pub(crate) fn from_lamp(colour: Colour, to_normal: f64, to_mirrored: f64) -> Colour {
    let white = Colour::new(1.0, 1.0, 1.0);
    colour * (LAMP * to_normal) + white * (GLOSS * to_mirrored.max(0.0).powi(64))
}

/// A pinhole camera.
pub(crate) struct Camera {
    /// The motor from the camera's frame, where it looks along −z with y upwards, into the world.
    pub(crate) pose: Motor<f64>,
    /// Half the height of the picture at distance 1.
    pub(crate) height: f64,
}

impl Camera {
    /// The ray through a place of the picture: y from −1 at the bottom to 1 at the top, and x to
    /// the right in the same unit.
    pub(crate) fn ray(&self, x: f64, y: f64) -> Option<Ray<f64>> {
        let ray = Ray::new(Point::default(), [x * self.height, y * self.height, -1.0])?;
        Some(self.pose.transform(ray))
    }
}

/// The picture row by row, the mean of `samples`² rays for each pixel.
pub(crate) fn render(
    scene: &Scene,
    camera: &Camera,
    size: [usize; 2],
    samples: usize,
) -> Vec<Colour> {
    let [width, height] = size;
    let pixel = 2.0 / height as f64;
    let mut picture = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let mut light = Colour::ZERO;
            for sample in 0..samples * samples {
                let within = |part: usize| (part as f64 + 0.5) / samples as f64;
                let x = column as f64 + within(sample % samples) - 0.5 * width as f64;
                let y = 0.5 * height as f64 - row as f64 - within(sample / samples);
                let ray = camera.ray(x * pixel, y * pixel);
                light += ray.map_or(Colour::ZERO, |ray| scene.light(ray));
            }
            picture.push(light / (samples * samples) as f64);
        }
    }
    picture
}

/// Balls on a floor, before a round mirror in a frame.
pub(crate) fn example() -> Scene {
    let plain = |[red, green, blue]: [f64; 3], mirror| Material {
        colour: Colour::new(red, green, blue),
        squares: None,
        mirror,
    };
    let ball = |centre: [f64; 3], radius, material| Thing {
        shape: Shape::Ball(Sphere::from_centre_radius(centre.into(), radius)),
        material,
    };
    let disc = |centre: [f64; 3], radius, material| {
        let normal = [-0.62, -0.77, -0.03];
        let circle = Circle::from_centre_normal_radius(centre.into(), normal, radius);
        Some(Thing {
            shape: Shape::Disc(circle?),
            material,
        })
    };
    let floor = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
    let mut things = vec![
        Thing {
            shape: Shape::Floor(floor),
            material: Material {
                squares: Some(Colour::new(0.16, 0.19, 0.24)),
                ..plain([0.78, 0.76, 0.70], 0.12)
            },
        },
        ball([-0.35, 0.55, 1.25], 1.25, plain([0.90, 0.90, 0.92], 0.86)),
        ball([-2.35, -0.25, 0.75], 0.75, plain([0.72, 0.07, 0.06], 0.10)),
        ball([1.25, -1.05, 0.55], 0.55, plain([0.05, 0.36, 0.42], 0.10)),
        ball([0.15, -1.85, 0.35], 0.35, plain([0.88, 0.55, 0.06], 0.06)),
        ball([-1.20, -1.75, 0.28], 0.28, plain([0.30, 0.14, 0.50], 0.06)),
        ball([2.30, -1.95, 0.30], 0.30, plain([0.12, 0.42, 0.12], 0.06)),
    ];
    things.extend(disc([2.75, 1.60, 1.56], 1.40, plain([0.9, 0.9, 0.9], 0.88)));
    things.extend(disc(
        [2.76, 1.61, 1.55],
        1.52,
        plain([0.50, 0.34, 0.10], 0.05),
    ));
    Scene {
        things,
        lamp: Point::new(-5.0, -4.5, 5.5),
    }
}

/// The camera of the picture.
pub(crate) fn example_camera() -> Option<Camera> {
    let (eye, target) = (Point::new(0.4, -7.2, 2.1), Point::new(0.15, 0.0, 1.0));
    let view = Motor::look_at(eye, target, Direction::new(0.0, 0.0, 1.0)).ok()?;
    Some(Camera {
        pose: view.reverse(),
        height: 0.33,
    })
}
