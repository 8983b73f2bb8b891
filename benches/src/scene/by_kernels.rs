//! The tracer with functions of `ga!` on the plain types of cga3.

use ga_runtime::cga3::{Direction, DualPlane, Point};
use ga_runtime::ga;

use super::by_methods::{self, Camera, Colour, Material};

ga! { ga_runtime::cga3;
    /// The point at a distance along a ray: its origin moved by a translator.
    fn at(o: Point, d: Direction, t: Scalar) -> Point { sandwich(1 - t * d / 2, o) }

    /// The distance along a ray of the point nearest to a centre, and the squared distance of that
    /// point from the centre.
    fn approach(o: Point, d: Direction, c: Point) -> (Scalar, Scalar) {
        let v = eo | d;
        ((c - o) | v, norm_squared((c - o) ^ v))
    }

    /// The free vector from one point to another, multiplied by a factor.
    fn between(p: Point, q: Point, factor: Scalar) -> Direction { factor * ((q - p) ^ ei) }

    /// The inner product of two free vectors.
    fn inner(a: Direction, b: Direction) -> Scalar { (eo | a) | (eo | b) }

    /// How fast a ray approaches a plane, and how far its origin is from the plane.
    fn slope_and_height(o: Point, d: Direction, plane: DualPlane) -> (Scalar, Scalar) {
        ((eo | d) | plane, -(o | plane))
    }

    /// The squared distance of two points.
    fn distance_squared(p: Point, q: Point) -> Scalar { -2 * (p | q) }

    /// The mirror image of a direction in a plane with a unit normal.
    fn mirrored(d: Direction, n: Direction) -> Direction {
        d - 2 * ((eo | d) | (eo | n)) * n
    }

    /// A free vector from one point to another, and its length.
    fn way(p: Point, q: Point) -> (Direction, Scalar) {
        let length = sqrt(-2 * (p | q));
        (((q - p) ^ ei) / length, length)
    }
}

const BESIDE: f64 = 1e-9;
const REFLECTIONS: usize = 5;

#[derive(Clone, Copy)]
struct Ray {
    origin: Point<f64>,
    direction: Direction<f64>,
}

#[derive(Clone, Copy)]
struct Hit {
    distance: f64,
    point: Point<f64>,
    normal: Direction<f64>,
}

enum Shape {
    Ball {
        centre: Point<f64>,
        radius: f64,
    },
    Floor(DualPlane<f64>),
    Disc {
        plane: DualPlane<f64>,
        centre: Point<f64>,
        radius: f64,
    },
}

pub(super) struct Scene {
    things: Vec<(Shape, Material)>,
    lamp: Point<f64>,
}

impl Shape {
    fn first_hit(&self, ray: &Ray) -> Option<Hit> {
        match *self {
            Shape::Ball { centre, radius } => {
                let (middle, off) = approach(ray.origin, ray.direction, centre);
                let half = radius * radius - off;
                if half < 0.0 {
                    return None;
                }
                let half = half.sqrt();
                let mut distance = middle - half;
                let mut factor = 1.0;
                if distance <= 0.0 {
                    distance = middle + half;
                    factor = -1.0;
                    if distance <= 0.0 {
                        return None;
                    }
                }
                let point = at(ray.origin, ray.direction, distance);
                Some(Hit {
                    distance,
                    point,
                    normal: between(centre, point, factor / radius),
                })
            }
            Shape::Floor(plane) => plane_hit(ray, plane),
            Shape::Disc {
                plane,
                centre,
                radius,
            } => {
                let hit = plane_hit(ray, plane)?;
                let is_within = distance_squared(hit.point, centre) <= radius * radius;
                is_within.then_some(hit)
            }
        }
    }
}

