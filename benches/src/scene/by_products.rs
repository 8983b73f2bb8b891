//! The tracer as textbooks write it: a ray is a line and the point where it starts, what it hits is
//! found by meets, and it is reflected in tangent planes. A disc is given by its plane and by a
//! sphere. The same steps are taken by operators and methods, and by functions of `ga!`.

use ga_runtime::cga3::{Line, Plane, Point, Sphere};
use ga_runtime::ga;
use ga_runtime::geometry::relation::Tolerance;
use ga_runtime::vga3::Vector;

use super::by_methods::{self, Camera, Colour, Material};

ga! { ga_runtime::cga3;
    /// The pair in which a sphere and a line meet.
    fn crossing(s: Sphere, l: Line) -> PointPair { s & l }

    /// The point where a line meets a plane, and infinity.
    fn piercing(a: Plane, l: Line) -> FlatPoint { a & l }

    /// The plane that touches a sphere at a point of it, with weight 1.
    fn touching(s: Sphere, p: Point) -> Plane {
        let a = dual(-(p | s) ^ ei);
        undual(a / sqrt(a | a))
    }

    /// The image of a line in a plane of weight 1.
    fn mirrored(l: Line, a: Plane) -> Line { sandwich(dual(a), l) }

    /// How far a line of weight 1 goes on from one point to another.
    fn depth(l: Line, p: Point, q: Point) -> Scalar { (p - q) | (eo | (ei | l)) }

    /// Half the power of a point, positive inside of the sphere.
    fn power(s: Sphere, p: Point) -> Scalar { p | dual(s) }
}

const BESIDE: f64 = 1e-9;
const REFLECTIONS: usize = 5;
/// Points of spheres are computed, and lie beside them by rounding.
const TOLERANCE: Tolerance<f64> = Tolerance::new(1e-9, 1e-9);

/// How the steps are taken. They are inlined, as operators and functions are where they are written
/// in their place.
pub(super) trait Style {
    fn points(sphere: Sphere<f64>, line: Line<f64>) -> Option<[Point<f64>; 2]>;
    fn point(plane: Plane<f64>, line: Line<f64>) -> Option<Point<f64>>;
    fn tangent(sphere: Sphere<f64>, point: Point<f64>) -> Option<Plane<f64>>;
    fn mirrored(line: Line<f64>, plane: Plane<f64>) -> Option<Line<f64>>;
    fn depth(line: Line<f64>, from: Point<f64>, to: Point<f64>) -> f64;
    fn is_inside(point: Point<f64>, sphere: Sphere<f64>) -> bool;
}

pub(super) struct Methods;

impl Style for Methods {
    #[inline(always)]
    fn points(sphere: Sphere<f64>, line: Line<f64>) -> Option<[Point<f64>; 2]> {
        (sphere & line).endpoints()
    }

    #[inline(always)]
    fn point(plane: Plane<f64>, line: Line<f64>) -> Option<Point<f64>> {
        (plane & line).to_point()
    }

    #[inline(always)]
    fn tangent(sphere: Sphere<f64>, point: Point<f64>) -> Option<Plane<f64>> {
        sphere.tangent_plane_at(point, TOLERANCE)
    }

    #[inline(always)]
    fn mirrored(line: Line<f64>, plane: Plane<f64>) -> Option<Line<f64>> {
        line.reflect_in(plane)
    }

    #[inline(always)]
    fn depth(line: Line<f64>, from: Point<f64>, to: Point<f64>) -> f64 {
        from.vector_to(to).dot(line.direction().into())
    }

    #[inline(always)]
    fn is_inside(point: Point<f64>, sphere: Sphere<f64>) -> bool {
        (point | sphere.dual()) >= 0.0
    }
}

pub(super) struct Kernels;

impl Style for Kernels {
    #[inline(always)]
    fn points(sphere: Sphere<f64>, line: Line<f64>) -> Option<[Point<f64>; 2]> {
        crossing(sphere, line).endpoints()
    }

    #[inline(always)]
    fn point(plane: Plane<f64>, line: Line<f64>) -> Option<Point<f64>> {
        piercing(plane, line).to_point()
    }

    #[inline(always)]
    fn tangent(sphere: Sphere<f64>, point: Point<f64>) -> Option<Plane<f64>> {
        Some(touching(sphere, point))
    }

    #[inline(always)]
    fn mirrored(line: Line<f64>, plane: Plane<f64>) -> Option<Line<f64>> {
        Some(mirrored(line, plane))
    }

    #[inline(always)]
    fn depth(line: Line<f64>, from: Point<f64>, to: Point<f64>) -> f64 {
        depth(line, from, to)
    }

    #[inline(always)]
    fn is_inside(point: Point<f64>, sphere: Sphere<f64>) -> bool {
        power(sphere, point) >= 0.0
    }
}

/// A line of weight 1, and the point of it where the ray starts.
#[derive(Clone, Copy)]
struct Ray {
    line: Line<f64>,
    origin: Point<f64>,
}

enum Shape {
    Ball(Sphere<f64>),
    Floor(Plane<f64>),
    Disc(Plane<f64>, Sphere<f64>),
}

#[derive(Clone, Copy)]
struct Hit {
    distance: f64,
    point: Point<f64>,
}

pub(super) struct Scene {
    things: Vec<(Shape, Material)>,
    lamp: Point<f64>,
}

impl Ray {
    fn along(line: Line<f64>, point: Point<f64>) -> Self {
        let origin = Vector::from(point) + Vector::from(line.direction()) * BESIDE;
        let origin = origin.into();
        Self { line, origin }
    }

