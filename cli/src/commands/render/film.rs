//! Films of a model that moves.

use std::ops::Range;

use anyhow::{Context as _, Result};
use ga_character::AnimatedScene;
use ga_character::animated_scene::Moment;
use ga_render::{Ground, Style, Viewpoint, model, render};

use super::arguments::Arguments;
use super::camera::Camera;
use super::drawing::Drawing;
use super::film_arguments::Times;
use crate::format::Format;

/// What a film shows, and when.
pub(super) struct Film<'a> {
    pub(super) animation: Option<usize>,
    pub(super) camera: &'a Camera,
    pub(super) times: &'a Times,
    /// The pictures that are drawn, of all that the film has.
    pub(super) pictures: Range<usize>,
}

impl Film<'_> {
    fn moment(&self, picture: usize) -> Moment {
        Moment {
            animation: self.animation,
            seconds: self.times.at(picture),
        }
    }

    /// Draws the pictures.
    pub(super) fn draw<'a>(
        &self,
        mut drawing: Drawing<'a>,
        arguments: &Arguments,
        scene: &mut AnimatedScene<'_>,
        style: &Style,
        format: Format,
    ) -> Result<Drawing<'a>> {
        let progress = drawing.progress;
        let count = self.times.count();
        progress.step("finding the camera");
        let viewpoint = match self.camera {
            Camera::Outside(viewpoint, _) => *viewpoint,
            Camera::Node(node, _) => Viewpoint::View(scene.view(*node, self.moment(0))?),
        };
        let moments = (0..count).map(|picture| {
            progress.at(picture as u64, count as u64);
            self.moment(picture)
        });
        let (first, bounds) = scene.framing(moments, &viewpoint, style.aspect())?;
        let options = model::Options {
            edges: arguments.wireframe,
            ground: arguments.ground.then(|| Ground::under(bounds)),
        };
        progress.step("drawing the film");
        let path = arguments.film.file.clone().unwrap_or_default();
        let rate = arguments.film.rate;
        drawing.add_film(
            &path,
            format,
            style,
            self.pictures.clone(),
            rate,
            |picture| {
                let moment = self.moment(picture);
                let view = match self.camera {
                    Camera::Outside(..) => first,
                    Camera::Node(node, _) => scene.view(*node, moment)?,
                };
                let model = scene.at(moment)?;
                let drawn = model.with_scene(options, |scene| render(scene, &view, style));
                progress.at(picture as u64 + 1, count as u64);
                let drawn = drawn.with_context(|| format!("at {} s", moment.seconds))?;
                Ok(drawn.colour)
            },
        )?;
        drawing.add_camera(arguments, &first, style)?;
        Ok(drawing)
    }
}
