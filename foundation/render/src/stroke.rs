//! Lines and dots drawn over a picture.

use crate::barycentric::volumes;
use ga_image::colour::LinearColour;
use rayon::prelude::*;

use crate::scene::{Scene, Visibility};
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

/// A segment on the picture with round ends; a dot where both ends are one place.
struct Stroke {
    ends: [[f64; 2]; 2],
    /// 1 / depth at both ends; on the picture it is linear between them.
    inverse_depth: [f64; 2],
    radius: f64,
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
            ends: [place(0), place(1)],
            inverse_depth,
            radius: width / 2.0,
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
    /// Everything within the radius of the segment, with a soft edge one pixel wide.
    fn draw(&mut self, stroke: &Stroke) {
        let [a, b] = stroke.ends;
        let reach = stroke.radius + 1.0;
        // A cast from float saturates, so that ends far outside the picture leave an empty or a
        // clamped range.
        let range = |low: f64, high: f64, begin: usize, end: usize| {
            let start = ((low - reach).max(0.0) as usize).max(begin);
            start..((high + reach).max(0.0) as usize).min(end)
        };
        let last = self.first + self.light.len() / self.width;
        let rows = range(a[1].min(b[1]), a[1].max(b[1]), self.first, last);
        for row in rows {
            let [low, high] = span(a, b, row as f64 + 0.5, reach);
            for column in range(low, high, 0, self.width) {
                let place = [column as f64 + 0.5, row as f64 + 0.5];
                let along = nearest(place, a, b);
                let foot = lerp(a, b, along);
                let distance = (place[0] - foot[0]).hypot(place[1] - foot[1]);
                let cover = (stroke.radius + 0.5 - distance).clamp(0.0, 1.0);
                let [near, far] = stroke.inverse_depth;
                let inverse_depth = near + (far - near) * along;
                if cover == 0.0
                    || stroke.visibility == Visibility::Hidden
                        && self.surfaces.hide(foot, inverse_depth)
                {
                    continue;
                }
                let pixel = &mut self.light[(row - self.first) * self.width + column];
                *pixel = pixel.lerp(stroke.colour, cover);
            }
        }
    }
}

/// The least and the greatest column of the part of a segment within `reach` of a row.
fn span(a: [f64; 2], b: [f64; 2], row: f64, reach: f64) -> [f64; 2] {
    let fall = b[1] - a[1];
    let at = |row: f64| {
        let along = ((row - a[1]) / fall).clamp(0.0, 1.0);
        a[0] + (b[0] - a[0]) * along
    };
    if fall.abs() <= reach {
        return [a[0].min(b[0]), a[0].max(b[0])];
    }
    let (p, q) = (at(row - reach), at(row + reach));
    [p.min(q), p.max(q)]
}

/// Where on a segment the place nearest to `p` lies, from 0 at `a` to 1 at `b`.
fn nearest(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (ab, ap) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let squared = ab[0] * ab[0] + ab[1] * ab[1];
    if squared > 0.0 {
        ((ap[0] * ab[0] + ap[1] * ab[1]) / squared).clamp(0.0, 1.0)
    } else {
        0.0
    }
}

fn lerp(a: [f64; 2], b: [f64; 2], t: f64) -> [f64; 2] {
    [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]
}
