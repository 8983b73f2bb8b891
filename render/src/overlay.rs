//! Bones drawn over a picture.

use crate::camera::{Camera, Lens};
use crate::clip::Clipper;
use crate::{Style, Vector};
use ga_image::colour::LinearColour;

/// The dot at a joint is this much wider than a bone.
const DOT: f64 = 2.2;

/// The least width of a bone, in pixels.
const LEAST_WIDTH: f64 = 1.5;

/// Draws each bone as a line with dots at its ends, dots on top.
pub(crate) fn draw_bones(
    light: &mut [LinearColour],
    bones: &[[[f64; 3]; 2]],
    camera: &Camera,
    style: &Style,
) {
    let lens = Lens::new(camera, style.width, style.height);
    let clipper = Clipper::new(camera.near(), 1.0, 1.0);
    let width = (style.bone_width * f64::from(style.height)).max(LEAST_WIDTH);
    let mut canvas = Canvas {
        light,
        width: style.width as usize,
        height: style.height as usize,
    };
    let project = |point: Vector| lens.project([point.e1, point.e2], 1.0 / point.e3);
    for ends in bones {
        if let Some(visible) = clipper.clip_segment(ends.map(|p| camera.view(p.into()))) {
            let [a, b] = visible.map(project);
            canvas.segment(a, b, width / 2.0, style.bone);
        }
    }
    for end in bones.iter().flatten() {
        let view = camera.view(Vector::from(*end));
        if view.e3 >= camera.near() {
            let place = project(view);
            canvas.segment(place, place, width / 2.0 * DOT, style.joint);
        }
    }
}

struct Canvas<'a> {
    light: &'a mut [LinearColour],
    width: usize,
    height: usize,
}

impl Canvas<'_> {
    /// Everything within `radius` of the segment, with a soft edge one pixel wide.
    fn segment(&mut self, a: [f64; 2], b: [f64; 2], radius: f64, colour: LinearColour) {
        let reach = radius + 1.0;
        // A cast from float saturates, so that ends far outside the picture leave an empty or a
        // clamped range.
        let range = |p: f64, q: f64, size: usize| {
            let start = (p.min(q) - reach).max(0.0) as usize;
            start..((p.max(q) + reach).max(0.0) as usize).min(size)
        };
        for row in range(a[1], b[1], self.height) {
            for column in range(a[0], b[0], self.width) {
                let place = [column as f64 + 0.5, row as f64 + 0.5];
                let cover = (radius + 0.5 - distance_to_segment(place, a, b)).clamp(0.0, 1.0);
                if cover > 0.0 {
                    let pixel = &mut self.light[row * self.width + column];
                    *pixel = pixel.lerp(colour, cover);
                }
            }
        }
    }
}

fn distance_to_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (ab, ap) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let squared = ab[0] * ab[0] + ab[1] * ab[1];
    let along = if squared > 0.0 {
        ((ap[0] * ab[0] + ap[1] * ab[1]) / squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (ap[0] - along * ab[0]).hypot(ap[1] - along * ab[1])
}