fn plane_hit(ray: &Ray, plane: DualPlane<f64>) -> Option<Hit> {
    let (slope, height) = slope_and_height(ray.origin, ray.direction, plane);
    let distance = height / slope;
    if !(distance > 0.0 && distance.is_finite()) {
        return None;
    }
    let normal = Direction::new(plane.e1, plane.e2, plane.e3);
    Some(Hit {
        distance,
        point: at(ray.origin, ray.direction, distance),
        normal: if slope < 0.0 { normal } else { -normal },
    })
}

impl Scene {
    fn light(&self, mut ray: Ray) -> Colour {
        let mut light = Colour::ZERO;
        let mut share = 1.0;
        for _ in 0..=REFLECTIONS {
            let sky = by_methods::sky(ray.direction);
            let Some((hit, material)) = self.first_hit(&ray) else {
                return light + sky * share;
            };
            let own = self.scattered(&ray, &hit, material);
            let clear = 1.0 / (1.0 + (hit.distance / by_methods::HAZE).powi(2));
            light += sky.lerp(own, clear) * (share * (1.0 - material.mirror));
            share *= material.mirror;
            if share == 0.0 {
                break;
            }
            let direction = mirrored(ray.direction, hit.normal);
            let origin = at(hit.point, direction, BESIDE);
            ray = Ray { origin, direction };
        }
        light
    }

    fn first_hit(&self, ray: &Ray) -> Option<(Hit, &Material)> {
        let mut nearest: Option<(Hit, &Material)> = None;
        for (shape, material) in &self.things {
            if let Some(hit) = shape.first_hit(ray)
                && nearest.is_none_or(|(best, _)| hit.distance < best.distance)
            {
                nearest = Some((hit, material));
            }
        }
        nearest
    }

    fn scattered(&self, ray: &Ray, hit: &Hit, material: &Material) -> Colour {
        let colour = material.colour_at(hit.point);
        let from_sky = colour * by_methods::ambient(hit.normal.e3i);
        let (to_lamp, distance) = way(hit.point, self.lamp);
        let cosine = inner(hit.normal, to_lamp);
        if cosine <= 0.0 {
            return from_sky;
        }
        let shadow = Ray {
            origin: at(hit.point, to_lamp, BESIDE),
            direction: to_lamp,
        };
        let mut shapes = self.things.iter().map(|(shape, _)| shape);
        if shapes.any(|shape| {
            shape
                .first_hit(&shadow)
                .is_some_and(|hit| hit.distance < distance)
        }) {
            return from_sky;
        }
        let to_mirrored = inner(mirrored(ray.direction, hit.normal), to_lamp);
        from_sky + by_methods::from_lamp(colour, cosine, to_mirrored)
    }

    /// The same scene with Euclidean data; `None` where a shape has none.
    pub(super) fn of(scene: &by_methods::Scene) -> Option<Self> {
        let thing = |thing: &by_methods::Thing| {
            let shape = match thing.shape {
                by_methods::Shape::Ball(sphere) => Shape::Ball {
                    centre: sphere.centre()?,
                    radius: sphere.radius()?,
                },
                by_methods::Shape::Floor(plane) => Shape::Floor(plane.dual()),
                by_methods::Shape::Disc(circle) => Shape::Disc {
                    plane: circle.carrier().dual(),
                    centre: circle.centre()?,
                    radius: circle.radius()?,
                },
            };
            Some((shape, thing.material))
        };
        Some(Self {
            things: scene.things.iter().map(thing).collect::<Option<_>>()?,
            lamp: scene.lamp,
        })
    }
}

pub(super) fn render(scene: &Scene, camera: &Camera, [width, height]: [usize; 2]) -> Vec<Colour> {
    let pixel = 2.0 / height as f64;
    let mut picture = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let x = column as f64 + 0.5 - 0.5 * width as f64;
            let y = 0.5 * height as f64 - row as f64 - 0.5;
            let light = camera.ray(x * pixel, y * pixel).map(|ray| {
                let (origin, direction) = (ray.origin(), ray.direction());
                scene.light(Ray { origin, direction })
            });
            picture.push(light.unwrap_or(Colour::ZERO));
        }
    }
    picture
}
