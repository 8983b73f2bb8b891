//! The pose of a figure from pictures of it: dots are painted on its skin and found in the
//! pictures, and the body is fitted to them. Prints how far the joints are from the true ones, and
//! draws the fitted body over the pictures.
//!
//! `cargo run --release -p ga-vision --features body --example body_from_pictures -- FOLDER
//! [MOTION.bvh]`

#[path = "../tests/body/studio.rs"]
mod studio;

use std::path::{Path, PathBuf};
use std::time::Instant;

use ga_anim::pose::Pose;
use ga_anim::retarget::{Options, Retarget, Soles};
use ga_body::pose_error::mean_per_joint_position_error;
use ga_camera::Camera;
use ga_image::colour::LinearColour;
use ga_image::plane::Plane;
use ga_image::png;
use ga_mannequin::walk;
use ga_render::{Appearance, Shading};

use studio::{Result, Studio};

/// How much of the fitted body is seen over the picture.
const OPACITY: f64 = 0.45;
/// Frames of each motion.
const FRAMES: usize = 8;
/// Rows of the painted texture.
const ROWS: usize = 2048;

/// How a motion is seen.
struct Setting {
    name: &'static str,
    sides: &'static [f64],
    distance: f64,
    shading: Shading,
}

const SETTINGS: &[Setting] = &[
    setting("front", &[0.4], 4.0, Shading::Lit),
    setting("left", &[1.7], 4.0, Shading::Lit),
    setting("back", &[3.3], 4.0, Shading::Lit),
    setting("front unlit", &[0.4], 4.0, Shading::Unlit),
    setting("front near", &[0.4], 3.2, Shading::Lit),
    setting("front, back", &[0.4, 3.54], 4.0, Shading::Lit),
    setting("left, right", &[1.7, 4.84], 4.0, Shading::Lit),
];

const fn setting(
    name: &'static str,
    sides: &'static [f64],
    distance: f64,
    shading: Shading,
) -> Setting {
    Setting {
        name,
        sides,
        distance,
        shading,
    }
}

fn main() -> Result<()> {
    let mut arguments = std::env::args_os().skip(1);
    let folder = arguments.next().map_or("out".into(), PathBuf::from);
    std::fs::create_dir_all(&folder)?;
    let studio = Studio::new(ROWS)?;
    let dots = studio.human.dots();
    let counts = studio
        .human
        .skeleton
        .joints()
        .iter()
        .enumerate()
        .map(|(index, joint)| {
            let count = dots.iter().filter(|dot| dot.joint == index).count();
            format!("{} {count}", joint.name)
        });
    println!(
        "{} dots: {}",
        dots.len(),
        counts.collect::<Vec<_>>().join(", ")
    );
    let walk = walk(1);
    let times = (0..FRAMES).map(|frame| walk.duration() * frame as f64 / FRAMES as f64);
    let poses: Vec<Pose> = times.map(|time| walk.sample(time)).collect();
    measure(&studio, "walk", &poses, &folder)?;
    if let Some(path) = arguments.next() {
        let motion = ga_anim::bvh::read(Path::new(&path))?;
        let human = &studio.human;
        let soles = Soles::of_mesh(human.mesh.positions(), &human.weights)?;
        let retarget = Retarget::new(
            &motion,
            &human.skeleton,
            &Options {
                soles: Some(&soles),
                ..Options::default()
            },
        )?;
        let count = motion.frame_count();
        let frames = (0..FRAMES).map(|frame| (2 * frame + 1) * count / (2 * FRAMES));
        let poses = frames
            .map(|frame| retarget.pose(frame))
            .collect::<std::result::Result<Vec<_>, _>>()?;
        measure(&studio, "motion", &poses, &folder)?;
    }
    Ok(())
}

