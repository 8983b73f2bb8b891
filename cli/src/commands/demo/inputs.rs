//! What the demonstration begins with: two films of a person, and pictures of a board. The truth
//! behind them is kept for the scores alone.

use std::path::Path;

use anyhow::{Context as _, Result, anyhow};
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_anim::skeleton::Skeleton;
use ga_anim::skin::Method;
use ga_camera::rig::StereoRig;
use ga_character::Figure;
use ga_image::film::Rate;
use ga_image::plane::Plane;
use ga_image::png;
use ga_mesh::gltf;
use ga_render::DepthMap;
use ga_runtime::cga3::Point;
use rayon::prelude::*;

use super::counterparts::facing;
use super::studio::{
    Disc, FRAMES_PER_SECOND, Filmed, Room, SIZE, Stage, Standpoint, board_pictures,
};
use crate::film_file::Film;
use crate::format::Format;
use crate::output::Staging;

/// Frames of the films.
pub(super) const FRAMES: usize = 25;
/// The frame of which dense depth is made.
pub(super) const STILL: usize = 12;
/// Frames of which the film without noise is kept.
const CLEAN: usize = 8;

/// What is true of the films.
pub(super) struct Truth {
    pub(super) rig: StereoRig,
    pub(super) disc: Disc,
    /// For each frame where the joints are.
    pub(super) joints: Vec<Vec<Point<f64>>>,
    pub(super) names: Vec<String>,
    /// Of the still.
    pub(super) depths: [DepthMap; 2],
}

/// Makes films and pictures of a figure with its motion, and writes them into the current folder.
pub(super) fn make(figure: &Figure, clip: &Clip, seed: u64) -> Result<Truth> {
    let character = &figure.character;
    let poses = (0..FRAMES).map(|frame| clip.sample(frame as f64 / f64::from(FRAMES_PER_SECOND)));
    let poses: Vec<Pose> = poses.collect();
    let joints = poses.iter().map(|pose| {
        let heads = character.joints(pose)?;
        Ok(heads.into_iter().map(Point::from).collect())
    });
    let joints: Vec<Vec<Point<f64>>> = joints.collect::<Result<_>>()?;
    let skin = poses.par_iter().map(|pose| {
        let places = character.skinned(pose, Method::Motor)?;
        Ok(places.into_iter().map(Point::from).collect())
    });
    let skin: Vec<Vec<Point<f64>>> = skin.collect::<Result<_>>()?;
    let heading = facing(&character.skeleton) + turn(&character.skeleton, &joints);
    let standpoint = Standpoint::before(middle(&joints), heading, &skin.concat())?;
    let rig = standpoint.rig()?;
    let room = Room::new(&standpoint, seed)?;
    let (glb, _) = ga_character::gltf::encode(figure, clip, "motion")?;
    let document = gltf::decode(&glb)?;
    let outputs = Staging::default();
    outputs.write("film/person.glb", &glb)?;
    let rate = Rate::new(f64::from(FRAMES_PER_SECOND)).unwrap_or(Rate::HIGHEST);
    let frames = (0..FRAMES).into_par_iter().map_init(
        || Stage::new(rig, &room, &document, seed),
        |stage, frame| {
            let stage = stage.as_mut().map_err(|error| anyhow!("{error:#}"))?;
            let mut filmed = stage.film(frame)?;
            if frame != STILL {
                filmed.depths = None;
            }
            Ok(filmed)
        },
    );
    let frames: Vec<Filmed> = frames.collect::<Result<_>>()?;
    let still = &frames[STILL];
    for (side, picture) in ["left", "right"].iter().zip(&still.pictures) {
        let path = format!("stills/{side}.png");
        outputs.write(path, png::encode(picture)?)?;
    }
    let depths = still
        .depths
        .clone()
        .context("the demonstration has no depths")?;
    let left: Vec<_> = frames.iter().map(|filmed| &filmed.pictures[0]).collect();
    let right: Vec<_> = frames.iter().map(|filmed| &filmed.pictures[1]).collect();
    let clean: Vec<_> = frames[..CLEAN].iter().map(|filmed| &filmed.clean).collect();
    for (name, frames) in [
        ("film/left.y4m", left.as_slice()),
        ("film/right.y4m", right.as_slice()),
        ("film/clean.y4m", clean.as_slice()),
        ("film/part.y4m", &left[..CLEAN]),
    ] {
        write_film(&outputs, Path::new(name), frames, rate)?;
    }
    let boards = board_pictures(&rig, &room, seed)?;
    let encoded = boards.par_iter().map(|pair| {
        let [left, right] = pair.each_ref().map(png::encode);
        Ok([left?, right?])
    });
    let encoded: Vec<[Vec<u8>; 2]> = encoded.collect::<Result<_>>()?;
    for (number, pair) in encoded.iter().enumerate() {
        for (side, picture) in ["left", "right"].iter().zip(pair) {
            let path = format!("boards/{side}-{:02}.png", number + 1);
            outputs.write(path, picture)?;
        }
    }
    outputs.finish()?;
    let names = character
        .skeleton
        .joints()
        .iter()
        .map(|joint| joint.name.clone());
    Ok(Truth {
        rig,
        disc: room.disc,
        joints,
        names: names.collect(),
        depths,
    })
}

/// Below the middle of where the root goes, on the floor.
fn middle(joints: &[Vec<Point<f64>>]) -> Point<f64> {
    let roots = joints.iter().filter_map(|joints| joints.first());
    let (mut sum, mut count) = ([0.0; 3], 0.0);
    for root in roots {
        let [x, _, z] = root.coordinates();
        sum[0] += x;
        sum[2] += z;
        count += 1.0;
    }
    Point::from(sum.map(|sum| sum / f64::max(count, 1.0)))
}

/// The angle by which the joints at rest are rotated about the vertical, from +z towards +x, to be
/// nearest to those of all frames.
fn turn(skeleton: &Skeleton, frames: &[Vec<Point<f64>>]) -> f64 {
    let rest = skeleton.joints().iter().map(|joint| joint.head);
    let rest = about_the_middle(rest.collect());
    let (mut sin, mut cos) = (0.0, 0.0);
    for joints in frames {
        let posed = joints.iter().map(|joint| joint.coordinates());
        let posed = about_the_middle(posed.collect());
        for ([x, z], [u, v]) in rest.iter().zip(posed) {
            sin += z * u - x * v;
            cos += x * u + z * v;
        }
    }
    sin.atan2(cos)
}

/// Where places are on the floor, from the middle of all.
fn about_the_middle(places: Vec<[f64; 3]>) -> Vec<[f64; 2]> {
    let mean = |k: usize| places.iter().map(|place| place[k]).sum::<f64>() / places.len() as f64;
    let [x, z] = [mean(0), mean(2)];
    let from_middle = places.iter().map(|place| [place[0] - x, place[2] - z]);
    from_middle.collect()
}

fn write_film(
    outputs: &Staging,
    path: &Path,
    frames: &[&Plane<[u8; 3]>],
    rate: Rate,
) -> Result<()> {
    let film = Film {
        path,
        format: Format::Y4m,
        size: SIZE.map(|side| side as u32),
        frames: frames.len(),
        rate,
    };
    film.write(outputs, |show| {
        frames.iter().try_for_each(|frame| show(frame))
    })?;
    Ok(())
}
