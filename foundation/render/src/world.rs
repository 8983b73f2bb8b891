//! The objects of a scene in the world and in the camera's frame.

use ga_mesh::normals::{area_vector, vertex_normals};
use ga_runtime::batch;
use ga_runtime::cga3::{Motor, Point};
use rayon::prelude::*;

use crate::appearance::{Appearance, CoordinateSet};
use crate::scene::{MaterialChoice, Normals, Object, Scene};
use crate::space::is_rigid;
use crate::{LARGEST_COORDINATE, RenderError, Vector, View};

/// All objects of a scene. Their triangles are numbered one object after the other.
pub(crate) struct World<'a> {
    pub(crate) objects: Vec<Placed<'a>>,
    materials: &'a [Appearance<'a>],
}

/// An object in its place.
pub(crate) struct Placed<'a> {
    pub(crate) object: &'a Object<'a>,
    /// The number of its first triangle.
    pub(crate) first: usize,
    /// Each vertex in the world.
    pub(crate) positions: Vec<Vector>,
    /// Each vertex in the camera's frame: right offset, up offset, depth.
    pub(crate) in_frame: Vec<Vector>,
    /// The smooth normal of each vertex in the object's coordinates, where it is shaded by them.
    smooth: Vec<[f64; 3]>,
    /// The rows of its rotation into the world.
    rotation: [Vector; 3],
}

/// A triangle of an object.
#[derive(Clone, Copy)]
pub(crate) struct Face<'w> {
    pub(crate) placed: &'w Placed<'w>,
    /// The index of the object.
    pub(crate) object: usize,
    /// The index of the triangle in its object.
    pub(crate) triangle: usize,
    pub(crate) vertices: [u32; 3],
}

impl<'a> World<'a> {
    /// The scene must have been checked.
    pub(crate) fn new(scene: &'a Scene<'a>, view: &View) -> Result<Self, RenderError> {
        let mut first = 0;
        let mut objects = Vec::with_capacity(scene.objects.len());
        for (index, object) in scene.objects.iter().enumerate() {
            let positions = place(object).ok_or(RenderError::Transform { object: index })?;
            let in_frame = positions.par_iter().map(|&p| view.in_frame(p)).collect();
            let smooth = match object.normals {
                Normals::Smooth => vertex_normals(object.positions, object.triangles),
                Normals::Flat | Normals::Given(_) => Vec::new(),
            };
            objects.push(Placed {
                object,
                first,
                positions,
                in_frame,
                smooth,
                rotation: object.transform.rotor().to_matrix().map(Vector::from),
            });
            first += object.triangles.len();
        }
        Ok(Self {
            objects,
            materials: scene.materials,
        })
    }

    /// The triangle of this number, which must exist.
    pub(crate) fn face(&self, number: u32) -> Face<'_> {
        let number = number as usize;
        let object = self.objects.partition_point(|o| o.first <= number) - 1;
        let placed = &self.objects[object];
        let triangle = number - placed.first;
        Face {
            placed,
            object,
            triangle,
            vertices: placed.object.triangles[triangle],
        }
    }

    /// The material of a triangle; `None` for the style's.
    pub(crate) fn material(&self, face: &Face) -> Option<&'a Appearance<'a>> {
        let material = face.placed.object.material.of(face.triangle)?;
        Some(&self.materials[material as usize])
    }

    /// Whether every triangle of an object is opaque everywhere and has two sides.
    pub(crate) fn is_solid(&self, object: &Placed) -> bool {
        let solid = |index: u32| {
            let material = &self.materials[index as usize];
            material.cutoff.is_none() && !material.transparent && material.double_sided
        };
        match object.object.material {
            MaterialChoice::Style => true,
            MaterialChoice::One(material) => solid(material),
            MaterialChoice::PerTriangle(list) => list.iter().flatten().all(|&index| solid(index)),
        }
    }

    /// The least and the greatest coordinates of all vertices.
    pub(crate) fn bounds(&self) -> Option<[Vector; 2]> {
        ga_mesh::bounds(self.objects.iter().flat_map(|o| &o.positions).copied())
    }

    /// The length of the bounding box's diagonal; 0 without positions.
    pub(crate) fn extent(&self) -> f64 {
        self.bounds().map_or(0.0, |[low, high]| low.distance(high))
    }

    /// The mean of all vertices.
    pub(crate) fn centre(&self) -> Option<Vector> {
        let positions = || self.objects.iter().flat_map(|o| &o.positions);
        let sum = positions().copied().reduce(|a, b| a + b)?;
        Some(sum * (1.0 / positions().count() as f64))
    }
}

