//! A studio in which cameras see the figure with painted dots.

use std::error::Error;

use ga_anim::pose::Pose;
use ga_anim::skin::{self, Method};
use ga_body::marked::{Mark, MarkedBody};
use ga_body::marker::{Dot, DotOptions, Hue, find_dots};
use ga_body::{BodyModel, BodyPoint};
use ga_camera::{Camera, Intrinsics};
use ga_image::colour::LinearColour;
use ga_image::plane::Plane;
use ga_mannequin::{Human, Marker};
use ga_render::texture::{Mipmap, Sampler};
use ga_render::{
    Appearance, Attribute, MaterialChoice, Object, Rendering, Scene, Shading, Style, View, render,
};
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

/// Width and height of the pictures, the part of a larger one that shows the figure.
pub(crate) const SIZE: [u32; 2] = [720, 640];
const FOCAL_LENGTH: f64 = 1000.0;
const BASELINE: f64 = 1.0;

pub(crate) type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// The figure and its painted skin.
pub(crate) struct Studio {
    pub(crate) human: Human,
    pub(crate) body: MarkedBody,
    texture: Mipmap,
    corners: Vec<Option<[u32; 3]>>,
}

impl Studio {
    /// Paints the dots on a texture with this number of rows.
    pub(crate) fn new(rows: usize) -> Result<Self> {
        let human = Human::new();
        let dots = human.dots();
        let centres: Vec<[f64; 3]> = dots.iter().map(|dot| dot.centre).collect();
        let hues = Hue::scattered(&centres, 1);
        let colours: Vec<[[u8; 3]; 2]> = hues.iter().map(|hue| [hue.colour(); 2]).collect();
        let painted = human.marked_texture(rows, &dots, &colours);
        let model = BodyModel::new(human.skeleton.clone(), dots.iter().map(point).collect())?;
        let marks = dots.iter().zip(hues).map(|(dot, hue)| Mark {
            hue,
            normal: dot.normal,
        });
        let coordinates = human
            .mesh
            .texture_coordinates()
            .ok_or("no texture coordinates")?;
        let corners = coordinates.corners.chunks_exact(3);
        let corners = corners.map(|corners| Some([corners[0]?, corners[1]?, corners[2]?]));
        Ok(Self {
            corners: corners.collect(),
            texture: Mipmap::colour(&painted, Sampler::default())?,
            body: MarkedBody::new(model, marks.collect())?,
            human,
        })
    }

    /// The skin in a pose.
    pub(crate) fn skin(&self, pose: &Pose) -> Result<Vec<[f64; 3]>> {
        let motions = pose.motions(&self.human.skeleton)?;
        let moved = skin::skin(
            self.human.mesh.positions(),
            &self.human.weights,
            &motions,
            Method::Linear,
        )?;
        Ok(moved.iter().map(|point| point.coordinates()).collect())
    }

    /// The joints in a pose.
    pub(crate) fn joints(&self, pose: &Pose) -> Result<Vec<Point<f64>>> {
        let bones = pose.bones(&self.human.skeleton)?;
        Ok(bones.into_iter().map(|[head, _]| head.into()).collect())
    }

    /// Pairs of cameras 1 m apart that see a pose from sides and a distance: 0 from the front, π/2
    /// from the left of the body.
    pub(crate) fn rigs(&self, pose: &Pose, sides: &[f64], distance: f64) -> Result<Vec<Camera>> {
        let points = self.skin(pose)?.into_iter().map(Vector::from);
        let [low, high] = ga_mesh::bounds(points).ok_or("no skin")?;
        let middle = (low + high) * 0.5;
        let principal = SIZE.map(|side| 0.5 * f64::from(side - 1));
        let intrinsics = Intrinsics::new([FOCAL_LENGTH; 2], principal)?;
        let half = (0.5 * BASELINE / distance).asin();
        let angles = sides.iter().flat_map(|side| [side - half, side + half]);
        let cameras = angles.map(|angle| {
            let eye = middle + Vector::new(angle.sin(), 0.0, angle.cos()) * distance;
            Camera::look_at(intrinsics, eye.into(), middle.into(), [0.0, 1.0, 0.0])
                .ok_or("the camera has no direction")
        });
        Ok(cameras.collect::<std::result::Result<_, _>>()?)
    }

    /// What a camera sees of the painted figure.
    pub(crate) fn view(
        &self,
        pose: &Pose,
        camera: &Camera,
        shading: Shading,
    ) -> Result<Plane<[u8; 3]>> {
        let material = Appearance {
            base_colour: LinearColour::WHITE,
            base_colour_map: Some(&self.texture),
            roughness: 0.9,
            ..Appearance::default()
        };
        let view = self.draw(pose, camera, &material, shading)?;
        Ok(view.colour)
    }

    /// The figure of a material.
    pub(crate) fn draw(
        &self,
        pose: &Pose,
        camera: &Camera,
        material: &Appearance<'_>,
        shading: Shading,
    ) -> Result<Rendering> {
        let positions = self.skin(pose)?;
        let triangles = self.human.mesh.triangles();
        let coordinates = self
            .human
            .mesh
            .texture_coordinates()
            .ok_or("no coordinates")?;
        let object = Object {
            texture_coordinates: Some(Attribute::of_corners(&coordinates.values, &self.corners)),
            material: MaterialChoice::One(0),
            ..Object::new(&positions, &triangles)
        };
        let scene = Scene {
            objects: vec![object],
            materials: std::slice::from_ref(material),
            ..Scene::default()
        };
        let view = View::pinhole(camera, 0.1)?;
        let style = Style {
            width: SIZE[0],
            height: SIZE[1],
            supersampling: 3,
            depth_contrast: 0.0,
            shading,
            ..Style::default()
        };
        Ok(render(&scene, &view, &style)?)
    }

    /// The dots in the pictures of cameras.
    pub(crate) fn dots(
        &self,
        pose: &Pose,
        cameras: &[Camera],
        shading: Shading,
    ) -> Result<Vec<Vec<Dot>>> {
        let found = cameras.iter().map(|camera| {
            let view = self.view(pose, camera, shading)?;
            Ok(find_dots(view.view(), &DotOptions::default()))
        });
        found.collect()
    }

    /// Where a pose takes the points of the body, by the linear blend, which is written here again.
    pub(crate) fn points(&self, pose: &Pose) -> Result<Vec<Point<f64>>> {
        let motions = pose.motions(&self.human.skeleton)?;
        let points = self.body.model().points().iter().map(|point| {
            let mut place = [0.0; 3];
            for &(joint, weight) in &point.joints {
                let moved = motions[joint]
                    .transform(Point::from(point.at_rest))
                    .coordinates();
                for (sum, c) in place.iter_mut().zip(moved) {
                    *sum += weight * c;
                }
            }
            Point::from(place)
        });
        Ok(points.collect())
    }
}

/// A dot as a point of the body.
fn point(dot: &Marker) -> BodyPoint {
    let weights = dot.weights.iter();
    BodyPoint {
        name: dot.name.clone(),
        at_rest: dot.middle,
        joints: weights
            .map(|influence| (influence.joint as usize, influence.weight))
            .collect(),
    }
}
