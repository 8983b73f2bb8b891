//! The films: the person walks through the room before both cameras.

use anyhow::{Context as _, Result};
use ga_anim::skin::Method;
use ga_camera::Camera;
use ga_camera::rig::StereoRig;
use ga_character::AnimatedScene;
use ga_character::animated_scene::Moment;
use ga_mesh::gltf::Document;
use ga_render::{DepthMap, Rendering, Scene, Style, View, render};

use super::SIZE;
use super::room::Room;
use ga_image::plane::Plane;
use ga_image::sensor::Sensor;

/// Frames of the films in a second.
pub(in crate::commands::demo) const FRAMES_PER_SECOND: u32 = 25;
/// Nothing nearer to a camera is drawn, in metres.
const NEAR: f64 = 0.1;
/// What the cameras make of the light: the right one is set wrongly.
pub(super) const SENSORS: [Sensor; 2] = [
    Sensor {
        exposure: 1.0,
        noise: 1.2,
    },
    Sensor {
        exposure: 1.3,
        noise: 1.2,
    },
];

/// The person in the room, ready to be filmed.
pub(in crate::commands::demo) struct Stage<'a> {
    pub(in crate::commands::demo) rig: StereoRig,
    room: &'a Room,
    person: AnimatedScene<'a>,
    seed: u64,
}

/// What both cameras show at a moment.
pub(in crate::commands::demo) struct Filmed {
    /// What the left camera would show without noise.
    pub(in crate::commands::demo) clean: Plane<[u8; 3]>,
    /// What is in the films.
    pub(in crate::commands::demo) pictures: [Plane<[u8; 3]>; 2],
    /// How far away everything is.
    pub(in crate::commands::demo) depths: Option<[DepthMap; 2]>,
}

/// The style of all pictures: plain light from the cameras' side.
pub(super) fn style() -> Style {
    Style {
        width: SIZE[0] as u32,
        height: SIZE[1] as u32,
        depth_contrast: 0.0,
        ..Style::default()
    }
}

pub(super) fn view(camera: &Camera) -> Result<View> {
    Ok(View::pinhole(camera, NEAR)?)
}

impl<'a> Stage<'a> {
    /// A document with one animation, in a room.
    pub(in crate::commands::demo) fn new(
        rig: StereoRig,
        room: &'a Room,
        document: &'a Document,
        seed: u64,
    ) -> Result<Self> {
        let person = AnimatedScene::new(document, None)?.with_method(Method::Motor);
        Ok(Self {
            rig,
            room,
            person,
            seed,
        })
    }

    /// What the cameras show in a frame.
    pub(in crate::commands::demo) fn film(&mut self, frame: usize) -> Result<Filmed> {
        let moment = Moment {
            animation: Some(0),
            seconds: frame as f64 / f64::from(FRAMES_PER_SECOND),
        };
        let model = self.person.at(moment)?;
        let mut materials = model.materials();
        let first = materials.len() as u32;
        materials.extend(self.room.materials());
        let mut scene: Scene<'_> = model.scene(&materials);
        scene.objects.extend(self.room.objects(first));
        let [left, right] = [&self.rig.left, &self.rig.right];
        let (left, right) = rayon::join(|| draw(&scene, left), || draw(&scene, right));
        let [left, right] = [left?, right?];
        let number = 2 * frame as u64;
        let store = |side: usize, drawn: &Rendering| {
            SENSORS[side].store(&drawn.colour, self.seed, number + side as u64)
        };
        let (a, b) = rayon::join(|| store(0, &left), || store(1, &right));
        Ok(Filmed {
            pictures: [a, b],
            clean: left.colour,
            depths: Some([left.depth, right.depth]),
        })
    }
}

fn draw(scene: &Scene<'_>, camera: &Camera) -> Result<Rendering> {
    render(scene, &view(camera)?, &style()).context("the film of the demonstration")
}
