//! The first pose as a picture that does not move, for readers whose browser runs no scripts.

use super::data::Data;
use crate::camera::{Camera, Pixel};
use crate::document::svg::{Anchor, Svg};

/// The size of the picture in pixels.
pub(super) const SIZE: [f64; 2] = [640.0, 480.0];

/// The first pose with the floor and the cameras, as SVG.
pub(super) fn draw(data: &Data<'_>, words: &str) -> String {
    let camera = data.camera(SIZE);
    let mut svg = Svg::new(SIZE, words);
    draw_lines(&mut svg, data, &camera, &data.floor, "stroke=\"#c3c9d1\"");
    for pyramid in &data.cameras {
        draw_lines(
            &mut svg,
            data,
            &camera,
            &pyramid.lines,
            "stroke=\"#5a626c\"",
        );
        let [x, y] = project(data, &camera, &pyramid.lines[..3]);
        let attributes = "fill=\"#5a626c\"";
        svg.text([x, y - 6.0], 13.0, Anchor::Middle, attributes, pyramid.name);
    }
    let point = |k: usize| {
        let numbers = &data.points[3 * k..3 * k + 3];
        let pixel = project(data, &camera, numbers);
        (pixel, camera.depth(data.place(numbers)))
    };
    // The first pose that is written is that of the first frame with a pose.
    let bones = data.bones.iter().map(|&[from, to, side]| {
        let [(from, near), (to, far)] = [point(from), point(to)];
        (near + far, [from, to], data.colours[side])
    });
    let mut bones: Vec<_> = bones.collect();
    bones.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, [from, to], colour) in bones {
        let attributes = format!("stroke=\"{colour}\" stroke-width=\"4\" stroke-linecap=\"round\"");
        svg.line(from, to, &attributes);
    }
    for k in 0..data.names.len() {
        svg.circle(point(k).0, 2.5, "fill=\"#2c3440\"");
    }
    svg.into_text()
}

fn project(data: &Data<'_>, camera: &Camera, numbers: &[i32]) -> Pixel {
    camera.project(data.place(numbers))
}

fn draw_lines(svg: &mut Svg, data: &Data<'_>, camera: &Camera, lines: &[i32], attributes: &str) {
    for ends in lines.chunks_exact(6) {
        let [from, to] = [&ends[..3], &ends[3..]].map(|end| project(data, camera, end));
        svg.line(from, to, attributes);
    }
}