    fn ahead<M: Style>(&self, point: Point<f64>) -> Option<Hit> {
        let distance = M::depth(self.line, self.origin, point);
        (distance > 0.0).then_some(Hit { distance, point })
    }
}

impl Shape {
    fn first_hit<M: Style>(&self, ray: &Ray) -> Option<Hit> {
        match *self {
            Self::Ball(sphere) => {
                let [p, q] = M::points(sphere, ray.line)?;
                // In the order of the meet, which is against the line.
                ray.ahead::<M>(q).or_else(|| ray.ahead::<M>(p))
            }
            Self::Floor(plane) => ray.ahead::<M>(M::point(plane, ray.line)?),
            Self::Disc(plane, sphere) => {
                let point = M::point(plane, ray.line)?;
                let hit = ray.ahead::<M>(point)?;
                M::is_inside(point, sphere).then_some(hit)
            }
        }
    }

    /// The plane that touches the shape at a point of it.
    fn tangent<M: Style>(&self, point: Point<f64>) -> Option<Plane<f64>> {
        match *self {
            Self::Ball(sphere) => M::tangent(sphere, point),
            Self::Floor(plane) | Self::Disc(plane, _) => Some(plane),
        }
    }
}

impl Scene {
    fn light<M: Style>(&self, mut ray: Ray) -> Option<Colour> {
        let mut light = Colour::ZERO;
        let mut share = 1.0;
        for _ in 0..=REFLECTIONS {
            let sky = by_methods::sky(ray.line.attitude());
            let Some((hit, shape, material)) = self.first_hit::<M>(&ray) else {
                return Some(light + sky * share);
            };
            let tangent = shape.tangent::<M>(hit.point)?;
            let mirrored = M::mirrored(ray.line, tangent)?;
            let own = self.scattered::<M>(&ray, mirrored, hit.point, tangent, material);
            let clear = 1.0 / (1.0 + (hit.distance / by_methods::HAZE).powi(2));
            light += sky.lerp(own, clear) * (share * (1.0 - material.mirror));
            share *= material.mirror;
            if share == 0.0 {
                break;
            }
            ray = Ray::along(mirrored, hit.point);
        }
        Some(light)
    }

    fn first_hit<M: Style>(&self, ray: &Ray) -> Option<(Hit, &Shape, &Material)> {
        let mut nearest: Option<(Hit, &Shape, &Material)> = None;
        for (shape, material) in &self.things {
            if let Some(hit) = shape.first_hit::<M>(ray)
                && nearest.is_none_or(|(best, ..)| hit.distance < best.distance)
            {
                nearest = Some((hit, shape, material));
            }
        }
        nearest
    }

    fn scattered<M: Style>(
        &self,
        ray: &Ray,
        mirrored: Line<f64>,
        point: Point<f64>,
        tangent: Plane<f64>,
        material: &Material,
    ) -> Colour {
        let direction = Vector::from(ray.line.direction());
        let mut normal = Vector::from(tangent.normal());
        if direction.dot(normal) > 0.0 {
            normal = -normal;
        }
        let colour = material.colour_at(point);
        let from_sky = colour * by_methods::ambient(normal.z());
        let distance = point.distance(self.lamp);
        let to_lamp = Line::through(point, self.lamp) / distance;
        let way = Vector::from(to_lamp.direction());
        let cosine = normal.dot(way);
        if cosine <= 0.0 {
            return from_sky;
        }
        let shadow = Ray::along(to_lamp, point);
        let mut shapes = self.things.iter().map(|(shape, _)| shape);
        if shapes.any(|shape| {
            shape
                .first_hit::<M>(&shadow)
                .is_some_and(|hit| hit.distance < distance)
        }) {
            return from_sky;
        }
        let to_mirrored = Vector::from(mirrored.direction()).dot(way);
        from_sky + by_methods::from_lamp(colour, cosine, to_mirrored)
    }

    /// The same scene; `None` where a shape has no Euclidean data.
    pub(super) fn of(scene: &by_methods::Scene) -> Option<Self> {
        let thing = |thing: &by_methods::Thing| {
            let shape = match thing.shape {
                by_methods::Shape::Ball(sphere) => Shape::Ball(sphere),
                by_methods::Shape::Floor(plane) => Shape::Floor(plane),
                by_methods::Shape::Disc(circle) => {
                    Shape::Disc(circle.carrier(), circle.container()?)
                }
            };
            Some((shape, thing.material))
        };
        Some(Self {
            things: scene.things.iter().map(thing).collect::<Option<_>>()?,
            lamp: scene.lamp,
        })
    }
}

pub(super) fn render<M: Style>(
    scene: &Scene,
    camera: &Camera,
    [width, height]: [usize; 2],
) -> Vec<Colour> {
    let pixel = 2.0 / height as f64;
    let origin = camera.pose.transform(Point::ORIGIN);
    let mut picture = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let x = column as f64 + 0.5 - 0.5 * width as f64;
            let y = 0.5 * height as f64 - row as f64 - 0.5;
            let line = through_pixel(camera, x * pixel, y * pixel);
            let light = line.and_then(|line| scene.light::<M>(Ray { line, origin }));
            picture.push(light.unwrap_or(Colour::ZERO));
        }
    }
    picture
}

/// The line from the eye through a place of the picture.
fn through_pixel(camera: &Camera, x: f64, y: f64) -> Option<Line<f64>> {
    let way = Vector::new(x * camera.height, y * camera.height, -1.0).normalized()?;
    let line = Line::from_point_direction(Point::ORIGIN, way.into());
    Some(camera.pose.transform(line))
}
