//! The scene of the example `ray_tracer`, traced by the methods of ga-runtime, by functions of
//! `ga!` and by glam, which do the same steps in the same order, and as textbooks write it, by
//! meets of lines, tangent planes and reflections.

mod by_glam;
mod by_kernels;
#[path = "../../../ga-runtime/examples/ray_tracer/scene.rs"]
mod by_methods;
mod by_products;

use ga_runtime::vga3::Vector;

/// A picture row by row, as linear light.
pub type Picture = Vec<[f64; 3]>;

/// A way to render the picture: its name, and a function of the width and the height in pixels.
pub struct Contender {
    /// What it uses.
    pub name: &'static str,
    /// The picture, with one ray for each pixel.
    pub render: Box<dyn Fn([usize; 2]) -> Picture>,
}

/// All contenders; `None` if the scene cannot be built.
#[must_use]
pub fn contenders() -> Option<Vec<Contender>> {
    let (scene, camera) = (by_methods::example(), by_methods::example_camera()?);
    let glam_scene = by_glam::Scene::of(&scene)?;
    let glam_camera = by_glam::Camera::of(&camera);
    let [products, functions] = [
        textbook::<by_products::Methods>("methods, as a textbook", &scene)?,
        textbook::<by_products::Kernels>("ga!, as a textbook", &scene)?,
    ];
    let kernel_scene = by_kernels::Scene::of(&scene)?;
    let kernel_camera = by_methods::example_camera()?;
    let coordinates = |picture: Vec<Vector<f64>>| picture.into_iter().map(Into::into).collect();
    Some(vec![
        Contender {
            name: "methods",
            render: Box::new(move |size| coordinates(by_methods::render(&scene, &camera, size, 1))),
        },
        Contender {
            name: "ga!",
            render: Box::new(move |size| {
                coordinates(by_kernels::render(&kernel_scene, &kernel_camera, size))
            }),
        },
        products,
        functions,
        Contender {
            name: "glam DVec3",
            render: Box::new(move |size| {
                let picture = by_glam::render(&glam_scene, &glam_camera, size);
                picture.into_iter().map(Into::into).collect()
            }),
        },
    ])
}

fn textbook<M: by_products::Style>(
    name: &'static str,
    scene: &by_methods::Scene,
) -> Option<Contender> {
    let (scene, camera) = (
        by_products::Scene::of(scene)?,
        by_methods::example_camera()?,
    );
    let render = move |size| {
        let picture = by_products::render::<M>(&scene, &camera, size);
        picture.into_iter().map(Into::into).collect()
    };
    Some(Contender {
        name,
        render: Box::new(render),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_contenders_render_the_same_picture() {
        let size = [160, 90];
        let contenders = contenders().expect("a scene");
        let pictures: Vec<Picture> = contenders.iter().map(|c| (c.render)(size)).collect();
        let (glam, others) = pictures.split_last().expect("contenders");
        // Not a picture of a single colour.
        let brightness = |pixel: &[f64; 3]| pixel.iter().sum::<f64>();
        let brightest = glam.iter().map(brightness).fold(0.0, f64::max);
        let darkest = glam.iter().map(brightness).fold(f64::INFINITY, f64::min);
        assert!(brightest > 2.0 && darkest < 0.3, "{darkest} to {brightest}");
        for (picture, contender) in others.iter().zip(&contenders) {
            assert_eq!(picture.len(), glam.len());
            for (index, (found, expected)) in picture.iter().zip(glam).enumerate() {
                for (a, b) in found.iter().zip(expected) {
                    assert!(
                        (a - b).abs() < 1e-6,
                        "{}, pixel {index}: {found:?} is not {expected:?}",
                        contender.name
                    );
                }
            }
        }
    }
}
