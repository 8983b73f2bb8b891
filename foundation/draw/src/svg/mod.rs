//! Pictures in Scalable Vector Graphics (SVG).

mod fit;
mod legend;
mod path;
mod theme;
mod writer;

use crate::escape::escaped;
use crate::picture::Picture;
use crate::scene::Scene;
use fit::fitted;
use legend::Legend;
use path::number;
use theme::{GROUND, STYLE};
use writer::Writer;

/// The picture of a scene.
pub(crate) fn draw(scene: &Scene) -> String {
    let size = scene.size.map(|pixels| f64::from(pixels.clamp(64, 8192)));
    let picture = Picture::of(scene);
    let legend = Legend::of(scene, size);
    let camera = fitted(scene, &picture, &legend, size);
    let mut writer = Writer::new(&picture);
    writer.surfaces_and_strokes(&camera);
    writer.labels(&camera, size, &legend.boxes());
    legend.write(&mut writer.body);
    let [width, height] = size.map(number);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         role=\"img\" aria-labelledby=\"picture-title picture-description\">\n\
         <title id=\"picture-title\">{}</title>\n<desc id=\"picture-description\">{}</desc>\n<style>{STYLE}</style>\n\
         <defs>\n{}</defs>\n<rect class=\"ground\" width=\"100%\" height=\"100%\" fill=\"{GROUND}\"/>\n{}</svg>\n",
        escaped(&scene.title),
        escaped(&scene.description_or_list()),
        writer.defs,
        writer.body,
    )
}
