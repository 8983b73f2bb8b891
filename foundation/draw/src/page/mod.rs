//! An HTML page that needs no other file.

#[cfg(test)]
mod tests;

use serde::Serialize;

use crate::colour::Colour;
use crate::escape::{escaped, in_script};
use crate::picture::Picture;
use crate::scene::Scene;
use crate::svg;
use crate::view::Projection;

const SHEET: &str = include_str!("page.css");
/// The mathematics of the page. They need no document, so that they can be tested alone.
pub(crate) const GEOMETRY: &str = include_str!("geometry.js");
/// The canvas and its view. It uses [`GEOMETRY`].
pub(crate) const STAGE: &str = include_str!("stage.js");
/// The pieces into which surfaces are cut. It uses [`GEOMETRY`].
const SURFACE: &str = include_str!("surface.js");
const SCRIPT: &str = include_str!("page.js");

/// The data from which the script draws.
#[derive(Serialize)]
struct Data<'a> {
    picture: Picture,
    elements: Vec<Entry<'a>>,
    azimuth: f64,
    elevation: f64,
    zoom: f64,
    perspective: bool,
    axes: [[f64; 3]; 3],
}

/// A line of the legend.
#[derive(Serialize)]
struct Entry<'a> {
    label: Option<&'a str>,
    kind: &'static str,
    colour: Colour,
}

impl<'a> Data<'a> {
    fn of(scene: &'a Scene) -> Self {
        let view = scene.view;
        let sensible = |value: f64, default| if value.is_finite() { value } else { default };
        Self {
            picture: Picture::of(scene),
            elements: scene
                .elements()
                .iter()
                .map(|element| Entry {
                    label: element.label.as_deref().filter(|_| scene.legend),
                    kind: element.shape.kind(),
                    colour: element.colour,
                })
                .collect(),
            azimuth: sensible(view.azimuth % 360.0, 0.0),
            elevation: sensible(view.elevation, 0.0).clamp(-90.0, 90.0),
            zoom: sensible(view.zoom, 1.0).clamp(0.1, 20.0),
            perspective: view.projection == Projection::Perspective,
            axes: view.up.axes().map(<[f64; 3]>::from),
        }
    }

    fn json(&self) -> String {
        // This cannot fail: all keys are texts, and numbers that are not finite are written as
        // null.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// The page of a scene.
pub(crate) fn write(scene: &Scene) -> String {
    let title = escaped(&scene.title);
    let description = escaped(&scene.description_or_list());
    let picture = svg::draw(scene);
    let json = in_script(&Data::of(scene).json());
    format!(
        r#"<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="nullcone draw">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>
{SHEET}</style>
</head>
<body>
<main>
<header><h1>{title}</h1><p id="description">{description}</p></header>
<ul id="legend" aria-label="Elements; press one to hide or show it" hidden></ul>
<div id="still">
{picture}</div>
<canvas id="stage" tabindex="0" role="img" aria-label="{title}" aria-describedby="description" hidden></canvas>
<footer hidden>Drag or use the arrow keys to rotate · wheel, two fingers or + − to zoom · double click or 0 to reset</footer>
</main>
<script type="application/json" id="scene">{json}</script>
<script>
{GEOMETRY}{STAGE}{SURFACE}{SCRIPT}</script>
</body>
</html>
"#
    )
}
