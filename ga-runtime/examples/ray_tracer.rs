//! Renders balls, a floor and a mirror with shadows, by tracing rays.
//!
//! Everything is found by methods: [`Ray`](ga_runtime::geometry::ray::Ray) finds its first hit with
//! spheres, planes and circles, is mirrored there, and looks for the lamp. The tracer itself is in
//! `ray_tracer/scene.rs`.
//!
//! `cargo run --release -p ga-runtime --example ray_tracer -- picture.png 480` writes a picture,
//! here 480 pixels wide; without arguments, it prints the brightness of a few pixels.

#[path = "ray_tracer/scene.rs"]
mod scene;

use std::error::Error;

use ga_image::colour::{LinearColour, SrgbEncoder};
use image::{Rgb, RgbImage};
use scene::Colour;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let Some(file) = arguments.next() else {
        return letters();
    };
    let width = arguments.next().map_or(Ok(960), |width| width.parse())?;
    let size = [width, width * 9 / 16];
    let camera = scene::example_camera().ok_or("the camera looks straight down")?;
    let picture = scene::render(&scene::example(), &camera, size, 4);
    ga_image::png::write(&file, &encoded(&picture, size)?)?;
    println!("wrote {file}, {} × {} pixels", size[0], size[1]);
    Ok(())
}

/// The picture in 8-bit sRGB.
fn encoded(picture: &[Colour], [width, height]: [usize; 2]) -> Result<RgbImage, Box<dyn Error>> {
    let encoder = SrgbEncoder::new();
    let mut image = RgbImage::new(width.try_into()?, height.try_into()?);
    for (pixel, light) in image.pixels_mut().zip(picture) {
        *pixel = Rgb(encoder.encode(LinearColour::from(light.coordinates())));
    }
    Ok(image)
}

/// Prints a small picture with letters.
fn letters() -> Result<(), Box<dyn Error>> {
    let (width, height) = (72, 20);
    let camera = scene::example_camera().ok_or("the camera looks straight down")?;
    // Letters are twice as high as wide: only every other row of square pixels is printed.
    let picture = scene::render(&scene::example(), &camera, [width, 2 * height], 1);
    for row in picture.chunks_exact(width).step_by(2) {
        let letter = |light: &Colour| {
            let brightness = (light.e1 + light.e2 + light.e3) / 3.0;
            let shades = [' ', '.', ':', '-', '=', '+', '*', '#', '%', '@'];
            shades[(brightness * 10.0).clamp(0.0, 9.0) as usize]
        };
        let line: String = row.iter().map(letter).collect();
        println!("{}", line.trim_end());
    }
    Ok(())
}

#[test]
fn it_runs() {
    letters().expect("a picture");
}
