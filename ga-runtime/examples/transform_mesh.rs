//! Moves a mesh by a rigid motion: the vertices with one call of `batch`, the normals with a
//! function of `ga!`.
//!
//! Run it with `cargo run -p ga-runtime --example transform_mesh`.

use ga_runtime::batch;
use ga_runtime::cga3::{Circle, Direction, Motor, Point, Rotor, Translator};

ga_runtime::ga! { ga_runtime::cga3;
    /// The textbook formula. `uniform` says that one motor moves many directions: it becomes a
    /// matrix once, and each direction then costs nine multiplications.
    fn rotating(uniform motor: Motor, normal: Direction) -> Direction { motor * normal * reverse(motor) }
}

/// The torus: RING is the radius of the circle in its middle, TUBE the radius of the tube.
const RING: f32 = 2.0;
const TUBE: f32 = 0.5;

struct Mesh {
    // A `Point<f32>` is three numbers, so this is an ordinary vertex buffer.
    vertices: Vec<Point<f32>>,
    normals: Vec<Direction<f32>>,
}

fn torus(around: usize, across: usize) -> Mesh {
    let angle = |step: usize, steps: usize| step as f32 / steps as f32 * std::f32::consts::TAU;
    let mut mesh = Mesh {
        vertices: Vec::new(),
        normals: Vec::new(),
    };
    for u in (0..around).map(|step| angle(step, around)) {
        for v in (0..across).map(|step| angle(step, across)) {
            let normal = [v.cos() * u.cos(), v.cos() * u.sin(), v.sin()];
            let middle = [RING * u.cos(), RING * u.sin(), 0.0];
            let vertex = [0, 1, 2].map(|k| middle[k] + TUBE * normal[k]);
            mesh.vertices.push(Point::from(vertex));
            mesh.normals.push(Direction::from_vector(normal));
        }
    }
    mesh
}

/// The corners of the box around the vertices.
fn bounds(vertices: &[Point<f32>]) -> [[f32; 3]; 2] {
    let mut corners = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    for place in vertices.iter().map(|vertex| vertex.coordinates()) {
        for k in 0..3 {
            corners[0][k] = corners[0][k].min(place[k]);
            corners[1][k] = corners[1][k].max(place[k]);
        }
    }
    corners
}

/// The distance of a point from a circle.
fn distance_from(circle: Circle<f32>, point: Point<f32>) -> Option<f32> {
    let height = circle.carrier().signed_distance(point)?;
    let from_centre = circle.centre()?.distance(point);
    let along = (from_centre * from_centre - height * height).sqrt() - circle.radius()?;
    Some(height.hypot(along))
}

fn main() {
    let mut mesh = torus(48, 24);
    println!("{} vertices", mesh.vertices.len());
    println!(
        "before: from {:.2?} to {:.2?}",
        bounds(&mesh.vertices)[0],
        bounds(&mesh.vertices)[1]
    );

    // First a rotation by 90° about the x axis, then a translation: the right factor acts first.
    let quarter = std::f32::consts::FRAC_PI_2;
    let rotor = Rotor::from_axis_angle([1.0, 0.0, 0.0], quarter).expect("the axis is not zero");
    let motor: Motor<f32> = Translator::from_displacement([0.0, 0.0, 3.0]) * rotor;

    batch::transform(&motor, &mut mesh.vertices);
    let rotating = rotating(motor);
    for normal in &mut mesh.normals {
        *normal = rotating.apply(*normal);
    }
    println!(
        "after:  from {:.2?} to {:.2?}",
        bounds(&mesh.vertices)[0],
        bounds(&mesh.vertices)[1]
    );

    // Motors move circles as they move points. So the distance of every vertex from the moved
    // circle is still TUBE, …
    let [p, q, r] = [[RING, 0.0, 0.0], [0.0, RING, 0.0], [-RING, 0.0, 0.0]].map(Point::from);
    let middle = motor.transform(Circle::through(p, q, r));
    // … and the point at distance TUBE against the normal of a vertex is on the circle.
    let mut worst = 0.0_f32;
    for (vertex, normal) in mesh.vertices.iter().zip(&mesh.normals) {
        let from_middle = distance_from(middle, *vertex).expect("the circle has a radius");
        let inward = Translator::from_displacement(normal.vector().map(|x| -TUBE * x));
        let left =
            distance_from(middle, inward.transform(*vertex)).expect("the circle has a radius");
        worst = worst.max((from_middle - TUBE).abs()).max(left);
    }
    // The bound is for single precision, with a square root of a difference.
    assert!(worst < 2e-3, "a vertex is off by {worst}");
    let axis = middle.unit_normal().expect("the circle has a radius");
    println!("the torus is where its circle is, and its axis is {axis:.2?}");
}

#[test]
fn it_runs() {
    main();
}
