//! The tracer with the vectors of glam.

use glam::{DAffine3, DMat4, DVec3};

use super::by_methods;

const BESIDE: f64 = 1e-9;
const REFLECTIONS: usize = 5;
const HORIZON: DVec3 = colour(by_methods::HORIZON);
const ZENITH: DVec3 = colour(by_methods::ZENITH);

#[derive(Clone, Copy)]
struct Ray {
    origin: DVec3,
    direction: DVec3,
}

#[derive(Clone, Copy)]
struct Hit {
    distance: f64,
    point: DVec3,
    normal: DVec3,
}

enum Shape {
    Ball {
        centre: DVec3,
        radius: f64,
    },
    Floor {
        normal: DVec3,
        distance: f64,
    },
    Disc {
        centre: DVec3,
        normal: DVec3,
        radius: f64,
    },
}

struct Material {
    colour: DVec3,
    squares: Option<DVec3>,
    mirror: f64,
}

pub(super) struct Scene {
    things: Vec<(Shape, Material)>,
    lamp: DVec3,
}

pub(super) struct Camera {
    pose: DAffine3,
    height: f64,
}

impl Ray {
    fn at(&self, distance: f64) -> DVec3 {
        self.origin + self.direction * distance
    }

    fn mirrored(&self, hit: &Hit) -> DVec3 {
        self.direction.reflect(hit.normal)
    }
}

impl Shape {
    fn first_hit(&self, ray: &Ray) -> Option<Hit> {
        match *self {
            Shape::Ball { centre, radius } => {
                let from_centre = ray.origin - centre;
                let half = from_centre.dot(ray.direction);
                let power = from_centre.length_squared() - radius * radius;
                let root = half * half - power;
                if root < 0.0 {
                    return None;
                }
                let root = root.sqrt();
                let mut distance = -half - root;
                let mut orientation = 1.0;
                if distance <= 0.0 {
                    distance = -half + root;
                    orientation = -1.0;
                    if distance <= 0.0 {
                        return None;
                    }
                }
                let point = ray.at(distance);
                Some(Hit {
                    distance,
                    point,
                    normal: (point - centre) * (orientation / radius),
                })
            }
            Shape::Floor { normal, distance } => plane_hit(ray, normal, distance),
            Shape::Disc {
                centre,
                normal,
                radius,
            } => {
                let hit = plane_hit(ray, normal, normal.dot(centre))?;
                let is_within = hit.point.distance_squared(centre) <= radius * radius;
                is_within.then_some(hit)
            }
        }
    }
}

fn plane_hit(ray: &Ray, normal: DVec3, distance: f64) -> Option<Hit> {
    let slope = normal.dot(ray.direction);
    let distance = (distance - normal.dot(ray.origin)) / slope;
    if !(distance > 0.0 && distance.is_finite()) {
        return None;
    }
    Some(Hit {
        distance,
        point: ray.at(distance),
        normal: if slope < 0.0 { normal } else { -normal },
    })
}

impl Scene {
    fn light(&self, mut ray: Ray) -> DVec3 {
        let mut light = DVec3::ZERO;
        let mut share = 1.0;
        for _ in 0..=REFLECTIONS {
            let sky = sky(ray.direction);
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
            let direction = ray.mirrored(&hit);
            let origin = hit.point + direction * BESIDE;
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

    fn scattered(&self, ray: &Ray, hit: &Hit, material: &Material) -> DVec3 {
        let colour = material.colour_at(hit.point);
        let from_sky = colour * by_methods::ambient(hit.normal.z);
        let to_lamp = self.lamp - hit.point;
        let distance = to_lamp.length();
        let to_lamp = to_lamp / distance;
        let cosine = hit.normal.dot(to_lamp);
        if cosine <= 0.0 {
            return from_sky;
        }
        let shadow = Ray {
            origin: hit.point + to_lamp * BESIDE,
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
        let gloss = ray.mirrored(hit).dot(to_lamp).max(0.0).powi(64);
        from_sky + colour * (by_methods::LAMP * cosine) + DVec3::ONE * (by_methods::GLOSS * gloss)
    }
}

impl Material {
    fn colour_at(&self, point: DVec3) -> DVec3 {
        match self.squares {
            Some(other) if (point.x.floor() + point.y.floor()) % 2.0 == 0.0 => other,
            _ => self.colour,
        }
    }
}

fn sky(direction: DVec3) -> DVec3 {
    HORIZON.lerp(ZENITH, direction.z.max(0.0).sqrt())
}

pub(super) fn render(scene: &Scene, camera: &Camera, [width, height]: [usize; 2]) -> Vec<DVec3> {
    let pixel = 2.0 / height as f64 * camera.height;
    let origin = camera.pose.translation;
    let mut picture = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let x = column as f64 + 0.5 - 0.5 * width as f64;
            let y = 0.5 * height as f64 - row as f64 - 0.5;
            let direction = DVec3::new(x * pixel, y * pixel, -1.0).normalize();
            let direction = camera.pose.transform_vector3(direction);
            picture.push(scene.light(Ray { origin, direction }));
        }
    }
    picture
}

const fn colour(colour: by_methods::Colour) -> DVec3 {
    DVec3::new(colour.e1, colour.e2, colour.e3)
}

fn vector(coordinates: impl Into<[f64; 3]>) -> DVec3 {
    DVec3::from_array(coordinates.into())
}

impl Scene {
    /// The same scene in the types of glam; `None` where a shape has no Euclidean data.
    pub(super) fn of(scene: &by_methods::Scene) -> Option<Self> {
        let thing = |thing: &by_methods::Thing| {
            let shape = match thing.shape {
                by_methods::Shape::Ball(sphere) => Shape::Ball {
                    centre: vector(sphere.centre()?),
                    radius: sphere.radius()?,
                },
                by_methods::Shape::Floor(plane) => Shape::Floor {
                    normal: vector(plane.unit_normal()?),
                    distance: -plane.signed_distance(ga_runtime::cga3::Point::default())?,
                },
                by_methods::Shape::Disc(circle) => Shape::Disc {
                    centre: vector(circle.centre()?),
                    normal: vector(circle.unit_normal()?),
                    radius: circle.radius()?,
                },
            };
            let material = Material {
                colour: colour(thing.material.colour),
                squares: thing.material.squares.map(colour),
                mirror: thing.material.mirror,
            };
            Some((shape, material))
        };
        Some(Self {
            things: scene.things.iter().map(thing).collect::<Option<_>>()?,
            lamp: vector(scene.lamp),
        })
    }
}

impl Camera {
    pub(super) fn of(camera: &by_methods::Camera) -> Self {
        let rows = camera.pose.to_matrix();
        let rows = [rows[0], rows[1], rows[2], [0.0, 0.0, 0.0, 1.0]];
        Self {
            pose: DAffine3::from_mat4(DMat4::from_cols_array_2d(&rows).transpose()),
            height: camera.height,
        }
    }
}
