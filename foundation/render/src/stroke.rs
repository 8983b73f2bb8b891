//! Lines and dots drawn over a picture.

use crate::barycentric::volumes;
use ga_image::colour::LinearColour;
use rayon::prelude::*;

use crate::scene::{Scene, Visibility};
use crate::segment::Segment;
use crate::surface::{NO_TRIANGLE, Samples};
use crate::view::View;
use crate::world::World;
use crate::{Ground, Style};

/// The dot at a joint is this much wider than a bone.
const JOINT: f64 = 2.2;

/// The least width of a bone, in pixels.
const LEAST_BONE: f64 = 1.5;

/// How far a line may lie behind a surface and be seen, as a share of its depth.
const TOLERANCE: f64 = 0.002;

/// Rows that are drawn together. What is drawn does not depend on it.
const BAND: usize = 32;

/// Draws lines, dots and bones, in this order, over the light of a picture.
pub(crate) fn draw(
    light: &mut [LinearColour],
    scene: &Scene,
    world: &World,
    view: &View,
    style: &Style,
    samples: &Samples,
) {
    let surfaces = Surfaces {
        world,
        samples,
        ground: scene.ground,
        view,
        factor: f64::from(style.supersampling),
    };
    let strokes = strokes(scene, style, &surfaces);
    if strokes.is_empty() {
        return;
    }
    let width = style.width as usize;
    let bands = light.par_chunks_mut(width * BAND).enumerate();
    bands.for_each(|(band, light)| {
        let mut canvas = Canvas {
            light,
            width,
            first: band * BAND,
            surfaces: &surfaces,
        };
        for stroke in &strokes {
            canvas.draw(stroke);
        }
    });
}

/// A segment on the picture, with its place in space.
struct Stroke {
    segment: Segment,
    /// 1 / depth at both ends; on the picture it is linear between them.
    inverse_depth: [f64; 2],
    colour: LinearColour,
    visibility: Visibility,
}

fn strokes(scene: &Scene, style: &Style, surfaces: &Surfaces) -> Vec<Stroke> {
    let Surfaces {
        samples,
        view,
        factor,
        ..
    } = *surfaces;
    let lens = samples.lens.scaled(1.0 / factor);
    let depths = [view.near(), view.far()];
    let clipper = lens.clipper(depths, style.width as usize, style.height as usize);
    let segment = |ends: [[f64; 3]; 2], width: f64, colour, visibility| {
        let ends = clipper.clip_segment(ends.map(|p| view.in_frame(p.into())))?;
        let inverse_depth = ends.map(|end| 1.0 / end.e3);
        let place = |i: usize| lens.project([ends[i].e1, ends[i].e2], inverse_depth[i]);
        Some(Stroke {
            segment: Segment {
                ends: [place(0), place(1)],
                radius: width / 2.0,
            },
            inverse_depth,
            colour,
            visibility,
        })
    };
    let mut strokes = Vec::new();
    for line in scene.lines {
        for ends in line.points.windows(2) {
            let ends = [ends[0], ends[1]];
            strokes.extend(segment(ends, line.width, line.colour, line.visibility));
        }
    }
    for dot in scene.dots {
        let ends = [dot.position; 2];
        strokes.extend(segment(ends, dot.diameter, dot.colour, dot.visibility));
    }
    let width = (style.bone_width * f64::from(style.height)).max(LEAST_BONE);
    for &ends in scene.bones {
        strokes.extend(segment(ends, width, style.bone, Visibility::OnTop));
    }
    for &end in scene.bones.iter().flatten() {
        let width = width * JOINT;
        strokes.extend(segment([end; 2], width, style.joint, Visibility::OnTop));
    }
    strokes
}

/// What may hide lines.
struct Surfaces<'a> {
    world: &'a World<'a>,
    samples: &'a Samples,
    ground: Option<Ground>,
    view: &'a View,
    /// Samples along each side of a pixel.
    factor: f64,
}

impl Surfaces<'_> {
    /// Whether something lies in front of a place of the picture with this inverse depth.
    fn hide(&self, [column, row]: [f64; 2], inverse_depth: f64) -> bool {
        let (x, y) = (column * self.factor, row * self.factor);
        // A cast from float saturates.
        let i = (x as usize).min(self.samples.width - 1);
        let j = (y as usize).min(self.samples.height - 1);
        let ray = self.samples.lens.ray(x, y);
        let least = inverse_depth * (1.0 + TOLERANCE);
        let behind_ground = self
            .ground
            .is_some_and(|ground| 1.0 / ground.depth(self.view, ray) > least);
        let index = j * self.samples.width + i;
        let triangle = self.samples.triangle[index];
        if triangle == NO_TRIANGLE || f64::from(self.samples.inverse_depth[index]) <= least {
            return behind_ground;
        }
        // The sample lies beside the place: on a steep surface, that changes the depth. The plane
        // of the triangle p₁ p₂ p₃ has the inverse depth Σ det(ray, pⱼ, pₖ) / det(p₁, p₂, p₃).
        let corners = self.world.face(triangle).in_frame();
        let total: f64 = volumes(ray, corners).iter().sum();
        let exact = total / corners[0].dot(corners[1].cross(corners[2]));
        behind_ground || exact > least
    }
}

/// Some rows of a picture.
struct Canvas<'a> {
    light: &'a mut [LinearColour],
    width: usize,
    /// The first row.
    first: usize,
    surfaces: &'a Surfaces<'a>,
}

impl Canvas<'_> {
    /// Everything that the segment covers.
    fn draw(&mut self, stroke: &Stroke) {
        let (width, first) = (self.width, self.first);
        let rows = first..first + self.light.len() / width;
        stroke.segment.covered(rows, width, |[column, row], cover| {
            let [near, far] = stroke.inverse_depth;
            let inverse_depth = near + (far - near) * cover.along;
            if stroke.visibility == Visibility::Hidden
                && self.surfaces.hide(cover.foot, inverse_depth)
            {
                return;
            }
            let pixel = &mut self.light[(row - first) * width + column];
            *pixel = pixel.lerp(stroke.colour, cover.share);
        });
    }
}