impl Face<'_> {
    /// The corners in the camera's frame.
    pub(crate) fn in_frame(&self) -> [Vector; 3] {
        self.vertices.map(|v| self.placed.in_frame[v as usize])
    }

    /// The corners in the world.
    pub(crate) fn corners(&self) -> [Vector; 3] {
        self.vertices.map(|v| self.placed.positions[v as usize])
    }

    /// The corners in the object's coordinates.
    pub(crate) fn object_corners(&self) -> [Vector; 3] {
        let positions = self.placed.object.positions;
        self.vertices.map(|v| Vector::from(positions[v as usize]))
    }

    /// The normal in the world, with the length of twice the triangle's area.
    pub(crate) fn area_vector(&self) -> Vector {
        area_vector(self.corners())
    }

    /// The normals at the corners in the object's coordinates; `None` where the triangle is shaded
    /// flat.
    pub(crate) fn normals(&self) -> Option<[Vector; 3]> {
        let normals = match self.placed.object.normals {
            Normals::Smooth => self.vertices.map(|v| self.placed.smooth[v as usize]),
            Normals::Flat => return None,
            Normals::Given(normals) => normals.at(self.triangle, self.vertices)?,
        };
        Some(normals.map(Vector::from))
    }

    /// The texture coordinates at the corners.
    pub(crate) fn texture_coordinates(&self, set: CoordinateSet) -> Option<[[f64; 2]; 3]> {
        let object = self.placed.object;
        let coordinates = match set {
            CoordinateSet::First => object.texture_coordinates?,
            CoordinateSet::Second => object.second_texture_coordinates?,
        };
        coordinates.at(self.triangle, self.vertices)
    }

    /// Whether the eye lies on the side of the triangle's orientation.
    pub(crate) fn faces_eye(&self) -> bool {
        // Right, up and forward are a left-handed frame.
        let [a, b, c] = self.in_frame();
        a.dot(b.cross(c)) > 0.0
    }

    /// The tangents at the corners, in the object's coordinates.
    pub(crate) fn tangents(&self) -> Option<[[f64; 4]; 3]> {
        let tangents = self.placed.object.tangents?;
        tangents.at(self.triangle, self.vertices)
    }

    /// The colours and opacities at the corners.
    pub(crate) fn colours(&self) -> Option<[[f64; 4]; 3]> {
        let colours = self.placed.object.colours?;
        colours.at(self.triangle, self.vertices)
    }
}

impl Placed<'_> {
    /// The world vector of a vector in the object's coordinates.
    pub(crate) fn world_direction(&self, v: Vector) -> Vector {
        let [x, y, z] = self.rotation;
        Vector::new(x.dot(v), y.dot(v), z.dot(v))
    }
}

/// The vertices of an object in the world; `None` where its transform is not usable.
fn place(object: &Object) -> Option<Vec<Vector>> {
    if object.transform == Motor::default() {
        return Some(object.positions.iter().map(|&p| Vector::from(p)).collect());
    }
    if !is_rigid(object.transform) {
        return None;
    }
    let mut points: Vec<Point<f64>> = object.positions.iter().map(|&p| p.into()).collect();
    batch::transform(&object.transform, &mut points);
    let reasonable = |p: &Point<f64>| {
        p.coordinates()
            .iter()
            .all(|c| c.abs() <= LARGEST_COORDINATE)
    };
    let all = points.iter().all(reasonable);
    all.then(|| points.into_iter().map(Vector::from).collect())
}