/// Fits all poses in all settings.
fn measure(studio: &Studio, name: &str, poses: &[Pose], folder: &Path) -> Result<()> {
    for setting in SETTINGS {
        let mut errors = Vec::new();
        for (frame, pose) in poses.iter().enumerate() {
            let cameras = studio.rigs(pose, setting.sides, setting.distance)?;
            let begin = Instant::now();
            let dots = studio.dots(pose, &cameras, setting.shading)?;
            let seen = begin.elapsed().as_secs_f64();
            let fit = match studio.body.fit(&cameras, &dots) {
                Ok(fit) => fit,
                Err(error) => {
                    println!("  {name} {frame}, {}: {error}", setting.name);
                    errors.push(f64::INFINITY);
                    continue;
                }
            };
            let fitting = begin.elapsed().as_secs_f64() - seen;
            let (truth, found) = (studio.joints(pose)?, studio.joints(&fit.fitted.pose)?);
            let error = 1e3 * mean_per_joint_position_error(&truth, &found)?;
            errors.push(error);
            let count = dots.iter().map(Vec::len).sum::<usize>();
            let used = fit.observation.views.iter().flatten().flatten().count();
            let wrong = wrong(studio, pose, &cameras, &fit.observation)?;
            let joints = &studio.human.skeleton.joints();
            let worst = truth.iter().zip(&found).zip(joints.iter());
            let worst = worst.map(|((a, b), joint)| (1e3 * a.distance(*b), &joint.name));
            let worst = worst.max_by(|a, b| a.0.total_cmp(&b.0)).ok_or("no joint")?;
            let missing: Vec<&str> = fit
                .unrecognised
                .iter()
                .map(|joint| joints[*joint].name.as_str())
                .collect();
            println!(
                "  {name} {frame}, {}: {error:.2} mm, {} {:.1} mm; {count} dots, {used} used, \
                 {wrong} wrong, {:.2} px; not recognised {missing:?}; {seen:.2} s {fitting:.3} s",
                setting.name, worst.1, worst.0, fit.fitted.root_mean_square_px,
            );
            if frame % 3 == 0 && setting.distance == 4.0 {
                let file = format!(
                    "{name}_{frame}_{}.png",
                    setting.name.replace([',', ' '], "_")
                );
                let picture = studio.view(pose, &cameras[0], setting.shading)?;
                let both = overlay(studio, &picture, &fit.fitted.pose, &cameras[0])?;
                png::write(folder.join(file), &both)?;
            }
        }
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        let worst = errors.iter().copied().fold(0.0, f64::max);
        println!(
            "{name}, {}: MPJPE {mean:.2} mm, worst frame {worst:.2} mm",
            setting.name
        );
    }
    Ok(())
}

/// How many dots are taken for points that are elsewhere.
fn wrong(
    studio: &Studio,
    pose: &Pose,
    cameras: &[Camera],
    seen: &ga_body::Observation,
) -> Result<usize> {
    let places = studio.points(pose)?;
    let mut count = 0;
    for (camera, view) in cameras.iter().zip(&seen.views) {
        for (place, pixel) in places.iter().zip(view) {
            if let Some(pixel) = pixel {
                let [u, v] = camera.project(*place)?;
                let distance = (pixel.position[0] - u).hypot(pixel.position[1] - v);
                count += usize::from(distance > 2.0);
            }
        }
    }
    Ok(count)
}

/// The picture, and beside it the fitted body over it.
fn overlay(
    studio: &Studio,
    picture: &Plane<[u8; 3]>,
    pose: &Pose,
    camera: &Camera,
) -> Result<Plane<[u8; 3]>> {
    let orange = Appearance {
        base_colour: LinearColour::new(0.9, 0.35, 0.05),
        roughness: 0.9,
        ..Appearance::default()
    };
    let body = studio.draw(pose, camera, &orange, Shading::Lit)?;
    let colours: &Plane<[u8; 3]> = &body.colour;
    let width = picture.width();
    Ok(Plane::from_fn(
        2 * width,
        picture.height(),
        |column, row| {
            let at = column % width;
            let under = picture.row(row)[at];
            if column < width {
                return under;
            }
            let share = OPACITY * f64::from(body.depth.coverages().row(row)[at]);
            let over = colours.row(row)[at];
            std::array::from_fn(|k| {
                let [under, over] = [under[k], over[k]].map(f64::from);
                (under + (over - under) * share).round() as u8
            })
        },
    ))
}
